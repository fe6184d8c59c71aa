// SPDX-License-Identifier: MIT
// Projectiles among parts that move: closed forms of ricochets, ways through and stops as the part's surface sees
// them, parts that strike and carry, solids that lie flush, random motions against poses sampled finely, levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/projectiles.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/body/level_floors.h"
#include "tests/lent_threads.h"
#include "tests/moving/part_worlds.h"
#include "tests/random_vector.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma::test {
namespace {

using scenes::Rng;

constexpr double kStep = 1.0 / 64;  // seconds

Projectile shot_at(const Vec3& position, const Vec3& velocity) {
    Projectile it;
    it.position = position;
    it.velocity = velocity;
    return it;
}

FlyOptions straight_on(const ShotTerms& terms = {}) {
    FlyOptions options;
    options.gravity = {};
    options.other = terms;
    return options;
}

/// What goes straight through, whatever the angle.
FlyOptions straight_through(double resistance) {
    return straight_on({.ricochet_below = 0, .resistance = resistance});
}

std::vector<ShotEvent> fly_once(const Scene& scene, Projectile& it, double seconds, const FlyOptions& options) {
    ShotEvents events;
    const Result<FlyReport> report = fly({&it, 1}, scene, seconds, events, options);
    EXPECT_TRUE(report.ok()) << report.error().text();
    return events.events;
}

/// A part that goes by a velocity in a step.
MovingPart going(World world, const Vec3& position, const Vec3& velocity, double seconds = kStep) {
    MovingPart part(std::move(world));
    part.motion.position = position;
    part.motion.path = velocity * seconds;
    return part;
}

Vec3 point_of(const RigidMotion& motion, double fraction, const Vec3& in_part) {
    return part_point(motion, fraction, in_part);
}

bool in_part(const MovingPart& part, double fraction, const Vec3& point) {
    const Pose pose = pose_at(part.motion, fraction);
    return locate(part.world(), matrix_of(pose.rotation).back(point - pose.position)).where == Where::kSolid;
}

/// A wall 0.25 m thick across x, its front at x = 0 of its frame.
World wall_world() {
    return box_world({0, -2, -2}, {0.25, 2, 2});
}

TEST(ShotsAtParts, APartThatStandsIsMetAsTheLevelIs) {
    const World level = wall_world(), nothing;
    const std::vector<MovingPart> parts{MovingPart(wall_world())};
    Rng rng(1);
    std::size_t kinds[6] = {};
    for (int k = 0; k < 300; ++k) {
        FlyOptions options = straight_on({.ricochet_below = rng.uniform(0, 1.5),
                                          .restitution = rng.uniform(0, 1),
                                          .friction = rng.uniform(0, 1),
                                          .resistance = rng.uniform(100, 4000)});
        const Vec3 from = random_vector(rng, 2.5, 4), to = random_vector(rng, 0, 1.5);
        Projectile one = shot_at(from, (to - from) * (1.5 / kStep)), other = one;
        const std::vector<ShotEvent> of_level = fly_once(Scene{level}, one, kStep, options);
        const std::vector<ShotEvent> of_part = fly_once(Scene{nothing, parts}, other, kStep, options);
        ASSERT_EQ(of_level.size(), of_part.size()) << k;
        double apart = 1e-7;
        Vec3 came = (to - from) * (1.5 / kStep);
        for (std::size_t e = 0; e < of_level.size(); ++e) {
            const ShotEvent &a = of_level[e], &b = of_part[e];
            // It goes on from 0.01 mm in front of a level, from a part at most 1 mm back on its way.
            const double sine = -dot(came, a.normal) / length(came);
            if (a.kind == ShotEventKind::kRicochet && sine < 0.01) apart += 2e-5 / sine;
            came = a.velocity;
            ++kinds[std::size_t(a.kind)];
            EXPECT_EQ(a.kind, b.kind);
            EXPECT_EQ(a.part, kNoPart);
            EXPECT_EQ(b.part, 0u);
            EXPECT_EQ(b.in_part, b.point);
            EXPECT_EQ(a.face, b.face);
            EXPECT_NEAR(a.time, b.time, 1e-12);
            EXPECT_NEAR(a.thickness, b.thickness, 1e-9);
            EXPECT_NEAR(a.energy, b.energy, 1e-6);
            EXPECT_LT(length(a.point - b.point), 1e-9);
            EXPECT_LT(length(a.velocity - b.velocity), 1e-6);
        }
        EXPECT_LT(length(one.position - other.position), apart) << k;
        EXPECT_EQ(one.state, other.state);
    }
    for (const ShotEventKind kind : {ShotEventKind::kRicochet, ShotEventKind::kLeft, ShotEventKind::kStopped})
        EXPECT_GT(kinds[std::size_t(kind)], 20u);
}

TEST(ShotsAtParts, ARicochetIsWhatTheSurfaceSees) {
    const World nothing;
    const ShotTerms terms{.ricochet_below = 2, .restitution = 0.5, .friction = 0.1};
    // The wall comes at 20 m/s and goes sideways at 30.
    const std::vector<MovingPart> parts{going(wall_world(), {4, 0, 0}, {-20, 30, 0})};
    Projectile it = shot_at({0, 0, 0}, {300, 50, 0});
    it.mass = 2;
    const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, straight_on(terms));
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kRicochet);
    EXPECT_EQ(events[0].part, 0u);
    const double time = 4 / 320.0;
    EXPECT_NEAR(events[0].time, time, 1e-9);
    EXPECT_LT(length(events[0].point - Vec3{300, 50, 0} * time), 1e-6);
    EXPECT_LT(length(events[0].in_part - Vec3{0, 20 * time, 0}), 1e-6);
    // Seen (320, 20, 0): -160 along the normal; along the face 0.1 * 480 is more than there is.
    EXPECT_LT(length(events[0].velocity - Vec3{-180, 30, 0}), 1e-9);
    EXPECT_LT(length(events[0].impulse - Vec3{480, 20, 0} * 2.0), 1e-9);
    EXPECT_NEAR(events[0].energy, 320 * 320 + 20 * 20 - 160 * 160, 1e-6);
    EXPECT_LT(length(it.position - (events[0].point + it.velocity * (kStep - time))), 2e-5);
}

