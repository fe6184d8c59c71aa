// SPDX-License-Identifier: MIT
// A moving capsule against a polygon.
//
// It is a ball that moves against the sum of the polygon and the turned segment. Where the ball meets the sum first is
// on the polygon, for either end (a sphere's cast); on what a side of the polygon sweeps (cast_axis_side.h); or on what
// a corner v sweeps, the edge from v - s to v: a ball against an edge (cast_sphere_edge.h), with A - (v - s) = B - v.
#include "cast/cast_capsule_polygon.h"

#include <cmath>

#include "cast/capsule_start.h"
#include "cast/cast_axis_side.h"
#include "cast/cast_sphere_edge.h"
#include "cast/cast_sphere_face.h"
#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// How both ends lie to the plane.
struct PlaneSpan {
    double low, high;  ///< heights of the segment, widened by rounding

    PlaneSpan(const PlaneView& one, const PlaneView& other) {
        const double error = one.height_error > other.height_error ? one.height_error : other.height_error;
        low = (one.height < other.height ? one.height : other.height) - error;
        high = (one.height < other.height ? other.height : one.height) + error;
    }
};

/// A box around the path of the capsule, or of its segment where it starts.
class AroundCapsule {
public:
    AroundCapsule(const CapsuleSweep& capsule, double latest) {
        const Vec3 &a = capsule.a.start, &b = capsule.b.start, along = capsule.direction() * latest;
        const double margin = capsule.radius() + rounding(64) * (max_abs(a) + max_abs(b) + 2 * max_abs(along) +
                                                                 capsule.radius() + kWorldRim);
        for (int axis = 0; axis < 3; ++axis) {
            const double low = a[axis] < b[axis] ? a[axis] : b[axis], high = a[axis] < b[axis] ? b[axis] : a[axis];
            low_[axis] = low + (along[axis] < 0 ? along[axis] : 0) - margin;
            high_[axis] = high + (along[axis] > 0 ? along[axis] : 0) + margin;
        }
    }
    bool clear_of(const Vec3& a, const Vec3& b) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (a[axis] < low_[axis] && b[axis] < low_[axis]) return true;
            if (a[axis] > high_[axis] && b[axis] > high_[axis]) return true;
        }
        return false;
    }
    bool clear_of(const PolygonShape& polygon) const {
        for (int axis = 0; axis < 3; ++axis) {
            bool below = true, above = true;
            for (const Vec3& v : polygon.corners) {
                below = below && v[axis] < low_[axis];
                above = above && v[axis] > high_[axis];
            }
            if (below || above) return true;
        }
        return false;
    }

private:
    Vec3 low_, high_;
};

/// The earliest touch so far; of touches at one time the first that came.
struct EarliestContact {
    Contact best;
    double latest;

    void keep(const Contact& contact) {
        if (!contact.touched() || (best.touched() && best.t <= contact.t)) return;
        best = contact;
        if (contact.t < latest) latest = contact.t;
    }
    void keep(const Entry& entry, Feature feature, std::size_t index) {
        if (entry.kind != Entry::kFound) return;
        keep({entry.t > 0 ? Status::kHit : Status::kInitialOverlap, feature, std::uint32_t(index), entry.t});
    }
};

/// A segment of no radius that moves within the plane: a corner meets its inside. Its ends meet the rim as particles.
Entry cross_corner_in_plane(const CapsuleSweep& capsule, const Vec3& v) {
    using Real = DoubleDouble;
    const VectorOf<Real> w = difference<Real>(capsule.b.start, v), s = capsule.precise_s(),
                         d = exactly<Real>(capsule.direction());
    const VectorOf<Real> m = cross(w, s), n = cross(d, s);
    const Real nn = dot(n, n);
    if (!(nn.high > 0)) return {};
    const Real t = -dot(m, n) / nn;
    if (!(0.0 < t)) return {};
    const Real along = dot(w, s) + t * dot(d, s);
    if (along < 0.0 || dot(s, s) < along) return {};
    return counted(capsule.a, t);
}

/// The segment alone, decided exactly.
void cross_sides(const CapsuleSweep& capsule, const PolygonShape& polygon, EarliestContact& first) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k)
        first.keep(cross_axis_side(capsule, polygon.corners[k], polygon.corners[polygon.next(k)]), Feature::kEdge, k);
}

void touch_sides(const CapsuleSweep& capsule, const PolygonShape& polygon, EarliestContact& first, CastCounts* counts) {
    const AroundCapsule path(capsule, first.latest);
    using Real = DoubleDouble;
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 &v = polygon.corners[k], &next = polygon.corners[polygon.next(k)];
        if (path.clear_of(v, next)) continue;
        Entry side = enter_axis_side(capsule, v, next);
        if (side.kind == Entry::kDoubtful) {
            side = enter_axis_side_precisely(capsule, v, next);
            if (counts) ++counts->precise;
        }
        first.keep(side, Feature::kEdge, k);
        if (path.clear_of(v, v)) continue;
        Entry corner = enter_cylinder(capsule.a, capsule.b.start - v, capsule.s);
        if (corner.kind == Entry::kDoubtful) {
            corner = enter_cylinder_precisely(capsule.a, difference<Real>(capsule.b.start, v), capsule.precise_s());
            if (counts) ++counts->precise;
        }
        first.keep(corner, Feature::kVertex, k);
    }
}

