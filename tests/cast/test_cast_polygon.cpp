// SPDX-License-Identifier: MIT
// The contract of a cast, row by row, on cases whose answers one can work out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "firma/polygon.h"

namespace firma {
namespace {

/// A square in z = 0 that faces up.
const std::vector<Vec3> kFloor{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};

PolygonHit drop(const Vec3& start, double radius, const Vec3& path, Sides sides = Sides::kFront) {
    return cast_polygon({start, radius}, path, kFloor, sides);
}

TEST(CastPolygon, MeetsTheFaceFromItsFront) {
    const PolygonHit hit = drop({0.25, 0.5, 3}, 0.5, {0, 0, -5});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.feature, Feature::kFace);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.centre, (Vec3{0.25, 0.5, 0.5}));
    EXPECT_EQ(hit.point, (Vec3{0.25, 0.5, 0}));
    EXPECT_EQ(hit.normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(hit.face_normal, (Vec3{0, 0, 1}));
}

TEST(CastPolygon, ContactAtTheVeryEndCounts) {
    EXPECT_EQ(drop({0, 0, 3}, 1, {0, 0, -2}).fraction, 1);
    EXPECT_EQ(drop({0, 0, 3}, 1, {0, 0, std::nextafter(-2.0, 0.0)}).status, Status::kMiss);
    EXPECT_EQ(drop({0, 0, 3}, 0, {0, 0, -3}).fraction, 1);
    EXPECT_EQ(drop({0, 0, 3}, 0, {0, 0, std::nextafter(-3.0, 0.0)}).status, Status::kMiss);
}

TEST(CastPolygon, OneSidedFacesAreNotMetFromBehind) {
    EXPECT_EQ(drop({0, 0, -3}, 0.5, {0, 0, 5}).status, Status::kMiss);
    const PolygonHit hit = drop({0, 0, -3}, 0.5, {0, 0, 5}, Sides::kBoth);
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.normal, (Vec3{0, 0, -1})) << "faces the mover";
    EXPECT_EQ(hit.face_normal, (Vec3{0, 0, 1})) << "as wound";
}

TEST(CastPolygon, EdgeAndVertex) {
    const PolygonHit edge = drop({5, 0, -0.0}, 1, {-8, 0, -0x1p-30});
    EXPECT_EQ(edge.status, Status::kHit);
    EXPECT_EQ(edge.feature, Feature::kEdge);
    EXPECT_EQ(edge.feature_index, 1u);
    EXPECT_NEAR(edge.fraction, 3.0 / 8, 1e-9);
    EXPECT_NEAR(edge.normal.x, 1, 1e-9);

    const PolygonHit vertex = drop({1 + 3, 1 + 4, 2}, 1, {-6, -8, -4});
    EXPECT_EQ(vertex.feature, Feature::kVertex);
    EXPECT_EQ(vertex.feature_index, 2u);
    EXPECT_EQ(vertex.point, (Vec3{1, 1, 0}));
}

TEST(CastPolygon, AnEdgeCountsWhileTheCentreIsBehindThePlane) {
    const PolygonHit hit = drop({3, 0, -0.25}, 0.5, {-2, 0, -0.125});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.feature, Feature::kEdge);
}

TEST(CastPolygon, AnExactGrazeIsAHit) {
    const PolygonHit side = drop({4, 0, 0.5}, 0.5, {-8, 0, 0}, Sides::kBoth);
    EXPECT_EQ(side.status, Status::kHit) << "sliding in along the face at exactly the radius";
    EXPECT_EQ(side.fraction, 3.0 / 8);
    const PolygonHit corner = drop({1 + 3, 1 + 4, -10}, 5, {0, 0, 20}, Sides::kBoth);
    EXPECT_EQ(corner.status, Status::kHit) << "past a corner at 3, 4, 5";
    EXPECT_EQ(corner.fraction, 0.5);
    EXPECT_EQ(drop({1 + 3, 1 + 4, -10}, std::nextafter(5.0, 0.0), {0, 0, 20}, Sides::kBoth).status, Status::kMiss);
}