TEST(ShotsAtParts, TheAngleIsWhatTheSurfaceSees) {
    // It grazes the wall, but for one that comes so fast that it meets it straight.
    const World nothing;
    const ShotTerms terms{.ricochet_below = 0.5};
    for (const double comes : {0.0, 400.0}) {
        const std::vector<MovingPart> parts{going(wall_world(), {1, 0, 0}, {-comes, 0, 0})};
        Projectile flat = shot_at({0.5, -1, 0}, {35, 100, 0});
        const std::vector<ShotEvent> events = fly_once({nothing, parts}, flat, kStep, straight_on(terms));
        ASSERT_EQ(events.size(), 1u);
        EXPECT_EQ(events[0].kind, comes > 0 ? ShotEventKind::kStopped : ShotEventKind::kRicochet);
    }
}

TEST(ShotsAtParts, ThroughAPartThatMoves) {
    const World nothing;
    const std::vector<MovingPart> parts{going(wall_world(), {2, 0, 0}, {-20, 80, 0})};
    Projectile it = shot_at({0, 0, 0}, {300, 0, 0});
    const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, straight_through(1000));
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kEntered);
    EXPECT_EQ(events[1].kind, ShotEventKind::kLeft);
    EXPECT_EQ(events[1].part, 0u);
    const double time = 2 / 320.0;
    EXPECT_NEAR(events[1].time, time, 1e-9);
    // The wall sees it come at (320, -80, 0).
    const Vec3 seen{320, -80, 0};
    const double thick = 0.25 * length(seen) / 320, energy = 0.5 * 0.01 * dot(seen, seen);
    EXPECT_NEAR(events[1].thickness, thick, 1e-9);
    EXPECT_NEAR(events[1].energy, 1000 * thick, 1e-6);
    EXPECT_EQ(events[1].normal, (Vec3{1, 0, 0}));
    const Vec3 after = seen * std::sqrt(1 - 1000 * thick / energy) + Vec3{-20, 80, 0};
    EXPECT_LT(length(it.velocity - after), 1e-6);
    EXPECT_LT(length(events[1].in_part - (events[0].in_part + seen * (thick / length(seen)))), 1e-8);
    EXPECT_NEAR(events[1].in_part.x, 0.25, 1e-9);
    EXPECT_LT(length(it.position - (events[1].point + after * (kStep - time))), 3e-5);
}

