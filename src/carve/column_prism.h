// SPDX-License-Identifier: MIT
// Prisms on the input grid: over triangles side by side, or over one convex part of a hole and a little more.
#pragma once

#include <span>
#include <vector>

#include "firma/cutter.h"
#include "firma/grid.h"
#include "firma/vec.h"

namespace firma {

inline constexpr double kInputStep = 1 / kInputSteps;

int steepest_axis(const Vec3& normal);
/// The nearest point on it.
Vec3 to_input_grid(const Vec3& p);

/// Its lower and its upper end are alike.
struct ColumnPrism {
    std::vector<Vec3> base;                 ///< corners
    std::vector<CutterTriangle> triangles;  ///< by index, counter-clockwise seen from above

    /// @param under, over  added to the corners give the lower end, the upper end
    /// @return not valid() where it is no sound cutter in the world
    Cutter raise(const Vec3& under, const Vec3& over) const;
};

/// Over the hull of squares around corners, two input steps wide, seen along the axis nearest to a normal.
ColumnPrism grown_prism(std::span<const Vec3> corners, const Vec3& normal);

}  // namespace firma
