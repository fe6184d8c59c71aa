// SPDX-License-Identifier: MIT
// What users of other libraries reported of their characters, in the blasted depot and in blasted maps: at places that
// are found there, with a capsule, a box and spheres.
#include <cmath>

#include "tests/moving/part_worlds.h"
#include "tests/player/path_ride.h"
#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerReports : public InPlayerLevels {
protected:
    /// Over a fold or a crest from 0.7 m before it and back, twice.
    void there_and_back(const Feature& feature, double speed, bool crest) const {
        const double low = crest ? -0.7 * feature.size : 0;
        Walk walk = stands(world(), feature.at - feature.way * 0.7 + Vec3{0, 0, low + 0.3 * feature.size + 0.01}, 30);
        // On a slope the offset, which is kept from the plane, is longer upright.
        const double over = crest ? kOffset * (std::sqrt(1 + feature.size * feature.size) - 1) : 0;
        for (const double way : {1.0, -1.0, 1.0, -1.0}) {
            walk.airborne = 0;
            double last = walk.at().z;
            for (int k = 0; k < int(1.4 / speed * 60); ++k) {
                walk.go(feature.way * (way * speed), 1);
                // Up on the way there, down on the way back, never the other way.
                EXPECT_GE((walk.at().z - last) * way, -1e-6 - over) << speed << ' ' << way << ' ' << k;
                last = walk.at().z;
            }
            EXPECT_EQ(walk.airborne, 0u) << speed << ' ' << way;
            EXPECT_GT(dot(walk.at() - feature.at, feature.way) * way, 0.4) << speed << ' ' << way;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerReports, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

// Jolt's #1514: on a platform that goes down and sideways at once the character jitters sideways.
TEST_P(PlayerReports, OnAPlatformThatGoesDownAndSidewaysItStandsStill) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        for (const double down : {0.9, 0.45, -0.9})
            for (int k = 0; k < 8; ++k) {
                const SineCosine turn = sine_cosine(k * 45 * kDegree);
                const Vec3 half = Vec3{turn.cosine, turn.sine, 0} * 0.35 + Vec3{0, 0, -down / 2};
                const Vec3 middle = place.at + Vec3{0, 0, 0.625};
                PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.5, -0.5, -0.125}, {0.5, 0.5, 0}))}};
                ride.path.stops = {{.position = middle - half, .wait = 0.25, .seconds = 1},
                                   {.position = middle + half, .wait = 1}};
                ride.player.position = middle - half + Vec3{0, 0, kOffset};
                for (int tick = 0; tick < 10; ++tick) ride.tick();
                const Vec3 over = ride.player.position - ride.part_at();
                ride.airborne = 0;
                for (int tick = 0; tick < 75; ++tick) {
                    ride.tick();
                    EXPECT_LT(length(ride.player.position - ride.part_at() - over), 1e-6) << k << ' ' << tick;
                    EXPECT_EQ(ride.player.velocity, Vec3()) << k << ' ' << tick;
                }
                EXPECT_EQ(ride.airborne, 0) << k;
                EXPECT_LT(length(ride.part_at() - middle - half), 1e-9) << k;
            }
    });
}

// Jolt's #1860: jitter where a slope and a floor meet, below.
TEST_P(PlayerReports, WhereAFloorMeetsASlopeItGoesBothWaysWithoutJitter) {
    at_features(FeatureKind::kFold, 3, [&](const Feature& fold) {
        for (const double speed : {0.2, 1.0, 4.0}) there_and_back(fold, speed, false);
        // In the fold it stands still.
        Walk walk = stands(world(), fold.at - fold.way * 0.6);
        walk.go(fold.way, 30);
        walk.wait(10);
        const Vec3 at = walk.at();
        for (int k = 0; k < 60; ++k) {
            walk.wait(1);
            EXPECT_LT(length(walk.at() - at), 1e-9) << k;
        }
    });
}