TEST(ShotsAtParts, WhatStopsGoesAlong) {
    const World nothing;
    RigidMotion motion;
    motion.position = {3, 0.5, 0};
    motion.rotation = random_turn(5);
    motion.path = {-0.2, 0.3, 0.1};
    motion.turn = {0.2, -0.1, 0.4};
    std::vector<MovingPart> parts{MovingPart(box_world({-1, -1, -1}, {1, 1, 1}), motion)};
    for (const double resistance : {3000.0, kUnpierced}) {
        Projectile it = shot_at({0, 0.4, 0.1}, {400, 0, 0});
        const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, straight_through(resistance));
        ASSERT_FALSE(events.empty());
        const ShotEvent& stop = events.back();
        EXPECT_EQ(stop.kind, ShotEventKind::kStopped);
        EXPECT_EQ(stop.part, 0u);
        EXPECT_EQ(it.state, ProjectileState::kStopped);
        EXPECT_LT(length(it.velocity - velocity_at(motion, 1, it.position) * (1 / kStep)), 1e-9);
        // Where it was then, and where it is at the end: one place of the part. Before the face 0.07 mm at most.
        const double near = resistance < kUnpierced ? 1e-9 : 1e-4;
        EXPECT_LT(length(point_of(motion, stop.time / kStep, stop.in_part) - stop.point), 1e-9);
        EXPECT_LT(length(point_of(motion, 1, stop.in_part) - it.position), near);
        EXPECT_GT(length(stop.point - it.position), 0.01);
        EXPECT_LT(length(stop.velocity - velocity_at(motion, stop.time / kStep, stop.point) * (1 / kStep)), 1e-9);
        EXPECT_EQ(in_part(parts[0], 1, it.position), resistance < kUnpierced);
        if (resistance < kUnpierced) {
            EXPECT_NEAR(stop.energy, stop.thickness * resistance, 1e-6);
        }
        // It stays stopped: it is the caller's.
        const Projectile before = it;
        EXPECT_TRUE(fly_once({nothing, parts}, it, kStep, straight_through(resistance)).empty());
        EXPECT_EQ(it.position, before.position);
    }
}

TEST(ShotsAtParts, ItIsStruckByWhatComes) {
    const World nothing;
    // A lift from below, faster than it falls; a blade from the side.
    const std::vector<MovingPart> lift{going(box_world({-2, -2, -1}, {2, 2, 0}), {0, 0, 0}, {0, 0, 8})};
    Projectile it = shot_at({0, 0, 0.0625}, {0, 0, 0});
    const std::vector<ShotEvent> events =
        fly_once({nothing, lift}, it, kStep, straight_on({.ricochet_below = 2, .restitution = 0.5}));
    ASSERT_EQ(events.size(), 1u);
    EXPECT_NEAR(events[0].time, 0.0625 / 8, 1e-9);
    EXPECT_LT(length(events[0].velocity - Vec3{0, 0, 12}), 1e-9);
    RigidMotion spin;
    spin.turn = {0, 0, 1};
    const std::vector<MovingPart> blade{MovingPart(box_world({-2, -0.125, -1}, {2, 0.125, 1}), spin)};
    Projectile stands = shot_at({1, 0.5, 0}, {0, 0, 0});
    const std::vector<ShotEvent> struck =
        fly_once({nothing, blade}, stands, kStep, straight_on({.ricochet_below = 2, .restitution = 1, .friction = 0}));
    ASSERT_EQ(struck.size(), 1u);
    // The blade's long face reaches it where r sin(angle - turn) = 0.125.
    const double radius = std::sqrt(1.25), turned = std::atan2(0.5, 1) - std::asin(0.125 / radius);
    EXPECT_NEAR(struck[0].time, turned * kStep, kStep * 1e-4);
    const Vec3 normal{-std::sin(turned), std::cos(turned), 0};
    const Vec3 surface = cross(Vec3{0, 0, 1 / kStep}, Vec3{1, 0.5, 0});
    EXPECT_LT(length(stands.velocity - normal * (2 * dot(surface, normal))), 0.01);
}

