// SPDX-License-Identifier: MIT
// A moving set of spheres against a level with parts that move meanwhile.
#include <algorithm>

#include "firma/capsule.h"
#include "firma/cast_set.h"
#include "moving/arc.h"

namespace firma {
namespace {

/// One sphere of a set in a scene.
class SphereInScene {
public:
    SphereInScene(const Scene& scene, const CastOptions& options, const Arc& arc, double radius)
        : scene_(scene), options_(options), arc_(arc), radius_(radius) {}

    /// The first touch between two times, in fractions of the whole motion.
    PartHit between(double from, double to) const {
        const double bulge = arc_.bulge(from, to);
        const Vec3 start = arc_.at(from), path = arc_.at(to) - start;
        const Scene meanwhile{scene_.world, scene_.parts, stretched(from), stretched(to)};
        if (bulge > kMaxBulge) {
            if (!comes_near(meanwhile, {start, radius_ + bulge}, path)) return {};
            const double middle = (from + to) * 0.5;
            const PartHit first = between(from, middle);
            return first.status != Status::kMiss ? first : between(middle, to);
        }
        PartHit hit = cast(meanwhile, {start, radius_ + bulge}, path, options_);
        if (!hit.touched()) return hit;
        hit.fraction = from + hit.fraction * (to - from);
        if (to > from) hit.surface_velocity *= 1 / (to - from);
        hit.safe_fraction = before(hit);
        hit.status = hit.fraction > 0 ? Status::kHit : Status::kInitialOverlap;
        return hit;
    }

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

    /// By the speed along the normal, of the sphere and of what it meets.
    double before(const PartHit& hit) const {
        const double offset =
            options_.contact_offset < 0 ? scene_.world.tolerance().contact_offset : options_.contact_offset;
        const double speed = -dot(arc_.velocity_at(hit.fraction) - hit.surface_velocity, hit.normal);
        const double back = speed > 0 ? offset / speed : 1;
        return back < hit.fraction ? hit.fraction - back : 0;
    }
    double stretched(double t) const {
        if (t == 1) return scene_.to;
        return scene_.from + (scene_.to - scene_.from) * t;
    }

    const Scene& scene_;
    const CastOptions& options_;
    const Arc& arc_;
    const double radius_;
};

SetPartHit invalid_set_part_hit() {
    SetPartHit hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    return hit;
}

bool can_be_cast(std::span<const Sphere> spheres, const RigidMotion& motion) {
    if (!is_usable(motion)) return false;
    for (const Sphere& sphere : spheres)
        if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !is_finite(sphere.radius)) return false;
    return true;
}

}  // namespace

SetPartHit cast(const Scene& scene, std::span<const Sphere> spheres, const RigidMotion& motion,
                const CastOptions& options) {
    if (!can_be_cast(spheres, motion)) return invalid_set_part_hit();
    SetPartHit first;
    first.centre = motion.position + motion.path;
    const TurnMatrix rotation = matrix_of(normalised(motion.rotation));
    const TurnRate rate(motion.turn);
    CastOptions each = options;
    each.trail = nullptr;
    for (std::uint32_t k = 0; k < spheres.size(); ++k) {
        const Arc arc(motion.position, motion.path, rate, rotation * spheres[k].centre);
        const bool turns = arc.bulge(0, 1) > 0;
        const PartHit hit = turns ? SphereInScene(scene, each, arc, spheres[k].radius).between(0, first.fraction)
                                  : cast(scene, {arc.at(0), spheres[k].radius}, motion.path, each);
        if (hit.status == Status::kInvalid) return invalid_set_part_hit();
        if (!hit.touched() || (first.touched() && !(hit.fraction < first.fraction))) continue;
        static_cast<PartHit&>(first) = hit;
        first.sphere = k;
        if (first.fraction == 0) break;
    }
    return first;
}

}  // namespace firma
