// SPDX-License-Identifier: MIT
// Players and parts of a level that move: lifts, trains, turntables, doors.
#include <cmath>

#include "firma/part_path.h"
#include "tests/player/player_walk.h"

namespace firma::test {
namespace {

constexpr double kTick = 1.0 / 60;

World slab(const Vec3& low, const Vec3& high) {
    return brush_world(map_text::box(low, high, "metal"));
}

/// A player in a level with one part that goes on with the same motion from tick to tick, judged in each.
class Ride {
public:
    Ride(const World& level, const World& part, const Vec3& at, const PlayerShape& player_shape, const Vec3& feet)
        : world(level), parts{MovingPart(part)}, shape(player_shape) {
        parts[0].motion.position = at;
        player.position = feet;
    }

    /// @param speed, spin  of the part, metres and radians a second
    const PlayerMove& tick(const Vec3& speed, const Vec3& spin, const PlayerWish& wish = {}) {
        parts[0].motion.path = speed * kTick;
        parts[0].motion.turn = spin * kTick;
        last = move_player(Scene{world, parts}, shape, player, wish, kTick, rules);
        EXPECT_TRUE(last.valid);
        player = last.player;
        const Pose pose = pose_at(parts[0].motion, 1);
        parts[0].motion = {pose.position, pose.rotation, {}, {}};
        const Scene now{world, parts};
        EXPECT_TRUE(player_fits(world, shape, player.position, player.crouched)) << "in the level";
        if (last.crushed_by == kNoPart && !player.stuck) {
            EXPECT_TRUE(player_fits(now, shape, player.position, player.crouched)) << "in the part";
        }
        airborne += !player.on_ground;
        return last;
    }
    void ticks(int count, const Vec3& speed, const PlayerWish& wish = {}) {
        for (int k = 0; k < count; ++k) tick(speed, {}, wish);
    }
    const Vec3& at() const { return player.position; }
    const Vec3& part_at() const { return parts[0].motion.position; }