TEST(ShotsAtParts, ALiftCarriesWhatLiesOnIt) {
    const World nothing;
    FlyOptions options;
    options.other = {.ricochet_below = 2, .restitution = 0.3, .friction = 0.3};
    options.max_age = 100;
    Projectile it = shot_at({0.3, 0.2, 0.5}, {0.5, 0, 0});
    Vec3 lies;
    const auto height = [](int step) { return 1.5 - 1.5 * std::cos(1.7 * step * kStep); };
    for (int step = 0; step < 400; ++step) {
        MovingPart lift(box_world({-2, -2, -1}, {2, 2, 0}));
        lift.motion.position.z = height(step);
        lift.motion.path.z = height(step + 1) - height(step);
        lift.motion.turn.z = 0.01;
        lift.motion.rotation = turn_by({0, 0, 0.01 * step});
        const std::vector<MovingPart> parts{lift};
        it.state = ProjectileState::kFlying;  // as games do with what lies
        fly_once({nothing, parts}, it, kStep, options);
        ASSERT_GT(it.position.z, height(step + 1)) << step;
        const Pose pose = pose_at(lift.motion, 1);
        const Vec3 now = matrix_of(pose.rotation).back(it.position - pose.position);
        if (step == 100) lies = now;
        if (step > 100) {
            ASSERT_LT(length(now - lies), 1e-3) << step;
        }
    }
    EXPECT_EQ(it.state, ProjectileState::kStopped);
}

TEST(ShotsAtParts, FlushWithTheLevelAndInIt) {
    const World level = brush_world(map_text::box({0, -2, -2}, {0.5, 2, 2}, "stone"));
    for (const double reaches : {0.0, 0.125}) {
        for (const bool from_behind : {false, true}) {
            const std::vector<MovingPart> parts{going(wall_world(), {0.5 - reaches, 0, 0}, {0, 1, 0})};
            Projectile it = from_behind ? shot_at({2, 0, 0}, {-400, 0, 0}) : shot_at({-2, 0, 0}, {400, 0, 0});
            const std::vector<ShotEvent> events = fly_once({level, parts}, it, kStep, straight_through(500));
            ASSERT_EQ(events.size(), 4u) << reaches;
            EXPECT_EQ(events[0].part, from_behind ? 0u : kNoPart);
            EXPECT_EQ(events[2].kind, ShotEventKind::kEntered);
            EXPECT_EQ(events[2].part, from_behind ? kNoPart : 0u);
            EXPECT_FALSE(events[2].face.valid());
            EXPECT_EQ(events[3].kind, ShotEventKind::kLeft);
            // What both hold counts once; 0.01 mm behind the first does not count.
            EXPECT_NEAR(events[1].thickness + events[3].thickness, 0.75 - reaches, 3e-5);
            EXPECT_NEAR(events[1].energy + events[3].energy, 500 * (0.75 - reaches), 0.02);
            EXPECT_EQ(it.state, ProjectileState::kFlying);
        }
    }
    // All of the part in the wall: nothing of it is met.
    const std::vector<MovingPart> within{going(wall_world(), {0.125, 0, 0}, {0, 1, 0})};
    Projectile it = shot_at({-2, 0, 0}, {400, 0, 0});
    EXPECT_EQ(fly_once({level, within}, it, kStep, straight_through(500)).size(), 2u);
    // What is not entered stops it between.
    const std::vector<MovingPart> behind{going(wall_world(), {0.5, 0, 0}, {0, 1, 0})};
    FlyOptions options = straight_through(500);
    options.max_impacts = 2;
    Projectile other = shot_at({-2, 0, 0}, {400, 0, 0});
    const std::vector<ShotEvent> stops = fly_once({level, behind}, other, kStep, options);
    ASSERT_EQ(stops.size(), 3u);
    EXPECT_EQ(stops[2].kind, ShotEventKind::kStopped);
    EXPECT_EQ(stops[2].part, 0u);
}

TEST(ShotsAtParts, PanesOfGlass) {
    const World nothing;
    const World pane = brush_world(map_text::box({0, -2, -2}, {0.0625, 2, 2}, "glass"));
    ASSERT_EQ(locate(pane, {0.03125, 0, 0}).where, Where::kAir);
    const std::vector<MovingPart> parts{going(pane, {2, 0, 0}, {100, 0, 0})};
    FlyOptions options = straight_on({.ricochet_below = 0.1});
    options.pane_energy = 50;
    Projectile it = shot_at({0, 0, 0}, {300, 0, 0});  // 200 J, as the pane sees it
    const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, options);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kPassed);
    EXPECT_NEAR(events[0].energy, 50, 1e-9);
    EXPECT_NEAR(it.velocity.x, 100 + 200 * std::sqrt(0.75), 1e-9);
    Projectile slow = shot_at({1.5, 0, 0}, {190, 0, 0});
    const std::vector<ShotEvent> stopped = fly_once({nothing, parts}, slow, kStep, options);
    ASSERT_EQ(stopped.size(), 1u);
    EXPECT_EQ(stopped[0].kind, ShotEventKind::kStopped);
}

