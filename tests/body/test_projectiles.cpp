// SPDX-License-Identifier: MIT
// Projectiles: the parabola in closed form, the bound on its chords, walls, ricochets, panes, bodies, thousands in
// levels, the same bits on any threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/carve.h"
#include "firma/projectiles.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/lent_threads.h"
#include "tests/openarena_maps.h"
#include "tests/random_vector.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using scenes::Rng;
using test::brush_world;

Projectile shot(const Vec3& position, const Vec3& velocity) {
    Projectile it;
    it.position = position;
    it.velocity = velocity;
    return it;
}

FlyOptions without_gravity(const ShotTerms& terms = {}) {
    FlyOptions options;
    options.gravity = {};
    options.other = terms;
    return options;
}

/// One step of one projectile.
std::vector<ShotEvent> fly_one(const World& world, Projectile& it, double seconds, const FlyOptions& options,
                               Bodies* bodies = nullptr) {
    ShotEvents events;
    const Result<FlyReport> report = fly({&it, 1}, world, seconds, events, options, bodies);
    EXPECT_TRUE(report.ok()) << report.error().text();
    return events.events;
}

TEST(Projectiles, AParabolaInStepsOfAnyLength) {
    Rng rng(1);
    const World empty;
    for (int run = 0; run < 20; ++run) {
        const Vec3 start = test::random_vector(rng, 0, 1000), velocity = test::random_vector(rng, 0, 900);
        Projectile it = shot(start, velocity);
        FlyOptions options;
        options.gravity = {rng.uniform(-2, 2), 1, -9.81};
        options.max_age = 100;
        double seconds = 0;
        std::size_t chords = 0;
        for (int k = 0; k < 1000; ++k) {
            ShotEvents events;
            const double step = rng.uniform(0.0001, k % 100 ? 0.02 : 0.5);
            const Result<FlyReport> report = fly({&it, 1}, empty, step, events, options);
            ASSERT_TRUE(report.ok());
            EXPECT_EQ(report.value().flying, 1u);
            EXPECT_TRUE(events.events.empty());
            chords += report.value().chords;
            seconds += step;
        }
        const Vec3 end = start + velocity * seconds + options.gravity * (0.5 * seconds * seconds);
        // Of each chord's end 2^-39 m a coordinate, and rounding of sums within 2^14 m.
        EXPECT_LT(max_abs(it.position - end), double(chords) * 0x1p-38 + 1e-9);
        EXPECT_LT(max_abs(it.velocity - velocity - options.gravity * seconds), 1e-9);
        EXPECT_NEAR(it.age, seconds, 1e-9);
        EXPECT_GT(chords, 1000u);
    }
}

/// How many of many shots over a wall, or under a beam, meet it: the parabola's apex is there, `above` its edge.
int meets_at_apex(double above, double max_bow, bool beam) {
    // The edges are at z = 4, the wall's or beam's faces at x = -1/64 and 1/64.
    const World world = brush_world(beam ? map_text::box({-1.0 / 64, -8, 4}, {1.0 / 64, 8, 8}, "stone")
                                         : map_text::box({-1.0 / 64, -8, 0}, {1.0 / 64, 8, 4}, "stone"));
    Rng rng(3);
    int met = 0;
    for (int k = 0; k < 200; ++k) {
        const double rise = rng.uniform(0.1, 0.4), speed = rng.uniform(20, 200);  // seconds to the apex; along x
        FlyOptions options;
        options.max_bow = max_bow;
        const Vec3 start{-speed * rise, rng.uniform(-7, 7), 4 + above - 0.5 * 9.81 * rise * rise};
        Projectile it = shot(start, {speed, 0, 9.81 * rise});
        const std::vector<ShotEvent> events = fly_one(world, it, 1, options);
        met += !events.empty();
    }
    return met;
}

TEST(Projectiles, TheBowIsBounded) {
    EXPECT_EQ(meets_at_apex(0.002, 0.001, false), 0);
    EXPECT_EQ(meets_at_apex(-0.002, 0.001, false), 200);
    EXPECT_EQ(meets_at_apex(0.002, 0.001, true), 200);
    EXPECT_EQ(meets_at_apex(-0.002, 0.001, true), 0);
    // With chords of a larger bow they would not be.
    EXPECT_GT(meets_at_apex(0.002, 0.05, false), 20);
    EXPECT_LT(meets_at_apex(0.002, 0.05, true), 180);
    EXPECT_EQ(meets_at_apex(0.0002, 0.0001, false), 0);
    EXPECT_EQ(meets_at_apex(0.0002, 0.0001, true), 200);
}

