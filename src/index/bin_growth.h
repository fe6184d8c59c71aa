// SPDX-License-Identifier: MIT
// How much a bin has to grow to hold one more box.
// Source: A. Guttman, R-Trees: A Dynamic Index Structure for Spatial Searching, 1984, section 3.2.
#pragma once

#include <algorithm>

#include "geometry/grid_box.h"
#include "index/bin.h"

namespace firma {

/// A box to be put somewhere, metres.
struct Bounds {
    double low[3], high[3];

    explicit Bounds(const GridBox& box) {
        const Vec3 a = to_metres(box.low), b = to_metres(box.high);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = a[axis];
            high[axis] = b[axis];
        }
    }
};

inline bool contains(const BoxF& box, const Bounds& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < double(box.low[axis]) || inner.high[axis] > double(box.high[axis])) return false;
    return true;
}

inline double half_area(const double (&extent)[3]) {
    return extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0];
}

inline double half_area(const BoxF& box) {
    double extent[3];
    for (int axis = 0; axis < 3; ++axis) extent[axis] = double(box.high[axis]) - double(box.low[axis]);
    return half_area(extent);
}

/// What a bin comes to when a box is added.
struct Growth {
    double by, to;  ///< half the surface, square metres

    Growth(const BoxF& box, const Bounds& added) {
        double before[3], after[3];
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.low[axis], high = box.high[axis];
            before[axis] = high - low;
            after[axis] = std::max(high, added.high[axis]) - std::min(low, added.low[axis]);
        }
        to = half_area(after);
        by = to - half_area(before);
    }
    bool better_than(const Growth& other) const { return by != other.by ? by < other.by : to < other.to; }
};

/// Whether a box goes to the second of two bins: to the one whose surface has to grow less; if both alike, to the one
/// that is smaller then.
inline bool goes_right(const BoxF& left, const BoxF& right, const Bounds& added) {
    // A bin that holds the box does not grow. One that does not, grows in some axis by a step or more, and has an
    // extent in another one, since faces have areas: its surface grows by 2^-34 of itself at least, and rounding is
    // 2^-50.
    const bool in_left = contains(left, added), in_right = contains(right, added);
    if (in_left != in_right) return in_right;
    if (in_left) return half_area(right) < half_area(left);
    return Growth(right, added).better_than(Growth(left, added));
}

}  // namespace firma