TEST(ShotsAtParts, MattersByTheirNames) {
    // The part's table has them in another order than the level's.
    MatterTable table = default_matters();
    std::reverse(table.matters.begin() + 1, table.matters.end());
    for (MatterPattern& it : table.patterns)
        if (it.matter > 0) it.matter = std::uint32_t(table.matters.size()) - it.matter;
    const World level = brush_world(map_text::box({-90, -2, -2}, {-89, 2, 2}, "stone"));
    WorldOptions with_table;
    with_table.matters = table;
    const World part = brush_world(map_text::box({0, -2, -2}, {0.25, 2, 2}, "wood"), with_table);
    const auto own = matter_named(table, "wood"), levels = matter_named(matters_of(level), "wood");
    ASSERT_TRUE(own && levels && *own != *levels);
    FlyOptions options = straight_through(kUnpierced);
    std::vector<ShotTerms> terms(matters_of(level).matters.size(), options.other);
    terms[*levels].resistance = 400;
    options.matters = terms;
    const std::vector<MovingPart> parts{going(part, {2, 0, 0}, {})};
    Projectile it = shot_at({0, 0, 0}, {300, 0, 0});
    ShotEvents events;
    ASSERT_TRUE(fly({&it, 1}, Scene{level, parts}, kStep, events, options).ok());
    ASSERT_EQ(events.events.size(), 2u);
    EXPECT_NEAR(events.events[1].energy, 100, 1e-6);
    EXPECT_EQ(events.events[1].matter, *own);
    EXPECT_EQ(events.matters[events.events[1].first_matter].matter, *own);
}

TEST(ShotsAtParts, StartsInAPart) {
    const World nothing;
    const std::vector<MovingPart> parts{going(box_world({-1, -1, -1}, {1, 1, 1}), {5, 0, 0}, {0, 16, 0})};
    Projectile it = shot_at({5, 0, 0}, {0, 0, 100});
    const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, straight_through(1));
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kStopped);
    EXPECT_EQ(events[0].part, 0u);
    EXPECT_EQ(events[0].time, 0);
    EXPECT_FALSE(events[0].face.valid());
    EXPECT_LT(length(it.position - Vec3{5, 0.25, 0}), 1e-9);
    Projectile beside = shot_at({5, 0, 0}, {0, 0, 100});
    beside.mask = 0;
    EXPECT_TRUE(fly_once({nothing, parts}, beside, kStep, straight_through(1)).empty());
}

TEST(ShotsAtParts, BetweenADoorAndAWall) {
    const World level = brush_world(map_text::box({0, -2, -2}, {1, 2, 2}, "stone"));
    Rng rng(4);
    for (int k = 0; k < 200; ++k) {
        // A door that shuts to the wall, and what bounces between them.
        const Vec3 comes{rng.uniform(5, 60), 0, 0};
        const std::vector<MovingPart> parts{going(wall_world(), {-0.25 - comes.x * kStep, 0, 0}, comes)};
        const Vec3 at{-rng.uniform(1e-4, comes.x * kStep), 0, 0};
        Projectile it = shot_at(at, {rng.uniform(-200, 200), rng.uniform(-50, 50), rng.uniform(-50, 50)});
        FlyOptions options = straight_on({.ricochet_below = 2, .restitution = 0.9, .friction = 0.1});
        options.max_impacts = 1000;
        const std::vector<ShotEvent> events = fly_once({level, parts}, it, kStep, options);
        ASSERT_GE(events.size(), 2u);
        EXPECT_NE(locate(level, it.position).where, Where::kSolid) << k;
        if (std::fabs(it.position.y) < 1.9 && std::fabs(it.position.z) < 1.9) {
            EXPECT_EQ(it.state, ProjectileState::kStopped) << k;
        }
    }
}

/// The first time, as a fraction, at which a chord is in a part: by many samples.
double first_inside(const MovingPart& part, const Vec3& from, const Vec3& path, int samples) {
    for (int k = 0; k <= samples; ++k)
        if (in_part(part, double(k) / samples, from + path * (double(k) / samples))) return double(k) / samples;
    return 2;
}