TEST(Projectiles, ThroughAWallAtAnAngle) {
    const World world = brush_world(map_text::box({0, 0, 0}, {8, 0.5, 4}, "stone"));
    Projectile it = shot({4, -1, 2}, {300, 400, 0});  // 1,250 J
    const FlyOptions options = without_gravity({.ricochet_below = 0.3, .resistance = 1000});
    const std::vector<ShotEvent> events = fly_one(world, it, 0.005, options);
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kEntered);
    EXPECT_NEAR(length(events[0].point - Vec3{4.75, 0, 2}), 0, 1e-9);
    EXPECT_EQ(events[0].normal, (Vec3{0, -1, 0}));
    EXPECT_NEAR(events[0].time, 0.0025, 1e-9);
    EXPECT_EQ(events[0].energy, 0);
    EXPECT_EQ(events[1].kind, ShotEventKind::kLeft);
    EXPECT_NEAR(length(events[1].point - Vec3{5.125, 0.5, 2}), 0, 1e-9);
    EXPECT_EQ(events[1].normal, (Vec3{0, 1, 0}));
    EXPECT_NEAR(events[1].thickness, 0.625, 1e-9);
    EXPECT_NEAR(events[1].energy, 625, 1e-6);
    EXPECT_EQ(events[1].matter_count, 1u);
    const double slower = std::sqrt(0.5);
    EXPECT_NEAR(length(it.velocity - Vec3{300, 400, 0} * slower), 0, 1e-6);
    EXPECT_NEAR(length(events[1].impulse - Vec3{3, 4, 0} * (1 - slower)), 0, 1e-8);
    // In no time; then on with what is left, from 0.01 mm behind the wall.
    const Vec3 end = Vec3{5.125, 0.5, 2} + Vec3{300, 400, 0} * (slower * 0.0025);
    EXPECT_LT(length(it.position - end), 2e-5);
    EXPECT_EQ(it.state, ProjectileState::kFlying);
}

TEST(Projectiles, StaysInAWall) {
    const World world = brush_world(map_text::box({0, 0, 0}, {8, 0.5, 4}, "stone"));
    Projectile it = shot({4, -1, 2}, {300, 400, 0});
    const FlyOptions options = without_gravity({.resistance = 4000});
    const std::vector<ShotEvent> events = fly_one(world, it, 0.01, options);
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kEntered);
    EXPECT_EQ(events[1].kind, ShotEventKind::kStopped);
    EXPECT_NEAR(events[1].thickness, 0.3125, 1e-9);
    EXPECT_NEAR(length(events[1].point - Vec3{4.9375, 0.25, 2}), 0, 1e-9);
    EXPECT_NEAR(events[1].energy, 1250, 1e-9);
    EXPECT_EQ(it.state, ProjectileState::kStopped);
    EXPECT_EQ(it.velocity, Vec3{});
    EXPECT_EQ(locate(world, it.position).where, Where::kSolid);
    const Projectile before = it;
    EXPECT_TRUE(fly_one(world, it, 0.01, options).empty());
    EXPECT_EQ(it.position, before.position);
    EXPECT_EQ(it.age, before.age);
    // At the face, of what is not entered.
    Projectile other = shot({4, -1, 2}, {300, 400, 0});
    const std::vector<ShotEvent> at_face = fly_one(world, other, 0.01, without_gravity());
    ASSERT_EQ(at_face.size(), 1u);
    EXPECT_EQ(at_face[0].kind, ShotEventKind::kStopped);
    EXPECT_EQ(at_face[0].thickness, 0);
    EXPECT_EQ(locate(world, other.position).where, Where::kAir);
    EXPECT_NEAR(other.position.y, -1e-5, 1e-9);
}

ShotTerms terms_of_number(const ShotImpact&, std::uint32_t matter, void* user) {
    ++*static_cast<int*>(user);
    return {.ricochet_below = 0, .resistance = 100.0 * matter};
}

