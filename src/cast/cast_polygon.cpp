// SPDX-License-Identifier: MIT
// The public pair functions: one mover, one polygon.
#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "cast/nearness.h"
#include "firma/polygon.h"
#include "geometry/rounding.h"

namespace firma {
PolygonHit cast_polygon(const Sphere& sphere, const Vec3& path, std::span<const Vec3> corners, Sides sides) {
    PolygonHit hit;
    Sweep sweep;
    hit.status = make_sweep(sphere, path, sweep);
    if (hit.status == Status::kInvalid) return hit;
    hit.status = Status::kInvalid;
    if (!usable_corners(corners)) return hit;
    const PolygonShape polygon = make_shape(corners);
    if (!(polygon.normal_length > 0)) return hit;
    hit.status = Status::kMiss;
    if (sweep.end == 0) return hit;
    const Contact contact = cast_sweep_polygon(sweep, polygon, sides, sweep.end);
    return contact.touched() ? make_hit(sweep, polygon, contact) : hit;
}

bool overlap(const Sphere& sphere, std::span<const Vec3> corners) {
    if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !usable_corners(corners)) return false;
    if (!(largest(sphere.centre) <= kLargestNumber && sphere.radius <= kLargestNumber)) return false;
    const PolygonShape polygon = make_shape(corners);
    if (!(polygon.normal_length > 0)) return false;
    return ball_meets(sphere.centre, sphere.radius, polygon, closest_to(sphere.centre - corners[0], polygon));
}

}  // namespace firma
