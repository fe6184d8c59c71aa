// SPDX-License-Identifier: MIT
// Ticks of a game: what its parts, players, projectiles, blasts and debris do together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/rooms.h"
#include "tests/game/small_games.h"
#include "tests/world/two_halves.h"

namespace firma {
namespace {

using test::ball;
using test::body_here;
using test::box_world;
using test::game_player;
using test::ground;
using test::named_part;
using test::sliding_drive;

GameReport ticks(GameState& game, int count) {
    GameReport report;
    for (int k = 0; k < count; ++k) {
        const auto error = step_game(game, &report);
        EXPECT_FALSE(error) << error->text();
    }
    return report;
}

void happens(GameState& game, decltype(GameEvent::what) what) {
    const auto error = apply_event(game, {0, std::move(what)});
    EXPECT_FALSE(error) << error->text();
}

GameState on_ground(std::uint32_t rate = 60) {
    return begin_game(with_anchors(ground()), rate);
}

TEST(GameStep, ARocketExplodesWhereItStops) {
    GameState game = on_ground();
    happens(game, FireEvent{1, {0, 0, 2}, {30, 0, -30}});
    GameReport report = ticks(game, 5);
    EXPECT_EQ(report.blasts.size(), 1u);
    ASSERT_EQ(report.shot_events.size(), 1u);
    EXPECT_EQ(report.shot_kinds[0], 1u);
    EXPECT_NEAR(report.blast_places[0].x, 2, 0.001);
    EXPECT_NEAR(report.blast_places[0].z, 0, 0.001);
    EXPECT_EQ(report.edits, 1u);
    EXPECT_EQ(game.explosions, 1u);
    EXPECT_TRUE(game.shots[1].projectiles.empty());
    EXPECT_EQ(game.log.commands().size(), 1u);
    EXPECT_EQ(hash_world(replay(with_anchors(ground()), game.log).world), hash_world(game.world));
}

TEST(GameStep, AGrenadeBouncesLiesAndExplodesByItsFuse) {
    GameState game = on_ground();
    happens(game, FireEvent{2, {0, 0, 1}, {2, 0, 0}});
    GameReport report = ticks(game, 149);
    EXPECT_TRUE(report.blasts.empty());
    ASSERT_EQ(game.shots[2].projectiles.size(), 1u);
    EXPECT_EQ(game.shots[2].projectiles[0].state, ProjectileState::kStopped);  // it lies
    EXPECT_NEAR(game.shots[2].projectiles[0].position.z, 0, 1e-3);
    std::size_t bounces = 0;
    for (const ShotEvent& event : report.shot_events) bounces += event.kind == ShotEventKind::kRicochet;
    EXPECT_GE(bounces, 1u);
    EXPECT_LE(report.shot_events.size(), bounces + 1);  // it is told once that it lies
    report = ticks(game, 2);
    EXPECT_EQ(report.blasts.size(), 1u);
    EXPECT_TRUE(game.shots[2].projectiles.empty());
}

TEST(GameStep, AGrenadeFallsWhenWhatItLayOnGoes) {
    GameState game = on_ground();
    game.shots[2].weapon.fuse = 20;
    happens(game, FireEvent{2, {0, 0, 0.1}, {0, 0, 0}});
    ticks(game, 60);
    ASSERT_NEAR(game.shots[2].projectiles.at(0).position.z, 0, 1e-3);
    EditCommand pit;  // as deep as 1 m
    pit.cutter = CraterSeed{CutterShape::kBox, 1};
    happens(game, EditEvent{pit});
    ticks(game, 60);
    EXPECT_NEAR(game.shots[2].projectiles.at(0).position.z, -1, 1e-2);
}

/// A leaf across x at 4 m.
GameState with_leaf() {
    GameState game = on_ground();
    PartDrive drive = sliding_drive({4, 0, 0});
    add_part(game, named_part(box_world({-0.125, -1, 0}, {0.125, 1, 2}), "leaf"), drive);
    return game;
}

TEST(GameStep, ProjectilesMeetPartsThatMove) {
    GameState game = with_leaf();
    happens(game, FireEvent{1, {0, 0, 1}, {120, 0, 0}});
    GameReport report = ticks(game, 3);
    ASSERT_EQ(report.blasts.size(), 1u);
    EXPECT_NEAR(report.blast_places[0].x, 3.875, 1e-3);
    EXPECT_NE(hash_world(game.parts[0].world()), hash_world(with_leaf().parts[0].world()));  // it took of the leaf
    // Up, it lets another through.
    game = with_leaf();
    happens(game, PartEvent{0});
    ticks(game, 70);
    EXPECT_NEAR(game.parts[0].motion.position.z, 2, 1e-9);
    happens(game, FireEvent{1, {0, 0, 1}, {120, 0, 0}});
    EXPECT_TRUE(ticks(game, 5).blasts.empty());
    EXPECT_GT(game.shots[1].projectiles.at(0).position.x, 8);
    // A grenade comes back from it; a bullet stops in it.
    game = with_leaf();
    happens(game, FireEvent{2, {0, 0, 1.5}, {20, 0, 0}});
    happens(game, FireEvent{0, {0, 0.5, 1.5}, {300, 0, 0}});
    report = ticks(game, 15);
    EXPECT_LT(game.shots[2].projectiles.at(0).velocity.x, -3);
    EXPECT_TRUE(game.shots[0].projectiles.empty());
}

TEST(GameStep, ABulletGoesThroughAThinPart) {
    GameState game = on_ground();
    add_part(game, named_part(box_world({-0.015625, -1, 0}, {0.015625, 1, 2}), "board"), sliding_drive({4, 0, 0}));
    happens(game, FireEvent{0, {0, 0.5, 1.5}, {300, 0, 0}});
    const GameReport report = ticks(game, 3);
    ASSERT_EQ(report.shot_events.size(), 2u);
    EXPECT_EQ(report.shot_events[1].kind, ShotEventKind::kLeft);
    EXPECT_EQ(report.shot_events[1].part, 0u);
    EXPECT_NEAR(report.shot_events[1].energy, 8000.0 / 32, 0.1);
    EXPECT_EQ(game.shots[0].projectiles.size(), 1u);
}

TEST(GameStep, AGrenadeLiesOnALiftThatGoes) {
    GameState game = on_ground();
    game.shots[2].weapon.fuse = 20;
    add_part(game, named_part(box_world({-1, -1, -0.25}, {1, 1, 0.25}), "lift"), sliding_drive({4, 0, 0.25}));
    happens(game, FireEvent{2, {4, 0, 0.6}, {0, 0, 0}});
    ticks(game, 60);
    ASSERT_NEAR(game.shots[2].projectiles.at(0).position.z, 0.5, 1e-3);
    happens(game, PartEvent{0});  // up in a second, there for one, down in one
    for (int k = 0; k < 240; ++k) {
        ticks(game, 1);
        const RigidMotion& motion = game.parts[0].motion;
        const Vec3 at = game.shots[2].projectiles.at(0).position;
        ASSERT_NEAR(at.z, motion.position.z + motion.path.z + 0.25, 0.21) << k;  // it hops where the lift halts
        ASSERT_GT(at.z, motion.position.z + motion.path.z + 0.25) << k;
    }
    EXPECT_NEAR(game.shots[2].projectiles.at(0).position.z, 0.5, 1e-3);
}

TEST(GameStep, APartSetsOffOnceAndAgainWhenItIsBack) {
    GameState game = with_leaf();
    ticks(game, 30);
    EXPECT_EQ(game.parts[0].motion.position.z, 0);
    happens(game, PartEvent{0});
    EXPECT_EQ(game.drives[0].started, 30u);
    ticks(game, 30);
    EXPECT_NEAR(game.parts[0].motion.position.z + game.parts[0].motion.path.z, 1, 1e-9);
    happens(game, PartEvent{0});  // on its way: in vain
    EXPECT_EQ(game.drives[0].started, 30u);
    ticks(game, 180);
    EXPECT_EQ(game.parts[0].motion.position.z, 0);
    happens(game, PartEvent{0});
    EXPECT_EQ(game.drives[0].started, 240u);
}

TEST(GameStep, ADoorClosesItsPortalWhileItIsShut) {
    // Two halves of a cube, the portal between them at x = 4.
    const World world = assemble_world(two_halves_parts()).value();
    GameState game = begin_game(world, 60);
    ASSERT_EQ(portal_count(game.world), 1u);
    const Box box = portal_info(game.world, {0})->bounds;
    const Vec3 low = box.low - Vec3{0.0625, 0.0625, 0.0625}, high = box.high + Vec3{0.0625, 0.0625, 0.0625};
    add_part(game, named_part(box_world(low, high), "door"), sliding_drive({0, 0, 0}));
    EXPECT_EQ(game.drives[0].portals, std::vector<PortalId>{{0}});
    ticks(game, 1);
    EXPECT_FALSE(portal_info(game.world, {0})->open);
    happens(game, PartEvent{0});
    ticks(game, 1);
    EXPECT_TRUE(portal_info(game.world, {0})->open);
    ticks(game, 178);
    EXPECT_TRUE(portal_info(game.world, {0})->open);
    ticks(game, 3);
    EXPECT_FALSE(portal_info(game.world, {0})->open);
    EXPECT_EQ(game.log.commands().size(), 3u);
}

/// A leaf that goes a metre to a wall and back in a second each way, with something in its way.
GameState leaf_and_wall(WhenBlocked when_blocked) {
    // The wall stands from x = 2 on; the leaf's face goes from x = 0.125 to 1.625.
    const World level = test::brush_world(map_text::box({-32, -32, -4}, {32, 32, 0}, "rock") +
                                          map_text::box({2, -4, 0}, {4, 4, 4}, "rock"));
    GameState game = begin_game(with_anchors(level), 60);
    PartDrive drive;
    drive.path.stops = {{{0, 0, 0}, 0, 0, 1}, {{1.5, 0, 0}, 0, 0.5, 1}};
    drive.waits = true;
    drive.when_blocked = when_blocked;
    add_part(game, named_part(box_world({-0.125, -1, 0.0625}, {0.125, 1, 2}), "leaf"), drive);
    return game;
}

double leaf_at(const GameState& game) {
    return game.parts[0].motion.position.x + game.parts[0].motion.path.x;
}

/// How far the leaf came, how far it is at the end, and in how many ticks somebody was crushed.
struct LeafRun {
    double farthest = 0, last = 0;
    int crushed = 0;
};

LeafRun run_leaf(GameState& game, int count) {
    LeafRun run;
    for (int k = 0; k < count; ++k) {
        const GameReport report = ticks(game, 1);
        for (const PlayerMove& move : report.moves) run.crushed += move.crushed_by != kNoPart;
        run.crushed += report.bodies.crushed > 0;
        run.farthest = std::max(run.farthest, leaf_at(game));
    }
    run.last = leaf_at(game);
    return run;
}

TEST(GameStep, ALeafThatAPlayerOrACrateBlocksWaitsGoesBackOrGoesOn) {
    for (const bool of_player : {true, false}) {
        for (const WhenBlocked rule : {WhenBlocked::kStops, WhenBlocked::kReturns, WhenBlocked::kCrushes}) {
            SCOPED_TRACE(std::string(of_player ? "player " : "crate ") + std::to_string(int(rule)));
            GameState game = leaf_and_wall(rule);
            // As wide as 0.7 and 0.5 m: the leaf is met by what stands against the wall.
            if (of_player)
                happens(game, PlayerEvent{game_player({1.6, 0, 0.01})});
            else
                happens(game, BodyEvent{body_here(test::box_body({0.25, 0.25, 0.25}), {1.7, 0, 0.251})});
            ticks(game, 30);
            happens(game, PartEvent{0});
            const LeafRun there = run_leaf(game, 75);
            if (rule == WhenBlocked::kCrushes) {
                EXPECT_NEAR(there.farthest, 1.5, 1e-9);
                EXPECT_GT(there.crushed, 0);
                continue;
            }
            EXPECT_EQ(there.crushed, 0);
            // It came as near as there is room for what is in its way.
            const double room = of_player ? 2 - 0.125 - 2 * game.players[0].shape.radius() : 2 - 0.125 - 0.5;
            EXPECT_LT(there.farthest, room + 0.03);
            EXPECT_GT(there.farthest, room - 0.1);
            if (rule == WhenBlocked::kStops)
                EXPECT_NEAR(there.last, there.farthest, 1e-9);
            else
                EXPECT_LT(there.last, there.farthest - 0.3);
            // Back at its first stop at last, or on its way again once there is room.
            if (rule == WhenBlocked::kReturns) {
                EXPECT_NEAR(run_leaf(game, 120).last, 0, 1e-9);
                EXPECT_EQ(game.parts[0].motion.path, Vec3{});
            } else if (!of_player) {
                game.bodies.slots[0].position = {-3, 0, 0.251};
                EXPECT_NEAR(run_leaf(game, 60).farthest, 1.5, 1e-9);
            }
        }
    }
}

TEST(GameStep, ABlockedLeafIsKeptInSaves) {
    GameState game = leaf_and_wall(WhenBlocked::kStops);
    happens(game, BodyEvent{body_here(test::box_body({0.25, 0.25, 0.25}), {1.7, 0, 0.251})});
    happens(game, PartEvent{0});
    ticks(game, 90);
    EXPECT_GT(game.drives[0].held, 10u);
    GameState again = unpack_game(pack_game(game).value(), "test").value();
    EXPECT_EQ(hash_game(again), hash_game(game));
    ticks(game, 30);
    ticks(again, 30);
    EXPECT_EQ(hash_game(again), hash_game(game));
}

TEST(GameStep, ABlastPushesPlayersAndBodies) {
    GameState game = on_ground();
    happens(game, PlayerEvent{game_player({3, 0, 0.001})});
    happens(game, PlayerEvent{game_player({-40, 0, 0.001})});
    happens(game, BodyEvent{body_here(ball(0.3), {0, 3, 0.3})});
    ticks(game, 30);
    happens(game, BlastEvent{{0, 0, 0.5}, {.crater = 0, .radius = 8, .impulse = 3000}});
    EXPECT_GT(game.players[0].player.velocity.x, 2);
    EXPECT_LE(length(game.players[0].player.velocity), game.rules.max_blast_speed + 1e-9);
    EXPECT_EQ(length(game.players[1].player.velocity), 0);
    EXPECT_GT(game.bodies.slots[0].velocity.y, 1);
    EXPECT_EQ(game.log.commands().size(), 0u);  // no crater
    ticks(game, 120);
    EXPECT_GT(game.players[0].player.position.x, 3.2);
    EXPECT_TRUE(game.players[0].player.on_ground);
}

TEST(GameStep, WishesLastAndAJumpIsOfOneTick) {
    GameState game = on_ground();
    happens(game, PlayerEvent{game_player({0, 0, 0.001})});
    ticks(game, 30);
    happens(game, WishEvent{0, {.velocity = {2, 0, 0}, .jump = true}});
    GameReport report = ticks(game, 180);
    std::size_t jumps = 0;
    for (const PlayerMove& move : report.moves) jumps += move.jumped;
    EXPECT_EQ(jumps, 1u);
    EXPECT_NEAR(game.players[0].player.position.x, 6, 0.3);
}

TEST(GameStep, WhatLiesLongBecomesGroundAndTheLogHasIt) {
    // A slab on a pin, and the pin shot in two.
    const World world = test::brush_world(map_text::box({-8, -8, -2}, {8, 8, 0}, "ground") +
                                          map_text::box({-0.25, -0.25, 0}, {0.25, 0.25, 1.5}, "rock") +
                                          map_text::box({-1, -1, 1.5}, {1, 1, 1.75}, "rock"));
    AnchorRules anchors;
    anchors.hanging = false;
    anchors.materials = {"ground"};
    const World level = with_anchors(world, anchors);
    GameState game = begin_game(level, 60);
    game.rules.debris.max_asleep = 0.5;
    game.rules.debris.to_ground = true;
    happens(game, BlastEvent{{0, 0, 0.75}, {.crater = 0.4, .impulse = 50, .break_radius = 0}});
    GameReport report = ticks(game, 600);
    EXPECT_GE(report.grounded, 1u);
    const ReplayResult replayed = replay(level, game.log);
    ASSERT_TRUE(replayed.ok()) << replayed.error->text();
    EXPECT_EQ(hash_world(replayed.world), hash_world(game.world));
    EXPECT_FALSE(check_world(game.world));
}

TEST(GameStep, ARateOrAWeaponThatCannotBeIsRefusedAndNothingHappens) {
    GameState game = on_ground();
    happens(game, FireEvent{1, {0, 0, 2}, {30, 0, 0}});
    const std::uint64_t hash = hash_game(game);
    game.rate = 3;
    EXPECT_EQ(step_game(game)->text(), "the rate of a game is not 4 to 1000 ticks a second");
    game.rate = 60;
    game.shots[0].weapon.fuse = -1;
    EXPECT_EQ(step_game(game)->text(), "weapon bullet: its fuse is not 0 to 3600 s");
    game.shots[0].weapon = standard_weapons()[0];
    game.shots[1].projectiles[0].velocity.x = NAN;
    EXPECT_EQ(step_game(game)->text(), "projectile 0 of rocket: a number is not finite or out of range");
    game.shots[1].projectiles[0].velocity.x = 30;
    EXPECT_EQ(hash_game(game), hash);
    add_part(game, named_part(box_world({0, 0, 0}, {1, 1, 1}), "fast"), {});
    game.drives[0].path.spin = 1e4;
    EXPECT_EQ(step_game(game)->text(), "part 0: its motion cannot be used");
}

TEST(GameStep, TheRateIsThatOfTheTicks) {
    GameState slow = on_ground(30), fast = on_ground(120);
    for (GameState* game : {&slow, &fast}) happens(*game, BodyEvent{body_here(ball(0.2), {0, 0, 20})});
    ticks(slow, 30);
    ticks(fast, 120);
    for (const GameState* game : {&slow, &fast}) EXPECT_NEAR(game->bodies.slots[0].position.z, 20 - 0.5 * 9.81, 0.1);
}

}  // namespace
}  // namespace firma