TEST(Projectiles, MattersOneBehindTheOther) {
    const World world = brush_world(test::three_matters());  // brick, wood, steel: 4 m each
    const MatterTable& table = matters_of(world);
    std::vector<ShotTerms> terms(table.matters.size());
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = {.ricochet_below = 0, .resistance = 100.0 * double(k)};
    FlyOptions options = without_gravity();
    options.matters = terms;
    options.max_thickness = 20;
    Projectile it = shot({-2, 2, 2}, {1000, 0, 0});  // 5,000 J, of which brick takes 400, wood 1,200, steel 1,600
    ShotEvents events;
    ASSERT_TRUE(fly({&it, 1}, world, 0.003, events, options).ok());
    ASSERT_EQ(events.events.size(), 2u);
    const ShotEvent& left = events.events[1];
    EXPECT_EQ(left.kind, ShotEventKind::kLeft);
    ASSERT_EQ(left.matter_count, 3u);
    double energy = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const MatterLength& part = events.matters[left.first_matter + k];
        EXPECT_NEAR(part.length, 4, 1e-9);
        EXPECT_NEAR(part.from, k / 3.0, 1e-9);
        energy += terms[part.matter].resistance * part.length;
    }
    EXPECT_EQ(table.matters[events.events[0].matter].name, "brick");
    EXPECT_EQ(table.matters[left.matter].name, "steel");
    EXPECT_NEAR(left.energy, energy, 1e-6);
    EXPECT_NEAR(it.velocity.x, 1000 * std::sqrt(1 - energy / 5000), 1e-6);
    // By a function the same; it is asked for the face and for each matter.
    int asked = 0;
    options.rule = terms_of_number;
    options.user = &asked;
    Projectile other = shot({-2, 2, 2}, {1000, 0, 0});
    fly_one(world, other, 0.003, options);
    EXPECT_EQ(asked, 4);
    EXPECT_EQ(other.velocity, it.velocity);
    // Where the energy ends, in the second.
    Projectile slow = shot({-2, 2, 2}, {std::sqrt(2 * 700 / 0.01), 0, 0});
    options.rule = nullptr;
    const std::vector<ShotEvent> stopped = fly_one(world, slow, 0.02, options);
    ASSERT_EQ(stopped.size(), 2u);
    EXPECT_EQ(stopped[1].kind, ShotEventKind::kStopped);
    EXPECT_EQ(table.matters[stopped[1].matter].name, "wood");
    const double brick = terms[*matter_named(table, "brick")].resistance,
                 wood = terms[*matter_named(table, "wood")].resistance;
    EXPECT_NEAR(stopped[1].thickness, 4 + (700 - 4 * brick) / wood, 1e-6);
    // Longer than max_thickness stays in, whatever its energy.
    options.max_thickness = 5;
    Projectile heavy = shot({-2, 2, 2}, {1000, 0, 0});
    heavy.mass = 100;
    const std::vector<ShotEvent> deep = fly_one(world, heavy, 0.003, options);
    ASSERT_EQ(deep.size(), 2u);
    EXPECT_EQ(deep[1].kind, ShotEventKind::kStopped);
    EXPECT_NEAR(deep[1].thickness, 5, 0.01);
}

TEST(Projectiles, RicochetBelowTheAngle) {
    const World world = test::ground();
    for (const double below : {0.1, 0.4, 1.0}) {
        for (const double angle : {0.02, 0.09, 0.11, 0.39, 0.41, 0.99, 1.01, 1.5}) {
            const double speed = 200, along = std::cos(angle) * speed, down = std::sin(angle) * speed;
            const FlyOptions options = without_gravity({.ricochet_below = below, .restitution = 0.5, .friction = 0.25});
            Projectile it = shot({0, 0, 0.25}, {along, 0, -down});
            const std::vector<ShotEvent> events = fly_one(world, it, 1.0 / 8, options);
            const bool expected = angle < below;
            ASSERT_EQ(events.size(), 1u);
            ASSERT_EQ(events[0].kind == ShotEventKind::kRicochet, expected) << angle << " " << below;
            if (!expected) continue;
            EXPECT_EQ(events[0].normal, (Vec3{0, 0, 1}));
            EXPECT_NEAR(it.velocity.z, 0.5 * down, 1e-9);
            EXPECT_NEAR(it.velocity.x, along - std::min(along, 0.25 * 1.5 * down), 1e-9);
            EXPECT_EQ(it.velocity.y, 0);
            EXPECT_GT(it.position.z, 0);
            EXPECT_NEAR(events[0].energy, 0.005 * (speed * speed - dot(it.velocity, it.velocity)), 1e-9);
        }
    }
}

TEST(Projectiles, BouncesUntilItIsSlow) {
    const World world = test::ground();
    FlyOptions options;
    options.other = {.ricochet_below = 2, .restitution = 0.5, .friction = 0};
    Projectile it = shot({0, 0, 5}, {0, 0, 0});
    std::vector<ShotEvent> all;
    for (int k = 0; k < 600 && it.state == ProjectileState::kFlying; ++k)
        for (const ShotEvent& event : fly_one(world, it, 1.0 / 60, options)) all.push_back(event);
    EXPECT_EQ(it.state, ProjectileState::kStopped);
    ASSERT_EQ(all.size(), 4u);  // at 9.90 m/s, 4.95, 2.48, and at 1.24 to less than 1
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(all[std::size_t(k)].velocity.z, std::sqrt(2 * 9.81 * 5) * std::pow(0.5, k + 1), 0.01);
    EXPECT_EQ(all[3].kind, ShotEventKind::kStopped);
    EXPECT_NEAR(it.position.z, 1e-5, 1e-8);
    // Never more impacts in a step than the options say.
    const World crack = brush_world(map_text::box({-128, -1, -1}, {128, 1, 0}, "stone") +
                                    map_text::box({-128, -1, 0.0625}, {128, 1, 1}, "stone"));
    options.other.restitution = 1;
    options.max_impacts = 5;
    Projectile fast = shot({0, 0, 0.03}, {100, 0, 50});
    const std::vector<ShotEvent> many = fly_one(crack, fast, 0.1, options);
    ASSERT_EQ(many.size(), 5u);
    EXPECT_EQ(many[3].kind, ShotEventKind::kRicochet);
    EXPECT_EQ(many[4].kind, ShotEventKind::kStopped);
    EXPECT_EQ(locate(crack, fast.position).where, Where::kAir);
}

