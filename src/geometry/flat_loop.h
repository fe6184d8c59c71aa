// SPDX-License-Identifier: MIT
// What loops of projected corners enclose: how much, and which points. Of corners in whole numbers that is exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/flat_point.h"

namespace firma {

/// Adds twice the area that a loop encloses, summed about its first corner: positive when it runs counter-clockwise.
///
/// @param first, end  numbers of its corners
/// @param corner      corner(k) has the coordinates u and v
template <class Sum, class Corner>
void add_twice_area(std::uint32_t first, std::uint32_t end, const Corner& corner, Sum& sum) {
    const auto start = corner(first);
    auto last = start;
    for (std::uint32_t k = first + 1; k < end; ++k) {
        auto next = corner(k);
        next.u = next.u - start.u;
        next.v = next.v - start.v;
        if (k > first + 1) sum = sum + (Sum(last.u) * next.v - Sum(last.v) * next.u);
        last = next;
    }
}

inline Int128 twice_area(std::span<const FlatPoint> loop) {
    Int128 sum = 0;
    add_twice_area(0, std::uint32_t(loop.size()), [&](std::uint32_t k) { return loop[k]; }, sum);
    return sum;
}

/// Whether the ray from p along u crosses a side; a corner on it counts as above. A point that is on no side lies in
/// what loops enclose when it does so for an odd number of their sides.
inline bool crosses_ray(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
    if ((a.v < p.v) == (b.v < p.v)) return false;
    return (turn(a, b, p) > 0) == (b.v > a.v);
}

inline bool encloses(std::span<const FlatPoint> loop, const FlatPoint& p) {
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k)
        inside ^= crosses_ray(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0], p);
    return inside;
}

}  // namespace firma