TEST(ShotsAtParts, RandomMotionsAgainstSampledPoses) {
    const World nothing, cross = cross_world();
    Rng rng(9);
    int met = 0, clear = 0;
    const int samples = 2000;
    for (int k = 0; k < sample(600); ++k) {
        const std::vector<MovingPart> parts{MovingPart(cross, random_motion(rng, k % 3, 4))};
        const Vec3 from = random_vector(rng, 0.5, 4), to = random_vector(rng, 0, 1.2);
        const Vec3 path = (to - from) * rng.uniform(0.5, 2);
        if (in_part(parts[0], 0, from)) continue;
        Projectile it = shot_at(from, path * (1 / kStep));
        const std::vector<ShotEvent> events = fly_once({nothing, parts}, it, kStep, straight_through(kUnpierced));
        const double first = first_inside(parts[0], from, path, samples);
        ASSERT_LE(events.size(), 1u);
        if (events.empty()) {
            EXPECT_GT(first, 1) << k;
            ++clear;
            continue;
        }
        ++met;
        const double fraction = events[0].time / kStep;
        EXPECT_LE(fraction, first) << k;
        // What it touched is there: 0.07 mm away, or sampled.
        const PartNear near = closest(Scene{nothing, parts}, from + path * fraction, 1, fraction);
        ASSERT_TRUE(near) << k;
        EXPECT_LT(near.distance, 7e-5) << k;
    }
    EXPECT_GT(met, sample(600) / 5);
    EXPECT_GT(clear, sample(600) / 10);
}

/// Through whatever moves: what lies in the part, and none slips by without a word.
TEST(ShotsAtParts, RandomWaysThrough) {
    const World nothing, cross = cross_world();
    Rng rng(11);
    int left = 0;
    for (int k = 0; k < sample(600); ++k) {
        const std::vector<MovingPart> parts{MovingPart(cross, random_motion(rng, k % 3, 2))};
        const Vec3 from = random_vector(rng, 2, 4), to = random_vector(rng, 0, 1);
        if (in_part(parts[0], 0, from)) continue;
        Projectile it = shot_at(from, (to - from) * (1.7 / kStep));
        FlyOptions options = straight_through(20);
        options.max_impacts = 50;
        int inside = 0;
        for (const ShotEvent& event : fly_once({nothing, parts}, it, kStep, options)) {
            EXPECT_EQ(event.part, 0u);
            if (event.kind == ShotEventKind::kEntered) ++inside;
            if (event.kind != ShotEventKind::kLeft) continue;
            --inside;
            ++left;
            // Half way it was in the part's solid.
            const Vec3 seen =
                event.velocity - velocity_at(parts[0].motion, event.time / kStep, event.point) * (1 / kStep);
            EXPECT_GT(dot(seen, event.normal), -1e-2 * length(seen)) << k;
        }
        EXPECT_EQ(inside, 0) << k;
        if (it.state == ProjectileState::kFlying) {
            EXPECT_FALSE(in_part(parts[0], 1, it.position)) << k;
        }
    }
    EXPECT_GT(left, sample(600) / 10);
}

TEST(ShotsAtParts, StretchesOfASceneJoin) {
    const World nothing;
    RigidMotion motion;
    motion.position = {2, 0, 0};
    motion.path = {0.1, 0.2, 0};
    motion.turn = {0, 0, 1};
    const std::vector<MovingPart> parts{MovingPart(cross_world(), motion)};
    Rng rng(2);
    int met = 0;
    for (int k = 0; k < 100; ++k) {
        const Vec3 velocity = Vec3{2, 0, 0} * (1 / kStep) + rng.direction() * 10;
        Projectile whole = shot_at({0, rng.uniform(-1, 1), 0}, velocity), parted = whole;
        const FlyOptions options = straight_through(kUnpierced);
        met += !fly_once({nothing, parts}, whole, kStep, options).empty();
        fly_once({nothing, parts, 0, 0.5}, parted, kStep / 2, options);
        if (parted.state == ProjectileState::kStopped) {
            EXPECT_EQ(whole.state, ProjectileState::kStopped);
            continue;
        }
        fly_once({nothing, parts, 0.5, 1}, parted, kStep / 2, options);
        EXPECT_EQ(whole.state, parted.state) << k;
        EXPECT_LT(length(whole.position - parted.position), 2e-4) << k;
    }
    EXPECT_GT(met, 20);
}

