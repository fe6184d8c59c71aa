// SPDX-License-Identifier: MIT
// Players and parts that move in the blasted depot and in blasted maps: trains, turntables, lifts under the level's
// ceilings, doors in its gaps, with a capsule, a box and spheres.
#include <cmath>

#include "tests/moving/part_worlds.h"
#include "tests/player/path_ride.h"
#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerPartsInLevels : public InPlayerLevels {
protected:
    /// A platform 1 m wide and 0.25 m over the floor, that goes along a place from -0.6 to 0.6 m and back in 4 s.
    PathRide on_train(const FloorPlace& place) const {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.5, -0.5, -0.125}, {0.5, 0.5, 0}))}};
        const Vec3 up{0, 0, 0.25}, far = place.along * 0.6;
        ride.path.stops = {{.position = place.at + up - far, .wait = 0.25, .seconds = 2},
                           {.position = place.at + up + far, .wait = 0, .seconds = 2}};
        ride.path.repeats = true;
        ride.player.position = place.at + up - far + Vec3{0, 0, kOffset};
        for (int k = 0; k < 10; ++k) ride.tick();
        EXPECT_EQ(ride.player.ground_part, 0u);
        ride.airborne = 0;
        return ride;
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerPartsInLevels, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerPartsInLevels, ATrainTakesItThereAndBack) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        PathRide ride = on_train(place);
        const Vec3 over = ride.player.position - ride.part_at();
        double farthest = 0;
        for (int k = 0; k < 230; ++k) {
            ride.tick();
            EXPECT_LT(length(ride.player.position - ride.part_at() - over), 1e-6) << k;
            farthest = std::max(farthest, dot(ride.player.position - place.at, place.along));
        }
        EXPECT_GT(farthest, 0.57);
        EXPECT_EQ(ride.airborne, 0);
        EXPECT_EQ(ride.crushed, 0);
    });
}

TEST_P(PlayerPartsInLevels, OnATrainItWalksByItsOwnSpeed) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        PathRide ride = on_train(place);
        while (ride.ticks < 20) ride.tick();
        for (int k = 0; k < 60; ++k) {
            const double way = k / 15 % 2 ? -1 : 1;
            const Vec3 over = ride.player.position - ride.part_at();
            ride.tick({.velocity = side_of(place) * way});
            if (k % 15 < 3) continue;  // it comes to that speed by 60 m/s2
            const Vec3 gone = ride.player.position - ride.part_at() - over;
            EXPECT_LT(length(gone - side_of(place) * (way / 60)), 1e-6) << k;
        }
        EXPECT_EQ(ride.airborne, 0);
    });
}

TEST_P(PlayerPartsInLevels, WhoJumpsOffATrainKeepsItsSpeed) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        PathRide ride = on_train(place);
        while (ride.ticks < 30) ride.tick();
        ride.tick({.jump = true});
        EXPECT_TRUE(ride.last.jumped);
        EXPECT_NEAR(dot(ride.player.velocity, place.along), 0.6, 1e-6);
        const double from = dot(ride.player.position, place.along);
        for (int k = 0; k < 30; ++k) ride.tick();
        EXPECT_FALSE(ride.player.on_ground);
        EXPECT_NEAR(dot(ride.player.position, place.along) - from, 0.3, 0.3);  // less what the air's braking takes
        EXPECT_GT(dot(ride.player.position, place.along) - from, 0);
        for (int k = 0; k < 60 && !ride.player.on_ground; ++k) ride.tick();
        EXPECT_TRUE(ride.player.on_ground);
    });
}

TEST_P(PlayerPartsInLevels, FromTheFloorOntoATrainThatPasses) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.4, -0.4, -0.125}, {0.4, 0.4, 0}))}};
        const Vec3 up{0, 0, 0.25};
        ride.path.stops = {{.position = place.at + up - place.along * 0.4, .wait = 0.25, .seconds = 3},
                           {.position = place.at + up + place.along * 1.2, .wait = 9}};
        ride.player.position = place.at - place.along * 1.4 + Vec3{0, 0, kOffset};
        for (int k = 0; k < 150 && ride.player.ground_part == kNoPart; ++k) ride.tick({.velocity = place.along * 2});
        EXPECT_EQ(ride.player.ground_part, 0u);
        for (int k = 0; k < 12; ++k) ride.tick({.velocity = place.along * 2});
        for (int k = 0; k < 30; ++k) ride.tick();
        EXPECT_EQ(ride.player.ground_part, 0u);
        EXPECT_NEAR(ride.player.position.z, place.at.z + 0.25 + kOffset, 1e-6);
        EXPECT_EQ(ride.crushed, 0);
    });
}