TEST(Projectiles, PanesStopItOrTakeEnergy) {
    Level level = test::empty_level();
    test::add_box(level, {0, 0, 0}, {1, 4, 4});
    test::add_polygon(level, {{-1, 0, 0}, {-1, 0, 4}, {-1, 4, 4}, {-1, 4, 0}});
    // A sheet in front of the wall, nearer than a projectile goes on behind a pane.
    const double near = -1 / kInputSteps;
    test::add_polygon(level, {{near, 0, 0}, {near, 0, 4}, {near, 4, 4}, {near, 4, 0}});
    const World world = make_world(level).value();
    FlyOptions options = without_gravity({.ricochet_below = 0, .resistance = 100});
    Projectile stops = shot({-2, 2, 2}, {300, 0, 0});
    const std::vector<ShotEvent> at_pane = fly_one(world, stops, 0.02, options);
    ASSERT_EQ(at_pane.size(), 1u);
    EXPECT_EQ(at_pane[0].kind, ShotEventKind::kStopped);
    EXPECT_EQ(at_pane[0].point, (Vec3{-1, 2, 2}));
    options.pane_energy = 50;
    Projectile it = shot({-2, 2, 2}, {300, 0, 0});  // 450 J
    const std::vector<ShotEvent> events = fly_one(world, it, 0.02, options);
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kPassed);
    EXPECT_NEAR(events[0].energy, 50, 1e-9);
    EXPECT_EQ(events[1].kind, ShotEventKind::kPassed);
    EXPECT_EQ(events[2].kind, ShotEventKind::kEntered);
    EXPECT_EQ(events[3].kind, ShotEventKind::kLeft);
    EXPECT_NEAR(events[3].thickness, 1, 1e-9);
    EXPECT_NEAR(length(it.velocity), std::sqrt(2 * 250 / 0.01), 1e-6);
    EXPECT_GT(it.position.x, 1);
    // What shares no bit is not there.
    Projectile through = shot({-2, 2, 2}, {300, 0, 0});
    through.mask = 0;
    EXPECT_TRUE(fly_one(world, through, 0.02, options).empty());
    EXPECT_NEAR(through.position.x, 4, 1e-9);
}

TEST(Projectiles, AWallRightBehindASheet) {
    Level level = test::empty_level();
    test::add_polygon(level, {{0, 1, 1}, {0, 1, 3}, {0, 3, 3}, {0, 3, 1}});  // on the wall
    test::add_box(level, {0, 0, 0}, {1, 4, 4});
    const World world = make_world(level).value();
    FlyOptions options = without_gravity({.ricochet_below = 0, .resistance = 100});
    options.pane_energy = 50;
    Projectile it = shot({-2, 2, 2}, {300, 0, 0});
    const std::vector<ShotEvent> events = fly_one(world, it, 0.02, options);
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kPassed);
    EXPECT_EQ(events[1].kind, ShotEventKind::kEntered);
    EXPECT_EQ(events[2].kind, ShotEventKind::kLeft);
    EXPECT_NEAR(events[2].thickness, 1, 1e-9);
    EXPECT_NEAR(length(it.velocity), std::sqrt(2 * 300 / 0.01), 1e-6);
}

