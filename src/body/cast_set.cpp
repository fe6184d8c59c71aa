// SPDX-License-Identifier: MIT
// A moving set of spheres against a world.
#include "body/cast_spheres.h"

#include <cmath>

#include "firma/capsule.h"
#include "moving/arc.h"

namespace firma {
namespace {

/// One sphere of a set against the world.
class SphereSweep {
public:
    SphereSweep(const World& world, const CastOptions& options, const Arc& arc, double radius)
        : world_(world), options_(options), arc_(arc), radius_(radius) {}

    /// The first touch between two times, in fractions of the whole motion.
    Hit between(double from, double to) const {
        const double bulge = arc_.bulge(from, to);
        const Vec3 start = arc_.at(from), path = arc_.at(to) - start;
        if (bulge > kMaxBulge) {
            if (!comes_near(start, path, radius_ + bulge)) return {};
            const double middle = (from + to) * 0.5;
            const Hit first = between(from, middle);
            return first.status != Status::kMiss ? first : between(middle, to);
        }
        Hit hit = cast(world_, {start, radius_ + bulge}, path, options_);
        if (!hit.touched()) return hit;
        hit.fraction = from + hit.fraction * (to - from);
        hit.status = hit.fraction > 0 ? Status::kHit : Status::kInitialOverlap;
        return hit;
    }

private:
    bool comes_near(const Vec3& start, const Vec3& path, double radius) const {
        NearOptions near;
        near.mask = options_.mask;
        // An overlap that cannot be asked is left to the casts.
        return overlap_each(
                   world_, Capsule{start, start + path, radius}, [](const Overlap&) { return false; }, near) !=
               Status::kMiss;
    }

    const World& world_;
    const CastOptions& options_;
    const Arc& arc_;
    const double radius_;
};

void put_safe_fraction(const World& world, const Arc& arc, const CastOptions& options, SetHit& hit) {
    const double offset = options.contact_offset < 0 ? world.tolerance().contact_offset : options.contact_offset;
    const double speed = -dot(arc.velocity_at(hit.fraction), hit.normal);
    const double back = speed > 0 ? offset / speed : 1;
    hit.safe_fraction = back < hit.fraction ? hit.fraction - back : 0;
}

/// Whether a sphere around all of a set, as it turns, comes near anything.
bool comes_near(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
                const CastOptions& options) {
    double reach = 0;
    for (const Sphere& sphere : spheres) {
        const double far = length(sphere.centre) + sphere.radius;
        reach = far > reach ? far : reach;
    }
    NearOptions near;
    near.mask = options.mask;
    const Capsule around{motion.position, motion.position + motion.path, reach * (1 + 0x1p-40)};
    return overlap_each(world, around, [](const Overlap&) { return false; }, near) != Status::kMiss;
}

SetHit invalid_set_hit() {
    SetHit hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    return hit;
}

bool are_usable(std::span<const Sphere> spheres, const RigidMotion& motion) {
    if (!is_usable(motion)) return false;
    for (const Sphere& sphere : spheres)
        if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !is_finite(sphere.radius)) return false;
    return true;
}

}  // namespace

SetHit cast(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
            const CastOptions& options) {
    if (!are_usable(spheres, motion)) return invalid_set_hit();
    if (!spheres.empty() && comes_near(world, spheres, motion, options))
        return cast_spheres(world, spheres, motion, options);
    SetHit missed;
    missed.centre = motion.position + motion.path;
    return missed;
}

SetHit cast_spheres(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
                    const CastOptions& options) {
    if (!are_usable(spheres, motion)) return invalid_set_hit();
    SetHit first;
    first.centre = motion.position + motion.path;
    const TurnMatrix rotation = matrix_of(normalised(motion.rotation));
    const TurnRate rate(motion.turn);
    CastOptions each = options;
    each.trail = nullptr;
    for (std::uint32_t k = 0; k < spheres.size(); ++k) {
        const Arc arc(motion.position, motion.path, rate, rotation * spheres[k].centre);
        const bool turns = arc.bulge(0, 1) > 0;
        const Hit hit = turns ? SphereSweep(world, each, arc, spheres[k].radius).between(0, first.fraction)
                              : cast(world, {arc.at(0), spheres[k].radius}, motion.path, each);
        if (hit.status == Status::kInvalid) return invalid_set_hit();
        if (!hit.touched() || (first.touched() && !(hit.fraction < first.fraction))) continue;
        static_cast<Hit&>(first) = hit;
        first.sphere = k;
        if (turns) put_safe_fraction(world, arc, each, first);
        if (first.fraction == 0) break;
    }
    return first;
}

}  // namespace firma
