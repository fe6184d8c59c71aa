// SPDX-License-Identifier: MIT
#pragma once

#include <LinearMath/btVector3.h>

#include "firma/vec.h"

namespace firma::test {

inline btVector3 bullet_vector(const Vec3& v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}
inline Vec3 our_vector(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

}  // namespace firma::test
