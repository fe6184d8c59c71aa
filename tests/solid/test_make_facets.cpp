// SPDX-License-Identifier: MIT
// Facets cover their face, once; or are refused where they must be.
#include "solid/make_facets.h"

#include <gtest/gtest.h>

#include "tests/solid/face_samples.h"
#include "tests/solid/judge_face.h"

namespace firma {
namespace {

using namespace samples;

struct Tally {
    int made = 0, refused = 0;
};

/// Makes facets when the face is sound, and only then; checks all that is promised of them.
void try_face(FacetMaker& maker, const SampleFace& face, Tally& tally) {
    Facets facets;
    const bool made = maker.make(face.points, face.ends, {face.axis, face.flip}, facets);
    ASSERT_EQ(made, judge(face) == Verdict::kSound) << face.points.size() << " corners";
    if (made) {
        ASSERT_EQ(fault(face, facets), "");
    }
    ++(made ? tally.made : tally.refused);
}

void must_make(FacetMaker& maker, const SampleFace& face) {
    Tally tally;
    ASSERT_NO_FATAL_FAILURE(try_face(maker, face, tally));
    ASSERT_EQ(tally.made, 1);
}

std::size_t count_facets(const SampleFace& face) {
    FacetMaker maker;
    Facets facets;
    EXPECT_TRUE(maker.make(face.points, face.ends, {face.axis, face.flip}, facets));
    EXPECT_EQ(fault(face, facets), "");
    return facets.count();
}

SampleFace drawn(std::vector<Loop> loops) {
    return put(sample_axis_plane(2, false), loops);
}

TEST(MakeFacets, Triangles) {
    FacetMaker maker;
    Facets facets;
    const SampleFace face = drawn({{{0, 0}, {5, 1}, {2, 7}}});
    EXPECT_EQ(count_facets(face), 1u);
    EXPECT_FALSE(maker.make(face.points, face.ends, {2, true}, facets)) << "seen from behind";
    const SampleFace flat = drawn({{{0, 0}, {2, 2}, {5, 5}}});
    EXPECT_FALSE(maker.make(flat.points, flat.ends, {2, false}, facets));
}

TEST(MakeFacets, LoopsWithoutAreaAreRefused) {
    FacetMaker maker;
    Tally tally;
    for (int count = 3; count < 9; ++count)
        for (int back = 1; back < count; ++back) {
            Loop loop;  // out along a line, and back between those corners
            for (int k = 0; k < count; ++k) {
                const double place = k < back ? k : back - 1 - (k - back + 1.0) * back / (count + 1);
                loop.push_back({place * 2520, place * 5040});
            }
            ASSERT_NO_FATAL_FAILURE(try_face(maker, drawn({loop}), tally));
            ASSERT_NO_FATAL_FAILURE(try_face(maker, drawn({rectangle(-99999, -99999, 99999, 99999), loop}), tally));
        }
    EXPECT_EQ(tally.made, 0);
}

TEST(MakeFacets, BadLoopEndsAreRefused) {
    FacetMaker maker;
    Facets facets;
    const SampleFace face = drawn({rectangle(0, 0, 10, 10)});
    const auto refused = [&](std::vector<std::uint32_t> ends) {
        return !maker.make(face.points, ends, {2, false}, facets);
    };
    EXPECT_FALSE(refused({4}));
    EXPECT_TRUE(refused({}));
    EXPECT_TRUE(refused({3}));
    EXPECT_TRUE(refused({5}));
    EXPECT_TRUE(refused({3, 4}));
    EXPECT_TRUE(refused({4, 4}));
}

/// Every quad of a small grid with its first corner in the middle.
TEST(MakeFacets, AllSmallQuads) {
    FacetMaker maker;
    Tally tally;
    constexpr int kSide = 4;
    for (int code = 0; code < kSide * kSide * kSide * kSide * kSide * kSide; ++code) {
        Loop loop{{1, 1}};
        for (int k = 0, rest = code; k < 3; ++k, rest /= kSide * kSide)
            loop.push_back({double(rest % kSide), double(rest / kSide % kSide)});
        ASSERT_NO_FATAL_FAILURE(try_face(maker, drawn({loop}), tally));
    }
    EXPECT_GT(tally.made, 500);
    EXPECT_GT(tally.refused, 500);
}

/// Corners meet, repeat and lie on edges all the time; heights make most merges impossible, or none.
TEST(MakeFacets, TinyLoopsAreMadeWhenSoundAndRefusedOtherwise) {
    FacetMaker maker;
    Rng rng(1);
    Tally tally;
    for (int round = 0; round < 60000; ++round) {
        const int side = rng.whole(2, 7), count = rng.whole(3, 9);
        Loop loop;
        for (int k = 0; k < count; ++k) {
            const double u = rng.whole(0, side);
            const double v = rng.whole(0, side);
            loop.push_back({u, v});
        }
        SampleFace face = put(sample_axis_plane(round % 3, round % 2), {loop});
        if (round % 4 == 0)
            for (GridPoint& point : face.points) point[face.axis] = rng.whole(0, 1);
        ASSERT_NO_FATAL_FAILURE(try_face(maker, face, tally)) << round;
    }
    EXPECT_GT(tally.made, 3000);
    EXPECT_GT(tally.refused, 10000);
}

TEST(MakeFacets, TinyHolesAreMadeWhenSoundAndRefusedOtherwise) {
    FacetMaker maker;
    Rng rng(2);
    Tally tally;
    for (int round = 0; round < 60000; ++round) {
        const int side = rng.whole(6, 14), holes = rng.whole(1, 3);
        std::vector<Loop> loops{with_runs(rng, rectangle(0, 0, side, side), 2)};
        for (int h = 0; h < holes; ++h) {
            const int low_u = rng.whole(-1, side - 1);
            const int low_v = rng.whole(-1, side - 1);
            const int reach = rng.whole(1, 5), count = rng.whole(3, 4);
            Loop loop;
            for (int k = 0; k < count; ++k) {
                const double u = low_u + rng.whole(0, reach);
                const double v = low_v + rng.whole(0, reach);
                loop.push_back({u, v});
            }
            double twice = 0;
            for (int k = 0; k < count; ++k)
                twice += loop[k].u * loop[(k + 1) % count].v - loop[k].v * loop[(k + 1) % count].u;
            loops.push_back(twice > 0 && rng.whole(0, 20) ? reversed(loop) : loop);
        }
        ASSERT_NO_FATAL_FAILURE(try_face(maker, drawn(loops), tally)) << round;
    }
    EXPECT_GT(tally.made, 2000);
    EXPECT_GT(tally.refused, 10000);
}

/// As many holes as a small grid takes, in an outline grown on it: bridges run along edges and through corners.
TEST(MakeFacets, TinyHolesPacked) {
    FacetMaker maker;
    Rng rng(13);
    int most = 0;
    for (int round = 0; round < 300; ++round) {
        const int side = rng.whole(6, 16);
        std::vector<Loop> loops{with_runs(rng, rectangle(0, 0, side, side), 1)};
        const auto sound = [](const std::vector<Loop>& tried) { return judge(drawn(tried)) == Verdict::kSound; };
        if (!sound(loops)) continue;
        for (int tries = 0; tries < 120; ++tries) {
            std::vector<Loop> more = loops;
            const int low_u = rng.whole(0, side - 1), reach = rng.whole(1, 6);
            const int low_v = rng.whole(0, side - 1), count = rng.whole(3, 6);
            Loop loop;
            for (int k = 0; k < count; ++k) {
                const double u = low_u + rng.whole(0, reach);
                const double v = low_v + rng.whole(0, reach);
                loop.push_back({u, v});
            }
            if (tries % 4 == 0) {
                more[0].insert(more[0].begin() + rng.whole(0, int(more[0].size())), loop[0]);
            } else {
                more.push_back(loop);
                if (!sound(more)) more.back() = reversed(loop);
            }
            if (sound(more)) loops = more;
        }
        most = std::max(most, int(loops.size()));
        ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn(loops))) << round;
    }
    EXPECT_GT(most, 9);
}

