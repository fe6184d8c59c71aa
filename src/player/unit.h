// SPDX-License-Identifier: MIT
// Directions.
#pragma once

#include "firma/vec.h"

namespace firma {

/// As long as 1; zero stays zero.
inline Vec3 unit(const Vec3& v) {
    const double size = length(v);
    return size > 0 ? v * (1 / size) : Vec3{};
}

}  // namespace firma
