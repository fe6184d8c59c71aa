// SPDX-License-Identifier: MIT
// Sets of spheres on their way, as a caller has them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "bindings/c/calls.h"
#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"
#include "firma/motion.h"
#include "firma/sphere_set.h"

namespace firma::c {

/// Spheres as a caller has them, four doubles each. Of too many one too many, which is refused like all that are.
inline SphereSet spheres_of(const double* spheres, std::size_t count) {
    SphereSet all(std::min(count, kMaxSpheres + 1));
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k] = {{spheres[4 * k], spheres[4 * k + 1], spheres[4 * k + 2]}, spheres[4 * k + 3]};
    return all;
}

/// The first spheres of a set to a caller, likewise.
inline void put_spheres(std::span<const Sphere> from, double* spheres, std::size_t capacity) {
    for (std::size_t k = 0; k < from.size() && k < capacity; ++k) {
        for (int axis = 0; axis < 3; ++axis) spheres[4 * k + std::size_t(axis)] = from[k].centre[axis];
        spheres[4 * k + 3] = from[k].radius;
    }
}

/// A set, and how it moves.
struct MovingSetThere {
    SphereSet spheres;
    RigidMotion motion;

    firma_code read(const double* given, std::size_t count, const firma_motion* way, const char* function) {
        if (!way || (!given && count)) return bad_call(function, kNull);
        if (count > kMaxSpheres)
            return fail(FIRMA_ERROR_TOO_LARGE, function,
                        "a set has at most " + std::to_string(kMaxSpheres) + " spheres");
        spheres = spheres_of(given, count);
        motion = motion_of(*way);
        // A cast takes a rotation of zero for none; here it is a mistake, told as other numbers are.
        if (!is_rotation(way->rotation)) motion.position.x = std::numeric_limits<double>::quiet_NaN();
        return FIRMA_OK;
    }
};

}  // namespace firma::c
