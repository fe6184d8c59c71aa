// SPDX-License-Identifier: MIT
// Spheres of a body that begins where the world may reach into it.
#include "fracture/clear_spheres.h"

#include <algorithm>

#include "firma/queries.h"
#include "firma/solid.h"
#include "firma/turn.h"

namespace firma {
namespace {

/// Of a sphere's radius: what less is left of is no sphere.
constexpr double kLeastLeft = 0.25;

}  // namespace

SphereSet clear_spheres(const World& world, const SphereSet& spheres, const Vec3& centre, const Pose& pose,
                        std::uint32_t mask) {
    const TurnMatrix turn = matrix_of(pose.rotation);
    NearOptions options;
    options.mask = mask;
    SphereSet clear;
    if (locate(world.solid(), pose.position + turn * centre) == Where::kSolid) return clear;
    for (Sphere sphere : spheres) {
        const Vec3 middle = pose.position + turn * sphere.centre;
        const NearFace near = closest(world, middle, sphere.radius, options);
        if (near && near.distance < sphere.radius * kLeastLeft) continue;
        if (locate(world.solid(), middle) == Where::kSolid) continue;
        if (near) sphere.radius = std::min(sphere.radius, near.distance);
        clear.push_back(sphere);
    }
    return clear;
}

}  // namespace firma
