// SPDX-License-Identifier: MIT
// Segment against box by outcodes.
// Source: J. D. Foley and others, Computer Graphics: Principles and Practice, 1996, pp. 113-117 (Cohen and Sutherland's
// clipping); the article's fraction for a plane was printed upside down.
#include <cmath>

#include "firma/polygon.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// A bit for each side of the box that the point lies beyond.
unsigned outcode(const Vec3& p, const Box& box) {
    unsigned code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] < box.low[axis]) code |= 1u << (2 * axis);
        if (p[axis] > box.high[axis]) code |= 2u << (2 * axis);
    }
    return code;
}

bool within_other_axes(const Vec3& p, const Box& box, int skipped) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != skipped && (p[axis] < box.low[axis] || p[axis] > box.high[axis])) return false;
    return true;
}

Box grown_by_rounding(Box box, const Vec3& start, const Vec3& path) {
    const double size = max_abs(start) + max_abs(path) + max_abs(box.low) + max_abs(box.high);
    const double margin = rounding(16) * size;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] -= margin;
        box.high[axis] += margin;
    }
    return box;
}

}  // namespace

bool clip_segment_box(const Vec3& start, const Vec3& path, const Box& box) {
    if (box.empty()) return false;
    const Box grown = grown_by_rounding(box, start, path);
    const Vec3 end = start + path;
    const unsigned from = outcode(start, grown), to = outcode(end, grown);
    if (from == 0 || to == 0) return true;  // an end lies inside
    if (from & to) return false;            // both beyond the same side

    // The segment crosses each plane that one end lies beyond; where it meets the box, it enters through one of them.
    const unsigned crossed = from | to;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            if (!(crossed & (1u << (2 * axis + side)))) continue;
            const double plane = side == 0 ? grown.low[axis] : grown.high[axis];
            const double fraction = (plane - start[axis]) / path[axis];
            if (within_other_axes(start + path * fraction, grown, axis)) return true;
        }
    return false;
}

}  // namespace firma
