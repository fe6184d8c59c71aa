// SPDX-License-Identifier: MIT
// Signs against rational numbers: random ones, and those that are zero or a hair from it.
#include "geometry/exact_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "firma/grid.h"
#include "geometry/whole_path.h"
#include "scenes/rng.h"
#include "tests/geometry/grid_corners.h"
#include "tests/sample.h"

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

int edge_side_of_rationals(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b) {
    const Exact s(start);
    return sign(dot(Exact(direction), cross(Exact(a) - s, Exact(b) - s)));
}

/// Numbers whose lowest bits lie any way from their highest.
double random_number(scenes::Rng& rng, double size) {
    const double any = rng.uniform(-size, size);
    switch (rng.below(5)) {
        case 0:
            return double(float(any));
        case 1:
            return std::floor(any * kInputSteps) / kInputSteps;
        case 2:
            return any * std::ldexp(1.0, -int(rng.below(70)));
        case 3:
            return 0;
        default:
            return any;
    }
}

Vec3 random_point(scenes::Rng& rng, double size) {
    const double x = random_number(rng, size), y = random_number(rng, size), z = random_number(rng, size);
    return {x, y, z};
}

/// The largest coordinate in [1, 2), by a power of two: as a Sweep has it.
Vec3 as_direction(const Vec3& path) {
    return path * std::ldexp(1.0, -std::ilogb(max_abs(path)));
}

struct EdgeTally {
    int all = 0, zeros = 0;  ///< edges
    int whole = 0;           ///< triangles beside a WholePath
};

void check_edges(const Vec3& start, const Vec3& direction, const Vec3 (&corners)[3], EdgeTally& tally) {
    int side[3];
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = corners[k], &b = corners[(k + 1) % 3];
        side[k] = edge_side_of_rationals(start, direction, a, b);
        ASSERT_EQ(exact_edge_side(start, direction, a, b), side[k]);
        ASSERT_EQ(exact_edge_side(start, direction, b, a), -side[k]);
        ++tally.all;
        tally.zeros += side[k] == 0;
    }
    const WholePath whole(start, direction);
    if (!whole.known()) return;
    ++tally.whole;
    for (const Vec3& c : corners)
        if (max_abs(c) >= kWorldRim) return;  // no point of the grid is so far
    GridPoint on_grid[3];
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) on_grid[k][axis] = std::int32_t(corners[k][axis] * kSurfaceSteps);
    for (unsigned open = 1; open < 8; ++open) {
        unsigned signs = 0;
        for (int k = 0; k < 3; ++k)
            if (open >> k & 1) signs |= side[k] > 0 ? kSomePositive : side[k] < 0 ? kSomeNegative : 0u;
        ASSERT_EQ(whole.triangle_sides(GridCorners{on_grid}, open), signs) << "edges " << open;
    }
}

TEST(ExactEdges, AgreeWithRationals) {
    scenes::Rng rng(13);
    EdgeTally tally;
    for (int k = 0; k < test::sample(30000); ++k) {
        const double steps = rng.chance(0.5) ? kInputSteps : kSurfaceSteps;
        const double size = std::ldexp(1.0, int(rng.below(22)) - 8);  // up to 8192 m
        Vec3 corners[3] = {random_corner(rng, steps, size), random_corner(rng, steps, size),
                           random_corner(rng, steps, size)};
        if (rng.chance(0.3)) corners[1][int(rng.below(3))] = corners[0].x;
        if (rng.chance(0.1)) corners[0] = {kWorldRim, -kWorldRim, kWorldRim};
        if (rng.chance(0.1)) corners[1] = {-kWorldRim, kWorldRim, 1 / kSurfaceSteps - kWorldRim};
        Vec3 start = random_point(rng, rng.chance(0.8) ? size * 2 : 0x1p20);
        if (rng.chance(0.1)) start[int(rng.below(3))] = std::ldexp(rng.uniform(-1, 1), int(rng.below(90)) - 245);
        // Through a corner, an edge's middle or end, a hair beside them, or anywhere.
        const double share = std::ldexp(double(rng.below(5)), -2);
        Vec3 path = corners[0] + (corners[1] - corners[0]) * share - start;
        if (rng.chance(0.3)) path[int(rng.below(3))] *= 1 + std::ldexp(rng.uniform(-1, 1), -int(rng.below(60)));
        if (rng.chance(0.2)) path = {double(float(path.x)), double(float(path.y)), double(float(path.z))};
        if (rng.chance(0.2)) path = random_point(rng, 1);
        if (rng.chance(0.1)) path = corners[1] - corners[0];
        if (rng.chance(0.1)) path[int(rng.below(3))] = std::ldexp(rng.uniform(1, 2), int(rng.below(90)) - 245);
        if (!(max_abs(path) > 0)) continue;
        check_edges(start, as_direction(path), corners, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.zeros, tally.all / 20);
    EXPECT_LT(tally.zeros, tally.all / 2);
    EXPECT_GT(3 * tally.whole, tally.all / 20);
}

/// From starts so far away, or so near to nothing, that no whole numbers hold them beside the corners.
TEST(ExactEdges, AgreeWithRationalsAtTheRangesEnds) {
    scenes::Rng rng(14);
    EdgeTally tally;
    const auto number = [&] {
        const double size = rng.chance(0.5) ? rng.uniform(1, 2) : 1;
        return std::ldexp(rng.chance(0.5) ? size : -size, int(rng.below(450)) - 250);
    };
    for (int k = 0; k < test::sample(5000); ++k) {
        const Vec3 corners[3] = {random_corner(rng, kSurfaceSteps, 8191), random_corner(rng, kInputSteps, 2),
                                 rng.chance(0.5) ? Vec3{} : random_corner(rng, kSurfaceSteps, 1)};
        Vec3 start, path;
        for (int axis = 0; axis < 3; ++axis) {
            if (rng.chance(0.7)) start[axis] = number();
            if (rng.chance(0.7)) path[axis] = number();
        }
        if (rng.chance(0.4)) path = corners[rng.below(3)] - start;
        if (!(max_abs(path) > 0)) continue;
        Vec3 direction = as_direction(path);
        for (int axis = 0; axis < 3; ++axis)
            if (std::fabs(direction[axis]) < 0x1p-250) direction[axis] = 0;
        check_edges(start, direction, corners, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.zeros, 100);
}

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