/// Grown a corner at a time, each anywhere, as long as the loop stays simple.
TEST(MakeFacets, RandomSimpleLoops) {
    FacetMaker maker;
    Rng rng(3);
    for (int round = 0; round < 60; ++round) {
        const SamplePlane plane = any_plane(rng);
        const double size = std::ldexp(1, rng.whole(4, 22));
        Loop loop{{-size, -size}, {size, -size}, {0, size}};
        for (int tries = 0; tries < 500; ++tries) {
            Loop longer = loop;
            const int place = rng.whole(1, int(loop.size()));
            const double u = rng.real(-size, size);
            const double v = rng.real(-size, size);
            longer.insert(longer.begin() + place, {u, v});
            if (judge(put(plane, {longer})) == Verdict::kSound) loop = longer;
        }
        ASSERT_NO_FATAL_FAILURE(must_make(maker, put(plane, {loop})));
    }
}

TEST(MakeFacets, StarsOnSlantedPlanes) {
    FacetMaker maker;
    Rng rng(4);
    Tally tally;
    for (int round = 0; round < 400; ++round) {
        const SamplePlane plane = any_plane(rng);
        const double size = std::ldexp(1, rng.whole(3, 24));
        const int count = rng.whole(4, 60);
        const double inner = rng.real(0.1, 1);
        const Loop loop = star(rng, count, {0, 0}, inner * size, size);
        ASSERT_NO_FATAL_FAILURE(try_face(maker, put(plane, {with_runs(rng, loop, round % 4)}), tally));
    }
    EXPECT_GT(tally.made, 250);
    EXPECT_GT(tally.refused, 5);
}

