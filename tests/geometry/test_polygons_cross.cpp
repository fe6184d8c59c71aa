// SPDX-License-Identifier: MIT
// Polygons that share what their mesh says, and more; against all triangles of both, by rational segments.
#include "geometry/polygons_cross.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

using Numbers = std::vector<std::uint32_t>;
using Rational = boost::multiprecision::cpp_rational;

bool crosses(const std::vector<InputPoint>& points, const Numbers& p, const Numbers& q) {
    const MeshPolygon a{p, polygon_normal(points, p)}, b{q, polygon_normal(points, q)};
    const bool result = polygons_cross(points, a, b);
    EXPECT_EQ(polygons_cross(points, b, a), result);
    const Numbers turned(q.rbegin(), q.rend());
    EXPECT_EQ(polygons_cross(points, a, {turned, polygon_normal(points, turned)}), result);
    return result;
}

/// A flat board of 3 x 3 places, z = 0, and points above and below.
const std::vector<InputPoint> kPoints = {
    {0, 0, 0}, {4, 0, 0},  {8, 0, 0}, {0, 4, 0}, {4, 4, 0},  {8, 4, 0}, {0, 8, 0}, {4, 8, 0}, {8, 8, 0},  // 0 .. 8
    {4, 2, 4}, {4, 2, -4}, {2, 2, 4}, {2, 2, 0}, {2, 2, -4}, {0, 0, 4}, {6, 6, 4}, {6, 6, 0}, {12, 0, 0}};

TEST(PolygonsCross, NeighboursDoNot) {
    EXPECT_FALSE(crosses(kPoints, {0, 1, 4, 3}, {1, 2, 5, 4})) << "in one plane";
    EXPECT_FALSE(crosses(kPoints, {0, 1, 4, 3}, {1, 4, 9})) << "at an angle";
    EXPECT_FALSE(crosses(kPoints, {0, 1, 4, 3}, {4, 5, 8, 7})) << "a corner in common";
    EXPECT_TRUE(crosses(kPoints, {0, 1, 4, 3}, {0, 14, 2})) << "a corner, and on along the side";
}

TEST(PolygonsCross, CornersAlongSidesAreCorners) {
    EXPECT_FALSE(crosses(kPoints, {0, 1, 2, 5, 4, 3}, {4, 3, 6})) << "two neighbours along one side";
    EXPECT_FALSE(crosses(kPoints, {0, 1, 2, 5, 4, 3}, {5, 4, 8}));
    EXPECT_TRUE(crosses(kPoints, {0, 1, 2, 5, 3}, {4, 3, 6})) << "a corner on a side that has none there";
}

TEST(PolygonsCross, TouchingIsCrossing) {
    EXPECT_TRUE(crosses(kPoints, {0, 1, 4, 3}, {12, 11, 14})) << "a corner on the face";
    EXPECT_TRUE(crosses(kPoints, {0, 2, 8, 6}, {1, 9, 14})) << "a corner on an edge";
    EXPECT_TRUE(crosses(kPoints, {0, 2, 8, 6}, {13, 11, 9})) << "an edge through the face";
    EXPECT_FALSE(crosses(kPoints, {0, 2, 8, 6}, {11, 9, 15})) << "above it";
    EXPECT_TRUE(crosses(kPoints, {0, 2, 6}, {1, 10, 15})) << "through an edge";
    EXPECT_FALSE(crosses(kPoints, {0, 1, 3}, {16, 15, 8})) << "of its plane, beside it";
}

TEST(PolygonsCross, OverlapsInOnePlane) {
    EXPECT_TRUE(crosses(kPoints, {0, 2, 8, 6}, {0, 1, 4, 3})) << "a corner and part of two sides";
    EXPECT_TRUE(crosses(kPoints, {0, 1, 4, 3}, {0, 1, 4, 3})) << "the same";
    EXPECT_TRUE(crosses(kPoints, {0, 1, 4, 3}, {0, 1, 3})) << "folded onto it";
    EXPECT_TRUE(crosses(kPoints, {0, 2, 8, 6}, {12, 1, 16})) << "within";
    EXPECT_TRUE(crosses(kPoints, {0, 1, 4, 3}, {4, 0, 2})) << "along a diagonal";
    EXPECT_FALSE(crosses(kPoints, {0, 1, 4, 3}, {2, 17, 5})) << "elsewhere";
}

