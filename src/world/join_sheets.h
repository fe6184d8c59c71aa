// SPDX-License-Identifier: MIT
// Pieces of portals that lie side by side in one plane become one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solid/solid_face.h"

namespace firma {

/// What several exact faces in one plane make together.
struct JoinedSheet {
    std::vector<std::uint32_t> members;  ///< of those given, ascending; of one alone nothing else is set
    std::vector<SolidUse> uses;          ///< of all loops in a row
    std::vector<std::uint32_t> ends;     ///< of each loop; the outer one is first
};

/// Longer outlines are left apart: making facets takes the square of their corners.
inline constexpr std::size_t kMostJoinedCorners = 256;

/// Joins faces of one plane, turned the same way, that share edges. Where the whole has no single outer loop, or comes
/// back to one of its corners, they stay apart.
/// @return in order of their first members
/// Costs the faces' edges.
std::vector<JoinedSheet> join_sheets(std::span<const Ref<const SolidFace>> sheets);

}  // namespace firma
