// SPDX-License-Identifier: MIT
// The public pair functions: one mover, one polygon.
#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "cast/nearness.h"
#include "firma/polygon.h"
#include "geometry/rounding.h"

namespace firma {
PolygonHit cast_polygon(const Sphere& sphere, const Vec3& path, std::span<const Vec3> corners, Sides sides) {
    PolygonHit none;
    none.status = Status::kInvalid;
    none.fraction = 0;
    none.centre = sphere.centre;
    Sweep sweep;
    if (make_sweep(sphere, path, sweep) == Status::kInvalid || !usable_corners(corners)) return none;
    const PolygonShape polygon = make_shape(corners);
    if (!(polygon.normal_length > 0)) return none;
    if (sweep.end != 0) {
        const Contact contact = cast_sweep_polygon(sweep, polygon, sides, sweep.end);
        if (contact.touched()) return make_hit(sweep, polygon, contact);
    }
    PolygonHit miss;
    miss.centre = sphere.centre + path;
    return miss;
}

bool overlap(const Sphere& sphere, std::span<const Vec3> corners) {
    if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !usable_corners(corners)) return false;
    if (!(max_abs(sphere.centre) <= kLargestNumber && sphere.radius <= kLargestNumber)) return false;
    const PolygonShape polygon = make_shape(corners);
    if (!(polygon.normal_length > 0)) return false;
    return ball_meets(sphere.centre, sphere.radius, polygon, closest_to(sphere.centre - corners[0], polygon));
}

}  // namespace firma
