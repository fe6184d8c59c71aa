// SPDX-License-Identifier: MIT
// Capsules against polygons: by hand, and judged by the exact oracle.
#include <gtest/gtest.h>

#include <string>

#include "firma/capsule.h"
#include "tests/reference/exact_capsule.h"
#include "tests/reference/judge_shapes.h"

namespace {

using namespace firma;
using namespace firma::reference;

constexpr std::uint64_t kCapsuleCasts = 500;  // full_shapes judges many more

class CapsuleCasts : public testing::TestWithParam<ShapeFamily> {};

TEST_P(CapsuleCasts, AreWhatTheOracleSays) {
    const ShapeTally tally = judge_shapes(GetParam(), 5, kCapsuleCasts);
    EXPECT_EQ(tally.wrong, 0u) << tally.first_failure;
    EXPECT_GT(tally.hits + tally.overlaps, tally.casts / 50);
    EXPECT_GT(tally.misses, tally.casts / 50);
    EXPECT_LE(tally.excused, tally.casts / 50);
}

INSTANTIATE_TEST_SUITE_P(Families, CapsuleCasts,
                         testing::ValuesIn(capsule_families().begin(), capsule_families().end()),
                         [](const auto& of) { return std::string(of.param.name); });

const std::vector<Vec3> kFloor{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};  // front up

PolygonHit capsule_at(const Vec3& from, const Vec3& to, double radius, const Vec3& path, Sides sides = Sides::kFront) {
    return cast_polygon(Capsule(from, to, radius), path, kFloor, sides);
}

TEST(CastCapsule, FallsOnAFaceWithAnEnd) {
    const PolygonHit hit = capsule_at({1, 2, 5}, {2, 2, 7}, 1, {0, 0, -8});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.feature, Feature::kFace);
    EXPECT_EQ(hit.centre, (Vec3{1.5, 2, 2}));
    EXPECT_EQ(hit.point, (Vec3{1, 2, 0}));
    EXPECT_EQ(hit.normal, (Vec3{0, 0, 1}));
}

TEST(CastCapsule, LiesFlatByTheMiddleOfWhatTouches) {
    PolygonHit hit = capsule_at({1, 2, 5}, {3, 2, 5}, 1, {0, 0, -8});
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.point, (Vec3{2, 2, 0}));
    EXPECT_EQ(hit.normal, (Vec3{0, 0, 1}));
    hit = capsule_at({2, 2, 5}, {8, 2, 5}, 1, {0, 0, -8});  // over the rim at x = 4
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.point, (Vec3{3, 2, 0}));
    hit = capsule_at({-4, 2, 5}, {8, 2, 5}, 1, {0, 0, -8});  // over both
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.point, (Vec3{2, 2, 0}));
}

TEST(CastCapsule, MeetsAnEdgeWithItsSide) {
    // The side x = 4, from outside; the segment leans across it.
    const PolygonHit hit = capsule_at({9, 2, -1}, {9, 2, 1}, 1, {-8, 0, 0}, Sides::kBoth);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.feature, Feature::kEdge);
    EXPECT_EQ(hit.feature_index, 1u);
    EXPECT_EQ(hit.point, (Vec3{4, 2, 0}));
    EXPECT_EQ(hit.normal, (Vec3{1, 0, 0}));
}

TEST(CastCapsule, MeetsAVertexWithItsSide) {
    const PolygonHit hit = capsule_at({10, 10, -2}, {10, 10, 2}, 5, {-8, -8, 0}, Sides::kBoth);
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.feature, Feature::kVertex);
    EXPECT_EQ(hit.feature_index, 2u);
    EXPECT_EQ(hit.point, (Vec3{4, 4, 0}));
    EXPECT_NEAR(length(hit.centre - hit.point), 5, 1e-12);
}

TEST(CastCapsule, AnExactGrazeIsAHitAndAnUlpLessIsNot) {
    // The segment passes the edge x = 0 at a distance of 5, as 3, 4, 5.
    const auto past = [](double radius) {
        return capsule_at({-3, -10, 4}, {-3, -6, 4}, radius, {0, 20, 0}, Sides::kBoth).status;
    };
    EXPECT_EQ(past(5), Status::kHit);
    EXPECT_EQ(past(std::nextafter(5, 0)), Status::kMiss);
    EXPECT_EQ(capsule_at({1, 1, 5}, {2, 1, 5}, 1, {0, 0, -4}).fraction, 1);
    EXPECT_EQ(capsule_at({1, 1, 5}, {2, 1, 5}, 1, {0, 0, -3.9999999999999996}).status, Status::kMiss);
}

