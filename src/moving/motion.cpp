// SPDX-License-Identifier: MIT
// Motions from fraction 0 to 1: whether they can be worked with, where they lead, how fast.
#include "firma/motion.h"

#include "moving/arc.h"

namespace firma {

bool is_usable(const RigidMotion& motion) {
    for (const double number : motion.rotation)
        if (!is_finite(number)) return false;
    return is_finite(motion.position) && is_finite(motion.path) && length(motion.turn) <= kMaxAngle;
}

Pose pose_at(const RigidMotion& motion, double fraction) {
    Pose pose;
    pose.position = motion.position + motion.path * fraction;
    pose.rotation = compose(turn_by(motion.turn * fraction), normalised(motion.rotation));
    return pose;
}

RigidMotion motion_between(const RigidMotion& motion, double from, double to) {
    if (from == 0 && to == 1) return motion;
    const Pose begin = pose_at(motion, from);
    return {begin.position, begin.rotation, motion.path * (to - from), motion.turn * (to - from)};
}

Vec3 velocity_at(const RigidMotion& motion, double fraction, const Vec3& point) {
    return motion.path + cross(motion.turn, point - (motion.position + motion.path * fraction));
}

}  // namespace firma
