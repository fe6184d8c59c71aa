// SPDX-License-Identifier: MIT
// Hulls against polygons, judged by the exact oracle: on lattices, where all ties there are come up, and anywhere.
#include <gtest/gtest.h>

#include <string>

#include "cast/hull_shape.h"
#include "tests/reference/judge_shapes.h"

namespace {

using namespace firma;
using namespace firma::reference;
using scenes::Rng;

constexpr std::uint64_t kHullCasts = 400;  // full_shapes judges many more

Vec3 lattice_point(Rng& rng, int reach, double step) {
    const auto one = [&] { return (double(rng.below(std::uint32_t(2 * reach + 1))) - reach) * step; };
    return {one(), one(), one()};
}

class HullCasts : public testing::TestWithParam<ShapeFamily> {};

TEST_P(HullCasts, AreWhatTheOracleSays) {
    const ShapeTally tally = judge_shapes(GetParam(), 17, kHullCasts);
    EXPECT_EQ(tally.wrong, 0u) << tally.first_failure;
    EXPECT_GT(tally.hits, tally.casts / 50);
    EXPECT_GT(tally.misses, tally.casts / 50);
    EXPECT_GT(tally.overlaps, 0u);
    EXPECT_LE(tally.excused, tally.casts / 20);
}

INSTANTIATE_TEST_SUITE_P(Families, HullCasts, testing::ValuesIn(hull_families().begin(), hull_families().end()),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(HullShapes, AreClosedAndHoldAllPoints) {
    Rng rng(5);
    for (int k = 0; k < 300; ++k) {
        std::vector<Vec3> points;
        const std::uint32_t count = 4 + rng.below(61);
        for (std::uint32_t i = 0; i < count; ++i)
            points.push_back(k % 3 == 0   ? lattice_point(rng, 2, 1)
                             : k % 3 == 1 ? rng.direction()
                                          : lattice_point(rng, 1, 1));
        const Result<HullShape> made = shape_of_hull(points);
        if (!made.ok()) continue;
        const HullShape& hull = made.value();
        ASSERT_EQ(hull.triangles.size(), 2 * hull.corners.size() - 4);
        ASSERT_EQ(hull.edges.size(), 3 * hull.corners.size() - 6);
        for (const HullShape::Triangle& t : hull.triangles) {
            ASSERT_GT(length(t.normal), 0);
            for (const Vec3& p : points)
                ASSERT_LE(exact_triple_sign(difference_as_sum(p, hull.corners[t.corner[0]]), hull.side(t, 1),
                                            hull.side(t, 2)),
                          0);
        }
        for (const Vec3& p : points) ASSERT_LE(length(p), hull.reach);
    }
}

TEST(HullShapes, SayWhatIsWrong) {
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(shape_of_hull(flat).error().code, ErrorCode::kInvalid);
    EXPECT_EQ(shape_of_hull({}).error().code, ErrorCode::kInvalid);
    EXPECT_EQ(shape_of_hull(std::vector<Vec3>(65)).error().code, ErrorCode::kTooLarge);
    EXPECT_EQ(shape_of_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}).error().code,
              ErrorCode::kOutOfRange);
}

}  // namespace
