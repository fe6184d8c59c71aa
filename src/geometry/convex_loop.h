// SPDX-License-Identifier: MIT
// Whether a projected loop is convex: exact, for corners in whole numbers of any width.
#pragma once

#include <cstddef>

namespace firma {

/// Whether every turn of a loop is to the left or none, and it comes around once: such a loop does not meet itself. (A
/// fold would be half of the way around, and from there the other half leads back only without area.)
///
/// @param count   of corners [>= 3]
/// @param corner  corner(k) has the coordinates u and v; Wide holds twice the area of three
/// @return false also for a corner that repeats the one before, and for a loop without area
template <class Wide, class Corner>
bool convex_loop(std::size_t count, const Corner& corner) {
    const auto forward = [](const auto& a, const auto& b) { return b.u > a.u || (b.u == a.u && b.v > a.v); };
    auto a = corner(count - 2), b = corner(count - 1);
    int reversals = 0;
    bool area = false, went_forward = forward(a, b);
    for (std::size_t k = 0; k < count; ++k) {
        const auto c = corner(k);
        if (c.u == b.u && c.v == b.v) return false;
        const Wide left = Wide(Wide(b.u - a.u) * (c.v - a.v)) - Wide(Wide(b.v - a.v) * (c.u - a.u));
        if (left < 0) return false;
        const bool goes_forward = forward(b, c);
        reversals += goes_forward != went_forward;
        area |= left > 0;
        went_forward = goes_forward;
        a = b;
        b = c;
    }
    return area && reversals == 2;
}

}  // namespace firma
