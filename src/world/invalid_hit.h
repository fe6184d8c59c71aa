// SPDX-License-Identifier: MIT
// What a cast answers that could not be asked.
#pragma once

#include "firma/hit.h"

namespace firma {

inline Hit invalid_hit(const Vec3& centre) {
    Hit hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    hit.centre = centre;
    return hit;
}

}  // namespace firma