TEST(CastCapsule, StartsInTouchOrOverlap) {
    const Vec3 a{1, 1, 1}, b{2, 1, 1};
    EXPECT_EQ(capsule_at(a, b, 1, {0, 0, -1}).status, Status::kInitialOverlap);
    EXPECT_EQ(capsule_at(a, b, 1, {1, 0, 0}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(capsule_at(a, b, 1, {1, 0, -1e-60}, Sides::kBoth).status, Status::kInitialOverlap);
    EXPECT_EQ(capsule_at(a, b, 2, {0, 0, 1}, Sides::kBoth).status, Status::kMiss);
    // The segment through the floor, less of it below: the short way out is up.
    EXPECT_EQ(capsule_at({2, 2, -1}, {2, 2, 2}, 0.5, {0, 0, -1}).status, Status::kInitialOverlap);
    EXPECT_EQ(capsule_at({2, 2, -1}, {2, 2, 2}, 0.5, {0, 0, 1}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(capsule_at({2, 2, -2}, {2, 2, 1}, 0.5, {0, 0, 1}, Sides::kBoth).status, Status::kInitialOverlap);
    EXPECT_EQ(capsule_at({2, 2, -2}, {2, 2, 1}, 0.5, {0, 0, 1}).status, Status::kMiss);  // from behind
    EXPECT_EQ(capsule_at({2, 2, -2}, {2, 2, 1}, 0.5, {0, 0, -1}).status, Status::kMiss);
    // In the middle both ways are as short.
    EXPECT_EQ(capsule_at({2, 2, -1}, {2, 2, 1}, 0.5, {0, 0, -1}).normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(capsule_at({2, 2, -1}, {2, 2, 1}, 0.5, {0, 0, 1}, Sides::kBoth).normal, (Vec3{0, 0, -1}));
    // Through the rim: out is across the side x = 4.
    const PolygonHit rim = capsule_at({3.5, 2, -2}, {3.5, 2, 2}, 0.25, {-1, 0, 0}, Sides::kBoth);
    EXPECT_EQ(rim.status, Status::kInitialOverlap);
    EXPECT_EQ(rim.normal, (Vec3{1, 0, 0}));
    EXPECT_EQ(rim.feature, Feature::kEdge);
    EXPECT_EQ(rim.feature_index, 1u);
    EXPECT_EQ(rim.point, (Vec3{3.5, 2, 0}));
    EXPECT_EQ(capsule_at({3.5, 2, -2}, {3.5, 2, 2}, 0.25, {1, 0, 0}, Sides::kBoth).status, Status::kMiss);
}

TEST(CastCapsule, SaysWhatCannotBeAsked) {
    EXPECT_EQ(capsule_at({1, 1, 5}, {2, 1, 5}, -1, {0, 0, -8}).status, Status::kInvalid);
    EXPECT_EQ(capsule_at({1, NAN, 5}, {2, 1, 5}, 1, {0, 0, -8}).status, Status::kInvalid);
    EXPECT_EQ(capsule_at({1, 1, 5}, {2, 1, 5}, NAN, {0, 0, -8}).status, Status::kInvalid);
    EXPECT_EQ(capsule_at({0x1p200, 1, 5}, {-0x1p200, 1, 5}, 1, {0, 0, -8}).status, Status::kInvalid);
    EXPECT_EQ(capsule_at({1, 1, 5}, {2, 1, 5}, 1, {0, 0, 0}).status, Status::kMiss);
    const Capsule made = make_capsule({1, 2, 3}, {0, 0, 1}, 0.5, 0.25);
    EXPECT_EQ(made.from, (Vec3{1, 2, 2.5}));
    EXPECT_EQ(made.to, (Vec3{1, 2, 3.5}));
    EXPECT_EQ(made.radius, 0.25);
}

// ---- the oracle by hand

TEST(ExactCapsule, IsWhatPaperSays) {
    const ExactCapsuleCast flat(Capsule({1, 2, 5}, {3, 2, 5}, 1), {0, 0, -8}, kFloor);
    const CapsuleExpected hit = flat.expect(Sides::kFront);
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(decimals(hit.at, 6), "0.500000");
    EXPECT_DOUBLE_EQ(flat.gap_at(0.25), 2);
    EXPECT_EQ(flat.away_at(0.25), (Vec3{0, 0, 1}));
    EXPECT_EQ(flat.expect(Sides::kBoth).status, Status::kHit);
    // Only the segment's inside comes near the side x = 4: |t 8 - 5| = 1.
    const ExactCapsuleCast across(Capsule({9, 2, -1}, {9, 2, 1}, 1), {-8, 0, 0}, kFloor);
    EXPECT_EQ(decimals(across.expect(Sides::kBoth).at, 6), "0.500000");
    EXPECT_EQ(across.expect(Sides::kFront).status, Status::kMiss);
    const ExactCapsuleCast through(Capsule({2, 2, -1}, {2, 2, 2}, 0.5), {0, 0, -1}, kFloor);
    EXPECT_TRUE(through.expect(Sides::kBoth).segment_meets);
    EXPECT_EQ(through.expect(Sides::kBoth).status, Status::kInitialOverlap);
    EXPECT_EQ(ExactCapsuleCast(Capsule({2, 2, -1}, {2, 2, 2}, 0.5), {0, 0, 1}, kFloor).expect(Sides::kBoth).status,
              Status::kMiss);
}

}  // namespace
