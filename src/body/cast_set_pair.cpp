// SPDX-License-Identifier: MIT
// Two moving sets of spheres against each other.
#include "body/first_within.h"
#include "firma/cast_set.h"
#include "moving/arc.h"

namespace firma {
namespace {

/// Two spheres, each on its arc.
struct SpherePair {
    const Arc &a, &b;
    const double reach;  ///< sum of the radii

    double bulge(double from, double to) const { return a.bulge(from, to) + b.bulge(from, to); }
    Vec3 apart(double t) const { return a.at(t) - b.at(t); }

    /// Whether they may touch at all.
    bool comes_near() const {
        const Vec3 start = apart(0);
        return comes_within(start, apart(1) - start, reach + bulge(0, 1));
    }

    /// When they first touch between two times; beyond 1 if they do not.
    double between(double from, double to) const {
        const double thicker = bulge(from, to);
        const Vec3 start = apart(from), path = apart(to) - start;
        if (thicker <= 2 * kMaxBulge) {
            const double t = first_within(start, path, reach + thicker);
            return t <= 1 ? from + t * (to - from) : t;
        }
        if (!comes_within(start, path, reach + thicker)) return 2;
        const double middle = (from + to) * 0.5, first = between(from, middle);
        return first <= 1 ? first : between(middle, to);
    }

private:
    /// Whether |w + t v| <= r for some t in [0, 1]; rounding may only say yes.
    static bool comes_within(const Vec3& w, const Vec3& v, double r) {
        const double along = dot(v, v), t = along > 0 ? -dot(w, v) / along : 0;
        const Vec3 nearest = w + v * (t > 0 ? (t < 1 ? t : 1) : 0);
        return dot(nearest, nearest) <= r * r * (1 + 0x1p-40) + dot(w, w) * 0x1p-40;
    }
};

/// A set on its way.
struct MovingSet {
    std::span<const Sphere> spheres;
    const RigidMotion& motion;
    TurnRate rate{motion.turn};
    TurnMatrix rotation = matrix_of(normalised(motion.rotation));
    double reach = 0;  ///< of all of it, from its origin

    MovingSet(std::span<const Sphere> all, const RigidMotion& moves) : spheres(all), motion(moves) {
        for (const Sphere& sphere : spheres) {
            const double far = length(sphere.centre) + sphere.radius;
            reach = far > reach ? far : reach;
        }
    }
    Arc arc_of(std::uint32_t k) const { return arc_of(rotation * spheres[k].centre); }
    Arc origin() const { return arc_of(Vec3{}); }
    bool is_usable() const { return firma::is_usable(motion) && is_finite(reach) && reach >= 0 && all_radii_usable(); }

private:
    Arc arc_of(const Vec3& offset) const { return {motion.position, motion.path, rate, offset}; }
    bool all_radii_usable() const {
        for (const Sphere& sphere : spheres)
            if (!(sphere.radius >= 0)) return false;
        return true;
    }
};

}  // namespace

SetPairHit cast(std::span<const Sphere> spheres_a, const RigidMotion& motion_a, std::span<const Sphere> spheres_b,
                const RigidMotion& motion_b) {
    const MovingSet a(spheres_a, motion_a), b(spheres_b, motion_b);
    SetPairHit first;
    if (!a.is_usable() || !b.is_usable()) {
        first.status = Status::kInvalid;
        first.fraction = 0;
        return first;
    }
    const Arc around_a = a.origin(), around_b = b.origin();
    if (spheres_a.empty() || spheres_b.empty() || !SpherePair{around_a, around_b, a.reach + b.reach}.comes_near())
        return first;
    for (std::uint32_t i = 0; i < spheres_a.size(); ++i) {
        const Arc one = a.arc_of(i);
        if (!SpherePair{one, around_b, spheres_a[i].radius + b.reach}.comes_near()) continue;
        for (std::uint32_t j = 0; j < spheres_b.size(); ++j) {
            const Arc other = b.arc_of(j);
            const double t =
                SpherePair{one, other, spheres_a[i].radius + spheres_b[j].radius}.between(0, first.fraction);
            if (t > 1 || (first.touched() && !(t < first.fraction))) continue;
            first.status = t > 0 ? Status::kHit : Status::kInitialOverlap;
            first.fraction = t;
            first.sphere_a = i;
            first.sphere_b = j;
            const Vec3 centre = other.at(t), apart = one.at(t) - centre;
            const double distance = length(apart);
            first.normal = distance > 0 ? apart * (1 / distance) : Vec3{0, 0, 1};
            first.point = centre + first.normal * spheres_b[j].radius;
            if (t == 0) return first;
        }
    }
    return first;
}

}  // namespace firma