TEST(ShotsAtParts, BadInput) {
    const World nothing;
    ShotEvents events;
    const auto fault = [&](const RigidMotion& motion, double from = 0, double to = 1) {
        const std::vector<MovingPart> parts{MovingPart(wall_world()), MovingPart(wall_world(), motion)};
        Projectile it = shot_at({0, 0, 9}, {1, 0, 0});
        const std::uint64_t hash = hash_projectiles({&it, 1});
        const Result<FlyReport> report = fly({&it, 1}, Scene{nothing, parts, from, to}, kStep, events);
        if (report.ok()) return std::string();
        EXPECT_EQ(hash_projectiles({&it, 1}), hash);
        return report.error().text();
    };
    EXPECT_EQ(fault({}), "");
    RigidMotion bad;
    bad.path.x = NAN;
    EXPECT_EQ(fault(bad), "part 1: its motion cannot be used");
    bad.path.x = 1e30;
    EXPECT_EQ(fault(bad), "part 1: it goes faster than 2^60 m/s");
    bad = {};
    bad.turn.z = 9;
    EXPECT_EQ(fault(bad), "part 1: its motion cannot be used");
    EXPECT_EQ(fault({}, 0.5, 0.25), "fly: the scene's stretch is not within 0 to 1");
    EXPECT_EQ(fault({}, -1, 1), "fly: the scene's stretch is not within 0 to 1");
    EXPECT_EQ(fault({}, 0, NAN), "fly: the scene's stretch is not within 0 to 1");
    // Far away, and as fast as may be: no trouble.
    bad = {};
    bad.position = {1e50, 0, 0};
    EXPECT_EQ(fault(bad), "");
    bad = {};
    bad.path.y = 1e15;
    EXPECT_EQ(fault(bad), "");
}

