// SPDX-License-Identifier: MIT
// How little a body rolls whose spheres leave much of it out.
#pragma once

#include <algorithm>

#include "firma/sphere_set.h"

namespace firma {

/// Body::rolling of what these spheres cover: they roll where it would tip over what they leave out, over half of that,
/// about; at most 0.5 for that.
/// @param least  for what they cover well
inline double rolling_of(const SphereFit& fit, double least) {
    constexpr double kMost = 0.5;
    const double left_out = fit.spheres.empty() ? 0 : fit.error / (2 * fit.spheres.front().radius);
    return std::max(least, std::min(left_out, kMost));
}

}  // namespace firma
