// SPDX-License-Identifier: MIT
// Players at any speed, in ticks of any length, with any way up, in the blasted depot and in blasted maps, with a
// capsule, a box and spheres.
#include <cmath>

#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerMotion : public InPlayerLevels {};
INSTANTIATE_TEST_SUITE_P(, PlayerMotion, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerMotion, AtAnySpeedItPassesNoWall) {
    at_walls(false, [&](const WallPlace& wall) {
        for (const double speed : {40.0, 1000.0, 1e5})
            for (const double askew : {0.0, 0.01, 1.0}) {
                Walk walk = stands(world(), wall.foot + wall.normal * 0.7);
                const Vec3 way = wall.along * askew - wall.normal;
                walk.player.velocity = way * speed;
                walk.player.on_ground = false;
                walk.wait(1);
                EXPECT_GT(dot(walk.at() - wall.foot, wall.normal), 0.3) << speed << ' ' << askew;
                EXPECT_LT(dot(walk.at() - wall.foot, wall.normal), askew < 0.5 ? 0.3 + 2 * kOffset : 1e4) << speed;
                EXPECT_FALSE(walk.player.stuck);
                EXPECT_TRUE(is_inside(world(), walk)) << speed << ' ' << askew;
            }
    });
}

TEST_P(PlayerMotion, IntoACornerAtAnySpeedItStopsInIt) {
    at_walls(true, [&](const WallPlace& wall) {
        for (const double speed : {10.0, 100.0, 5000.0}) {
            Walk walk = stands(world(), wall.foot + (wall.normal + wall.along) * 0.6);
            for (int k = 0; k < 10; ++k) walk.go((wall.normal + wall.along) * -speed, 1);
            EXPECT_NEAR(dot(walk.at() - wall.foot, wall.normal), 0.3 + kOffset, 1e-4) << speed;
            EXPECT_NEAR(dot(walk.at() - wall.foot, wall.along), 0.3 + kOffset, 1e-4) << speed;
            EXPECT_NEAR(walk.at().z, wall.foot.z + kOffset, 1e-6) << speed;
        }
    });
}

TEST_P(PlayerMotion, InTicksOfAnyLengthItWalksAsFar) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        for (const int rate : {4, 10, 30, 240, 1000}) {
            Walk walk = stands(world(), place.at - place.along * 0.5);
            const Vec3 from = walk.at();
            walk.seconds = 1.0 / rate;
            walk.go(place.along * 2, rate / 2);
            EXPECT_LT(length(walk.at() - from - place.along), 1e-6) << rate;
            EXPECT_EQ(walk.airborne, 0u) << rate;
        }
    });
}

TEST_P(PlayerMotion, InTicksOfAnyLengthItStopsAtAWallAndSlidesOn) {
    at_walls(false, [&](const WallPlace& wall) {
        for (const int rate : {4, 10, 30, 240, 1000}) {
            Walk walk = stands(world(), wall.foot + wall.normal * 0.6 - wall.along * 0.6);
            walk.seconds = 1.0 / rate;
            walk.go(wall.normal * -1.0, rate / 2);
            const double gap = dot(walk.at() - wall.foot, wall.normal) - 0.3;
            EXPECT_GT(gap, 0) << rate;
            EXPECT_LT(gap, 1.05 * kOffset) << rate;
            const double from = dot(walk.at(), wall.along);
            walk.go(wall.along - wall.normal, rate / 2);
            EXPECT_NEAR(dot(walk.at(), wall.along) - from, rate / 2 / double(rate), 0.005) << rate;
        }
    });
}

TEST_P(PlayerMotion, InTicksOfAnyLengthItFallsAsFast) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        for (const int rate : {4, 10, 30, 240, 1000}) {
            Walk walk(world(), shape(), place.at + Vec3{0, 0, 1});
            walk.seconds = 1.0 / rate;
            double landed = 0;
            int ticks = 0;
            for (; ticks < rate && landed == 0; ++ticks) landed = walk.move({}).landed_speed;
            const double time = std::sqrt(2 / 9.81);
            EXPECT_NEAR(ticks / double(rate), time, 1.0 / rate + 0.001) << rate;
            EXPECT_NEAR(landed, 9.81 * time, 9.81 / rate + 0.02) << rate;
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << rate;
        }
    });
}

// A wall of the level is the ground of a player whose up is its normal.
TEST_P(PlayerMotion, WithUpAWallsNormalItStandsOnTheWallAndWalksToItsFoot) {
    at_walls(false, [&](const WallPlace& wall) {
        // As low as it is wide: there is little room before a wall.
        const PlayerSize size{.radius = 0.25, .height = 0.6, .crouched_height = 0.5, .up = wall.normal};
        const std::vector<Sphere> ball{{wall.normal * 0.25, 0.25}};
        const PlayerShape shape = std::get<1>(GetParam()) == 0 ? make_player_capsule(size).value()
                                  : is_box()                   ? make_player_box(size).value()
                                                               : make_player_spheres(ball, {}, wall.normal).value();
        Player player;
        player.position = wall.foot + wall.normal * 0.1 + Vec3{0, 0, 1};
        const auto go = [&](const Vec3& velocity, int ticks) {
            for (int k = 0; k < ticks; ++k) {
                const PlayerMove move = move_player(world(), shape, player, {.velocity = velocity}, kTick);
                ASSERT_TRUE(move.valid);
                player = move.player;
                ASSERT_TRUE(player_fits(world(), shape, player.position));
            }
        };
        go({}, 60);
        EXPECT_TRUE(player.on_ground);
        EXPECT_NEAR(dot(player.position - wall.foot, wall.normal), kOffset, 1e-6);
        EXPECT_NEAR(player.position.z - wall.foot.z, 1, 1e-6);
        const Vec3 from = player.position;
        go(wall.along, 30);
        EXPECT_NEAR(dot(player.position - from, wall.along), 0.5, 0.02);
        EXPECT_NEAR(player.position.z, from.z, 1e-6);
        go({0, 0, -2}, 60);  // the floor is a wall to it
        EXPECT_NEAR(player.position.z - wall.foot.z, 0.25 + kOffset, 1e-4);
        EXPECT_TRUE(player.on_ground);
    });
}

}  // namespace
}  // namespace firma::test