class ShotsInLevels : public InBlastedLevels {};
INSTANTIATE_TEST_SUITE_P(, ShotsInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

/// Doors, lifts and blades all over a level's air, some through its walls.
std::vector<MovingPart> parts_all_over(const World& level, int count, Rng& rng) {
    const World shapes[] = {cross_world(), leaf_world(), box_world({-0.75, -0.75, -0.125}, {0.75, 0.75, 0.125}),
                            brush_world(map_text::box({-1, -0.0625, -1}, {1, 0.0625, 1}, "glass"))};
    const Box box = level.bounds();
    std::vector<MovingPart> parts;
    while (int(parts.size()) < count) {
        MovingPart part(shapes[parts.size() % std::size(shapes)], random_motion(rng, int(parts.size()) % 3, 0.5));
        for (int axis = 0; axis < 3; ++axis) part.motion.position[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (locate(level, part.motion.position).where == Where::kAir) parts.push_back(part);
    }
    return parts;
}

/// Each goes on to where its motion led.
void go_on(std::vector<MovingPart>& parts) {
    for (MovingPart& part : parts) {
        const Pose pose = pose_at(part.motion, 1);
        part.motion.position = pose.position;
        part.motion.rotation = pose.rotation;
    }
}

std::vector<Projectile> shots_between(const World& level, int count, Rng& rng) {
    const Box box = level.bounds();
    std::vector<Projectile> shots;
    while (int(shots.size()) < count) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (locate(level, at).where != Where::kAir) continue;
        shots.push_back(shot_at(at, random_vector(rng, 2, 500)));
    }
    return shots;
}

/// From some metres before parts, about toward them.
void add_shots_toward(const World& level, const std::vector<MovingPart>& parts, int count, Rng& rng,
                      std::vector<Projectile>& shots) {
    for (int k = 0; k < count; ++k) {
        const Vec3 target = parts[std::size_t(k) % parts.size()].motion.position;
        const Vec3 from = target + random_vector(rng, 1.5, 5);
        if (locate(level, from).where != Where::kAir) continue;
        const Vec3 way = target + random_vector(rng, 0, 0.8) - from;
        shots.push_back(shot_at(from, way * (rng.uniform(20, 500) / length(way))));
    }
}

/// What flew on undisturbed is in no solid on its way: sampled, with the parts where they are then.
void judge_free_way(const std::vector<MovingPart>& parts, const Vec3& from, const Vec3& to) {
    for (const MovingPart& part : parts) {
        const double reach = length(to - from) + length(part.motion.path) + 3;
        if (length(part.motion.position - from) > reach) continue;
        EXPECT_GT(first_inside(part, from, to - from, 40), 1);
    }
}

TEST_P(ShotsInLevels, NoneThroughAPartOrAWall) {
    const World& world = level().world;
    Rng rng(21);
    std::vector<MovingPart> parts = parts_all_over(world, 120, rng);
    std::vector<Projectile> shots = shots_between(world, sample(1000), rng);
    add_shots_toward(world, parts, sample(2500), rng, shots);
    FlyOptions options;
    options.other = {.ricochet_below = 0.4, .restitution = 0.5, .friction = 0.2, .resistance = 900};
    options.pane_energy = 20;
    options.max_age = 0.5;
    std::size_t of_parts[6] = {}, of_level[6] = {}, free = 0, carried = 0;
    ShotEvents told;
    for (int step = 0; step < 20; ++step) {
        const std::vector<Projectile> before = shots;
        ASSERT_TRUE(fly(shots, Scene{world, parts}, kTick, told, options).ok());
        std::vector<int> met(shots.size()), inside(shots.size());
        for (const ShotEvent& event : told.events) {
            ++met[event.projectile];
            ++(event.part == kNoPart ? of_level : of_parts)[std::size_t(event.kind)];
            if (event.kind == ShotEventKind::kEntered) ++inside[event.projectile];
            if (event.kind == ShotEventKind::kLeft) --inside[event.projectile];
            if (event.part == kNoPart) continue;
            const RigidMotion& motion = parts[event.part].motion;
            EXPECT_LT(length(point_of(motion, event.time / kTick, event.in_part) - event.point), 1e-9);
            if (event.kind != ShotEventKind::kStopped) continue;
            carried += length(point_of(motion, 1, event.in_part) - shots[event.projectile].position) < 2e-3;
        }
        for (std::size_t k = 0; k < shots.size(); ++k) {
            if (shots[k].state != ProjectileState::kFlying) continue;
            EXPECT_EQ(inside[k], 0);
            EXPECT_EQ(locate(world, shots[k].position).where, Where::kAir);
            for (const MovingPart& part : parts) {
                if (length(part.motion.position - shots[k].position) > 5) continue;
                EXPECT_FALSE(in_part(part, 1, shots[k].position)) << step << " " << k;
            }
            if (met[k] > 0) continue;
            ++free;
            judge_free_way(parts, before[k].position, shots[k].position);
        }
        go_on(parts);
    }
    const auto all = [](const std::size_t(&kinds)[6], ShotEventKind kind) { return kinds[std::size_t(kind)]; };
    EXPECT_GT(free, shots.size());
    EXPECT_GT(all(of_parts, ShotEventKind::kRicochet), 20u);
    EXPECT_GT(all(of_parts, ShotEventKind::kLeft), 20u);
    EXPECT_GT(all(of_parts, ShotEventKind::kPassed), 5u);
    EXPECT_GT(all(of_parts, ShotEventKind::kStopped), 20u);
    EXPECT_GT(carried, all(of_parts, ShotEventKind::kStopped) * 3 / 4);
    EXPECT_GT(all(of_level, ShotEventKind::kLeft), std::size_t(sample(40)));
}

TEST_P(ShotsInLevels, TheSameBitsOnAnyThreadsAndWithoutParts) {
    const World& world = level().world;
    Rng rng(22);
    const std::vector<MovingPart> parts = parts_all_over(world, 60, rng);
    const std::vector<Projectile> at_first = shots_between(world, 1200, rng);
    FlyOptions options;
    options.other.resistance = 900;
    const auto flown = [&](const std::vector<MovingPart>& among, const Tasks* tasks, bool by_world) {
        std::vector<Projectile> shots = at_first;
        FlyOptions chosen = options;
        chosen.tasks = tasks;
        ShotEvents events;
        double sum = 0;
        for (int step = 0; step < 10; ++step) {
            const auto report = by_world ? fly(shots, world, kTick, events, chosen)
                                         : fly(shots, Scene{world, among}, kTick, events, chosen);
            EXPECT_TRUE(report.ok());
            for (const ShotEvent& it : events.events)
                sum += it.time * it.projectile + dot(it.point, it.velocity) + it.number + it.energy;
        }
        return std::pair(hash_projectiles(shots), sum);
    };
    const auto alone = flown(parts, nullptr, false);
    for (const std::size_t threads : {2u, 3u}) {
        LentThreads lent(threads);
        EXPECT_EQ(flown(parts, &lent.tasks, false), alone);
    }
    const auto by_world = flown({}, nullptr, true);
    EXPECT_NE(by_world, alone);
    EXPECT_EQ(flown({}, nullptr, false), by_world);
    // Parts that no chord comes near change not a bit.
    const std::vector<MovingPart> far{going(cross_world(), {5000, 0, 0}, {1, 0, 0}),
                                      going(cross_world(), {1e6, 0, 0}, {1, 0, 0})};
    EXPECT_EQ(flown(far, nullptr, false), by_world);
}

}  // namespace
}  // namespace firma::test
