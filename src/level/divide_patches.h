// SPDX-License-Identifier: MIT
// Chooses how finely the patches of a level are divided, all together so that they meet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/patch.h"

namespace firma {

/// No span gets more chords than this, whatever the tolerance.
inline constexpr std::uint32_t kMostChords = 64;

/// @param tolerance   > 0, in the unit of the control points
/// @param max_cells  of all patches together
/// @return one division a patch; nothing when they would make more cells, found before work or memory is spent on them.
///         Each is fine enough for its own patch (short of kMostChords): every point of the surface is within
///         `tolerance` of the triangles of its cells, and every point of a rim of its chord. (Measured on the cells,
///         not proven. Where a patch folds over itself within its own plane, the fold may be off by a few times as
///         much.) Spans of any patches that have a rim with the same three control points, in either direction, get the
///         same number of chords. So they get the same points there: no cracks. Where a rim of one patch is only part
///         of a span of another, or is met by flat surfaces, nothing is promised.
std::optional<std::vector<PatchDivision>> divide_patches(std::span<const Patch> patches, double tolerance,
                                                         std::uint64_t max_cells);

}  // namespace firma
