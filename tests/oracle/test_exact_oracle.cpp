// SPDX-License-Identifier: MIT
// The oracle by hand: examples small enough to work out on paper.
#include "tests/reference/exact_oracle.h"

#include <gtest/gtest.h>

#include "tests/reference/judge.h"

namespace {

using namespace firma;
using namespace firma::reference;

const std::vector<Vec3> kSquare{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};  // front up

Expected expect(const Vec3& start, double radius, const Vec3& path, Sides sides = Sides::kFront) {
    return ExactOracle({kSquare}).expect({{start, radius}, path, sides});
}

TEST(ExactNumber, RootsAreWhole) {
    EXPECT_EQ(floor_root(0), 0);
    EXPECT_EQ(floor_root(1), 1);
    EXPECT_EQ(floor_root(8), 2);
    EXPECT_EQ(floor_root(9), 3);
    for (int bits = 1; bits < 600; bits += 7) {
        const Integer x = (Integer(1) << unsigned(bits)) + 12345;
        EXPECT_EQ(floor_root(x * x), x);
        EXPECT_EQ(floor_root(x * x - 1), x - 1);
        EXPECT_EQ(floor_root(x * x + 2 * x), x);
    }
}

TEST(ExactNumber, RootsCompareWithoutRoots) {
    const Root one{1, 0, 1}, also_one{3, 4, 1}, less{3, 5, 1}, more{3, 3, 1};  // 3 - 2, 3 - 2.236, 3 - 1.732
    EXPECT_EQ(compare(one, also_one), 0);
    EXPECT_EQ(compare(less, one), -1);
    EXPECT_EQ(compare(more, one), 1);
    EXPECT_EQ(compare(less, more), -1);
    EXPECT_EQ(compare(Root{6, 20, 2}, less), 0);  // the same, twice over
    const Integer huge = Integer(1) << 300;
    EXPECT_EQ(compare(Root{huge, 1, huge}, Root{huge, 4, huge}), 1);
    EXPECT_TRUE((Root{7, 49, 3}.is_zero()));
    EXPECT_FALSE((Root{7, 48, 3}.is_zero()));
}

TEST(ExactNumber, DecimalsAreRoundedDown) {
    EXPECT_EQ(decimals({2, 2, 1}, 10), "0.5857864376");  // 2 - sqrt 2 = 0.58578643762...
    EXPECT_EQ(decimals({1, 0, 3}, 5), "0.33333");
    EXPECT_EQ(decimals({1, 0, 1}, 3), "1.000");
    EXPECT_EQ(decimals({0, 0, 1}, 3), "0.000");
}

TEST(ExactNumber, DoublesAreTakenWhole) {
    EXPECT_EQ(in_units(0.75, 2), 3);
    EXPECT_EQ(in_units(-0x1p-1074, 1074), -1);
    EXPECT_EQ(in_units(0x1p100, 3), Integer(1) << 103);
    EXPECT_EQ(nearest({1, 3}), 1.0 / 3);
    EXPECT_EQ(nearest({-7, 2}, -1), -1.75);
    EXPECT_EQ(root_minus({9, 4}, 1, 0), 0.5);
    EXPECT_NEAR(root_minus({Integer(1) << 200, 1}, Integer(1) << 100, -100), 0, 1e-40);
}

TEST(ExactOracle, FaceHitFromAbove) {
    const Expected e = expect({2, 2, 10}, 2, {0, 0, -16});
    EXPECT_EQ(e.status, Status::kHit);
    EXPECT_EQ(e.fraction_text(10), "0.5000000000");
    EXPECT_EQ(e.feature, Feature::kFace);
    EXPECT_EQ(e.faces, std::vector<std::uint32_t>{0});
}

TEST(ExactOracle, OneSidedIgnoresTheBackAndTheParallel) {
    EXPECT_EQ(expect({2, 2, -10}, 2, {0, 0, 16}).status, Status::kMiss);
    EXPECT_EQ(expect({2, 2, -10}, 2, {0, 0, 16}, Sides::kBoth).status, Status::kHit);
    EXPECT_EQ(expect({-8, 2, 1}, 2, {16, 0, 0}).status, Status::kMiss);
    EXPECT_EQ(expect({-8, 2, 1}, 2, {16, 0, 0}, Sides::kBoth).status, Status::kHit);
    EXPECT_EQ(expect({-8, 2, 1}, 2, {16, 0, -1e-300}).status, Status::kHit);
}

// The centre is behind the plane all the time; the edge x = 0 is met.
TEST(ExactOracle, AnEdgeIsMetFromBehindThePlane) {
    const Expected e = expect({-10, 2, -0.5}, 1, {16, 0, -0.125});
    EXPECT_EQ(e.status, Status::kHit);
    EXPECT_EQ(e.feature, Feature::kEdge);
    EXPECT_EQ(e.feature_index, 3u);
}

// |(-8, -8, 0) + t (8, 8, 0)| = 1 at t = 1 - 1/sqrt 128.
TEST(ExactOracle, VertexHitIsARoot) {
    const Expected e = expect({-8, -8, 0}, 1, {8, 8, 0}, Sides::kBoth);
    EXPECT_EQ(e.status, Status::kHit);
    EXPECT_EQ(e.feature, Feature::kVertex);
    EXPECT_EQ(e.feature_index, 0u);
    EXPECT_EQ(e.fraction_text(25), "0.9116116523516815594498944");
}

TEST(ExactOracle, AnExactGrazeIsAHitAndAnUlpLessIsNot) {
    const Vec3 start{-3, -10, 4}, path{0, 20, 0};  // 3, 4, 5 away from the edge x = 0
    EXPECT_EQ(expect(start, 5, path, Sides::kBoth).status, Status::kHit);
    EXPECT_EQ(expect(start, std::nextafter(5, 0), path, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(expect({2, 2, 5}, 1, {0, 0, -4}).fraction_text(3), "1.000");
    EXPECT_EQ(expect({2, 2, 5}, 1, {0, 0, -3.9999999999999996}).status, Status::kMiss);
}

TEST(ExactOracle, TouchingNeedsADecreasingDistance) {
    EXPECT_EQ(expect({2, 2, 1}, 1, {0, 0, -1}).status, Status::kInitialOverlap);
    EXPECT_EQ(expect({2, 2, 1}, 1, {1, 0, 0}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(expect({2, 2, 1}, 1, {1, 0, 1e-300}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(expect({2, 2, 1}, 1, {1, 0, -1e-300}, Sides::kBoth).status, Status::kInitialOverlap);
    EXPECT_EQ(expect({2, 2, 0.5}, 1, {0, 0, 1}, Sides::kBoth).status, Status::kMiss);
    EXPECT_EQ(expect({2, 2, 0.5}, 1, {0, 0, -1}).fraction_text(2), "0.00");
}

TEST(ExactOracle, ACentreOnThePolygonIsDecidedByThePathsSide) {
    for (const double radius : {0.0, 1.0}) {
        EXPECT_EQ(expect({2, 2, 0}, radius, {0, 0, -1}).status, Status::kInitialOverlap);
        EXPECT_EQ(expect({0, 2, 0}, radius, {-1, 0, -1}).status, Status::kInitialOverlap);
        EXPECT_EQ(expect({2, 2, 0}, radius, {0, 0, 1}).status, Status::kMiss);
        EXPECT_EQ(expect({2, 2, 0}, radius, {0, 0, 1}, Sides::kBoth).status, Status::kInitialOverlap);
        EXPECT_EQ(expect({2, 2, 0}, radius, {1, 1, 0}, Sides::kBoth).status, Status::kMiss);
    }
}

TEST(ExactOracle, AParticleInThePlaneMeetsTheRim) {
    const Expected e = expect({-4, 2, 0}, 0, {16, 0, 0}, Sides::kBoth);
    EXPECT_EQ(e.status, Status::kHit);
    EXPECT_EQ(e.fraction_text(4), "0.2500");
    EXPECT_EQ(e.feature, Feature::kEdge);
    EXPECT_EQ(expect({-4, -4, 0}, 0, {8, 8, 0}, Sides::kBoth).feature, Feature::kVertex);
    EXPECT_EQ(expect({-4, 4, 0}, 0, {16, 0, 0}, Sides::kBoth).status, Status::kHit);  // along an edge
    EXPECT_EQ(expect({-4, 4.0000000000000009, 0}, 0, {16, 0, 0}, Sides::kBoth).status, Status::kMiss);
}

TEST(ExactOracle, TiesNameAllFaces) {
    const ExactOracle oracle(
        {kSquare, {{4, 0, 0}, {8, 0, 0}, {8, 4, 0}, {4, 4, 0}}, {{0, 0, -1}, {4, 0, -1}, {4, 4, -1}}});
    const Expected e = oracle.expect({{{4, 2, 3}, 1}, {0, 0, -8}});
    EXPECT_EQ(e.faces, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(e.feature, Feature::kEdge);
    EXPECT_EQ(e.fraction_text(4), "0.2500");
}

TEST(ExactOracle, BadNumbersAreInvalidAndZeroPathsMiss) {
    EXPECT_EQ(expect({NAN, 0, 0}, 0, {1, 0, 0}).status, Status::kInvalid);
    EXPECT_EQ(expect({0, 0, 1}, -1, {1, 0, 0}).status, Status::kInvalid);
    EXPECT_EQ(expect({0, 0, 1}, 1, {0, 0x1.8p200, 0}).status, Status::kInvalid);
    EXPECT_EQ(expect({2, 2, 0}, 1, {0, -0.0, 0}).status, Status::kMiss);
}

TEST(ExactOracle, MarginsAndOverlaps) {
    const ExactOracle oracle({kSquare});
    const auto margin = [&](const Vec3& start, double radius, const Vec3& path) {
        const ExactCast cast({start, radius}, path);
        return SeenPolygon(oracle.faces()[0].exact, cast).margin();
    };
    EXPECT_DOUBLE_EQ(margin({2, 2, 5}, 1, {0, 0, -4.5}), 0.5);
    EXPECT_DOUBLE_EQ(margin({2, 2, 5}, 1, {0, 0, -3}), -1);
    EXPECT_DOUBLE_EQ(margin({1, 2, 5}, 0, {0, 0, -20}), 1);     // a metre from the rim
    EXPECT_DOUBLE_EQ(margin({1, 2, 5}, 0, {0, 0, -5.5}), 0.5);  // ends half a metre behind
    EXPECT_DOUBLE_EQ(margin({2, 2, 0.75}, 1, {0, 0, -0.5}), 0.5);
    EXPECT_TRUE(oracle.overlaps({{-3, 2, 4}, 5}, 0));
    EXPECT_FALSE(oracle.overlaps({{-3, 2, 4}, std::nextafter(5, 0)}, 0));
}

// The filter may only reject what is apart; that it rejects most is what makes the oracle quick.
TEST(SurelyApart, IsSureOnlyWhenItIs) {
    const reference::Hull hull(kSquare);
    EXPECT_TRUE(surely_apart(hull, {2, 2, 5}, {0, 0, -3}, 1, 1.9));
    EXPECT_FALSE(surely_apart(hull, {2, 2, 5}, {0, 0, -3}, 1, 2));
    EXPECT_FALSE(surely_apart(hull, {2, 2, 5}, {0, 0, -3}, 1, 2.1));
    EXPECT_TRUE(surely_apart(hull, {2, 2, 5}, {0, 0, -6}, 0.5, 1.9));
    EXPECT_TRUE(surely_apart(hull, {-5, -5, 1}, {10, -1, 3}, 1, 2));
    EXPECT_FALSE(surely_apart(hull, {2, 2, 5}, {0x1p200, 0, 0}, 1, 1));
}

// ---- the judge

struct Case {
    ExactOracle oracle{{kSquare}};
    Cast cast{{{2, 2, 5}, 1}, {0, 0, -8}, Sides::kFront};  // hit at 0.5
    Answer answer;

    Case() {
        answer.hit = {Status::kHit, Feature::kFace, 0, 0.5, {2, 2, 1}, {2, 2, 0}, {0, 0, 1}, {0, 0, 1}};
        answer.safe_fraction = 0.5 - 0.001 / 8;
    }
    Fault fault() const { return judge(oracle, cast, answer).fault; }
};

TEST(Judge, TakesTheRightAnswer) {
    const Case c;
    const Verdict verdict = judge(c.oracle, c.cast, c.answer);
    EXPECT_EQ(verdict.fault, Fault::kNone) << verdict.text;
    EXPECT_FALSE(verdict.excused);
}

TEST(Judge, FindsEachFault) {
    Case miss;
    miss.answer.hit = {};
    EXPECT_EQ(miss.fault(), Fault::kMissed);

    Case late;
    late.answer.hit.fraction = 0.5 + 1e-9;
    EXPECT_EQ(late.fault(), Fault::kLate);

    Case early;
    early.answer.hit.fraction = 0.5 - 1e-9;
    EXPECT_EQ(early.fault(), Fault::kEarly);

    Case fraction;  // 8e-11 m along the path: within the distance, not within what a head-on contact must keep
    fraction.answer.hit.fraction = 0.5 - 1e-11;
    EXPECT_EQ(fraction.fault(), Fault::kFraction);

    Case nothing;
    nothing.cast.path = {0, 0, -3};
    EXPECT_EQ(nothing.fault(), Fault::kFalse);

    Case behind;
    behind.cast = {{{2, 2, -5}, 1}, {0, 0, 8}, Sides::kFront};
    EXPECT_EQ(behind.fault(), Fault::kFalse);
}

TEST(Judge, LooksAtEveryField) {
    const auto changed = [](auto&& change) {
        Case c;
        change(c.answer);
        return c.fault();
    };
    EXPECT_EQ(changed([](Answer& a) { a.hit.centre.x += 1e-8; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.point.y += 1e-8; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.normal = {0, 0, -1}; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.normal = {0, 0, 1 + 1e-8}; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.face_normal = {0, 0, -1}; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.face_normal.x = NAN; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.feature = Feature::kEdge; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.status = Status::kInitialOverlap; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.safe_fraction = 0.5; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.safe_fraction = -1e-9; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.face = 7; }), Fault::kFields);
    EXPECT_EQ(changed([](Answer& a) { a.hit.status = Status::kInvalid; }), Fault::kFields);
}

TEST(Judge, ForgivesWhatLiesWithinTheTolerances) {
    Case graze;  // 1e-10 deep: a miss is forgiven, and so is the hit of what passes 1e-10 away
    graze.cast = {{{-3, -10, 4}, 5 + 1e-10}, {0, 20, -1e-3}, Sides::kBoth};
    graze.cast.path = {0, 20, 0};
    graze.answer.hit = {};
    Verdict verdict = judge(graze.oracle, graze.cast, graze.answer);
    EXPECT_TRUE(verdict.ok()) << verdict.text;
    EXPECT_TRUE(verdict.excused);
    graze.cast.sphere.radius = 5 + 1e-8;
    EXPECT_EQ(graze.fault(), Fault::kMissed);
}

// Through the corner of four squares no face has a margin by itself; to pass is an error all the same.
TEST(Judge, ForgivesNoLeakAtASharedCorner) {
    const ExactOracle oracle({kSquare,
                              {{4, 0, 0}, {8, 0, 0}, {8, 4, 0}, {4, 4, 0}},
                              {{0, 4, 0}, {4, 4, 0}, {4, 8, 0}, {0, 8, 0}},
                              {{4, 4, 0}, {8, 4, 0}, {8, 8, 0}, {4, 8, 0}},
                              {{-8, -8, -2}, {16, -8, -2}, {16, 16, -2}, {-8, 16, -2}}});
    Answer answer;
    const Cast short_cast{{{4, 4, 5}, 0}, {0, 0, -6}, Sides::kFront};
    EXPECT_EQ(judge(oracle, short_cast, answer).fault, Fault::kMissed);
    const Cast cast{{{4, 4, 5}, 0}, {0, 0, -10}, Sides::kFront};
    answer.hit = {Status::kHit, Feature::kFace, 0, 0.7, {4, 4, -2}, {4, 4, -2}, {0, 0, 1}, {0, 0, 1}};
    answer.face = 4;
    answer.safe_fraction = 0.6999;
    EXPECT_EQ(judge(oracle, cast, answer).fault, Fault::kLate);
}

// A graze of the first face is forgiven; the second is not.
TEST(Judge, LooksForLatenessAtEveryFace) {
    const ExactOracle oracle({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                              {{-9, -9, -2}, {9, -9, -2}, {9, 9, -2}, {-9, 9, -2}},
                              {{-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}}});
    const Cast cast{{{-1, 2, 5}, 1 + 1e-11}, {0, 0, -10}, Sides::kFront};
    Answer answer;
    answer.hit = {Status::kHit, Feature::kFace, 0, 0, {}, {}, {0, 0, 1}, {0, 0, 1}};
    const auto stop_above = [&](std::uint32_t face, double height) {
        answer.face = face;
        answer.hit.fraction = (5 - (height + 1 + 1e-11)) / 10;
        answer.hit.centre = {-1, 2, height + 1 + 1e-11};
        answer.hit.point = {-1, 2, height};
        answer.safe_fraction = answer.hit.fraction - 0.0001;
        return judge(oracle, cast, answer);
    };
    EXPECT_EQ(stop_above(1, -2).text, "");
    EXPECT_EQ(stop_above(2, -3).fault, Fault::kLate);
}

}  // namespace
