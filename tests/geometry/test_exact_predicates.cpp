// SPDX-License-Identifier: MIT
// Signs against rational numbers: random ones, and those that are zero or a hair from it.
#include "geometry/exact_predicates.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "firma/grid.h"
#include "scenes/rng.h"

namespace firma {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Exact {
    Rational x, y, z;
    Exact(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
    Exact(Rational a, Rational b, Rational c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
};

Exact operator-(const Exact& a, const Exact& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Exact operator+(const Exact& a, const Exact& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Rational dot(const Exact& a, const Exact& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Exact cross(const Exact& a, const Exact& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
int sign(const Rational& r) {
    return r < 0 ? -1 : r > 0 ? 1 : 0;
}

Exact normal(const std::vector<Vec3>& c) {
    return cross(Exact(c[1]) - Exact(c[0]), Exact(c[2]) - Exact(c[0]));
}

Vec3 random_corner(scenes::Rng& rng, double steps, double size) {
    const auto coordinate = [&] { return std::floor(rng.uniform(-size, size) * steps) / steps; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
}

/// A direction as a Sweep has it: largest coordinate in [1, 2).
Vec3 random_direction(scenes::Rng& rng) {
    const Vec3 v = rng.direction();
    return v * (rng.uniform(1, 1.99) / max_abs(v));
}

class ExactPredicates : public testing::TestWithParam<double> {};  // grid steps in a metre

TEST_P(ExactPredicates, AgreeWithRationals) {
    scenes::Rng rng(11);
    const double steps = GetParam();
    int zeros = 0;
    for (int k = 0; k < 20000; ++k) {
        const double size = std::ldexp(1.0, int(rng.below(22)) - 9);  // up to 8192 m
        const std::vector<Vec3> corners{random_corner(rng, steps, size), random_corner(rng, steps, size),
                                        random_corner(rng, steps, size)};
        const Exact n = normal(corners);
        if (n.x == 0 && n.y == 0 && n.z == 0) continue;
        const PolygonShape polygon = make_shape(corners);
        Vec3 direction = random_direction(rng),
             point{rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size)};
        switch (rng.below(5)) {
            case 0:
                direction = corners[1] - corners[0];
                break;  // along an edge: exactly 0
            case 1:
                point = corners[rng.below(3)];
                break;  // at a corner
            case 2:
                point = (corners[0] + corners[1]) * 0.5;
                break;  // on an edge
            case 3:
                point = point - polygon.unit_normal() * (dot(point - corners[0], polygon.unit_normal()));
                break;  // a hair off
            default:
                break;
        }
        ASSERT_EQ(exact_facing(direction, polygon), sign(dot(Exact(direction), n)));
        ASSERT_EQ(exact_plane_side(point, polygon), sign(dot(Exact(point) - Exact(corners[0]), n)));
        const Vec3 offset = rng.chance(0.5) ? direction : corners[2] - point;
        ASSERT_EQ(exact_plane_side(point, offset, polygon),
                  sign(dot(Exact(point) + Exact(offset) - Exact(corners[0]), n)));
        zeros += exact_plane_side(point, polygon) == 0;

        const Vec3 aim = rng.chance(0.5) ? corners[0] - point : direction;  // through a corner, or anywhere
        const int expected =
            sign(dot(Exact(aim), cross(Exact(corners[0]) - Exact(point), Exact(corners[1]) - Exact(point))));
        ASSERT_EQ(exact_edge_side(point, aim, corners[0], corners[1]), expected);
    }
    EXPECT_GT(zeros, 1000) << "the test must meet the degenerate cases it is for";
}

INSTANTIATE_TEST_SUITE_P(Grids, ExactPredicates, testing::Values(kInputSteps, kSurfaceSteps));

TEST(ExactNormal, IsExactAtTheRangesRim) {
    const double end = kWorldRim - 1 / kSurfaceSteps;
    const std::vector<Vec3> corners{
        {-kWorldRim, -kWorldRim, -kWorldRim}, {end, -kWorldRim, end}, {-kWorldRim, end, end - 3 / kSurfaceSteps}};
    const ExactNormal n = exact_normal(corners);
    const Exact want = normal(corners);
    EXPECT_EQ(Rational(n.axis[0][0]) + Rational(n.axis[0][1]), want.x);
    EXPECT_EQ(Rational(n.axis[1][0]) + Rational(n.axis[1][1]), want.y);
    EXPECT_EQ(Rational(n.axis[2][0]) + Rational(n.axis[2][1]), want.z);
}

TEST(MakeShape, RoundsEachComponentAtMostOnce) {
    scenes::Rng rng(12);
    for (int k = 0; k < 5000; ++k) {
        const double steps = rng.chance(0.5) ? kInputSteps : kSurfaceSteps;
        const std::vector<Vec3> corners{random_corner(rng, steps, 8191), random_corner(rng, steps, 8191),
                                        random_corner(rng, steps, 8191)};
        const PolygonShape polygon = make_shape(corners);
        const Exact want = normal(corners);
        ASSERT_EQ(polygon.normal.x, double(want.x));
        ASSERT_EQ(polygon.normal.y, double(want.y));
        ASSERT_EQ(polygon.normal.z, double(want.z));
    }
}

}  // namespace
}  // namespace firma
