// SPDX-License-Identifier: MIT
// A convex hull made ready for casts: its corners, triangles and edges, decided exactly when it is made.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cast/shape_extent.h"
#include "firma/hull.h"
#include "firma/result.h"
#include "firma/vec.h"
#include "geometry/exact_triple.h"

namespace firma {

struct HullShape {
    /// Corners counter-clockwise seen from outside. Triangles may lie in one plane.
    struct Triangle {
        std::array<std::uint8_t, 3> corner;
        Vec3 normal;  ///< outward, rounded
        Vec3 error;   ///< bound on what rounding did to each coordinate of it
        Vec3 doubt;   ///< the same, and on what rounding does in a product with it, for each part of the other
    };
    /// Counter-clockwise around the triangle on its left, seen from outside.
    struct Edge {
        std::uint8_t from, to;
        std::uint8_t left, right;  ///< triangles
        Vec3 along;                ///< rounded
    };

    std::vector<Vec3> corners;  ///< from where the hull is put, metres
    std::vector<Triangle> triangles;
    std::vector<Edge> edges;
    double reach = 0;    ///< no corner is farther from the origin
    Vec3 sizes;          ///< nor farther along an axis
    ShapeExtent extent;  ///< the box along the axes

    static constexpr std::size_t kMaxTriangles = 2 * kMaxHullCorners - 4, kMaxEdges = 3 * kMaxHullCorners - 6;

    SumVec<2> side(const Triangle& triangle, int which) const {
        return difference_as_sum(corners[triangle.corner[std::size_t(which)]], corners[triangle.corner[0]]);
    }
    SumVec<2> along(const Edge& edge) const { return difference_as_sum(corners[edge.to], corners[edge.from]); }
};

/// The hull of up to kMaxHullCorners points; points inside it are left out. Costs some microseconds for a box,
/// some hundred for 64 corners; allocates.
/// @return kTooLarge for too many points; kOutOfRange for a number that is not finite or beyond 2^199; kInvalid for
///         points that lie in one plane
Result<HullShape> shape_of_hull(std::span<const Vec3> points);

}  // namespace firma
