// SPDX-License-Identifier: MIT
// Along which axis something is longest.
#pragma once

#include "firma/vec.h"

namespace firma {

/// 0 to 2; of equals the first.
inline int longest_axis(const Vec3& size) {
    const int axis = size.y > size.x ? 1 : 0;
    return size.z > size[axis] ? 2 : axis;
}

}  // namespace firma