/// Whether two triangles without common numbers share a point: the segments of each against the other, in rationals.
bool meet_by_rationals(const std::vector<InputPoint>& points, const Numbers& p, const Numbers& q) {
    const auto at = [&](std::uint32_t k, int axis) { return Rational(points[k][axis]); };
    const auto test = [&](const Numbers& t, const Numbers& u) {
        // u's plane: n . x = d
        Rational n[3], d;
        for (int x = 0; x < 3; ++x) {
            const int y = (x + 1) % 3, z = (x + 2) % 3;
            n[x] = (at(u[1], y) - at(u[0], y)) * (at(u[2], z) - at(u[0], z)) -
                   (at(u[1], z) - at(u[0], z)) * (at(u[2], y) - at(u[0], y));
        }
        for (int x = 0; x < 3; ++x) d += n[x] * at(u[0], x);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            Rational h_a = -d, h_b = -d;
            for (int x = 0; x < 3; ++x) {
                h_a += n[x] * at(a, x);
                h_b += n[x] * at(b, x);
            }
            if (h_a == h_b || (h_a > 0 && h_b > 0) || (h_a < 0 && h_b < 0)) continue;  // parallel ones: never here
            Rational x[3];
            for (int axis = 0; axis < 3; ++axis)
                x[axis] = at(a, axis) + (at(b, axis) - at(a, axis)) * h_a / (h_a - h_b);
            bool inside = true;
            for (int i = 0; i < 3; ++i) {
                Rational side;
                const std::uint32_t c = u[i], e = u[(i + 1) % 3];
                for (int w = 0; w < 3; ++w) {
                    const int y = (w + 1) % 3, z = (w + 2) % 3;
                    side +=
                        n[w] * ((at(e, y) - at(c, y)) * (x[z] - at(c, z)) - (at(e, z) - at(c, z)) * (x[y] - at(c, y)));
                }
                inside &= side >= 0;
            }
            if (inside) return true;
        }
        return false;
    };
    return test(p, q) || test(q, p);
}

TEST(PolygonsCross, AsRationalsSay) {
    scenes::Rng rng(3);
    int crossing = 0, compared = 0;
    for (int k = 0; k < 4000; ++k) {
        std::vector<InputPoint> points(6);
        const std::uint32_t span = k % 2 ? 4 : 1000;
        for (InputPoint& p : points)
            for (int axis = 0; axis < 3; ++axis) p[axis] = std::int32_t(rng.below(span + 1)) - std::int32_t(span / 2);
        const Numbers p{0, 1, 2}, q{3, 4, 5};
        const AreaVector n = polygon_normal(points, p), m = polygon_normal(points, q);
        if ((n.x == 0 && n.y == 0 && n.z == 0) || (m.x == 0 && m.y == 0 && m.z == 0)) continue;
        bool along = false;  // an edge in the other's plane: left to the cases above
        for (std::uint32_t i = 0; i < 3; ++i) {
            const auto lies_in = [&](const AreaVector& normal, std::uint32_t on, std::uint32_t a, std::uint32_t b) {
                return side_of_plane(points[on], normal, points[a]) == 0 &&
                       side_of_plane(points[on], normal, points[b]) == 0;
            };
            along |= lies_in(m, 3, i, (i + 1) % 3) || lies_in(n, 0, 3 + i, 3 + (i + 1) % 3);
        }
        if (along) continue;
        ++compared;
        const bool expected = meet_by_rationals(points, p, q);
        crossing += expected;
        EXPECT_EQ(crosses(points, p, q), expected) << k;
    }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(crossing, 400);
}

}  // namespace
}  // namespace firma
