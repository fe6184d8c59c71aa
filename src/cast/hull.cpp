// SPDX-License-Identifier: MIT
// Hulls as users see them: made, and cast against one polygon.
#include "firma/hull.h"

#include <utility>

#include "cast/make_hull_hit.h"
#include "geometry/rounding.h"

namespace firma {

namespace {

/// @param extent  what is known to hold it, or null
Result<Hull> hull_within(std::span<const Vec3> points, const ShapeExtent* extent) {
    Result<HullShape> shape = shape_of_hull(points);
    if (!shape.ok()) return shape.error();
    if (extent) shape.value().extent = *extent;
    for (const HullShape::Triangle& triangle : shape.value().triangles) {
        const Vec3& corner = shape.value().corners[triangle.corner[0]];
        const int side = exact_triple_sign(difference_as_sum({}, corner), shape.value().side(triangle, 1),
                                           shape.value().side(triangle, 2));
        if (side > 0)
            return Error{ErrorCode::kInvalid, "hull",
                         "the place it is put at, the origin of its points, lies outside of it"};
    }
    return Hull(std::make_shared<const HullShape>(std::move(shape).value()));
}

}  // namespace

Hull::Hull(std::shared_ptr<const HullShape> shape) : shape_(std::move(shape)) {}

std::span<const Vec3> Hull::corners() const {
    if (!shape_) return {};
    return shape_->corners;
}

Result<Hull> make_hull(std::span<const Vec3> points) {
    return hull_within(points, nullptr);
}

Result<Hull> make_box(const Vec3& half, const std::array<Vec3, 3>& axes) {
    if (!(half.x > 0 && half.y > 0 && half.z > 0))
        return Error{ErrorCode::kInvalid, "box", "a half extent that is not above 0"};
    std::array<Vec3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = axes[0] * (k & 1 ? half.x : -half.x) + axes[1] * (k & 2 ? half.y : -half.y) +
                     axes[2] * (k & 4 ? half.z : -half.z);
    ShapeExtent extent{{}, {axes[0] * half.x, axes[1] * half.y, axes[2] * half.z}, 3, 0};
    for (const Vec3& axis : extent.axis) extent.radius += rounding(32) * length(axis);
    return hull_within(corners, &extent);
}

PolygonHit cast_polygon(const Hull& hull, const Vec3& at, const Vec3& path, std::span<const Vec3> corners,
                        Sides sides) {
    PolygonHit none;
    none.status = Status::kInvalid;
    none.fraction = 0;
    none.centre = at;
    Sweep sweep;
    if (!hull.valid() || !usable_corners(corners)) return none;
    if (make_sweep({at, hull.shape()->reach}, path, sweep) == Status::kInvalid) return none;
    const PolygonShape polygon = make_shape(corners);
    if (!polygon.has_area()) return none;
    if (sweep.end != 0) {
        const HullContact found = cast_hull_polygon(sweep, *hull.shape(), polygon, sides, sweep.end);
        if (found.contact.touched()) return make_hull_hit(sweep, *hull.shape(), polygon, found);
    }
    PolygonHit miss;
    miss.centre = at + path;
    return miss;
}

bool overlap(const Hull& hull, const Vec3& at, std::span<const Vec3> corners) {
    Sweep sweep;
    if (!hull.valid() || !usable_corners(corners)) return false;
    if (make_sweep({at, hull.shape()->reach}, {1, 0, 0}, sweep) == Status::kInvalid) return false;
    const PolygonShape polygon = make_shape(corners);
    return polygon.has_area() && hull_meets(HullAgainstPolygon(sweep, *hull.shape(), polygon));
}

ContactPoints contact_points(const Hull& hull, const PolygonHit& hit, std::span<const Vec3> corners) {
    if (!hull.valid() || !hit || !is_finite(hit.centre) || !is_finite(hit.normal) || !usable_corners(corners))
        return {};
    const PolygonShape polygon = make_shape(corners);
    if (!polygon.has_area()) return {};
    return points_of_contact(*hull.shape(), hit, polygon);
}

}  // namespace firma