TEST(Projectiles, OutOfAFloorAndRightIntoAWall) {
    // Out of the floor 4 millionths of a metre before the wall that stands on it.
    const World world = brush_world(map_text::box({-8, -4, -0.5}, {1, 4, 0}, "stone") +
                                    map_text::box({1, -4, -1}, {1.25, 4, 4}, "stone"));
    const FlyOptions options = without_gravity({.ricochet_below = 0, .resistance = 10});
    Projectile it = shot({1 - 4e-6 - 2, 0, -2}, {200, 0, 200});
    const std::vector<ShotEvent> events = fly_one(world, it, 0.02, options);
    ASSERT_EQ(events.size(), 4u);
    EXPECT_NEAR(events[1].thickness, std::sqrt(0.5), 1e-6);
    EXPECT_EQ(events[1].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(events[2].kind, ShotEventKind::kEntered);
    EXPECT_EQ(events[2].normal, (Vec3{-1, 0, 0}));
    EXPECT_NEAR(events[3].thickness, 0.25 * std::sqrt(2.0), 1e-6);
    EXPECT_EQ(locate(world, it.position).where, Where::kAir);
}

TEST(Projectiles, ExactlyAtEdges) {
    // Touching an edge it passes by, with a way through of no thickness; into an edge it goes as into a face.
    const World world = brush_world(map_text::box({0, 0, 0}, {1, 1, 4}, "stone"));
    const FlyOptions options = without_gravity({.ricochet_below = 0, .resistance = 100});
    Projectile past = shot({-1, 1, 2}, {128, -128, 0});
    past.position = {-1, 1, 2};
    const std::vector<ShotEvent> touched = fly_one(world, past, 1.0 / 64, options);
    double thickness = 0;
    for (const ShotEvent& event : touched) thickness += event.thickness;
    EXPECT_EQ(thickness, 0);
    EXPECT_EQ(past.state, ProjectileState::kFlying);
    EXPECT_LT(length(past.position - Vec3{1, -1, 2}), 2e-3);
    EXPECT_NEAR(length(past.velocity), 128 * std::sqrt(2.0), 1e-9);
    Projectile into = shot({-1, -1, 2}, {128, 128, 0});
    const std::vector<ShotEvent> through = fly_one(world, into, 1.0 / 32, options);
    ASSERT_EQ(through.size(), 2u);
    EXPECT_NEAR(through[1].thickness, std::sqrt(2.0), 1e-9);
    // Along a wall, exactly: it touches the edge that the wall begins with.
    Projectile along = shot({-1, 1, 2}, {128, 0, 0});
    for (const ShotEvent& event : fly_one(world, along, 1.0 / 32, options)) EXPECT_EQ(event.thickness, 0);
    EXPECT_EQ(along.state, ProjectileState::kFlying);
    EXPECT_NEAR(along.position.x, 3, 2e-3);
    EXPECT_EQ(along.position.y, 1);
}

TEST(Projectiles, AShutDoorStopsIt) {
    LevelPortal hatch;
    hatch.polygons.emplace_back();
    for (const Vec3& corner : {Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{2, 2, 0}, Vec3{-2, 2, 0}})
        hatch.polygons[0].push_back(*snap(corner));
    const World open = make_divided_world(test::box_level({-2, -2, -4}, {2, 2, 4}, true), {&hatch, 1}).value();
    Projectile it = shot({0, 0.5, 1}, {0, 0, -100});
    EXPECT_TRUE(fly_one(open, it, 0.02, without_gravity()).empty());
    Projectile other = shot({0, 0.5, 1}, {0, 0, -100});
    const std::vector<ShotEvent> events = fly_one(*set_portal_open(open, {0}, false), other, 0.02, without_gravity());
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].portal, PortalId{0});
    EXPECT_EQ(events[0].kind, ShotEventKind::kStopped);
}

TEST(Projectiles, BodiesAreMetWhereverProjectilesFly) {
    const World empty;
    for (const double x : {-16000.0, -8192.0, -8000.0, 8190.0, 8200.0, 12000.0, 16000.0}) {
        Bodies bodies;
        const BodyId id = add_body(bodies, test::body_here(test::ball(0.5), {x, x / 2, -x / 3}));
        Projectile it = shot({x - 2, x / 2, -x / 3}, {100, 0, 0}),
                   beside = shot({x - 2, x / 2 + 0.6, -x / 3}, {100, 0, 0});
        const std::vector<ShotEvent> events = fly_one(empty, it, 0.05, without_gravity(), &bodies);
        ASSERT_EQ(events.size(), 1u) << x;
        EXPECT_EQ(events[0].body, id);
        EXPECT_NEAR(events[0].point.x, x - 0.5, 1e-9);
        EXPECT_TRUE(fly_one(empty, beside, 0.05, without_gravity(), &bodies).empty()) << x;
    }
}

