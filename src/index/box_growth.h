// SPDX-License-Identifier: MIT
// How much a box has to grow to hold one more.
// Source: A. Guttman, R-Trees: A Dynamic Index Structure for Spatial Searching, 1984, section 3.2.
#pragma once

#include <algorithm>

#include "geometry/grid_box.h"

namespace firma {

inline bool contains(const GridBox& box, const GridBox& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < box.low[axis] || inner.high[axis] > box.high[axis]) return false;
    return true;
}

/// Half the surface, square steps.
inline double half_area(const double (&extent)[3]) {
    return extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0];
}
inline double half_area(const GridBox& box) {
    double extent[3];
    for (int axis = 0; axis < 3; ++axis) extent[axis] = double(box.high[axis]) - double(box.low[axis]);
    return half_area(extent);
}

/// Half the surface of what two boxes share, 0 when they are apart.
inline double shared_half_area(const GridBox& a, const GridBox& b) {
    double extent[3];
    for (int axis = 0; axis < 3; ++axis) {
        extent[axis] = double(std::min(a.high[axis], b.high[axis])) - double(std::max(a.low[axis], b.low[axis]));
        if (extent[axis] < 0) return 0;
    }
    return half_area(extent);
}

/// What a box comes to when one is added.
struct Growth {
    double by, to;  ///< half the surface, square steps

    Growth(const GridBox& box, const GridBox& added) {
        // One that holds the other does not grow. One that does not, grows in some axis by a step or more, and has an
        // extent in another one, since faces have areas: its surface grows by 2^-34 of itself at least, and rounding is
        // 2^-50.
        GridBox both = box;
        both.add(added);
        to = half_area(both);
        by = contains(box, added) ? 0 : to - half_area(box);
    }
    bool better_than(const Growth& other) const { return by != other.by ? by < other.by : to < other.to; }
};

/// Whether a box goes to the second of two: to the one whose surface has to grow less; if both alike, to the one that
/// is smaller then.
inline bool goes_right(const GridBox& left, const GridBox& right, const GridBox& added) {
    return Growth(right, added).better_than(Growth(left, added));
}

}  // namespace firma