/// The sides of these have corners a step off to either side: slivers, or crossings.
TEST(MakeFacets, CollinearRunsRounded) {
    FacetMaker maker;
    Rng rng(5);
    Tally tally;
    for (int round = 0; round < 600; ++round) {
        const double size = std::ldexp(1, rng.whole(4, 22));
        const SamplePlane plane = any_plane(rng);
        const Loop loop = circle(rng.whole(3, 6), {0, 0}, size);
        ASSERT_NO_FATAL_FAILURE(try_face(maker, put(plane, {with_runs(rng, loop, 12)}), tally));
    }
    EXPECT_GT(tally.made, 400);
}

TEST(MakeFacets, Slivers) {
    FacetMaker maker;
    Rng rng(6);
    Tally tally;
    for (int round = 0; round < 2000; ++round) {
        const double length = std::ldexp(1, rng.whole(2, 24)), width = rng.real(0.5, 4), slope = rng.real(-1, 1);
        Loop loop;
        const int below = rng.whole(1, 6), above = rng.whole(1, 6);
        for (int k = 0; k <= below; ++k) loop.push_back({length * k / below, slope * length * k / below});
        for (int k = above; k >= 0; --k) loop.push_back({length * k / above, slope * length * k / above + width});
        ASSERT_NO_FATAL_FAILURE(try_face(maker, put(any_plane(rng), {loop}), tally));
    }
    EXPECT_GT(tally.made, 500);
    EXPECT_GT(tally.refused, 100);
}

TEST(MakeFacets, CombsAndSpirals) {
    FacetMaker maker;
    Rng rng(7);
    for (const int size : {1, 2, 5, 20, 80}) {
        ASSERT_NO_FATAL_FAILURE(must_make(maker, put(any_plane(rng), {comb(size, 1000, 30000)})));
        ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn({comb(size, 1000, 30000)})));
        ASSERT_NO_FATAL_FAILURE(must_make(maker, put(any_plane(rng), {spiral(size + 2, 1000)})));
        ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn({spiral(size + 2, 1000)})));
    }
}

TEST(MakeFacets, Craters) {
    FacetMaker maker;
    Rng rng(8);
    for (int round = 0; round < 100; ++round) {
        const double size = std::ldexp(1, rng.whole(12, 22));
        const SamplePlane plane = round % 2 ? any_plane(rng) : sample_axis_plane(rng.whole(0, 2), rng.whole(0, 1) == 1);
        ASSERT_NO_FATAL_FAILURE(must_make(maker, put(plane, crater(rng, 40, size))));
    }
}