TEST(Projectiles, BodiesTakeTheImpulse) {
    const World empty;
    Bodies bodies;
    Body body = test::body_here(test::box_body({0.3, 0.3, 0.3}), {0, 0, 0});
    body.asleep = true;
    const BodyId id = add_body(bodies, body);
    add_body(bodies, test::body_here(test::ball(0.5), {5, 0, 0.3}));
    const Vec3 velocity{200, 0, 0};
    Projectile it = shot({-2, 0.15, 0.15}, velocity);
    it.mass = 0.5;
    const std::vector<ShotEvent> events = fly_one(empty, it, 0.05, without_gravity(), &bodies);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kStopped);
    EXPECT_EQ(events[0].body, id);
    EXPECT_NEAR(length(events[0].point - Vec3{-0.3, 0.15, 0.15}), 0, 1e-9);
    EXPECT_NEAR(events[0].normal.x, -1, 1e-9);
    const Body& hit = *bodies.find(id);
    EXPECT_NEAR(length(hit.velocity * hit.shape.mass() - velocity * it.mass), 0, 1e-9);
    EXPECT_FALSE(hit.asleep);
    const Vec3 moment = cross(Vec3{-0.3, 0.15, 0.15}, velocity * it.mass);
    EXPECT_NEAR(length(angular_momentum(hit) - moment), 0, 1e-9);
    EXPECT_EQ(bodies.slots[1].velocity, Vec3{});
    // At a flat angle it ricochets, and momentum is kept.
    Projectile flat = shot({3, 0, 0.79}, {100, 0, 0});
    FlyOptions options = without_gravity();
    options.bodies = {.ricochet_below = 0.5, .restitution = 0.6, .friction = 0.1};
    const std::vector<ShotEvent> glance = fly_one(empty, flat, 0.05, options, &bodies);
    ASSERT_EQ(glance.size(), 1u);
    EXPECT_EQ(glance[0].kind, ShotEventKind::kRicochet);
    EXPECT_EQ(glance[0].body.slot, 1u);
    EXPECT_GT(flat.velocity.z, 0);
    const Vec3 sum = flat.velocity * flat.mass + bodies.slots[1].velocity * bodies.slots[1].shape.mass();
    EXPECT_NEAR(length(sum - Vec3{1, 0, 0}), 0, 1e-12);
    // A wall before it, a mask without a common bit: not met.
    bodies.slots[1].mask = 2;
    Projectile beside = shot({3, 0, 0.3}, {100, 0, 0});
    beside.mask = 1;
    EXPECT_TRUE(fly_one(empty, beside, 0.05, options, &bodies).empty());
    const World wall = brush_world(map_text::box({3.5, -2, -2}, {4, 2, 2}, "stone"));
    Projectile behind = shot({3, 0, 0.3}, {100, 0, 0});
    const std::vector<ShotEvent> first = fly_one(wall, behind, 0.05, without_gravity(), &bodies);
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].body.slot, ~0u);
}

/// Terms by matter: some are thin, some throw it back.
std::vector<ShotTerms> some_terms(const World& world) {
    std::vector<ShotTerms> terms(matters_of(world).matters.size());
    for (std::size_t k = 0; k < terms.size(); ++k)
        terms[k] = {.ricochet_below = 0.3 * double(k % 4 + 1),
                    .restitution = 0.5,
                    .friction = 0.2,
                    .resistance = k % 3 == 2 ? kUnpierced : 500.0 * double(k + 1)};
    return terms;
}

std::vector<Projectile> shots_in(const World& world, int count, std::uint64_t seed) {
    Rng rng(seed);
    const Box box = world.bounds();
    std::vector<Projectile> shots;
    while (int(shots.size()) < count) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (locate(world, at).where != Where::kAir) continue;
        shots.push_back(shot(at, test::random_vector(rng, 5, 900)));
    }
    return shots;
}

/// What holds of each projectile in each step.
struct FlightJudge {
    const World& world;
    std::size_t kinds[6] = {}, free = 0;

    void judge(const std::vector<Projectile>& before, const std::vector<Projectile>& after, const ShotEvents& told) {
        std::vector<int> inside(after.size()), met(after.size());
        for (std::size_t k = 0; k < told.events.size(); ++k) {
            const ShotEvent& event = told.events[k];
            ++kinds[std::size_t(event.kind)];
            EXPECT_GE(event.time, told.events[k > 0 ? k - 1 : 0].time);
            ++met[event.projectile];
            EXPECT_EQ(
                inside[event.projectile] == 1,
                event.kind == ShotEventKind::kLeft || (event.kind == ShotEventKind::kStopped && event.thickness > 0));
            if (event.kind == ShotEventKind::kEntered) ++inside[event.projectile];
            if (event.kind != ShotEventKind::kLeft) continue;
            --inside[event.projectile];
            judge_way_out(event, told);
        }
        for (std::size_t k = 0; k < after.size(); ++k) {
            if (before[k].state != ProjectileState::kFlying) continue;
            if (after[k].state == ProjectileState::kFlying) {
                EXPECT_EQ(locate(world, after[k].position).where, Where::kAir);
                EXPECT_EQ(inside[k], 0);
            }
            if (met[k] > 0) continue;
            ++free;
            Piercing found;
            pierce(world, {before[k].position, after[k].position - before[k].position}, found);
            EXPECT_TRUE(found.spans.empty());
        }
    }

