// SPDX-License-Identifier: MIT
// Signs and distances of the facets of the Minkowski sum of a hull and a polygon.
#include "cast/hull_against_polygon.h"

#include <cmath>

#include "cast/cast_sphere_face.h"
#include "cast/sizes_of.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// u . w for a u and a w that are off by so much. Twice what the terms add up to, for the second order.
Estimate dot_estimate(const Vec3& u, const Vec3& u_error, const Vec3& w, const Vec3& w_error) {
    const Vec3 us = sizes_of(u), ws = sizes_of(w);
    return {dot(u, w), 2 * (dot(u_error, ws + w_error) + dot(us, w_error) + rounding(4) * dot(us, ws))};
}

SumVec<2> as_sum(const ExactNormal& normal, double turn) {
    SumVec<2> sum;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < 2; ++k) sum.at[axis][k] = turn * normal.axis[axis][k];
    return sum;
}

/// Sign of d . (b x w), by double where that is sure. `b` may be rounded once, `w_sizes` bounds what w was made from.
template <int parts_b, int parts_w>
int triple_sign(const Vec3& d, const Vec3& b, const Vec3& w, const Vec3& w_sizes, const SumVec<parts_b>& exact_b,
                const SumVec<parts_w>& exact_w) {
    const double estimate = dot(d, cross(b, w));
    const Vec3 p = sizes_of(b), q = w_sizes, a = sizes_of(d);
    const Vec3 size{p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
    if (std::fabs(estimate) > rounding(32) * dot(a, size)) return estimate > 0 ? 1 : -1;
    return exact_triple_sign(as_sum(d), exact_b, exact_w);
}

}  // namespace

HullAgainstPolygon::HullAgainstPolygon(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon)
    : sweep_(sweep), hull_(hull), polygon_(polygon), seen_(sweep.start - polygon.corners[0]) {
    Vec3 far;
    for (const Vec3& corner : polygon.corners) {
        const Vec3 from_first = sizes_of(corner - polygon.corners[0]);
        for (int axis = 0; axis < 3; ++axis)
            if (from_first[axis] > far[axis]) far[axis] = from_first[axis];
    }
    sizes_ = sizes_of(seen_) + hull.sizes + far;
}

std::int8_t HullAgainstPolygon::sign_along_normal(const HullShape::Edge& edge) const {
    const Vec3& n = polygon_.normal;
    const double estimate = dot(n, edge.along), error = rounding(6) * dot(sizes_of(n), sizes_of(edge.along));
    if (std::fabs(estimate) > error) return estimate > 0 ? 1 : -1;
    if (error == 0) return 0;  // each product is
    return std::int8_t(exact_dot_sign(as_sum(exact_normal(polygon_.corners), 1), hull_.along(edge)));
}

std::int8_t HullAgainstPolygon::sign_of_normal_along(std::size_t t, const Vec3& e) const {
    const HullShape::Triangle& triangle = hull_.triangles[t];
    const double estimate = dot(triangle.normal, e), error = dot(triangle.doubt, sizes_of(e));
    if (std::fabs(estimate) > error) return estimate > 0 ? 1 : -1;
    if (error == 0) return 0;  // each product is
    return std::int8_t(exact_triple_sign(firma::as_sum(e), hull_.side(triangle, 1), hull_.side(triangle, 2)));
}

SumFacet HullAgainstPolygon::facet(const SumFacet::Name& name) const {
    if (name.kind == SumFacet::kPlane) {
        const Vec3& n = polygon_.normal;
        return {name, n * name.turn, sizes_of(n) * rounding(2)};
    }
    if (name.kind == SumFacet::kTriangle) {
        const HullShape::Triangle& triangle = hull_.triangles[name.hull];
        return {name, -triangle.normal, triangle.error};
    }
    const Vec3 e = side(name.side), &along = hull_.edges[name.hull].along;
    return {name, cross(e, along) * name.turn, sizes_of_cross(e, along) * rounding(4)};
}

template <class Function>
void HullAgainstPolygon::each_support(const SumFacet& facet, const Function& function) const {
    const Vec3& v = polygon_.corners[facet.name.side];
    if (facet.kind() == SumFacet::kPlane) {
        for (const Vec3& o : hull_.corners)
            if (!function(v, o)) return;
    } else if (facet.kind() == SumFacet::kTriangle) {
        const Vec3& o = hull_.corners[hull_.triangles[facet.name.hull].corner[0]];
        for (const Vec3& corner : polygon_.corners)
            if (!function(corner, o)) return;
    } else {
        function(v, hull_.corners[hull_.edges[facet.name.hull].from]);
    }
}

Estimate HullAgainstPolygon::outside(const SumFacet& facet) const {
    const Vec3& u = facet.direction;
    double support = 0;  // of the lowest corner of the hull, less that of the highest of the polygon
    if (facet.kind() == SumFacet::kPlane) {
        support = dot(u, hull_.corners[0]);
        for (const Vec3& o : hull_.corners) {
            const double here = dot(u, o);
            if (here < support) support = here;
        }
    } else if (facet.kind() == SumFacet::kTriangle) {
        double highest = 0;
        for (const Vec3& corner : polygon_.corners) {
            const double here = dot(u, corner - polygon_.corners[0]);
            if (here > highest) highest = here;
        }
        support = dot(u, hull_.corners[hull_.triangles[facet.name.hull].corner[0]]) - highest;
    } else {
        const Vec3& v = polygon_.corners[facet.name.side];
        support = dot(u, hull_.corners[hull_.edges[facet.name.hull].from]) - dot(u, v - polygon_.corners[0]);
    }
    return outside_by(facet, support);
}

