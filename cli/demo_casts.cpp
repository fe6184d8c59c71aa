// SPDX-License-Identifier: MIT
// Hops through the level by casts; a hop out of an open level starts anew.
#include "cli/demo_casts.h"
#include "firma/queries.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scenes/rng.h"

namespace firma::cli {

namespace {

constexpr double kLargestRadius = 0.5;  // metres
constexpr int kTries = 1000;            // to find a first point

/// A random length between 1/1024 of `most` and `most`, as many short as long ones.
double some_length(scenes::Rng& rng, double most) {
    const double mantissa = rng.uniform(0.5, 1);  // in statements of its own: arguments have no order
    const int halvings = int(rng.below(10));
    return most * std::ldexp(mantissa, -halvings);
}

class Hopper {
public:
    Hopper(const World& world, std::uint64_t seed) : world_(world), rng_(seed) {
        bounds_ = world.bounds();
        diagonal_ = length(bounds_.high - bounds_.low);
        home_ = first_point();
        place_ = home_;
    }

    Query next() {
        hop();
        Query query;
        query.sphere.centre = place_;
        if (rng_.chance(0.5)) query.sphere.radius = free_radius(some_length(rng_, kLargestRadius));
        const Vec3 direction = rng_.direction();
        query.path = direction * some_length(rng_, diagonal_);
        return query;
    }

private:
    Vec3 random_point() {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = rng_.uniform(bounds_.low[axis], bounds_.high[axis]);
        return p;
    }

    /// What a particle meets, from either side, on its way through the whole level.
    Hit look(const Vec3& from, const Vec3& direction) const {
        CastOptions options;
        options.sides = Sides::kBoth;
        return cast(world_, {from, 0}, direction * (2 * diagonal_), options);
    }

    bool sees_only_fronts(const Vec3& from) {
        for (int k = 0; k < 8; ++k) {
            const Vec3 direction = rng_.direction();
            const Hit hit = look(from, direction);
            if (!hit.touched() || dot(hit.face_normal, direction) >= 0) return false;
        }
        return true;
    }

    Vec3 first_point() {
        for (int k = 0; k < kTries; ++k) {
            const Vec3 p = random_point();
            if (sees_only_fronts(p)) return p;
        }
        return random_point();  // an open level: any will do
    }

    void hop() {
        const Vec3 direction = rng_.direction();
        const Hit hit = look(place_, direction);
        if (hit.touched() && hit.fraction > 0 && dot(hit.face_normal, direction) < 0) {
            place_ = place_ + (hit.centre - place_) * rng_.uniform(0.02, 0.98);
        } else {
            place_ = home_;
        }
    }

    double free_radius(double wanted) const {
        const std::optional<NearFace> nearest = closest(world_, place_, wanted);
        return nearest ? std::min(wanted, 0.9 * nearest->distance) : wanted;
    }

    const World& world_;
    scenes::Rng rng_;
    Box bounds_;
    double diagonal_ = 0;
    Vec3 home_, place_;
};

}  // namespace

std::vector<Query> make_demo_casts(const World& world, std::size_t count, std::uint64_t seed) {
    std::vector<Query> casts;
    if (world.face_count() == 0) return casts;
    Hopper hopper(world, seed);
    casts.reserve(count);
    while (casts.size() < count) casts.push_back(hopper.next());
    return casts;
}

}  // namespace firma::cli
