// SPDX-License-Identifier: MIT
// A hull that moves against a polygon, as a particle that moves against their Minkowski sum: the sum's facets.
//
// With corners o_i of the hull around the particle and corners v_k of the polygon, the hull at q shares a point with
// the polygon when q lies in the sum of all v_k - o_i. That is convex; its facets have the directions u of
//     the polygon's plane, both ways                           u = n, -n
//     the hull's triangles, turned about                       u = -N
//     an edge e of the polygon and an edge g of the hull       u = sign(g.n) (e x g)
// The last is a facet when e.N of the triangles left and right of g have the signs of g.n and of -g.n: then u lies
// between directions that both edges support. Everywhere q is at u.(q + o_i - v_k) from the facet, for the lowest o_i
// and the highest v_k along u: above 0 is outside. All of these are triple products of differences of corners, so each
// sign can be decided exactly. Source: E. Gilbert, D. Johnson, S. Keerthi, 1988 (the sum); D. Gregorius, The Separating
// Axis Test between Convex Polyhedra, GDC 2013 (edges by arcs).
#pragma once

#include "cast/hull_shape.h"
#include "cast/sweep.h"
#include "cast/vector_of.h"
#include "geometry/polygon_shape.h"

namespace firma {

/// A facet of the sum.
struct SumFacet {
    enum Kind : std::uint8_t { kPlane, kTriangle, kEdges };
    Kind kind = kPlane;
    std::int8_t turn = 1;   ///< the sign in front of n, or of e x g
    std::uint8_t hull = 0;  ///< triangle or edge of the hull
    std::uint8_t side = 0;  ///< edge of the polygon
    Vec3 direction;         ///< u, rounded
    Vec3 error;             ///< bound on what rounding did to each of its coordinates
};

/// A number and a bound on its error.
struct Estimate {
    double value = 0, error = 0;
    int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }  ///< 0: left open
};

class HullAgainstPolygon {
public:
    /// All three must outlive this.
    HullAgainstPolygon(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon)
        : sweep_(sweep), hull_(hull), polygon_(polygon) {}

    /// Calls function(facet) until it returns false.
    template <class Function>
    bool each_facet(const Function& function) const {
        const double slack = rounding(2);
        const Vec3& n = polygon_.normal;
        for (const int turn : {1, -1}) {
            const Vec3 error{std::fabs(n.x) * slack, std::fabs(n.y) * slack, std::fabs(n.z) * slack};
            if (!function(SumFacet{SumFacet::kPlane, std::int8_t(turn), 0, 0, n * turn, error})) return false;
        }
        for (std::size_t t = 0; t < hull_.triangles.size(); ++t) {
            const HullShape::Triangle& triangle = hull_.triangles[t];
            if (!function(SumFacet{SumFacet::kTriangle, 1, std::uint8_t(t), 0, -triangle.normal, triangle.error}))
                return false;
        }
        for (std::size_t g = 0; g < hull_.edges.size(); ++g) {
            const int rise = sign_along_normal(hull_.edges[g]);
            if (rise == 0) continue;
            for (std::size_t k = 0; k < polygon_.corners.size(); ++k) {
                const Vec3 e = side(k);
                if (sign_of_normal_along(hull_.edges[g].left, e) != rise ||
                    sign_of_normal_along(hull_.edges[g].right, e) != -rise)
                    continue;
                if (!function(facet_of_edges(g, k, rise))) return false;
            }
        }
        return true;
    }

    /// How far outside of the facet the hull is after `travelled` of the path, which is 0 or sweep.end; by double.
    Estimate outside(const SumFacet& facet) const;
    /// How that changes with the sweep's parameter.
    Estimate change(const SumFacet& facet) const;
    /// The sign of the same, exactly.
    int outside_exactly(const SumFacet& facet, double travelled) const;
    int change_exactly(const SumFacet& facet) const;

    /// In double-double: how far outside at the start, the change, and the length of the facet's direction.
    struct Precise {
        DoubleDouble outside, change, length;
        VectorOf<DoubleDouble> direction;
    };
    Precise precisely(const SumFacet& facet) const;

    /// Whether the particle's line meets the sum, exactly: by the shadows of hull and polygon along the path.
    /// @param facing  sign of direction . normal
    bool line_meets(int facing) const;

    const HullShape& hull() const { return hull_; }
    const PolygonShape& polygon() const { return polygon_; }
    const Sweep& sweep() const { return sweep_; }

private:
    /// Exact: corners lie on the grid.
    Vec3 side(std::size_t k) const { return polygon_.corners[polygon_.next(k)] - polygon_.corners[k]; }
    SumFacet facet_of_edges(std::size_t g, std::size_t k, int rise) const;
    int sign_along_normal(const HullShape::Edge& edge) const;
    int sign_of_normal_along(std::size_t triangle, const Vec3& e) const;
    /// Calls function(v_k, o_i) for the corners of which the lowest o_i and the highest v_k are among, until it returns
    /// false.
    template <class Function>
    void each_support(const SumFacet& facet, const Function& function) const;
    int sign_of_facet(const SumFacet& facet, const SumVec<4>& w) const;
    SumVec<4> offset(const Vec3& v, const Vec3& o, double travelled) const;

    const Sweep& sweep_;
    const HullShape& hull_;
    const PolygonShape& polygon_;
};

}  // namespace firma
