// SPDX-License-Identifier: MIT
// A box in whole surface steps.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firma/grid.h"

namespace firma {

/// A closed box; empty until something is added.
struct GridBox {
    GridPoint low{INT32_MAX, INT32_MAX, INT32_MAX};
    GridPoint high{INT32_MIN, INT32_MIN, INT32_MIN};

    void add(const GridPoint& p) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    void add(const GridBox& b) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], b.low[axis]);
            high[axis] = std::max(high[axis], b.high[axis]);
        }
    }
    friend bool operator==(const GridBox&, const GridBox&) = default;
    double extent(int axis) const { return (double(high[axis]) - double(low[axis])) / kSurfaceSteps; }
    /// Along which it is longest; the first of several.
    int longest_axis() const {
        int longest = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (extent(axis) > extent(longest)) longest = axis;
        return longest;
    }
    /// Metres.
    double longest_extent() const { return extent(longest_axis()); }
    double volume() const { return extent(0) * extent(1) * extent(2); }
    /// Half the surface, square metres.
    double half_area() const { return extent(0) * extent(1) + extent(1) * extent(2) + extent(2) * extent(0); }
};

}  // namespace firma