    void judge_way_out(const ShotEvent& left, const ShotEvents& told) const {
        double sum = 0;
        for (std::uint32_t k = 0; k < left.matter_count; ++k) sum += told.matters[left.first_matter + k].length;
        EXPECT_NEAR(sum, left.thickness, 1e-9);
        EXPECT_GT(dot(left.normal, left.velocity), -1e-3 * length(left.velocity));
    }
};

void fly_in(const World& world, int count) {
    std::vector<Projectile> shots = shots_in(world, count, 7);
    const std::vector<ShotTerms> terms = some_terms(world);
    FlyOptions options;
    options.matters = terms;
    options.pane_energy = 100;
    options.max_age = 0.4;
    FlightJudge judge{world};
    ShotEvents events;
    for (int step = 0; step < 30; ++step) {
        const std::vector<Projectile> before = shots;
        ASSERT_TRUE(fly(shots, world, 1.0 / 60, events, options).ok());
        judge.judge(before, shots, events);
    }
    std::size_t flying = 0;
    for (const Projectile& it : shots) flying += it.state == ProjectileState::kFlying;
    EXPECT_EQ(flying, 0u);
    const auto told = [&](ShotEventKind kind) { return judge.kinds[std::size_t(kind)]; };
    EXPECT_EQ(told(ShotEventKind::kStopped) + told(ShotEventKind::kExpired), shots.size());
    EXPECT_GT(told(ShotEventKind::kLeft), shots.size() / 20);
    EXPECT_GT(told(ShotEventKind::kEntered), told(ShotEventKind::kLeft));
    EXPECT_GT(told(ShotEventKind::kRicochet), shots.size() / 40);
    EXPECT_GT(judge.free, shots.size());
}

TEST(Projectiles, NoneThroughAWallOfTheDepot) {
    World world = test::depot_world();
    fly_in(world, test::sample(10000));
    Rng rng(5);
    for (int k = 0; k < 20; ++k) {
        const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, rng.next()),
                                      {.position = shots_in(world, 1, rng.next())[0].position, .scale = 3});
        if (cut.done()) world = cut.world;
    }
    ASSERT_GT(world.version(), 5u);
    fly_in(world, test::sample(3000));
}

TEST(Projectiles, NoneThroughAWallOfAMap) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& path) { return path.stem() == "kaos2"; });
    if (map == maps.end()) GTEST_SKIP() << kNoOpenArena;
    fly_in(make_world(read_brush_level(map->string()).value()).value(), test::sample(10000));
}

TEST(Projectiles, TheSameBitsOnAnyThreadsAndFromASnapshot) {
    const World world = test::depot_world();
    const std::vector<ShotTerms> terms = some_terms(world);
    FlyOptions options;
    options.matters = terms;
    Bodies bodies;
    for (const Projectile& it : shots_in(world, 20, 3)) add_body(bodies, test::body_here(test::ball(1), it.position));
    const Bodies bodies_at_first = bodies;
    std::vector<Projectile> alone = shots_in(world, 1500, 2);
    const std::vector<Projectile> at_first = alone;
    std::vector<Projectile> snapshot;
    Bodies bodies_then;
    ShotEvents events;
    const auto hash_of_events = [&] {
        double sum = 0;
        for (const ShotEvent& it : events.events)
            sum += it.time * it.projectile + dot(it.point, it.velocity) + it.number;
        for (const MatterLength& it : events.matters) sum = sum * 0.5 + it.length;
        return sum;
    };
    std::vector<double> told;
    for (int k = 0; k < 20; ++k) {
        if (k == 10) snapshot = alone, bodies_then = bodies;
        ASSERT_TRUE(fly(alone, world, 1.0 / 60, events, options, &bodies).ok());
        told.push_back(hash_of_events());
    }
    EXPECT_NE(hash_bodies(bodies), hash_bodies(bodies_at_first));
    for (const std::size_t threads : {1u, 2u, 3u}) {
        test::LentThreads lent(threads);
        FlyOptions on_threads = options;
        on_threads.tasks = &lent.tasks;
        std::vector<Projectile> shots = at_first;
        Bodies again = bodies_at_first;
        for (std::size_t k = 0; k < 20; ++k) {
            ASSERT_TRUE(fly(shots, world, 1.0 / 60, events, on_threads, &again).ok());
            EXPECT_EQ(hash_of_events(), told[k]);
        }
        EXPECT_EQ(hash_projectiles(shots), hash_projectiles(alone));
        EXPECT_EQ(hash_bodies(again), hash_bodies(bodies));
    }
    for (int k = 10; k < 20; ++k) ASSERT_TRUE(fly(snapshot, world, 1.0 / 60, events, options, &bodies_then).ok());
    EXPECT_EQ(hash_projectiles(snapshot), hash_projectiles(alone));
    EXPECT_EQ(hash_bodies(bodies_then), hash_bodies(bodies));
    snapshot[0].age += 1e-9;
    EXPECT_NE(hash_projectiles(snapshot), hash_projectiles(alone));
}

