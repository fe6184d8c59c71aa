// SPDX-License-Identifier: MIT
// Parts for tests: a door's leaf, a blade, a slab, made of brushes.
#pragma once

#include "firma/moving_parts.h"
#include "scenes/rng.h"
#include "tests/brush/map_text.h"
#include "tests/random_vector.h"
#include "tests/world/matter_levels.h"

namespace firma::test {

/// A box as a part's solid, its corners in the part's frame, metres.
inline World box_world(const Vec3& low, const Vec3& high) {
    return brush_world(map_text::box(low, high, "door"));
}

/// A leaf 1 m wide that hangs at its frame's z axis.
inline World leaf_world() {
    return box_world({0, -0.0625, 0}, {1, 0.0625, 2});
}

/// A cross of two bars, an L beneath: concave, with edges that look every way.
inline World cross_world() {
    return brush_world(map_text::box({-1, -0.125, -0.125}, {1, 0.125, 0.125}, "bar") +
                       map_text::box({-0.125, -1, -0.125}, {0.125, 1, 0.125}, "bar") +
                       map_text::box({-0.5, -0.25, -0.75}, {-0.25, 0.25, -0.125}, "bar"));
}

/// A point of a part's frame in the world, at a fraction.
inline Vec3 part_point(const RigidMotion& motion, double fraction, const Vec3& p) {
    const Pose pose = pose_at(motion, fraction);
    return pose.position + matrix_of(pose.rotation) * p;
}

/// A motion near the origin: 0 straight, 1 turned at the start alone, 2 turning.
inline RigidMotion random_motion(scenes::Rng& rng, int kind, double turn) {
    RigidMotion motion;
    motion.position = random_vector(rng, 0, 1);
    motion.path = random_vector(rng, 0, 1.5);
    if (kind > 0) motion.rotation = random_turn(rng.next());
    if (kind > 1) motion.turn = random_vector(rng, 0, turn);
    return motion;
}

}  // namespace firma::test
