// SPDX-License-Identifier: MIT
// Sizes of vectors, coordinate by coordinate: what bounds on rounding are made of.
#pragma once

#include <cmath>

#include "firma/vec.h"

namespace firma {

inline Vec3 sizes_of(const Vec3& v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

/// Of the terms of a cross product.
inline Vec3 sizes_of_cross(const Vec3& a, const Vec3& b) {
    const Vec3 p = sizes_of(a), q = sizes_of(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

}  // namespace firma