TEST(MakeFacets, ManyHoles) {
    FacetMaker maker;
    Rng rng(9);
    for (int round = 0; round < 150; ++round) {
        const SamplePlane plane = round % 2 ? any_plane(rng) : sample_axis_plane(rng.whole(0, 2), rng.whole(0, 1) == 1);
        const int holes = rng.whole(1, 12);
        ASSERT_NO_FATAL_FAILURE(must_make(maker, put(plane, sieve(rng, holes, 12, 100000))));
    }
}

/// Bridges meet the same corner of the rim, or run through between each other.
TEST(MakeFacets, HolesThatShareARimCorner) {
    FacetMaker maker;
    for (int holes = 1; holes <= 10; ++holes) {
        std::vector<Loop> loops{{{0, 0}, {100000, -90000}, {100000, 90000}}};
        for (int k = 0; k < holes; ++k) {
            const double v = (k - 0.5 * (holes - 1)) * 10000;
            loops.push_back({{70000, v}, {75000, v + 4000}, {75000, v - 4000}});
        }
        ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn(loops)));
    }
}

TEST(MakeFacets, HolesInTheWrongPlaceAreRefused) {
    FacetMaker maker;
    Facets facets;
    const Loop rim = rectangle(0, 0, 100, 100), hole = reversed(rectangle(20, 20, 60, 60));
    const auto makes = [&](const std::vector<Loop>& loops) {
        const SampleFace face = drawn(loops);
        return maker.make(face.points, face.ends, {face.axis, face.flip}, facets);
    };
    EXPECT_TRUE(makes({rim, hole}));
    EXPECT_FALSE(makes({rim, rectangle(20, 20, 60, 60)})) << "counter-clockwise";
    EXPECT_FALSE(makes({reversed(rim), hole})) << "all turned over";
    EXPECT_FALSE(makes({hole, rim}));
    EXPECT_FALSE(makes({rim, reversed(rectangle(120, 20, 160, 60))})) << "outside";
    EXPECT_FALSE(makes({rim, reversed(rectangle(-60, 20, -20, 60))})) << "outside";
    EXPECT_FALSE(makes({rim, reversed(rectangle(-60, -60, 160, 160))})) << "around";
    EXPECT_FALSE(makes({rim, hole, reversed(rectangle(30, 30, 40, 40))})) << "a hole in a hole";
    EXPECT_FALSE(makes({rim, hole, hole})) << "twice";
    EXPECT_FALSE(makes({rim, reversed(rectangle(0, 20, 60, 60))})) << "along the rim";
    EXPECT_FALSE(makes({rim, reversed(rectangle(50, 20, 150, 60))})) << "across";
}

/// A strip that bends around and runs over itself: every turn of it is harmless, and it winds around just once.
TEST(MakeFacets, OverlappingStripIsRefused) {
    const SampleFace face = drawn({{{0, 0},
                                    {100, 0},
                                    {100, 100},
                                    {-50, 100},
                                    {-50, 20},
                                    {50, 20},
                                    {50, 40},
                                    {-30, 40},
                                    {-30, 80},
                                    {80, 80},
                                    {80, 30},
                                    {0, 30}}});
    EXPECT_EQ(judge(face), Verdict::kWrong);
    FacetMaker maker;
    Facets facets;
    EXPECT_FALSE(maker.make(face.points, face.ends, {2, false}, facets));
}

TEST(MakeFacets, ConvexLoopsOfAWallStayWhole) {
    EXPECT_EQ(count_facets(drawn({rectangle(0, 0, 70000, 30000)})), 1u);
    EXPECT_EQ(count_facets(drawn({circle(8, {0, 0}, 50000)})), 1u);
    EXPECT_EQ(count_facets(drawn({circle(64, {0, 0}, 1e6)})), 1u);
    EXPECT_EQ(count_facets(drawn({circle(65, {0, 0}, 1e6)})), 2u);
    EXPECT_EQ(count_facets(drawn({{{0, 0}, {10, 0}, {20, 0}, {20, 10}, {20, 20}, {0, 20}, {0, 1}}})), 1u)
        << "corners along sides";
}