TEST_P(PlayerPartsInLevels, ATurntableTakesItRound) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        for (const double spin : {1.0, -2.0}) {
            PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.9, -0.9, -0.125}, {0.9, 0.9, 0}))}};
            ride.path.stops = {{.position = place.at + Vec3{0, 0, 0.25}}};
            ride.path.spin = spin;
            ride.player.position = place.at + Vec3{0.5, 0, 0.25 + kOffset};
            for (int k = 0; k < 10; ++k) ride.tick();
            ASSERT_EQ(ride.player.ground_part, 0u);
            ride.airborne = 0;
            const Vec3 began = ride.player.position - place.at;
            for (int k = 0; k < 120; ++k) ride.tick();
            const SineCosine turn = sine_cosine(spin * 2);
            const Vec3 turned{began.x * turn.cosine - began.y * turn.sine, began.x * turn.sine + began.y * turn.cosine,
                              began.z};
            EXPECT_LT(length(ride.player.position - place.at - turned), 1e-5) << spin;
            EXPECT_EQ(ride.airborne, 0) << spin;
        }
    });
}

TEST_P(PlayerPartsInLevels, ALiftThatRisesToACeilingCrushesItAndPutsItNotIntoTheCeiling) {
    at_features(FeatureKind::kLowCeiling, 2, [&](const Feature& ceiling) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.4, -0.4, -0.125}, {0.4, 0.4, 0}))}};
        const double rise = ceiling.size - 1.8 + 0.2;  // 20 cm more than there is room for
        ride.path.stops = {{.position = ceiling.at + Vec3{0, 0, 0.01}, .wait = 0.25, .seconds = 1},
                           {.position = ceiling.at + Vec3{0, 0, rise}, .wait = 0.25, .seconds = 1}};
        ride.player.position = ceiling.at + Vec3{0, 0, 0.02};
        for (int k = 0; k < 170; ++k) {
            ride.tick();
            EXPECT_LT(ride.player.position.z + 1.8, ceiling.at.z + ceiling.size + 1e-9) << k;
        }
        EXPECT_GT(ride.crushed, 0);
        EXPECT_EQ(ride.last.crushed_by, kNoPart);
        EXPECT_TRUE(ride.player.on_ground);
        EXPECT_LT(ride.player.position.z, ceiling.at.z + 0.02);
    });
}

TEST_P(PlayerPartsInLevels, ADoorThatShutsAcrossAGapCrushesItOrPutsItOut) {
    at_features(FeatureKind::kGap, 2, [&](const Feature& gap) {
        const Vec3 side{-gap.way.y, gap.way.x, 0};
        for (const double off : {0.0, 0.2, 0.34}) {  // metres along the gap, the leaf 0.1 m thick in its middle
            const double half = gap.size / 2;
            const Vec3 size = side * half + gap.way * 0.05;
            const Vec3 high{std::fabs(size.x), std::fabs(size.y), 1.7};
            PathRide ride{world(), shape(), {}, {MovingPart(box_world({-high.x, -high.y, 0}, high))}};
            const Vec3 shut = gap.at + Vec3{0, 0, 0.02};
            ride.path.stops = {{.position = shut - side * (half + 0.35), .wait = 0.25, .seconds = 1},
                               {.position = shut, .wait = 0.25, .seconds = 1}};
            ride.player.position = gap.at + gap.way * off + side * (half - 0.31) + Vec3{0, 0, kOffset};
            for (int k = 0; k < 170; ++k) {
                ride.tick();
                EXPECT_LT(std::fabs(dot(ride.player.position - gap.at, side)), half - 0.3 + 1e-6) << off << ' ' << k;
            }
            EXPECT_GT(ride.crushed + ride.pushed, 0) << off;
            EXPECT_EQ(ride.last.crushed_by, kNoPart) << off;  // it is open again
            EXPECT_TRUE(ride.player.on_ground) << off;
            const Vec3 at = ride.player.position;
            for (int k = 0; k < 6; ++k) ride.tick({.velocity = gap.way});
            EXPECT_GT(dot(ride.player.position - at, gap.way), 0.05) << off;
        }
    });
}

TEST_P(PlayerPartsInLevels, AWallScrapesItOffAPlatformThatGoesOn) {
    std::size_t scraped = 0;
    at_walls(false, [&](const WallPlace& wall) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.35, -0.35, -0.125}, {0.35, 0.35, 0}))}};
        const Vec3 up{0, 0, 0.25};
        ride.path.stops = {{.position = wall.foot + wall.normal * 0.4 + up, .wait = 0.25, .seconds = 1},
                           {.position = wall.foot - wall.normal * 0.6 + up, .wait = 9}};
        ride.player.position = wall.foot + wall.normal * 0.4 + up + Vec3{0, 0, kOffset};
        for (int k = 0; k < 10; ++k) ride.tick();
        if (ride.player.ground_part == kNoPart) return;  // something else is there
        ++scraped;
        for (int k = 0; k < 120; ++k) {
            ride.tick();
            EXPECT_GT(dot(ride.player.position - wall.foot, wall.normal), 0.3) << k;
        }
        EXPECT_NEAR(dot(ride.player.position - wall.foot, wall.normal), 0.3, 0.02);
        EXPECT_EQ(ride.crushed, 0);
        EXPECT_TRUE(ride.player.on_ground);
        EXPECT_EQ(ride.player.ground_part, kNoPart);
    });
    EXPECT_GE(scraped, 2u);
}

}  // namespace
}  // namespace firma::test