Estimate HullAgainstPolygon::outside_by(const SumFacet& facet, double support) const {
    const Vec3& u = facet.direction;
    return {dot(u, seen_) + support, dot(facet.error + sizes_of(u) * rounding(8), sizes_)};
}

Estimate HullAgainstPolygon::change(const SumFacet& facet) const {
    const Vec3& d = sweep_.direction;
    return {dot(facet.direction, d), dot(facet.error + sizes_of(facet.direction) * rounding(4), sizes_of(d))};
}

int HullAgainstPolygon::sign_of_facet(const SumFacet& facet, const SumVec<4>& w) const {
    if (facet.kind() == SumFacet::kPlane)
        return exact_dot_sign(as_sum(exact_normal(polygon_.corners), facet.name.turn), w);
    if (facet.kind() == SumFacet::kTriangle) {
        const HullShape::Triangle& triangle = hull_.triangles[facet.name.hull];
        return -exact_triple_sign(w, hull_.side(triangle, 1), hull_.side(triangle, 2));
    }
    return facet.name.turn *
           exact_triple_sign(w, firma::as_sum(side(facet.name.side)), hull_.along(hull_.edges[facet.name.hull]));
}

SumVec<4> HullAgainstPolygon::offset(const Vec3& v, const Vec3& o, double travelled) const {
    SumVec<4> w;
    for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble seen = two_difference(sweep_.start[axis], v[axis]);
        w.at[axis][0] = seen.high;
        w.at[axis][1] = seen.low;
        w.at[axis][2] = o[axis];
        w.at[axis][3] = travelled == 0 ? 0 : sweep_.direction[axis] * travelled;  // a power of two: exact
    }
    return w;
}

int HullAgainstPolygon::outside_exactly(const SumFacet& facet, double travelled) const {
    int lowest = 1;
    each_support(facet, [&](const Vec3& v, const Vec3& o) {
        const Vec3 seen = sweep_.start - v, moved = seen + o, along = sweep_.direction * travelled, w = moved + along;
        const Estimate here = dot_estimate(facet.direction, facet.error, w,
                                           (sizes_of(seen) + sizes_of(moved) + sizes_of(w)) * rounding(1));
        const int sign = here.sign() != 0 ? here.sign() : sign_of_facet(facet, offset(v, o, travelled));
        if (sign < lowest) lowest = sign;
        return lowest >= 0;
    });
    return lowest;
}

int HullAgainstPolygon::change_exactly(const SumFacet& facet) const {
    const Estimate estimate = change(facet);
    if (estimate.sign() != 0) return estimate.sign();
    SumVec<4> d{};
    for (int axis = 0; axis < 3; ++axis) d.at[axis][0] = sweep_.direction[axis];
    return sign_of_facet(facet, d);
}

VectorOf<DoubleDouble> HullAgainstPolygon::direction_precisely(const SumFacet::Name& name) const {
    using Real = DoubleDouble;
    if (name.kind == SumFacet::kPlane) return precise_normal(polygon_) * Real(name.turn);
    if (name.kind == SumFacet::kTriangle) {
        const auto& corner = hull_.triangles[name.hull].corner;
        const Vec3& a = hull_.corners[corner[0]];
        return cross(difference<Real>(hull_.corners[corner[2]], a), difference<Real>(hull_.corners[corner[1]], a));
    }
    const HullShape::Edge& edge = hull_.edges[name.hull];
    return cross(exactly<Real>(side(name.side)), difference<Real>(hull_.corners[edge.to], hull_.corners[edge.from])) *
           Real(name.turn);
}

HullAgainstPolygon::Precise HullAgainstPolygon::precisely(const SumFacet& facet) const {
    using Real = DoubleDouble;
    Precise precise;
    precise.direction = direction_precisely(facet.name);
    const VectorOf<Real>& u = precise.direction;
    bool any = false;
    each_support(facet, [&](const Vec3& v, const Vec3& o) {
        const Real here = dot(u, difference<Real>(sweep_.start, v) + exactly<Real>(o));
        if (!any || here < precise.outside) precise.outside = here;
        return any = true;
    });
    precise.change = dot(u, exactly<Real>(sweep_.direction));
    precise.length = square_root(dot(u, u));
    return precise;
}

bool HullAgainstPolygon::line_meets(int facing) const {
    const Vec3& d = sweep_.direction;
    const auto side_of = [&](const Vec3& b, const auto& exact_b, const Vec3& v, const Vec3& o) {
        const Vec3 seen = sweep_.start - v;
        return triple_sign(d, b, seen + o, sizes_of(seen) + sizes_of(o), exact_b, offset(v, o, 0));
    };
    // Beyond a side of the polygon: with facing 0 its plane has told, and the sides are all one line.
    for (std::size_t k = 0; k < polygon_.corners.size() && facing != 0; ++k) {
        const Vec3 e = side(k);
        bool beyond = true;
        for (const Vec3& o : hull_.corners)
            if (!(beyond = side_of(e, firma::as_sum(e), polygon_.corners[k], o) == -facing)) break;
        if (beyond) return false;
    }
    // Beyond an edge of the hull's outline.
    for (const HullShape::Edge& edge : hull_.edges) {
        const int left = sign_of_normal_along(edge.left, d), right = sign_of_normal_along(edge.right, d);
        if (left * right > 0 || (left == 0 && right == 0)) continue;
        const int turn = left > 0 || right < 0 ? -1 : 1;  // turn (d x g) points out of the outline
        bool beyond = true;
        for (const Vec3& v : polygon_.corners)
            if (!(beyond = turn * side_of(edge.along, hull_.along(edge), v, hull_.corners[edge.from]) < 0)) break;
        if (beyond) return false;
    }
    return true;
}

}  // namespace firma
