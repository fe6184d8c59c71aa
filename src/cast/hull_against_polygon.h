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
    struct Name {
        Kind kind = kPlane;
        std::int8_t turn = 1;   ///< the sign in front of n, or of e x g
        std::uint8_t hull = 0;  ///< triangle or edge of the hull
        std::uint8_t side = 0;  ///< edge of the polygon

        /// All of it in a number, and back.
        std::uint32_t code() const {
            return std::uint32_t(kind) | std::uint32_t(turn > 0) << 8 | std::uint32_t(hull) << 16 |
                   std::uint32_t(side) << 24;
        }
        static Name of(std::uint32_t code) {
            return {Kind(code & 0xff), std::int8_t(code >> 8 & 1 ? 1 : -1), std::uint8_t(code >> 16),
                    std::uint8_t(code >> 24)};
        }
    };
    Name name;
    Vec3 direction;  ///< u, rounded
    Vec3 error;      ///< bound on what rounding did to each of its coordinates

    Kind kind() const { return name.kind; }
};

/// A number and a bound on its error.
struct Estimate {
    double value = 0, error = 0;
    int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }  ///< 0: left open
};

class HullAgainstPolygon {
public:
    /// All three must outlive this.
    HullAgainstPolygon(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon);

    /// Calls function(facet) until it returns false.
    template <class Function>
    bool each_facet(const Function& function) const {
        for (const int turn : {1, -1})
            if (!function(facet({SumFacet::kPlane, std::int8_t(turn), 0, 0}))) return false;
        for (std::size_t t = 0; t < hull_.triangles.size(); ++t)
            if (!function(facet({SumFacet::kTriangle, 1, std::uint8_t(t), 0}))) return false;
        std::int8_t rise[HullShape::kMaxEdges], along[HullShape::kMaxTriangles];
        for (std::size_t g = 0; g < hull_.edges.size(); ++g) rise[g] = sign_along_normal(hull_.edges[g]);
        for (std::size_t k = 0; k < polygon_.corners.size(); ++k) {
            const Vec3 e = side(k);
            for (std::size_t t = 0; t < hull_.triangles.size(); ++t) along[t] = sign_of_normal_along(t, e);
            for (std::size_t g = 0; g < hull_.edges.size(); ++g) {
                const HullShape::Edge& edge = hull_.edges[g];
                if (rise[g] == 0 || along[edge.left] != rise[g] || along[edge.right] != -rise[g]) continue;
                if (!function(facet({SumFacet::kEdges, rise[g], std::uint8_t(g), std::uint8_t(k)}))) return false;
            }
        }
        return true;
    }

    SumFacet facet(const SumFacet::Name& name) const;

    /// How far outside of the facet the hull is after `travelled` of the path, which is 0 or sweep.end; by double.
    Estimate outside(const SumFacet& facet) const;
    /// The same, told how low the hull's lowest corner is less the polygon's highest, along the facet's direction.
    Estimate outside_by(const SumFacet& facet, double support) const;
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
    /// Its direction alone.
    VectorOf<DoubleDouble> direction_precisely(const SumFacet::Name& name) const;

    /// Whether the particle's line meets the sum, exactly: by the shadows of hull and polygon along the path.
    /// @param facing  sign of direction . normal
    bool line_meets(int facing) const;

    const HullShape& hull() const { return hull_; }
    const PolygonShape& polygon() const { return polygon_; }
    const Sweep& sweep() const { return sweep_; }
    /// Where the hull is put at the start, from the polygon's first corner, rounded once.
    const Vec3& seen() const { return seen_; }
    /// Of that, of the hull's corners and of the polygon's from its first, in sum.
    const Vec3& sizes() const { return sizes_; }

private:
    /// Exact: corners lie on the grid.
    Vec3 side(std::size_t k) const { return polygon_.corners[polygon_.next(k)] - polygon_.corners[k]; }
    std::int8_t sign_along_normal(const HullShape::Edge& edge) const;
    std::int8_t sign_of_normal_along(std::size_t triangle, const Vec3& e) const;
    /// Calls function(v_k, o_i) for the corners of which the lowest o_i and the highest v_k are among, until it returns
    /// false.
    template <class Function>
    void each_support(const SumFacet& facet, const Function& function) const;
    int sign_of_facet(const SumFacet& facet, const SumVec<4>& w) const;
    SumVec<4> offset(const Vec3& v, const Vec3& o, double travelled) const;

    const Sweep& sweep_;
    const HullShape& hull_;
    const PolygonShape& polygon_;
    Vec3 seen_, sizes_;
};

}  // namespace firma
