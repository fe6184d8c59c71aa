// SPDX-License-Identifier: MIT
// A moving set of spheres against a world.
#include <algorithm>

#include "body/cast_spheres.h"
#include "body/sphere_set_sweep.h"
#include "firma/capsule.h"

namespace firma {
namespace {

/// Whether a sphere that goes straight comes near anything. An overlap that cannot be asked is left to the casts.
bool comes_near(const World& world, const Sphere& sphere, const Vec3& path, std::uint32_t mask) {
    NearOptions near;
    near.mask = mask;
    const Capsule swept{sphere.centre, sphere.centre + path, sphere.radius};
    return overlap_each(world, swept, [](const Overlap&) { return false; }, near) != Status::kMiss;
}

/// Whether a sphere around all of a set, as it turns, does.
bool comes_near(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion, std::uint32_t mask) {
    double reach = 0;
    for (const Sphere& sphere : spheres) reach = std::max(reach, length(sphere.centre) + sphere.radius);
    return comes_near(world, {motion.position, reach * (1 + 0x1p-40)}, motion.path, mask);
}

}  // namespace

SetHit cast(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
            const CastOptions& options) {
    if (!can_be_cast(spheres, motion)) return invalid_hit<SetHit>();
    if (!spheres.empty() && comes_near(world, spheres, motion, options.mask))
        return cast_spheres(world, spheres, motion, options);
    SetHit missed;
    missed.centre = motion.position + motion.path;
    return missed;
}

SetHit cast_spheres(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
                    const CastOptions& options) {
    if (!can_be_cast(spheres, motion)) return invalid_hit<SetHit>();
    CastOptions each = options;
    each.trail = nullptr;
    const double offset = options.contact_offset < 0 ? world.tolerance().contact_offset : options.contact_offset;
    const auto may_meet = [&](double, double, const Sphere& sphere, const Vec3& path) {
        return comes_near(world, sphere, path, options.mask);
    };
    const auto cast_chord = [&](double, double, const Sphere& sphere, const Vec3& path) {
        return cast(world, sphere, path, each);
    };
    SetHit first;
    first.centre = motion.position + motion.path;
    first_of_set(spheres, motion, first, [&](const Arc& arc, double radius, double before) -> Hit {
        if (!(arc.bulge(0, 1) > 0)) return cast(world, {arc.at(0), radius}, motion.path, each);
        Hit hit = first_on_arc(arc, radius, 0, before, may_meet, cast_chord);
        if (hit.touched())
            hit.safe_fraction = fraction_before(hit.fraction, offset, -dot(arc.velocity_at(hit.fraction), hit.normal));
        return hit;
    });
    return first;
}

}  // namespace firma