TEST(MakeFacets, OneStepOffThePlaneDivides) {
    SampleFace quad = drawn({rectangle(0, 0, 70000, 30000)}), ring = drawn({circle(8, {0, 0}, 50000)});
    quad.points[1].z = 1;
    EXPECT_EQ(count_facets(quad), 2u);
    ring.points[7].z = -1;
    EXPECT_GE(count_facets(ring), 2u);
    for (GridPoint& point : ring.points) point.z = point.x - 2 * point.y;
    EXPECT_EQ(count_facets(ring), 1u) << "slanted, and planar to the step";
}

/// Six times the volume of the corners is 2^66: a whole number of 2^64.
TEST(MakeFacets, VolumesThatVanishIn64Bits) {
    constexpr double kSide = 1 << 22;
    SampleFace quad = drawn({rectangle(0, 0, kSide, kSide)});
    quad.points[1].z = 1 << 22;
    EXPECT_EQ(count_facets(quad), 2u);
}

TEST(MakeFacets, WallsMergeToFewFacets) {
    EXPECT_EQ(count_facets(drawn({{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}}})), 2u) << "L";
    EXPECT_EQ(
        count_facets(drawn(
            {{{0, 0}, {6, 0}, {13, 0}, {20, 0}, {20, 10}, {15, 10}, {10, 10}, {10, 15}, {10, 20}, {0, 20}, {0, 9}}})),
        2u)
        << "L with corners along its sides";
    EXPECT_LE(count_facets(drawn({rectangle(0, 0, 90, 90), reversed(rectangle(30, 30, 60, 60))})), 5u) << "frame";
    Rng rng(10);
    const SampleFace face = drawn(crater(rng, 40, 1e6));
    EXPECT_LT(count_facets(face), 30u) << "of 44 triangles";
}

TEST(MakeFacets, AcrossTheWholeWorld) {
    FacetMaker maker;
    constexpr double kLow = INT32_MIN, kHigh = INT32_MAX;
    const Loop rim = rectangle(kLow, kLow, kHigh, kHigh);
    EXPECT_EQ(count_facets(drawn({rim})), 1u);
    ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn({rim, reversed(circle(40, {5, 5}, 2e9))})));
    const Loop five{{kLow, kLow}, {kHigh, kLow}, {kHigh, kHigh}, {0, kHigh - 1}, {kLow, kHigh}};
    ASSERT_NO_FATAL_FAILURE(must_make(maker, drawn({five})));
    SampleFace slanted = drawn({five});
    for (std::size_t k = 0; k < 5; ++k) slanted.points[k].z = slanted.points[k].x;
    ASSERT_NO_FATAL_FAILURE(must_make(maker, slanted));
    EXPECT_EQ(count_facets(slanted), 2u) << "planar, and not convex";
    slanted.points[2].z -= 1;
    ASSERT_NO_FATAL_FAILURE(must_make(maker, slanted));
    EXPECT_EQ(count_facets(slanted), 2u) << "one corner a step off: a triangle of its own";
}

TEST(MakeFacets, ThousandsOfCorners) {
    FacetMaker maker;
    Rng rng(11);
    Facets facets;
    for (const SampleFace& face :
         {put(any_plane(rng), {star(rng, 2000, {0, 0}, 4e6, 8e6)}), drawn({comb(1000, 5000, 8e6)}),
          drawn({spiral(1000, 20000)}), put(any_plane(rng), {circle(2000, {0, 0}, 8e6)})}) {
        ASSERT_TRUE(maker.make(face.points, face.ends, {face.axis, face.flip}, facets));
        ASSERT_EQ(fault(face, facets), "");
    }
}

TEST(MakeFacets, ScratchLeavesNoTrace) {
    FacetMaker used;
    Rng rng(12);
    for (int round = 0; round < 50; ++round) {
        const SampleFace face = put(any_plane(rng), sieve(rng, round % 5, 9, 3000));
        FacetMaker fresh;
        Facets a, b;
        ASSERT_TRUE(used.make(face.points, face.ends, {face.axis, face.flip}, a));
        ASSERT_TRUE(fresh.make(face.points, face.ends, {face.axis, face.flip}, b));
        ASSERT_EQ(a.corners, b.corners);
        ASSERT_EQ(a.first, b.first);
    }
}

}  // namespace
}  // namespace firma
