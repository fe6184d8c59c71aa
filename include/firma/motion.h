// SPDX-License-Identifier: MIT
// How something rigid moves from fraction 0 to 1: a set of spheres, a body, a part of a level.
#pragma once

#include "firma/export.h"
#include "firma/turn.h"
#include "firma/vec.h"

namespace firma {

/// The origin goes straight, at an even pace, while all else turns about the origin, evenly as well.
struct RigidMotion {
    Vec3 position{};                  ///< of the origin at the start, metres
    Quaternion rotation{0, 0, 0, 1};  ///< at the start; normalised when used
    Vec3 path{};                      ///< of the origin, metres
    Vec3 turn{};                      ///< axis times angle, radians, in the world's axes; within kMaxAngle
};

/// Where it is at a fraction of its motion: scale is 1. Never allocates.
[[nodiscard]] FIRMA_EXPORT Pose pose_at(const RigidMotion& motion, double fraction);

/// The part of a motion from one fraction to another, as a motion of its own. Never allocates.
[[nodiscard]] FIRMA_EXPORT RigidMotion motion_between(const RigidMotion& motion, double from, double to);

/// How fast what moves like this is at a point, at a fraction: metres from fraction 0 to 1 at that pace.
/// @param point  where it is then, metres, in the world
/// Never allocates.
[[nodiscard]] FIRMA_EXPORT Vec3 velocity_at(const RigidMotion& motion, double fraction, const Vec3& point);

}  // namespace firma
