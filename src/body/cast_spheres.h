// SPDX-License-Identifier: MIT
// Spheres of a set against the world, one by one.
#pragma once

#include <span>

#include "firma/cast_set.h"

namespace firma {

/// As cast() of a set does, without a look first at what is around all of them: for sets that something is near.
SetHit cast_spheres(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
                    const CastOptions& options);

}  // namespace firma
