// SPDX-License-Identifier: MIT
// Capsules as users see them: made, and cast against one polygon.
#include "firma/capsule.h"

#include "cast/capsule_start.h"
#include "cast/cast_capsule_polygon.h"
#include "geometry/rounding.h"

namespace firma {

Capsule make_capsule(const Vec3& middle, const Vec3& axis, double half, double radius) {
    return {middle - axis * half, middle + axis * half, radius};
}

PolygonHit cast_polygon(const Capsule& capsule, const Vec3& path, std::span<const Vec3> corners, Sides sides) {
    const Sphere around = ball_around(capsule);
    PolygonHit none;
    none.status = Status::kInvalid;
    none.fraction = 0;
    none.centre = around.centre;
    Sweep sweep;
    if (make_sweep(around, path, sweep) == Status::kInvalid || !usable_corners(corners)) return none;
    const PolygonShape polygon = make_shape(corners);
    if (!polygon.has_area()) return none;
    if (sweep.end != 0) {
        const CapsuleShape shape = shape_of_capsule(capsule);
        const Contact contact = cast_capsule_polygon(sweep, shape, polygon, sides, sweep.end);
        if (contact.touched()) return make_capsule_hit(sweep, shape, polygon, contact);
    }
    PolygonHit miss;
    miss.centre = around.centre + path;
    return miss;
}

bool overlap(const Capsule& capsule, std::span<const Vec3> corners) {
    if (capsule.from == capsule.to) return overlap(Sphere{capsule.from, capsule.radius}, corners);
    Sweep sweep;
    if (make_sweep(ball_around(capsule), {1, 0, 0}, sweep) == Status::kInvalid || !usable_corners(corners))
        return false;
    const PolygonShape polygon = make_shape(corners);
    return polygon.has_area() && capsule_meets(CapsuleSweep(sweep, shape_of_capsule(capsule)), polygon);
}

}  // namespace firma
