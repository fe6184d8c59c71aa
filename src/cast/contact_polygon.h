// SPDX-License-Identifier: MIT
// Points in a plane, reduced to the four of them that span the most area.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace firma {

/// A point seen along a normal, and which it was.
struct SeenPoint {
    double x = 0, y = 0;
    std::size_t index = 0;
};

inline double turn_of(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners of the convex hull, counter-clockwise: from the point farthest from the mean on, each time to the one
/// that has all others on its left; of several on one line to rounding to the farthest.
/// Source: R. A. Jarvis, On the Identification of the Convex Hull of a Finite Set of Points in the Plane, 1973.
/// @param slack  points nearer to each other count as one, points nearer to a line as on it
/// @param hull   room for as many as there are points
/// @return how many
inline std::size_t hull_in_plane(std::span<const SeenPoint> points, double slack, std::span<SeenPoint> hull) {
    const auto far = [](const SeenPoint& a, const SeenPoint& b) {
        return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    };
    if (points.empty()) return 0;
    SeenPoint mean;
    for (const SeenPoint& p : points) {
        mean.x += p.x / double(points.size());
        mean.y += p.y / double(points.size());
    }
    SeenPoint start = points[0];
    for (const SeenPoint& p : points)
        if (far(p, mean) > far(start, mean)) start = p;
    std::size_t count = 0;
    SeenPoint at = start;
    while (count < points.size()) {
        hull[count++] = at;
        SeenPoint next = at;
        for (const SeenPoint& p : points) {
            const double there = far(at, p), here = far(at, next);
            if (there <= slack) continue;
            const double turn = turn_of(at, next, p), rounding = slack * (there + here);
            if (here == 0 || turn < -rounding || (turn <= rounding && there > here)) next = p;
        }
        if (far(next, start) <= slack || far(next, at) <= slack) break;
        at = next;
    }
    return count;
}

/// Of a convex polygon the four corners that span the most area, in order; all, where there are no more.
/// @return how many
inline std::size_t widest_four(std::span<const SeenPoint> corners, std::array<SeenPoint, 4>& widest) {
    const std::size_t count = corners.size();
    if (count <= 4) {
        for (std::size_t k = 0; k < count; ++k) widest[k] = corners[k];
        return count;
    }
    // By each diagonal the farthest on either side.
    double most = -1;
    for (std::size_t i = 0; i + 2 < count; ++i)
        for (std::size_t j = i + 2; j < count && j - i < count - 1; ++j) {
            double left = -1, right = -1;
            std::size_t on_left = 0, on_right = 0;
            for (std::size_t k = i + 1; k < j; ++k) {
                const double far = -turn_of(corners[i], corners[j], corners[k]);
                if (far <= right) continue;
                right = far;
                on_right = k;
            }
            for (std::size_t k = 0; k < count; ++k) {
                if (k >= i && k <= j) continue;
                const double far = turn_of(corners[i], corners[j], corners[k]);
                if (far <= left) continue;
                left = far;
                on_left = k;
            }
            if (left + right <= most) continue;
            most = left + right;
            if (on_left < i)
                widest = {corners[on_left], corners[i], corners[on_right], corners[j]};
            else
                widest = {corners[i], corners[on_right], corners[j], corners[on_left]};
        }
    return 4;
}

}  // namespace firma
