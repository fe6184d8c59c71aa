// SPDX-License-Identifier: MIT
// A moving set of spheres against a level with parts that move meanwhile.
#include <algorithm>

#include "body/sphere_set_sweep.h"
#include "firma/capsule.h"
#include "firma/cast_set.h"

namespace firma {
namespace {

/// A set on its way in a scene. Times are fractions of the set's motion.
class SetInScene {
public:
    SetInScene(const Scene& scene, const CastOptions& options) : scene_(scene), options_(options) {
        options_.trail = nullptr;
        if (options.contact_offset < 0) options_.contact_offset = scene.world.tolerance().contact_offset;
    }

    PartHit on_arc(const Arc& arc, double radius, double before) const {
        const auto may_meet = [&](double from, double to, const Sphere& sphere, const Vec3& path) {
            return comes_near(meanwhile(from, to), sphere, path);
        };
        const auto cast_chord = [&](double from, double to, const Sphere& sphere, const Vec3& path) {
            PartHit hit = cast(meanwhile(from, to), sphere, path, options_);
            if (hit.touched() && to > from) hit.surface_velocity *= 1 / (to - from);
            return hit;
        };
        PartHit hit = first_on_arc(arc, radius, 0, before, may_meet, cast_chord);
        if (!hit.touched()) return hit;
        const double speed = -dot(arc.velocity_at(hit.fraction) - hit.surface_velocity, hit.normal);
        hit.safe_fraction = fraction_before(hit.fraction, options_.contact_offset, speed);
        return hit;
    }
    PartHit straight(const Sphere& sphere, const Vec3& path) const { return cast(scene_, sphere, path, options_); }

private:
    /// Whether a ball that goes straight touches any face, from whichever side, or the ball around a part.
    bool comes_near(const Scene& meanwhile, const Sphere& thick, const Vec3& path) const {
        NearOptions near;
        near.mask = options_.mask;
        const Capsule swept{thick.centre, thick.centre + path, thick.radius};
        if (overlap_each(scene_.world, swept, [](const Overlap&) { return false; }, near) != Status::kMiss) return true;
        for (const MovingPart& part : scene_.parts)
            if (comes_near(part, meanwhile, thick, path)) return true;
        return false;
    }

    static bool comes_near(const MovingPart& part, const Scene& meanwhile, const Sphere& thick, const Vec3& path) {
        const Box& box = part.bounds();
        if (!(box.low.x <= box.high.x)) return false;
        const RigidMotion& motion = part.motion;
        const Vec3 middle = matrix_of(normalised(motion.rotation)) * ((box.low + box.high) * 0.5);
        const Arc way(motion.position, motion.path, TurnRate(motion.turn), middle);
        const Vec3 there = way.at(meanwhile.from), along = way.at(meanwhile.to) - there;
        const double reach = length(box.high - box.low) * 0.5 + way.bulge(meanwhile.from, meanwhile.to) + thick.radius;
        const Vec3 apart = thick.centre - there, closing = path - along;
        const double most = dot(closing, closing);
        const double t = most > 0 ? std::clamp(-dot(apart, closing) / most, 0.0, 1.0) : 0;
        return length(apart + closing * t) <= reach * (1 + 0x1p-20);
    }

    Scene meanwhile(double from, double to) const {
        return {scene_.world, scene_.parts, stretched(from), stretched(to)};
    }
    double stretched(double t) const {
        if (t == 1) return scene_.to;
        return scene_.from + (scene_.to - scene_.from) * t;
    }

    const Scene& scene_;
    CastOptions options_;
};

}  // namespace

SetPartHit cast(const Scene& scene, std::span<const Sphere> spheres, const RigidMotion& motion,
                const CastOptions& options) {
    if (!can_be_cast(spheres, motion)) return invalid_hit<SetPartHit>();
    const SetInScene set(scene, options);
    SetPartHit first;
    first.centre = motion.position + motion.path;
    first_of_set(spheres, motion, first, [&](const Arc& arc, double radius, double before) {
        return arc.bulge(0, 1) > 0 ? set.on_arc(arc, radius, before) : set.straight({arc.at(0), radius}, motion.path);
    });
    return first;
}

}  // namespace firma
