// SPDX-License-Identifier: MIT
// How the casts of a set are drawn, and the sets that are measured again and again.
#pragma once

#include "scenes/cast_families.h"

namespace firma::scenes {

/// Radius and length of the path evenly from their ranges (metres), directions evenly over the sphere.
struct CastRange {
    double radius_low = 0, radius_high = 0;
    double length_low = 0, length_high = 0;
};

inline constexpr CastRange kShortSpheres{0.3, 0.5, 0.1, 2};
inline constexpr CastRange kLongSpheres{0.3, 0.5, 50, 50};
inline constexpr CastRange kShortRays{0, 0, 1, 2};
inline constexpr CastRange kLongRays{0, 0, 5, 100};

}  // namespace firma::scenes
