// SPDX-License-Identifier: MIT
// The public pair functions: one mover, one polygon.
#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "firma/polygon.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

bool castable(std::span<const Vec3> corners) {
    if (corners.size() < 3) return false;
    for (const Vec3& corner : corners)
        if (!(largest(corner) <= kWorldRim)) return false;
    return true;
}

}  // namespace

PolygonHit cast_polygon(const Sphere& sphere, const Vec3& path, std::span<const Vec3> corners, Sides sides) {
    PolygonHit hit;
    Sweep sweep;
    hit.status = make_sweep(sphere, path, sweep);
    if (hit.status == Status::kInvalid) return hit;
    hit.status = Status::kInvalid;
    if (!castable(corners)) return hit;
    const PolygonShape polygon = make_shape(corners);
    if (!(polygon.normal_length > 0)) return hit;
    hit.status = Status::kMiss;
    if (sweep.end == 0) return hit;
    const Contact contact = cast_sweep_polygon(sweep, polygon, sides, sweep.end);
    return contact.touched() ? make_hit(sweep, polygon, contact) : hit;
}

bool overlap(const Sphere& sphere, std::span<const Vec3> corners) {
    if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !castable(corners)) return false;
    return closest_point(sphere.centre, corners).distance <= sphere.radius;
}

}  // namespace firma