// The same above.
TEST_P(PlayerReports, OverTheCrestOfASlopeItNeverHops) {
    at_features(FeatureKind::kCrest, 3, [&](const Feature& crest) {
        for (const double speed : {0.2, 1.0, 4.0}) there_and_back(crest, speed, true);
        Walk walk = stands(world(), crest.at + crest.way * 0.6);
        walk.go(crest.way * -1.0, 36);
        walk.wait(10);
        const Vec3 at = walk.at();
        for (int k = 0; k < 60; ++k) {
            walk.wait(1);
            EXPECT_LT(length(walk.at() - at), 1e-9) << k;
        }
    });
}

// Rapier's #627, with #418 and #611: stuck at upright walls that are walked against at an angle, and the offset not
// kept. At angles that are hardly none, or hardly not straight on, and at speeds at which it comes on slower than the
// offset a tick.
TEST_P(PlayerReports, AtAWallAtAGlanceOrStraightOnItSlidesOnAndKeepsItsOffset) {
    at_walls(false, [&](const WallPlace& place) {
        for (const double degrees : {0.01, 1.0, 3.0, 85.0, 89.0})
            for (const double speed : {4.0, 0.5})
                for (const double side : {1.0, -1.0}) {
                    const SineCosine turn = sine_cosine(degrees * kDegree);
                    const Vec3 along = place.along * side,
                               wish = (along * turn.cosine - place.normal * turn.sine) * speed;
                    Walk walk = stands(world(), place.foot + place.normal * 0.4 - along * 0.8);
                    walk.go(place.normal * -2.0, 10);
                    walk.go(wish, 2);
                    const double share = speed * turn.cosine / 60;
                    for (int k = 0; k < 60 && dot(walk.at() - place.foot, along) < 0.8; ++k) {
                        const double from = dot(walk.at(), along);
                        walk.go(wish, 1);
                        const double gap = dot(walk.at() - place.foot, place.normal) - 0.3;
                        EXPECT_NEAR(dot(walk.at(), along) - from, share, 0.01 * share) << degrees << ' ' << k;
                        EXPECT_GT(gap, 0) << degrees << ' ' << k;
                        EXPECT_LT(gap, kOffset * 1.05) << degrees << ' ' << k;
                    }
                    EXPECT_EQ(walk.airborne, 0u) << degrees;
                }
    });
}

// PhysX's #400: stuck in small pits of a detailed mesh. The floor is shot at until it is one.
TEST_P(PlayerReports, OverAFloorFullOfSmallPitsItGoesOn) {
    std::size_t crossed = 0;
    at_places(kRun, 2, [&](const FloorPlace& place) {
        World pitted = world();
        scenes::Rng rng(place.faces + 3);
        for (int k = 0; k < 24; ++k) {
            const Vec3 at = place.at + place.along * (k * 0.1 - 1.15) + side_of(place) * rng.uniform(-0.3, 0.3);
            const double size = rng.uniform(0.12, 0.25), up = rng.uniform(0, 0.1);
            const CarveResult pit =
                carve(pitted, make_crater(CutterShape::kRocky, rng.next()), pose_at(at.x, at.y, at.z + up, size));
            if (pit.done() && !reference::opens_way_out(pitted, pit.world)) pitted = pit.world;
        }
        for (const double way : {1.0, -1.0}) {
            Walk walk = stands(pitted, place.at - place.along * (way * 1.75));
            walk.passes_sheets = true;
            for (int k = 0; k < 150 && dot(walk.at() - place.at, place.along) * way < 1.75; ++k)
                walk.go(place.along * (way * 2), 1);
            EXPECT_GT(dot(walk.at() - place.at, place.along) * way, 1.75);  // 105 ticks on flat ground
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
            EXPECT_TRUE(is_inside(pitted, walk));
            crossed += walk.ticks > 0;
        }
    });
    EXPECT_GE(crossed, 2u);
}

}  // namespace
}  // namespace firma::test
