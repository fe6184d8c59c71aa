// SPDX-License-Identifier: MIT
// Shapes that are no spheres, by chance.
#pragma once

#include <span>
#include <vector>

#include "cast/cast_capsule_polygon.h"
#include "cast/cast_hull_polygon.h"
#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/queries.h"
#include "scenes/rng.h"

namespace firma {

/// A capsule, a box turned any way, or a hull, in a ball of some size.
struct AnyShape {
    Hull hull;
    Capsule capsule;  ///< where no hull is valid

    AnyShape(scenes::Rng& rng, const Vec3& at, double size) {
        const double kind = rng.uniform(0, 1);
        if (kind < 0.4) {
            const double half = rng.uniform(0, 0.9) * size;
            capsule = make_capsule(at, rng.direction(), half, rng.chance(0.2) ? 0 : size - half);
        } else if (kind < 0.7) {
            const Vec3 x = rng.chance(0.3) ? Vec3{1, 0, 0} : rng.direction(), aside = cross(x, rng.direction());
            const Vec3 y = aside * (1 / length(aside));
            hull =
                make_box({rng.uniform(0.05, 0.5) * size, rng.uniform(0.05, 0.5) * size, rng.uniform(0.05, 0.5) * size},
                         {x, y, cross(x, y)})
                    .value();
        } else {
            std::vector<Vec3> points{{0, 0, 0}};
            for (int k = 4 + int(rng.below(10)); k > 0; --k) points.push_back(rng.direction() * size);
            hull = make_hull(points).value();
        }
    }
    Hit cast_through(const World& world, const Vec3& at, const Vec3& path, Sides sides) const {
        return hull.valid() ? cast(world, hull, at, path, {.sides = sides})
                            : cast(world, capsule, path, {.sides = sides});
    }
    PolygonHit cast_at(std::span<const Vec3> polygon, const Vec3& at, const Vec3& path, Sides sides) const {
        return hull.valid() ? cast_polygon(hull, at, path, polygon, sides)
                            : cast_polygon(capsule, path, polygon, sides);
    }
    Sphere around(const Vec3& at) const {
        return hull.valid() ? Sphere{at, hull.shape()->reach} : ball_around(capsule);
    }
    ShapeExtent extent() const { return hull.valid() ? hull.shape()->extent : extent_of(shape_of_capsule(capsule)); }
    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides) const {
        if (hull.valid()) return cast_hull_polygon(sweep, *hull.shape(), polygon, sides, sweep.end).contact;
        return cast_capsule_polygon(sweep, shape_of_capsule(capsule), polygon, sides, sweep.end);
    }
};

}  // namespace firma