TEST(CastPolygon, ParallelPaths) {
    EXPECT_EQ(drop({4, 0, 0.25}, 0.5, {-8, 0, 0}).status, Status::kMiss) << "one-sided: path . normal = 0 is ignored";
    EXPECT_EQ(drop({4, 0, 0.25}, 0.5, {-8, 0, 0}, Sides::kBoth).status, Status::kHit);
    EXPECT_EQ(drop({4, 0, 0.75}, 0.5, {-8, 0, 0}, Sides::kBoth).status, Status::kMiss);
}

TEST(CastPolygon, AParticleInThePlaneMeetsTheRim) {
    const PolygonHit hit = drop({4, 0, 0}, 0, {-8, 0, 0}, Sides::kBoth);
    EXPECT_EQ(hit.status, Status::kHit) << "the polygon is a closed set";
    EXPECT_EQ(hit.fraction, 3.0 / 8);
    EXPECT_EQ(hit.feature, Feature::kEdge);
    EXPECT_EQ(drop({4, 1, 0}, 0, {-8, 0, 0}, Sides::kBoth).fraction, 3.0 / 8) << "along its very side";
    EXPECT_EQ(drop({4, 1.5, 0}, 0, {-8, 0, 0}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(drop({4, 3, 0}, 0, {-2, -1, 0}, Sides::kBoth).status, Status::kMiss) << "ends before it";
    EXPECT_EQ(drop({0, 0, 0}, 0, {-8, 0, 0}, Sides::kBoth).status, Status::kMiss) << "starts on it and stays on it";
    EXPECT_EQ(drop({4, 0, 0}, 0, {-8, 0, 0}).status, Status::kMiss) << "one-sided";
}

TEST(CastPolygon, TouchingAtTheStart) {
    EXPECT_EQ(drop({0, 0, 0.5}, 0.5, {0, 0, -1}).status, Status::kInitialOverlap);
    EXPECT_EQ(drop({0, 0, 0.5}, 0.5, {0, 0, 1}).status, Status::kMiss) << "moves away";
    EXPECT_EQ(drop({0, 0, 0.5}, 0.5, {1, 0, 0}).status, Status::kMiss) << "slides";
    EXPECT_EQ(drop({0, 0, 0.25}, 0.5, {0, 0, -1}).status, Status::kInitialOverlap) << "overlaps and sinks";
    EXPECT_EQ(drop({0, 0, 0.25}, 0.5, {0, 0, 1}, Sides::kBoth).status, Status::kMiss) << "overlaps and leaves";
    EXPECT_EQ(drop({0, 0, -0.25}, 0.5, {0, 0, -1}).status, Status::kMiss) << "behind, and the distance grows";
    const PolygonHit edge = drop({1.5, 0, 0}, 0.5, {-1, 0, -1});
    EXPECT_EQ(edge.status, Status::kInitialOverlap);
    EXPECT_EQ(edge.feature, Feature::kEdge);
    EXPECT_EQ(edge.normal, (Vec3{1, 0, 0}));
    EXPECT_EQ(edge.fraction, 0);
}

TEST(CastPolygon, CentreOnThePolygon) {
    for (const double radius : {0.0, 0.5}) {
        const PolygonHit hit = drop({0.5, 0.5, 0}, radius, {0, 1, -1});
        EXPECT_EQ(hit.status, Status::kInitialOverlap);
        EXPECT_EQ(hit.normal, (Vec3{0, 0, 1}));
        EXPECT_EQ(drop({0.5, 0.5, 0}, radius, {0, 1, 1}).status, Status::kMiss);
        EXPECT_EQ(drop({0.5, 0.5, 0}, radius, {0, 1, 1}, Sides::kBoth).status, Status::kInitialOverlap);
        EXPECT_EQ(drop({0.5, 0.5, 0}, radius, {0, 1, 1}, Sides::kBoth).normal, (Vec3{0, 0, -1}));
        EXPECT_EQ(drop({0.5, 0.5, 0}, radius, {0, 1, 0}, Sides::kBoth).status, Status::kMiss);
        EXPECT_EQ(drop({1, 1, 0}, radius, {0, 1, -1}).status, Status::kInitialOverlap) << "on a corner";
        EXPECT_EQ(drop({1, 0.5, 0}, radius, {0, 1, -1}).status, Status::kInitialOverlap) << "on an edge";
    }
}

TEST(CastPolygon, ZeroPathsMiss) {
    EXPECT_EQ(drop({0, 0, 0.25}, 0.5, {0, 0, 0}).status, Status::kMiss);
    EXPECT_EQ(drop({0, 0, 0.25}, 0.5, {0, -0.0, 0}, Sides::kBoth).status, Status::kMiss);
}

TEST(CastPolygon, NonsenseIsInvalidAndNotAMiss) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
    for (const double bad : {kNan, kInf, -kInf, 1e300}) {
        EXPECT_EQ(drop({bad, 0, 3}, 0.5, {0, 0, -5}).status, Status::kInvalid);
        EXPECT_EQ(drop({0, 0, 3}, 0.5, {0, bad, -5}).status, Status::kInvalid);
        EXPECT_EQ(drop({0, 0, 3}, bad, {0, 0, -5}).status, Status::kInvalid);
    }
    EXPECT_EQ(drop({0, 0, 3}, -1e-300, {0, 0, -5}).status, Status::kInvalid) << "a negative radius, however small";
    EXPECT_EQ(drop({0, 0, kNan}, 0.5, {0, 0, 0}).status, Status::kInvalid) << "also with a zero path";
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(cast_polygon({{0, 0, 1}, 0}, {0, 0, -2}, line).status, Status::kInvalid);
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(cast_polygon({{0, 0, 1}, 0}, {0, 0, -2}, flat).status, Status::kInvalid);
    const std::vector<Vec3> wild{{0, 0, 0}, {1, kNan, 0}, {2, 0, kInf}};
    EXPECT_EQ(cast_polygon({{0, 0, 1}, 0}, {0, 0, -2}, wild).status, Status::kInvalid);
}

TEST(CastPolygon, StartsOutsideTheWorldAreAnsweredLikeAnyOther) {
    EXPECT_EQ(drop({0, 0, 0x1p+20}, 0, {0, 0, -0x1p+21}).fraction, 0.5);
    EXPECT_EQ(drop({0, 0, 0x1p+100}, 0, {0, 0, -0x1p+101}).fraction, 0.5);
    EXPECT_EQ(drop({0, 0, 0x1p+20 + 1}, 1, {0, 0, -0x1p+21}).fraction, 0.5);
}

TEST(CastPolygon, TinyAndHugePathsAndRadii) {
    EXPECT_EQ(drop({0, 0, 0x1p-200}, 0, {0, 0, -0x1p-199}).fraction, 0.5);
    EXPECT_EQ(drop({0, 0, 0.25}, 0.5, {0, 0, -1e-300}).status, Status::kInitialOverlap)
        << "the shortest path has a direction";
    EXPECT_EQ(drop({0, 0, 0x1p-240}, 0, {0, 0, -1e-300}).status, Status::kMiss);
    EXPECT_EQ(drop({0, 0, 1}, 0x1p-60, {0, 0, -2}).status, Status::kHit) << "a radius lost in rounding never leaks";
    EXPECT_EQ(drop({1, 1, 1}, 0x1p-60, {0, 0, -2}).status, Status::kHit) << "not at a corner either";
    EXPECT_EQ(drop({0, 0, 1000 + 1}, 1000, {0, 0, -2}).fraction, 0.5);
    EXPECT_EQ(drop({0, 0, 1}, 5e-324, {0, 0, -2}).fraction, 0.5);
}

}  // namespace
}  // namespace firma
