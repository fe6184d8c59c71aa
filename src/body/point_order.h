// SPDX-License-Identifier: MIT
// Orders of points and spheres, the same on every machine.
#pragma once

#include "firma/polygon.h"

namespace firma {

inline bool comes_before(const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// The larger one first.
inline bool is_larger(const Sphere& a, const Sphere& b) {
    return a.radius != b.radius ? a.radius > b.radius : comes_before(a.centre, b.centre);
}

}  // namespace firma