    World world;
    std::vector<MovingPart> parts;
    PlayerShape shape;
    Player player;
    PlayerRules rules;
    PlayerMove last;
    int airborne = 0;
};

class PlayerParts : public testing::TestWithParam<int> {
protected:
    PlayerShape shape() const { return player_shapes()[std::size_t(GetParam())]; }
    /// On a platform 4 m wide and 0.5 m thick, its top at z = 1.
    Ride on_platform(const std::string& level = "") const {
        return Ride(course(level), slab({-2, -2, -0.5}, {2, 2, 0}), {0, 0, 1}, shape(), {0, 0, 1 + kOffset});
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerParts, testing::Values(0, 1, 2), name_of_player_shape);

TEST_P(PlayerParts, ALiftTakesItUpAndDown) {
    for (const double speed : {1.0, 8.0, 40.0}) {
        Ride ride = on_platform();
        ride.ticks(5, {});
        ASSERT_EQ(ride.player.ground_part, 0u);
        ride.airborne = 0;
        ride.ticks(30, {0, 0, speed});
        EXPECT_NEAR(ride.at().z, ride.part_at().z + kOffset, 1e-6) << speed;
        ride.ticks(30, {0, 0, -speed});
        EXPECT_NEAR(ride.at().z, 1 + kOffset, 1e-6) << speed;
        EXPECT_EQ(ride.airborne, 0) << speed;
        EXPECT_EQ(ride.player.velocity, Vec3()) << speed;
    }
}

TEST_P(PlayerParts, APlatformTakesItAlongAndItWalksOnThat) {
    Ride ride = on_platform();
    ride.ticks(5, {});
    ride.ticks(60, {3, 1, 0});
    EXPECT_NEAR(ride.at().x - ride.part_at().x, 0, 1e-6);
    EXPECT_NEAR(ride.at().y - ride.part_at().y, 0, 1e-6);
    EXPECT_NEAR(length(ride.player.ground_velocity - Vec3{3, 1, 0}), 0, 1e-9);
    ride.ticks(30, {3, 1, 0}, {.velocity = {0, 2, 0}});
    EXPECT_NEAR(ride.at().x - ride.part_at().x, 0, 1e-6);
    EXPECT_NEAR(ride.at().y - ride.part_at().y, 1, 0.05);
    EXPECT_EQ(ride.airborne, 0);
}

// Jolt's #1514: on a platform that goes down and sideways at once, users saw their character jitter sideways.
TEST_P(PlayerParts, OnAPlatformThatGoesDownAndSidewaysItStandsStill) {
    for (const Vec3& way : {Vec3{1, 0, -1}, {2, 1, -2}, {-1, 0, 1}, {0.25, 0, -8}, {6, -6, -0.5}}) {
        Ride ride = Ride(course(""), slab({-2, -2, -0.5}, {2, 2, 0}), {0, 0, 12}, shape(), {0, 0, 12 + kOffset});
        ride.ticks(30, {});
        const Vec3 over = ride.at() - ride.part_at();
        for (int k = 0; k < 60; ++k) {
            ride.tick(way, {});
            EXPECT_LT(length(ride.at() - ride.part_at() - over), 1e-6) << k;
            EXPECT_EQ(ride.player.velocity, (Vec3{})) << k;
        }
        EXPECT_EQ(ride.airborne, 0) << way.z;
    }
}

TEST_P(PlayerParts, WhoJumpsOffKeepsItsSpeed) {
    Ride ride = on_platform();
    ride.ticks(5, {5, 0, 0});
    const double x = ride.at().x;
    ride.ticks(1, {5, 0, 0}, {.jump = true});
    EXPECT_TRUE(ride.last.jumped);
    EXPECT_NEAR(ride.player.velocity.x, 5, 1e-9);
    for (int k = 0; k < 20; ++k) ride.tick({5, 0, 0}, {});
    EXPECT_NEAR(ride.at().x - x, 21 * 5 * kTick, 0.09);
    while (!ride.player.on_ground) ride.tick({5, 0, 0}, {});
    EXPECT_EQ(ride.player.ground_part, 0u);  // it comes down on the same place
    EXPECT_NEAR(ride.player.velocity.x, 0, 1e-9);
}

TEST_P(PlayerParts, WalkingOffAPlatformItFliesOnWithBothSpeeds) {
    Ride ride = on_platform();
    ride.ticks(5, {2, 0, 0});
    for (int k = 0; k < 120 && ride.player.on_ground; ++k) ride.tick({2, 0, 0}, {}, {.velocity = {3, 0, 0}});
    ASSERT_FALSE(ride.player.on_ground);
    EXPECT_NEAR(ride.player.velocity.x, 5, 0.6);
    ride.ticks(60, {2, 0, 0});
    EXPECT_EQ(ride.player.ground_part, kNoPart);
    EXPECT_NEAR(ride.at().z, kOffset, 1e-6);
}

TEST_P(PlayerParts, ATurntableTakesItRound) {
    Ride ride = on_platform();
    ride.player.position = {1.5, 0, 1 + kOffset};
    ride.ticks(5, {});
    for (int k = 0; k < 240; ++k) ride.tick({}, {0, 0, 1});
    EXPECT_NEAR(std::hypot(ride.at().x, ride.at().y), 1.5, 1e-6);
    EXPECT_NEAR(ride.at().x, 1.5 * std::cos(4), 1e-5);
    EXPECT_NEAR(ride.at().y, 1.5 * std::sin(4), 1e-5);
    EXPECT_EQ(ride.airborne, 0);
}

TEST_P(PlayerParts, AWallStopsItOnAPlatformThatGoesOn) {
    Ride ride = on_platform(map_text::box({4, -8, -1}, {5, 8, 8}, "rock"));
    ride.ticks(5, {});
    ride.ticks(90, {3, 0, 0});  // the platform goes into the wall; the player does not
    EXPECT_NEAR(ride.at().x, 4 - 0.3 - kOffset, 0.01);
}

TEST_P(PlayerParts, ADoorPushesItAlong) {
    for (const double speed : {0.5, 4.0, 30.0}) {
        Ride ride(course(""), slab({-0.05, -1, 0}, {0.05, 1, 3}), {-2, 0, 0.01}, shape(), {0, 0, kOffset});
        ride.ticks(5, {});
        int pushed = 0;
        while (ride.part_at().x < 1) {
            ride.tick({speed, 0, 0}, {});
            pushed += ride.last.pushed_by == 0;
        }
        EXPECT_GT(ride.at().x, ride.part_at().x + 0.05 + 0.3 - 1e-3) << speed;
        EXPECT_LT(ride.at().x, ride.part_at().x + 0.4) << speed;
        EXPECT_GT(pushed, 0) << speed;
    }
}

TEST_P(PlayerParts, ABladeThatTurnsPushesIt) {
    Ride ride(course(""), slab({-3, -0.1, 0}, {3, 0.1, 2}), {0, 0, 0.01}, shape(), {2, 1, kOffset});
    ride.ticks(5, {});
    for (int k = 0; k < 120; ++k) ride.tick({}, {0, 0, 1.5});
    EXPECT_GT(length(across(ride.at() - Vec3{2, 1, 0})), 0.5);
    EXPECT_EQ(ride.last.crushed_by, kNoPart);
}

TEST_P(PlayerParts, BetweenDoorAndWallItIsCrushedAndNotPutIntoTheWall) {
    Ride ride(course(map_text::box({1, -8, -1}, {2, 8, 8}, "rock") + map_text::box({-2, 0.6, -1}, {1, 2, 8}, "rock") +
                     map_text::box({-2, -2, -1}, {1, -0.6, 8}, "rock")),
              slab({-0.1, -0.5, 0}, {0.1, 0.5, 3}), {-1.5, 0, 0.01}, shape(), {0.5, 0, kOffset});
    ride.ticks(5, {});
    bool crushed = false;
    while (ride.part_at().x < 0.6) {
        ride.tick({1, 0, 0}, {});
        crushed |= ride.last.crushed_by == 0;
        EXPECT_LE(ride.at().x, 1 - 0.3 + 1e-6);
    }
    EXPECT_TRUE(crushed);
    ride.ticks(90, {-1, 0, 0});  // it opens again
    EXPECT_EQ(ride.last.crushed_by, kNoPart);
    ride.ticks(10, {-1, 0, 0}, {.velocity = {-3, 0, 0}});
    EXPECT_LT(ride.at().x, 0.6);
}

TEST_P(PlayerParts, ALiftUnderACeilingCrushes) {
    Ride ride = on_platform(map_text::box({-4, -4, 4}, {4, 4, 5}, "rock"));
    ride.ticks(5, {});
    bool crushed = false;
    while (ride.part_at().z < 2.6) {
        ride.tick({0, 0, 1}, {});
        crushed |= ride.last.crushed_by == 0;
        EXPECT_LE(ride.at().z + 1.8, 4);
    }
    EXPECT_TRUE(crushed);
    while (ride.part_at().z > 1) ride.tick({0, 0, -1}, {});
    EXPECT_EQ(ride.last.crushed_by, kNoPart);
    EXPECT_TRUE(ride.player.on_ground);
}

TEST_P(PlayerParts, OntoAMovingPlatformFromTheGround) {
    Ride ride(course(""), slab({-2, -2, -0.5}, {2, 2, 0}), {4, 0, 0.25}, shape(), {0, 0, kOffset});
    ride.ticks(5, {});
    for (int k = 0; k < 120 && ride.player.ground_part == kNoPart; ++k)
        ride.tick({-1, 0, 0}, {}, {.velocity = {3, 0, 0}});
    EXPECT_EQ(ride.player.ground_part, 0u);
    ride.ticks(15, {-1, 0, 0}, {.velocity = {3, 0, 0}});  // a capsule is on its edge yet
    ride.ticks(30, {-1, 0, 0});
    EXPECT_EQ(ride.player.ground_part, 0u);
    EXPECT_NEAR(ride.at().z, 0.25 + kOffset, 1e-6);
}

TEST_P(PlayerParts, MotionsByTimeTakeItThereAndBack) {
    PartPath path;
    path.stops = {{.position = {0, 0, 1}, .wait = 0.5, .seconds = 2},
                  {.position = {0, 4, 5}, .wait = 0.5, .seconds = 2}};
    path.repeats = true;
    Ride ride = on_platform();
    double highest = 0;
    for (int k = 0; k < 300; ++k) {
        const double time = k * kTick;
        ride.parts[0].motion = part_motion(path, time, time + kTick);
        ride.last = move_player(Scene{ride.world, ride.parts}, ride.shape, ride.player, {}, kTick);
        ride.player = ride.last.player;
        highest = std::max(highest, ride.at().z);
        EXPECT_TRUE(ride.player.on_ground) << k;
    }
    EXPECT_NEAR(highest, 5 + kOffset, 1e-3);
    EXPECT_NEAR(ride.at().z, 1 + kOffset, 1e-3);
    EXPECT_NEAR(ride.at().y, 0, 1e-3);
}

TEST(PlayerPartsInput, BadMotionsAreRefused) {
    const World world = course("");
    std::vector<MovingPart> parts{MovingPart(slab({-1, -1, -1}, {1, 1, 0}))};
    parts[0].motion.path.x = NAN;
    Player player;
    player.position = {0, 0, 2};
    EXPECT_FALSE(move_player(Scene{world, parts}, make_player_capsule().value(), player, {}, kTick).valid);
    parts[0].motion.path.x = 0;
    player.ground_part = 7;  // of another level
    player.on_ground = true;
    player.ground_normal = {0, 0, 1};
    EXPECT_TRUE(move_player(Scene{world, parts}, make_player_capsule().value(), player, {}, kTick).valid);
}

}  // namespace
}  // namespace firma::test
