// SPDX-License-Identifier: MIT
// Players in the air and crouched: jumps, ceilings, gaps, low passages.
#include <cmath>
#include <iterator>

#include "scenes/rng.h"
#include "tests/player/player_walk.h"

namespace firma::test {
namespace {

class PlayerJumps : public testing::TestWithParam<int> {
protected:
    Walk walk(const World& world, const Vec3& feet) const {
        return Walk(world, player_shapes()[std::size_t(GetParam())], feet);
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerJumps, testing::Values(0, 1, 2), name_of_player_shape);

TEST_P(PlayerJumps, AJumpReachesItsHeightAtAnyFrameRate) {
    for (const double rate : {10.0, 30.0, 60.0, 240.0}) {
        Walk walk = this->walk(course(""), {0, 0, kOffset});
        walk.seconds = 1 / rate;
        walk.wait(int(rate / 10));
        double highest = 0;
        walk.with({.jump = true}, 1);
        EXPECT_TRUE(walk.last.jumped);
        for (int k = 0; k < rate && !walk.player.on_ground; ++k) {
            highest = std::max(highest, walk.at().z);
            walk.wait(1);
        }
        const double step = 9.81 / rate / rate / 8;  // the top lies between two ticks
        EXPECT_NEAR(highest, kOffset + 4.4 * 4.4 / 2 / 9.81, step + 1e-9) << rate;
        EXPECT_TRUE(walk.player.on_ground) << rate;
        EXPECT_NEAR(walk.at().z, kOffset, 2e-7) << rate;
    }
}

TEST_P(PlayerJumps, NoJumpInTheAir) {
    Walk walk = this->walk(course(""), {0, 0, kOffset});
    walk.wait(1);
    walk.with({.jump = true}, 1);
    for (int k = 0; k < 20; ++k) EXPECT_FALSE(walk.move({.jump = true}).jumped);
}

TEST_P(PlayerJumps, ARunningJumpIsAsFarAsItsTimeInTheAir) {
    Walk walk = this->walk(course(""), {-10, 0, kOffset});
    walk.go({6, 0, 0}, 60);
    const double from = walk.at().x;
    walk.with({.velocity = {6, 0, 0}, .jump = true}, 1);
    while (!walk.player.on_ground) walk.go({6, 0, 0}, 1);
    EXPECT_NEAR(walk.at().x - from, 6 * 2 * 4.4 / 9.81, 0.11);
}

TEST_P(PlayerJumps, OverAGapAndNotWithoutAJump) {
    const World world = brush_world(map_text::box({-32, -32, -8}, {0, 32, 0}, "rock") +
                                    map_text::box({4, -32, -8}, {32, 32, 0}, "rock"));
    for (const bool jump : {false, true}) {
        Walk walk = this->walk(world, {-3, 0, kOffset});
        for (int k = 0; k < 110; ++k) walk.move({.velocity = {6, 0, 0}, .jump = jump && walk.at().x > -0.1});
        EXPECT_EQ(walk.at().z > -0.1, jump);
    }
}

TEST_P(PlayerJumps, ACeilingStopsAJump) {
    Walk walk = this->walk(course(map_text::box({-4, -4, 2}, {4, 4, 3}, "rock")), {0, 0, kOffset});
    walk.wait(1);
    walk.with({.jump = true}, 1);
    double highest = 0;
    int up = 0;
    bool ceiling = false;
    while (!walk.player.on_ground && ++up < 120) {
        walk.wait(1);
        highest = std::max(highest, walk.at().z);
        ceiling |= walk.met(ContactKind::kCeiling);
    }
    EXPECT_TRUE(ceiling);
    EXPECT_NEAR(highest, 0.2 - kOffset, 1e-6);
    EXPECT_LT(up, 24);  // it falls at once
}

TEST_P(PlayerJumps, AlongAWallAJumpIsAsHigh) {
    Walk walk = this->walk(course(map_text::box({1, -30, -1}, {2, 30, 8}, "rock")), {0.5, -10, kOffset});
    walk.go({4, 4, 0}, 60);
    walk.with({.velocity = {4, 4, 0}, .jump = true}, 1);
    double highest = 0;
    while (!walk.player.on_ground) {
        walk.go({4, 4, 0}, 1);
        highest = std::max(highest, walk.at().z);
    }
    EXPECT_NEAR(highest, 4.4 * 4.4 / 2 / 9.81, 0.01);
}

TEST_P(PlayerJumps, OntoABoxHigherThanAStep) {
    Walk walk = this->walk(course(map_text::box({2, -4, -1}, {4, 4, 0.75}, "rock")), {0, 0, kOffset});
    for (int k = 0; k < 60; ++k) walk.move({.velocity = {3, 0, 0}, .jump = walk.at().x > 1});
    EXPECT_NEAR(walk.at().z, 0.75 + kOffset, 1.1);
    walk.go({0, 0, 0}, 60);
    EXPECT_NEAR(walk.at().z, 0.75 + kOffset, 2e-7);
}

TEST_P(PlayerJumps, JumpsInACornerDoNotHoldIt) {
    Walk walk = this->walk(course(map_text::box({1, -8, -1}, {2, 8, 8}, "rock") +
                                  map_text::box({-8, 1, -1}, {1, 2, 8}, "rock") + ramp(-1, 1, 1.5)),
                           {-2, 0, kOffset});
    for (int k = 0; k < 600; ++k) walk.move({.velocity = {4, 4, 0}, .jump = true});
    walk.wait(60);
    ASSERT_TRUE(walk.player.on_ground);
    const Vec3 at = walk.at();
    walk.go({-3, -3, 0}, 60);
    EXPECT_GT(length(walk.at() - at), 1);
}

TEST_P(PlayerJumps, HeldBetweenSteepSlopesItStandsAndCanJump) {
    // A groove along y, its sides at 60 degrees.
    const double rise = std::sqrt(3.0);
    std::string groove;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 slope = Vec3{-side * rise, 0, 1} * 0.5;
        groove += map_text::plane_brush(
            {{slope, 0}, {{side, 0, 0}, 3}, {{-side, 0, 0}, 0}, {{0, 1, 0}, 20}, {{0, -1, 0}, 20}, {{0, 0, -1}, 1}},
            "rock");
    }
    Walk walk = this->walk(course(groove), {0.2, 0, 2});
    walk.wait(120);
    ASSERT_TRUE(walk.player.on_ground);
    const Vec3 at = walk.at();
    walk.wait(60);
    EXPECT_LT(length(walk.at() - at), 1e-6);
    walk.go({0, 3, 0}, 60);
    EXPECT_GT(walk.at().y, 2);
    walk.wait(10);
    EXPECT_TRUE(walk.move({.jump = true}).jumped);
    walk.wait(10);
    EXPECT_GT(walk.at().z, at.z + 0.3);
}

TEST_P(PlayerJumps, InAGrooveOfSteepSlopesItStandsWhereThatIsNotSteep) {
    // Along y, its sides at 60 degrees; it rises by so much a metre.
    for (const double rise : {0.075, 0.5, 1.5}) {
        std::string groove;
        for (const double side : {-1.0, 1.0}) {
            const Vec3 out{-side * std::sqrt(3.0), -rise, 1};
            groove += map_text::plane_brush({{out * (1 / length(out)), 0},
                                             {{side, 0, 0}, 3},
                                             {{-side, 0, 0}, 0},
                                             {{0, 1, 0}, 6},
                                             {{0, -1, 0}, 6},
                                             {{0, 0, -1}, 12}},
                                            "rock");
        }
        Walk walk = this->walk(course(groove), {0.1, 2, 2 * rise + 1.5});
        walk.wait(180);
        EXPECT_TRUE(walk.player.on_ground) << rise;
        if (rise > 1) {
            EXPECT_LT(walk.at().z, 0.1) << "slid down to the floor";
            continue;
        }
        const Vec3 at = walk.at();
        EXPECT_GT(at.z, rise * 1.5);
        walk.wait(60);
        EXPECT_LT(length(walk.at() - at), 1e-6) << rise;
        walk.go({0, -2, 0}, 30);
        EXPECT_LT(walk.at().y, at.y - 0.7) << rise;
        walk.wait(30);
        EXPECT_TRUE(walk.move({.jump = true}).jumped) << rise;
    }
}

TEST_P(PlayerJumps, CrouchesUnderALowBeamAndCannotStandThere) {
    Walk walk = this->walk(course(map_text::box({1, -8, 1.25}, {3, 8, 3}, "rock")), {0, 0, kOffset});
    walk.go({2, 0, 0}, 60);
    EXPECT_LT(walk.at().x, 1);
    walk.with({.velocity = {2, 0, 0}, .crouch = true}, 90);
    EXPECT_NEAR(walk.at().x, 0.7 + 1.5, 0.1);  // at half the speed
    walk.go({2, 0, 0}, 6);
    EXPECT_TRUE(walk.player.crouched);
    walk.go({2, 0, 0}, 120);
    EXPECT_FALSE(walk.player.crouched);
    EXPECT_GT(walk.at().x, 3);
}

TEST_P(PlayerJumps, CrouchedUpToWhereItIsTooLowAndOut) {
    // A ceiling that comes down along x.
    const Vec3 lean{0.2, 0, 1};
    const double size = length(lean);
    const std::string wedge = map_text::plane_brush({{lean * (-1 / size), -1.6 / size},
                                                     {{0, 0, 1}, 6},
                                                     {{-1, 0, 0}, 0},
                                                     {{1, 0, 0}, 7},
                                                     {{0, 1, 0}, 8},
                                                     {{0, -1, 0}, 8}},
                                                    "rock");
    Walk walk = this->walk(course(wedge), {-1, 0, kOffset});
    walk.with({.velocity = {3, 0, 0}, .crouch = true}, 240);
    const Vec3 in = walk.at();
    EXPECT_GT(in.x, 1.5);
    EXPECT_NEAR(in.z, kOffset, 2e-7);
    walk.with({.velocity = {3, 0.5, 0}, .crouch = true}, 60);
    EXPECT_NEAR(walk.at().x, in.x, 1e-3);
    EXPECT_GT(walk.at().y, 0.15);
    walk.go({-3, 0, 0}, 300);
    EXPECT_LT(walk.at().x, -1);
    EXPECT_FALSE(walk.player.crouched);
}

TEST_P(PlayerJumps, PushedInTheAirItKeepsItsSpeed) {
    Walk walk = this->walk(course(""), {0, 0, kOffset});
    walk.wait(1);
    walk.player.velocity = {12, 0, 6};
    walk.player.on_ground = false;
    walk.wait(60);
    EXPECT_NEAR(walk.at().x, 12, 1e-9);
    walk.wait(90);
    EXPECT_TRUE(walk.player.on_ground);
    EXPECT_EQ(walk.player.velocity, Vec3());
}

TEST(PlayerUp, AnyWayMayBeUp) {
    // The floor of one is the wall of another.
    const World room = brush_world(map_text::box({-32, -32, -8}, {32, 32, 0}, "rock") +
                                   map_text::box({-32, -32, 0}, {-2, 32, 20}, "rock"));
    for (const auto make : {make_player_capsule, make_player_box}) {
        PlayerSize size;
        size.up = {1, 0, 0};
        Walk walk(room, make(size).value(), {3, 0, 10});
        for (int k = 0; k < 120; ++k)
            walk.player = move_player(walk.world, walk.shape, walk.player, {.velocity = {0, 2, -2}}, 1.0 / 60).player;
        EXPECT_TRUE(walk.player.on_ground);
        EXPECT_NEAR(walk.at().x, -2 + kOffset, 2e-7);
        EXPECT_GT(walk.at().y, 2);
        EXPECT_LT(walk.at().z, 8);
    }
}

TEST(PlayerInput, BadShapesAreRefused) {
    EXPECT_FALSE(make_player_capsule({.radius = -1}).ok());
    EXPECT_FALSE(make_player_capsule({.radius = 1}).ok());
    EXPECT_FALSE(make_player_capsule({.height = NAN}).ok());
    EXPECT_FALSE(make_player_box({.height = 1, .crouched_height = 2}).ok());
    PlayerSize no_way;
    no_way.up = {};
    EXPECT_FALSE(make_player_box(no_way).ok());
    EXPECT_FALSE(make_player_spheres({}).ok());
    const Sphere point{{0, 0, 0}, 0};
    EXPECT_FALSE(make_player_spheres({&point, 1}).ok());
}

TEST(PlayerInput, BadNumbersLeaveThePlayerAsItWas) {
    const World world = course("");
    const PlayerShape shape = make_player_capsule().value();
    Player player;
    player.position = {1, 2, 3};
    const auto refused = [&](const Player& p, const PlayerWish& wish, double seconds, const PlayerRules& rules = {}) {
        const PlayerMove move = move_player(world, shape, p, wish, seconds, rules);
        return !move.valid && move.player.position == p.position;
    };
    EXPECT_TRUE(refused(player, {.velocity = {NAN, 0, 0}}, 0.01));
    EXPECT_TRUE(refused(player, {}, -1));
    EXPECT_TRUE(refused(player, {}, 1.5));
    EXPECT_TRUE(refused(player, {}, INFINITY));
    EXPECT_TRUE(refused(player, {}, 0.01, {.gravity = -1}));
    EXPECT_TRUE(refused(player, {}, 0.01, {.max_slope = 2}));
    Player standing_on_nothing = player;
    standing_on_nothing.on_ground = true;
    EXPECT_TRUE(refused(standing_on_nothing, {}, 0.01));
    EXPECT_FALSE(move_player(world, {}, player, {}, 0.01).valid);
    player.velocity = {0, INFINITY, 0};
    EXPECT_FALSE(move_player(world, shape, player, {}, 0.01).valid);
    player.velocity = {1e30, 0, 0};
    const PlayerMove far = move_player(world, shape, player, {}, 0.01);
    EXPECT_TRUE(is_finite(far.player.position));
}

TEST(PlayerInput, WhateverIsGivenTheAnswerIsANumber) {
    const World world = course(map_text::box({2, -8, -1}, {3, 8, 4}, "rock"));
    const double numbers[] = {0,     1,      -1,  1e-300,   1e30,     -1e100,   1e160,
                              1e300, -1e308, NAN, INFINITY, 0x1p+200, 0x1p+199, 5e-324};
    scenes::Rng rng(9);
    const auto number = [&](double usual) {
        return rng.chance(0.85) ? usual : numbers[rng.below(std::uint32_t(std::size(numbers)))];
    };
    const auto vector = [&](const Vec3& usual) { return Vec3{number(usual.x), number(usual.y), number(usual.z)}; };
    std::size_t moved = 0;
    for (const PlayerShape& shape : player_shapes())
        for (int k = 0; k < 20'000; ++k) {
            Player player;
            player.position = vector({rng.uniform(-1, 1.7), 0, rng.chance(0.5) ? kOffset : 0.5});
            player.velocity = vector({rng.uniform(-5, 5), 0, 0});
            player.on_ground = rng.chance(0.5);
            player.ground_normal = vector({0, 0, 1});
            player.ground_velocity = vector({});
            player.world_hash = rng.chance(0.5) ? hash_world(world) : 0;
            PlayerWish wish;
            wish.velocity = vector({5, 1, 0});
            wish.jump = rng.chance(0.2);
            wish.careful = rng.chance(0.2);
            PlayerRules rules;
            rules.gravity = number(9.81);
            rules.step_height = number(0.45);
            rules.max_push = number(4);
            rules.contact_offset = number(0);
            rules.ground_acceleration = number(60);
            rules.jump_speed = number(4.4);
            rules.max_drop = number(0.6);
            const PlayerMove move = move_player(world, shape, player, wish, number(1.0 / 60), rules);
            if (!move.valid) continue;
            ++moved;
            for (const Vec3& v : {move.player.position, move.player.velocity, move.pushed, move.carried})
                ASSERT_TRUE(is_finite(v)) << k;
            ASSERT_TRUE(is_finite(move.player.ground_normal)) << k;
        }
    EXPECT_GT(moved, 1000u);
}

}  // namespace
}  // namespace firma::test
