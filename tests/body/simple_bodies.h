// SPDX-License-Identifier: MIT
// Ground, balls and boxes for tests of bodies.
#pragma once

#include <algorithm>

#include "firma/bodies.h"
#include "firma/world.h"
#include "tests/brush/depot_level.h"
#include "tests/brush/map_text.h"
#include "tests/world/matter_levels.h"

namespace firma::test {

/// A slab whose top is at z = 0, 256 m wide.
inline World ground() {
    return brush_world(map_text::box({-128, -128, -4}, {128, 128, 0}, "rock"));
}

inline World depot_world() {
    return make_world(depot_level()).value();
}

inline BodyShape ball(double radius, double density = 1000) {
    const Sphere sphere{{0, 0, 0}, radius};
    return make_body_shape({&sphere, 1}, mass_of_ball(radius, density)).value();
}

/// A box as spheres in its corners, of half the thinnest half side.
inline BodyShape box_body(const Vec3& half, double density = 1000) {
    const double radius = std::min({half.x, half.y, half.z}) * 0.5;
    SphereSet spheres;
    for (int corner = 0; corner < 8; ++corner) {
        Sphere sphere{half - Vec3{radius, radius, radius}, radius};
        for (int axis = 0; axis < 3; ++axis)
            if (corner >> axis & 1) sphere.centre[axis] = -sphere.centre[axis];
        spheres.push_back(sphere);
    }
    return make_body_shape(spheres, mass_of_box(half, density)).value();
}

inline Body body_here(const BodyShape& shape, const Vec3& position) {
    Pose pose;
    pose.position = position;
    return body_at(shape, pose);
}

/// Steps of a sixtieth of a second.
inline void run(Bodies& bodies, const World& world, int steps, const StepOptions& options = {}) {
    for (int k = 0; k < steps; ++k) step(bodies, world, 1.0 / 60, options);
}

}  // namespace firma::test
