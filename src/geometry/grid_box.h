// SPDX-License-Identifier: MIT
// A box in whole surface steps.
#pragma once

#include <cstdint>

#include "firma/grid.h"

namespace firma {

/// A closed box; empty until something is added.
struct GridBox {
    GridPoint low{INT32_MAX, INT32_MAX, INT32_MAX};
    GridPoint high{INT32_MIN, INT32_MIN, INT32_MIN};

    void add(const GridPoint& p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    void add(const GridBox& b) {
        add(b.low);
        add(b.high);
    }
    double extent(int axis) const { return (double(high[axis]) - double(low[axis])) / kSurfaceSteps; }
    double volume() const { return extent(0) * extent(1) * extent(2); }
    /// Half the surface, square metres.
    double half_area() const { return extent(0) * extent(1) + extent(1) * extent(2) + extent(2) * extent(0); }
};

}  // namespace firma