/// A radius not far above rounding could let the capsule slip between features; its segment, decided exactly, cannot.
bool too_thin(const CapsuleSweep& capsule, const PolygonShape& polygon) {
    constexpr double kFarAboveRounding = 0x1p-36;
    const double far =
        length(capsule.a.start - polygon.corners[0]) + length(capsule.s) + capsule.end() * capsule.a.direction_length;
    return capsule.radius() < kFarAboveRounding * far;
}

}  // namespace

Contact cast_capsule_polygon(const Sweep& around, const CapsuleShape& shape, const PolygonShape& polygon, Sides sides,
                             double latest, CastCounts* counts) {
    const CapsuleSweep capsule(around, shape);
    if (shape.is_sphere()) return cast_sweep_polygon(capsule.a, polygon, sides, latest, counts);
    const int facing = exact_facing(capsule.direction(), polygon);
    if (facing >= 0 && sides == Sides::kFront) return {};
    const PlaneView one = view_plane(capsule.a, polygon, facing), other = view_plane(capsule.b, polygon, facing);
    const PlaneSpan span(one, other);
    const double r = capsule.radius();
    if (span.high < -r) return {};
    if (span.low - r > (one.approach + one.approach_error) * latest * (1 + rounding(8))) return {};
    if (span.low <= r && !AroundCapsule(capsule, 0).clear_of(polygon)) {
        const CapsuleStart start = capsule_start(capsule, polygon, facing);
        if (start.kind != StartContact::kApart) return start.contact;
    }
    const bool thin = too_thin(capsule, polygon);
    EarliestContact first{{}, thin ? capsule.end() : latest};
    first.keep(cast_sweep_polygon(capsule.a, polygon, sides, first.latest, counts));
    first.keep(cast_sweep_polygon(capsule.b, polygon, sides, first.latest, counts));
    if (r > 0) touch_sides(capsule, polygon, first, counts);
    if (r == 0 || (thin && !first.best.touched())) cross_sides(capsule, polygon, first);
    if (r == 0 && facing == 0 && exact_plane_side(capsule.a.start, polygon) == 0 &&
        exact_plane_side(capsule.b.start, polygon) == 0)
        for (std::size_t k = 0; k < polygon.corners.size(); ++k)
            first.keep(cross_corner_in_plane(capsule, polygon.corners[k]), Feature::kVertex, k);
    return first.best;
}

PolygonHit make_capsule_hit(const Sweep& around, const CapsuleShape& shape, const PolygonShape& polygon,
                            const Contact& contact) {
    const CapsuleSweep capsule(around, shape);
    if (shape.is_sphere()) return make_hit(capsule.a, polygon, contact);
    const Vec3 a = (capsule.a.start - polygon.corners[0]) + capsule.direction() * contact.t;
    const NearestOnAxis nearest = nearest_on_axis(a, capsule.s, polygon);
    // As a sphere at the nearest point of the segment.
    Sweep ball = capsule.a;
    ball.start = nearest.part == 1 ? capsule.b.start : capsule.a.start + capsule.s * nearest.part;
    ball.radius = 1;  // any but 0, which stands for a particle
    PolygonHit hit = make_hit(ball, polygon, contact);
    hit.centre = around.at(contact.t);
    if (contact.status == Status::kInitialOverlap) {
        const CapsuleStart start = capsule_start(capsule, polygon, exact_facing(capsule.direction(), polygon));
        if (!start.pierces || start.kind != StartContact::kInitialOverlap) return hit;
        hit.normal = start.out;
        hit.feature = start.contact.feature;
        hit.feature_index = start.contact.index;
        return hit;
    }
    const double far = max_abs(capsule.a.start - polygon.corners[0]) + contact.t * capsule.a.direction_length;
    const double noise = rounding(64) * (far + max_abs(capsule.s));
    if (nearest.distance > noise && capsule.radius() > 0) return hit;
    // The difference of the nearest points is rounding: as a particle, or across the side and the segment.
    ball.radius = 0;
    hit.normal = make_hit(ball, polygon, {contact.status, Feature::kFace, 0, contact.t}).normal;
    if (contact.feature != Feature::kEdge) return hit;
    const Vec3 &v = polygon.corners[contact.index], e = polygon.corners[polygon.next(contact.index)] - v;
    const Vec3 u = cross(e, capsule.s);
    const double u_length = length(u);
    if (u_length > 0) hit.normal = u * ((dot(u, capsule.direction()) > 0 ? -1 : 1) / u_length);
    const bool on_side = length(cross(e, hit.point - v)) <= noise * length(e);
    if (hit.feature != Feature::kFace || !on_side) return hit;
    hit.feature = Feature::kEdge;
    hit.feature_index = contact.index;
    return hit;
}

}  // namespace firma
