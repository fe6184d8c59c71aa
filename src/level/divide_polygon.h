// SPDX-License-Identifier: MIT
// Divides an outline that is not a convex planar polygon into triangles on that very outline.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"

namespace firma {

/// Readers refuse faces of more corners: a division may take time that grows with their square.
inline constexpr std::uint32_t kMaxOutlineCorners = 4096;

struct Division {
    enum class What : std::uint8_t {
        kNoArea,    ///< nothing has area
        kWhole,     ///< convex, exactly planar, at most 64 corners: to be used as it is
        kSplit,     ///< divided
        kCrossing,  ///< divided, though pieces overlap or face the other way, as seen along the outline's normal
    };
    What what = What::kNoArea;
    /// Indices into the outline, when divided. Each has area.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Judges an outline exactly and divides it where needed.
///
/// The directed sides of the triangles come to the outline, exactly, once opposite ones are struck out: a closed mesh
/// stays closed. Triangles without area are left out, and only what lies on one line takes its sides with it; an
/// outline that meets itself nowhere loses none, also when many of its corners lie along a side.
///
/// @param outline  corners in order [any count]; any points of the surface grid, also repeated ones
Division divide_polygon(std::span<const GridPoint> outline);

}  // namespace firma
