// SPDX-License-Identifier: MIT
// The convex hull of points of the surface grid, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "geometry/exact_integer.h"

namespace firma {

struct GridHull {
    /// Corners counter-clockwise seen from outside. Triangles may lie in one plane; corners may be left out.
    struct Triangle {
        std::array<std::uint32_t, 3> corner;
        Vec3 normal;        ///< unit, rounded
        double offset = 0;  ///< metres
    };
    std::vector<GridPoint> points;  ///< those of the hull, each once, ascending
    std::vector<Triangle> triangles;
    Int128 sixths = 0;  ///< six times the volume, cubic surface steps

    /// Cubic metres.
    [[nodiscard]] double volume() const;
};

/// @return no triangles where all points lie in one plane
/// Costs the product of points and triangles.
GridHull hull_of(std::vector<GridPoint> points);

}  // namespace firma
