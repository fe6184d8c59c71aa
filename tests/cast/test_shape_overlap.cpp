// SPDX-License-Identifier: MIT
// Capsules, boxes and hulls that overlap a polygon: whether they do, judged in whole numbers; how deep, and whether the
// way out leads out.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cast/capsule_start.h"
#include "cast/make_hull_hit.h"
#include "firma/capsule.h"
#include "firma/hull.h"
#include "scenes/grid_polygons.h"
#include "tests/reference/exact_capsule.h"
#include "tests/reference/exact_hull.h"
#include "tests/sample.h"

namespace firma {
namespace {

using scenes::Rng;

std::vector<Vec3> polygon_near(Rng& rng, double away) {
    const scenes::Steps middle = scenes::random_steps(rng, std::int64_t(away)) * scenes::kMetre;
    return scenes::to_metres(rng.chance(0.5) ? scenes::random_triangle(rng, middle, 3 * scenes::kMetre, scenes::kMetre)
                                             : scenes::random_polygon(rng, middle, 3 * scenes::kMetre,
                                                                      scenes::kMetre / 4, 8, rng.chance(0.3)));
}

Vec3 whole_point(Rng& rng, int reach) {
    const auto one = [&] { return double(rng.below(std::uint32_t(2 * reach + 1))) - reach; };
    return {one(), one(), one()};
}

/// So that sums and differences are exact.
Vec3 in_few_bits(const Vec3& p) {
    const auto one = [](double x) { return std::round(x * 0x1p30) * 0x1p-30; };
    return {one(p.x), one(p.y), one(p.z)};
}

/// Somewhere around a polygon; on a lattice all numbers are halves away from its corners.
Vec3 place_near(Rng& rng, const std::vector<Vec3>& polygon, bool lattice) {
    const Vec3& here = polygon[rng.below(std::uint32_t(polygon.size()))];
    return lattice ? here + whole_point(rng, 4) * 0.5 : in_few_bits(here + rng.direction() * rng.uniform(0, 3));
}

TEST(ShapeOverlap, OfHullsIsThatInWholeNumbers) {
    Rng rng(5);
    int met = 0, touching = 0, behind = 0;
    for (int round = 0; round < test::sample(4000); ++round) {
        const bool lattice = rng.chance(0.5);
        const std::vector<Vec3> polygon = polygon_near(rng, rng.chance(0.3) ? 3000 : 10);
        std::vector<Vec3> points;
        for (int k = 4 + int(rng.below(6)); k > 0; --k)
            points.push_back(lattice ? whole_point(rng, 2) * 0.5 : rng.direction() * rng.uniform(0.3, 1.5));
        points.push_back({0, 0, 0});
        const Result<Hull> made = make_hull(points);
        if (!made.ok()) continue;  // flat
        const Hull& hull = made.value();
        const Vec3 at = place_near(rng, polygon, lattice);
        const reference::ExactHullCast exact(hull.corners(), at, {1, 0, 0}, polygon);
        ASSERT_EQ(overlap(hull, at, polygon), exact.overlaps()) << round;
        if (!exact.overlaps()) continue;
        ++met;
        const double deep = -exact.gap_at(0), tolerance = 1e-9 * (1 + max_abs(at) * 1e-3);
        touching += deep == 0;
        Sweep sweep;
        ASSERT_EQ(make_sweep({at, hull.shape()->reach}, {1, 0, 0}, sweep), Status::kHit);
        const PolygonShape shape = make_shape(polygon);
        for (const bool along_normal : {false, true}) {
            const WayOut out = way_out_of_hull(sweep, *hull.shape(), shape, along_normal);
            EXPECT_NEAR(length(out.direction), 1, 1e-12);
            if (!along_normal) {
                EXPECT_NEAR(out.depth, deep, tolerance) << round;
            } else {
                EXPECT_EQ(out.direction, shape.unit_normal());
                EXPECT_GE(out.depth, deep - tolerance);
                behind += out.depth > deep + 0.01;
            }
            const Vec3 moved = at + out.direction * out.depth;
            const double gap = reference::ExactHullCast(hull.corners(), moved, {1, 0, 0}, polygon).gap_at(0);
            const Vec3 point = polygon[0] + out.closest.offset;
            EXPECT_LE(closest_point(point, polygon).distance, tolerance);
            EXPECT_EQ(out.closest.distance, 0);
            if (along_normal) {  // all of it is over the plane, so it may be off the face
                EXPECT_GE(gap, -tolerance) << round;
                double lowest = INFINITY;
                for (const Vec3& corner : hull.corners())
                    lowest = std::fmin(lowest, dot(shape.unit_normal(), moved + corner - polygon[0]));
                EXPECT_NEAR(lowest, 0, tolerance) << round;
                continue;
            }
            EXPECT_NEAR(gap, 0, tolerance) << round;
            // The point on the polygon is of the hull once that is out.
            double far = -INFINITY;  // from the hull that has moved, by all of its triangles
            for (const HullShape::Triangle& triangle : hull.shape()->triangles) {
                const Vec3& corner = hull.corners()[triangle.corner[0]];
                far = std::fmax(far, dot(triangle.normal, point - moved - corner) / length(triangle.normal));
            }
            EXPECT_LE(far, 1e-6) << round;
        }
    }
    EXPECT_GT(met, test::sample(500));
    EXPECT_GT(touching, test::sample(20));
    EXPECT_GT(behind, test::sample(100));
}

/// Metres between the segment's sum and A, from outside; within it, how deep, negative.
double capsule_gap(const Capsule& capsule, const std::vector<Vec3>& polygon, bool& through) {
    const reference::ExactCapsuleCast exact(capsule, {1, 0, 0}, polygon);
    const Vec3 s = capsule.to - capsule.from;
    const std::vector<Vec3> axis{{0, 0, 0}, s};
    const reference::ExactHullCast hull(axis, capsule.from, {1, 0, 0}, polygon);
    if (std::fabs(dot(make_shape(polygon).unit_normal(), s)) < 1e-12) {  // the sum is flat: nothing lies within it
        through = exact.gap_at(0) == -capsule.radius;
        return exact.gap_at(0);
    }
    through = hull.overlaps();
    return through ? hull.gap_at(0) - capsule.radius : exact.gap_at(0);
}

TEST(ShapeOverlap, OfCapsulesIsThatInWholeNumbers) {
    Rng rng(6);
    int met = 0, pierced = 0, apart = 0;
    for (int round = 0; round < test::sample(4000); ++round) {
        const bool lattice = rng.chance(0.5);
        const std::vector<Vec3> polygon = polygon_near(rng, rng.chance(0.3) ? 3000 : 10);
        const Vec3 from = place_near(rng, polygon, lattice);
        const Vec3 to =
            lattice ? from + whole_point(rng, 3) * 0.5 : in_few_bits(from + rng.direction() * rng.uniform(0.1, 3));
        if (from == to) continue;
        const Capsule capsule(from, to, lattice ? 0.5 * rng.below(4) : rng.uniform(0, 1.5));
        bool through = false;
        const double gap = capsule_gap(capsule, polygon, through), tolerance = 1e-9 * (1 + max_abs(from) * 1e-3);
        const bool meets = overlap(capsule, polygon);
        if (std::fabs(gap) > 1e-13) {
            EXPECT_EQ(meets, gap < 0) << round;
        } else if (lattice || through) {
            EXPECT_TRUE(meets) << round << " gap " << gap;
        }
        apart += !meets;
        if (!meets) continue;
        ++met;
        pierced += through;
        Sweep sweep;
        ASSERT_EQ(make_sweep(ball_around(capsule), {1, 0, 0}, sweep), Status::kHit);
        const PolygonShape shape = make_shape(polygon);
        const CapsuleSweep there(sweep, shape_of_capsule(capsule));
        for (const bool along_normal : {false, true}) {
            const WayOut out = way_out_of_capsule(there, shape, along_normal);
            EXPECT_NEAR(length(out.direction), 1, 1e-12);
            if (along_normal) {
                EXPECT_EQ(out.direction, shape.unit_normal());
            } else {
                EXPECT_NEAR(out.depth, std::fmax(0, -gap), tolerance) << round;
            }
            const Vec3 moved = out.direction * out.depth;
            bool still = false;
            const Capsule outside(from + moved, to + moved, capsule.radius);
            const double left = capsule_gap(outside, polygon, still);
            EXPECT_GE(left, -tolerance) << round << " through " << through;
            EXPECT_TRUE(along_normal || left <= tolerance) << round << " " << left;
            EXPECT_TRUE(!through || out.closest.distance == 0);
            EXPECT_LE(closest_point(polygon[0] + out.closest.offset, polygon).distance, tolerance);
        }
    }
    EXPECT_GT(met, test::sample(500));
    EXPECT_GT(pierced, test::sample(100));
    EXPECT_GT(apart, test::sample(200));
}

TEST(ShapeOverlap, OfACapsuleWithoutLengthIsThatOfItsSphere) {
    Rng rng(7);
    int met = 0;
    for (int round = 0; round < 500; ++round) {
        const std::vector<Vec3> polygon = polygon_near(rng, 10);
        const Vec3 at = place_near(rng, polygon, rng.chance(0.5));
        const double radius = rng.chance(0.5) ? 0.5 : rng.uniform(0, 2);
        EXPECT_EQ(overlap(Capsule(at, at, radius), polygon), overlap(Sphere{at, radius}, polygon));
        met += overlap(Sphere{at, radius}, polygon);
    }
    EXPECT_GT(met, 50);
}

TEST(ShapeOverlap, OfWhatCannotBeAskedIsNone) {
    const std::vector<Vec3> ground{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Hull box = make_box({1, 1, 1}).value();
    EXPECT_TRUE(overlap(box, {1, 1, 1}, ground));
    EXPECT_FALSE(overlap(box, {1, 1, 1.0000001}, ground));
    EXPECT_FALSE(overlap(Hull(), {1, 1, 0}, ground));
    EXPECT_FALSE(overlap(box, {1, NAN, 0}, ground));
    EXPECT_FALSE(overlap(box, {1, 1, 0}, std::span(ground).first(2)));
    EXPECT_TRUE(overlap(Capsule({1, 1, 1}, {1, 1, 3}, 1), ground));
    EXPECT_FALSE(overlap(Capsule({1, 1, 1}, {1, 1, 3}, -1), ground));
    EXPECT_FALSE(overlap(Capsule({1, 1, NAN}, {1, 1, 3}, 1), ground));
    EXPECT_FALSE(overlap(Capsule({1, 1, 1}, {1, 1, 0x1p200}, 1), ground));
}

}  // namespace
}  // namespace firma
