// SPDX-License-Identifier: MIT
// A particle against a polygon.
//
// Every corner is projected along the path onto two axes, by one expression of corner and path alone; an edge's side is
// the sign of a difference of two rounded products. Faces that share an edge therefore see the same numbers. Where the
// sign could be rounding's, an exact sum of products decides instead, so the answer is that of real arithmetic: nothing
// leaks, and nothing is met that is not there. Source: S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle
// Intersection, 2013 (the projection).
#include "cast/cast_particle_polygon.h"

#include <cmath>

#include "cast/cast_sphere_face.h"
#include "cast/nearness.h"
#include "cast/vector_of.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

struct Projected {
    double u = 0, v = 0;
    double size = 0;  ///< largest coordinate of the corner as seen from the start
};

Projected project(const Sweep& sweep, const Vec3& corner) {
    const Vec3 w = corner - sweep.start;
    return {w[sweep.axis_u] - sweep.shear_u * w[sweep.axis_k], w[sweep.axis_v] - sweep.shear_v * w[sweep.axis_k],
            max_abs(w)};
}

/// A projected coordinate is off by at most 6 roundoffs of the corner's size and at most twice that size; so two
/// products and their difference are off by at most 64 roundoffs of the sizes' product. Twice that is used.
constexpr double kProjectionError = 128 * kRoundoff;

/// Sign of direction . ((a - start) x (b - start)).
int edge_side(const Sweep& sweep, const Vec3& a, const Projected& pa, const Vec3& b, const Projected& pb) {
    const double left = pa.u * pb.v, right = pa.v * pb.u;
    const double side = left - right;
    const double size = pa.size < pb.size ? pb.size : pa.size;
    if (std::fabs(side) > kProjectionError * size * size) return side > 0 ? 1 : -1;
    return exact_edge_side(sweep.start, sweep.direction, a, b);
}

/// Which side a particle at t is on. Of several sides in a row on one line the clipping knows only the line.
std::uint32_t side_at(const Sweep& sweep, const PolygonShape& polygon, double t) {
    const Closest closest = closest_on_rim((sweep.start - polygon.corners[0]) + sweep.direction * t, polygon);
    return closest.index;  // a vertex stands for the side it begins
}

/// A path within the plane meets the polygon's rim: clipping by each side's half-plane, in double-double. The start is
/// not on it.
Contact cast_in_plane(const Sweep& sweep, const PolygonShape& polygon) {
    using Real = DoubleDouble;
    const VectorOf<Real> n = precise_normal(polygon), d = exactly<Real>(sweep.direction);
    Contact contact;
    Real enters = 0.0, leaves = sweep.end;
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 &a = polygon.corners[k], &b = polygon.corners[polygon.next(k)];
        const VectorOf<Real> inward = cross(n, difference<Real>(b, a));
        const Real inside = dot(difference<Real>(sweep.start, a), inward), gain = dot(d, inward);
        const double size = std::sqrt(rounded(dot(inward, inward))) * sweep.direction_length;
        if (std::fabs(gain.high) <= 8 * kDoubleDoubleRoundoff * size) {  // along this side
            if (inside.high < 0) return {};
            continue;
        }
        const Real t = -inside / gain;
        if (gain.high > 0) {
            if (enters < t) {
                enters = t;
                contact = {Status::kHit, Feature::kEdge, std::uint32_t(k), rounded(t)};
            }
        } else if (t < leaves) {
            leaves = t;
        }
    }
    const double slack = 8 * kDoubleDoubleRoundoff * (enters.high < 0 ? -enters.high : enters.high);
    if (!contact.touched() || leaves + Real(slack) < enters) return {};
    contact.index = side_at(sweep, polygon, contact.t);
    return contact;
}

/// When a particle crosses the plane: without the normal's length, which takes longer than all else.
Entry cross_plane(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const double rise = std::fabs(dot(sweep.direction, polygon.normal));
    if (rise >= sweep.direction_length * kShallowSine * polygon.normal_length) {
        const double t = std::fabs(dot(sweep.start - polygon.corners[0], polygon.normal)) / rise;
        if (!near_end(t, sweep.end)) return t > sweep.end ? Entry{} : Entry{Entry::kFound, t};
    }
    return enter_plane_precisely(sweep, 0, polygon, facing);
}

/// A start that is off a plane at all is off by more than 2^-340 m times the normal; so a path below this never gets
/// there, and its products would underflow.
constexpr double kTooShortToCross = 0x1p-400;

}  // namespace

bool line_meets_polygon(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const auto corners = polygon.corners;
    const Vec3* a = &corners.back();
    Projected pa = project(sweep, *a);
    for (const Vec3& b : corners) {
        const Projected pb = project(sweep, b);
        if (edge_side(sweep, *a, pa, b, pb) * facing < 0) return false;
        a = &b;
        pa = pb;
    }
    return true;
}

Contact cast_particle_polygon(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const int side = exact_plane_side(sweep.start, polygon);
    if (facing == 0) {
        if (side != 0) return {};
        const Closest closest = closest_to(sweep.start - polygon.corners[0], polygon);
        const bool on_it = nearness(sweep.start, 0, sweep.direction, facing, polygon, closest).on_it;
        return on_it ? Contact{} : cast_in_plane(sweep, polygon);
    }
    if (side == facing) return {};  // beyond the plane, moving away
    if (!line_meets_polygon(sweep, polygon, facing)) return {};
    if (side == 0) return {Status::kInitialOverlap, Feature::kFace, 0, 0};
    if (sweep.end < kTooShortToCross) return {};
    if (exact_plane_side(sweep.start, sweep.direction * sweep.end, polygon) == side) return {};

    const Entry entry = cross_plane(sweep, polygon, facing);
    const double t = entry.kind == Entry::kFound ? entry.t : sweep.end;  // beyond the end by rounding only
    return {t > 0 ? Status::kHit : Status::kInitialOverlap, Feature::kFace, 0, t};
}

}  // namespace firma