TEST(Projectiles, WhatIsFilledInAroundItStopsIt) {
    const World world = test::ground();
    Projectile it = shot({0, 0, 3}, {0, 0, 1});
    FlyOptions options;
    EXPECT_TRUE(fly_one(world, it, 1.0 / 60, options).empty());
    const World filled = fill(world, make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, 3, 1)).world;
    Projectile other_mask = it;
    const std::vector<ShotEvent> events = fly_one(filled, it, 1.0 / 60, options);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kStopped);
    EXPECT_FALSE(events[0].face.valid());
    EXPECT_EQ(it.state, ProjectileState::kStopped);
    other_mask.mask = 0;
    EXPECT_TRUE(fly_one(filled, other_mask, 1.0 / 60, options).empty());
}

TEST(Projectiles, Expire) {
    const World world = test::ground();
    FlyOptions options = without_gravity();
    options.max_age = 0.1;
    Projectile old = shot({0, 0, 3}, {10, 0, 0});
    EXPECT_TRUE(fly_one(world, old, 0.0625, options).empty());
    const std::vector<ShotEvent> events = fly_one(world, old, 0.0625, options);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, ShotEventKind::kExpired);
    EXPECT_NEAR(events[0].time, 0.0375, 1e-12);
    EXPECT_NEAR(old.position.x, 1, 1e-9);
    EXPECT_EQ(old.state, ProjectileState::kExpired);
    Projectile far = shot({16000, 0, 3}, {50000, 0, 0});
    const std::vector<ShotEvent> out = fly_one(world, far, 0.0625, options);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].kind, ShotEventKind::kExpired);
    Projectile away = shot({1e100, 0, 3}, {0, 0, 0});
    EXPECT_EQ(fly_one(world, away, 0.0625, options).size(), 1u);
}

void leave_undone(std::size_t count, void (*work)(void* context, std::size_t k), void* context, void*) {
    for (std::size_t k = 0; k + 1 < count; ++k) work(context, k);
}

TEST(Projectiles, BadInput) {
    const World world = test::ground();
    std::vector<Projectile> shots(600, shot({0, 0, 3}, {10, 0, 0}));
    const std::uint64_t hash = hash_projectiles(shots);
    ShotEvents events;
    const auto refuses = [&](double seconds, const FlyOptions& options) {
        const Result<FlyReport> report = fly(shots, world, seconds, events, options);
        EXPECT_EQ(hash_projectiles(shots), hash);
        return !report.ok() && events.events.empty();
    };
    FlyOptions options;
    for (const double seconds : {0.0, -1.0, 1.5, double(NAN), double(INFINITY)}) EXPECT_TRUE(refuses(seconds, options));
    const auto with = [](const auto& change) {
        FlyOptions changed;
        change(changed);
        return changed;
    };
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.gravity.z = NAN; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.gravity.z = 1e30; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.max_bow = 0; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.max_age = NAN; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.stop_speed = -1; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.max_impacts = 0; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.max_impacts = 1001; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.max_thickness = INFINITY; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.pane_energy = NAN; })));
    EXPECT_TRUE(refuses(0.1, with([](FlyOptions& o) { o.other.restitution = 1.5; })));
    const ShotTerms bad{.friction = NAN};
    EXPECT_TRUE(refuses(0.1, with([&](FlyOptions& o) { o.matters = {&bad, 1}; })));
    const Tasks undone{leave_undone};
    EXPECT_TRUE(refuses(0.1, with([&](FlyOptions& o) { o.tasks = &undone; })));
    for (int k = 0; k < 6; ++k) {
        std::vector<Projectile> some(3, shot({0, 0, 3}, {10, 0, 0}));
        Projectile& one = some[1];
        if (k == 0) one.position.x = NAN;
        if (k == 1) one.velocity.y = INFINITY;
        if (k == 2) one.velocity.y = 1e9;
        if (k == 3) one.mass = 0;
        if (k == 4) one.age = -1;
        if (k == 5) one.mass = NAN;
        const Result<FlyReport> report = fly(some, world, 0.1, events);
        ASSERT_FALSE(report.ok()) << k;
        EXPECT_EQ(report.error().code, ErrorCode::kOutOfRange);
        EXPECT_EQ(report.error().place, "projectile 1");
        EXPECT_EQ(some[0].position, (Vec3{0, 0, 3}));
        one.state = ProjectileState::kStopped;  // is not looked at
        EXPECT_TRUE(fly(some, world, 0.1, events).ok());
    }
    EXPECT_TRUE(fly({}, world, 0.1, events).ok());
}

}  // namespace
}  // namespace firma
