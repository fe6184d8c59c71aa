// SPDX-License-Identifier: MIT
// Which way a loop of exact points runs around, as far as doubles tell.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/exact_point.h"
#include "geometry/flat_point.h"

namespace firma {

/// Bound on how far off twice the area of a loop is, summed about its first corner from approximate points, for each
/// corner and input step of reach. A term is the difference of two products of differences, each of which is off by
/// 2 * kApproximation = 2^-25: the term by 4 * 2^-25 of the reach, and by the squares of such errors, for which there
/// is as much again.
inline constexpr double kAreaError = 0x1p-22;
/// Likewise for the roundings of a term, for each corner and square of the reach.
inline constexpr double kAreaRounding = 0x1p-45;

/// @param corner  corner(k) is the ExactPoint of corner k, 0 <= k < count
/// @param view    from the front of the loop's plane
/// @return 1 counter-clockwise, -1 clockwise, 0 where that is left open
template <class Corner>
int surely_turns(std::size_t count, const Corner& corner, FlatView view) {
    const Vec3& start = corner(0).approximate();
    double twice_area = 0, reach = 0, last_u = 0, last_v = 0;
    for (std::size_t k = 1; k < count; ++k) {
        const Vec3& p = corner(k).approximate();
        const double u = p[view.u()] - start[view.u()], v = p[view.v()] - start[view.v()];
        twice_area += last_u * v - last_v * u;
        reach = std::max({reach, std::fabs(u), std::fabs(v)});
        last_u = u;
        last_v = v;
    }
    const double error = double(count) * (reach + kApproximation) * (kAreaError + kAreaRounding * reach);
    return twice_area > error ? 1 : twice_area < -error ? -1 : 0;
}

}  // namespace firma
