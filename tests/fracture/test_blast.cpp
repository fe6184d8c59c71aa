// SPDX-License-Identifier: MIT
// Pushes of blasts: away, weaker farther off, and by what is seen.
#include <gtest/gtest.h>

#include "firma/blast.h"
#include "firma/debris.h"
#include "firma/moving_parts.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using test::ball;
using test::body_here;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Ground with a wall at x = 2 to 2.5, 40 m long, so high.
World with_wall(double height) {
    return test::brush_world(map_text::box({-128, -128, -4}, {128, 128, 0}, "rock") +
                             map_text::box({2, -20, 0}, {2.5, 20, height}, "rock"));
}

TEST(Blasts, FallOffToNothing) {
    const Blast blast{{1, 2, 3}, 4, 100};
    EXPECT_EQ(blast_share(blast, 0), 1);
    EXPECT_EQ(blast_share(blast, 1), 0.5625);
    EXPECT_EQ(blast_share(blast, 2), 0.25);
    EXPECT_EQ(blast_share(blast, 4), 0);
    EXPECT_EQ(blast_share(blast, 9), 0);
    EXPECT_EQ(blast_share(blast, kNone), 0);
    EXPECT_EQ(blast_impulse(blast, {3, 2, 3}, 0.5), (Vec3{100 * 0.25 * 0.5, 0, 0}));
    EXPECT_EQ(blast_impulse(blast, {1, 2, 1}, 0.5, 0.5), (Vec3{0, 0, -6.25}));
    EXPECT_EQ(blast_impulse(blast, {1, 2, 3}, 1), (Vec3{0, 0, 100}));
    EXPECT_EQ(blast_impulse(blast, {1, 2, 8}, 1), Vec3{});
    for (const double bad : {kNone, double(INFINITY), -1.0}) {
        EXPECT_EQ(blast_impulse(blast, {3, 2, 3}, bad), Vec3{});
        EXPECT_EQ(blast_impulse({{1, 2, 3}, bad, 100}, {3, 2, 3}, 1), Vec3{});
        EXPECT_EQ(blast_impulse({{1, 2, 3}, 4, bad}, {3, 2, 3}, 1), Vec3{});
    }
    EXPECT_EQ(blast_impulse(blast, {kNone, 2, 3}, 1), Vec3{});
    EXPECT_EQ(blast_impulse(blast, {3, 2, 3}, 1, 2), Vec3{});
}

TEST(Blasts, AreSeenOverAWall) {
    const Vec3 at{0, 0, 0.5};
    const Sphere player[] = {{{4, 0, 0.4}, 0.3}, {{4, 0, 1}, 0.3}, {{4, 0, 1.6}, 0.3}};
    EXPECT_EQ(exposure(with_wall(0.1), at, player), 1);
    EXPECT_EQ(exposure(with_wall(9), at, player), 0);
    // From half a metre up over 0.85 m: at 4 m what is above 1.2 m, but for what the far edge hides.
    const double half = exposure(with_wall(0.85), at, player);
    EXPECT_GT(half, 0.3);
    EXPECT_LT(half, 0.7);
    const Vec3 points[] = {{4, 0, 0.4}, {4, 0, 1}, {4, 0, 1.6}, {4, 0, kNone}};
    EXPECT_EQ(exposure(with_wall(0.85), at, points), 0.25);
    EXPECT_EQ(exposure(with_wall(0.85), at, std::span<const Vec3>{}), 0);
    EXPECT_EQ(exposure(with_wall(0.85), at, std::span<const Sphere>{}), 0);
    EXPECT_EQ(exposure(with_wall(0.85), {kNone, 0, 0}, points), 0);
    EXPECT_EQ(exposure(with_wall(9), at, player, 0), 1) << "a mask of nothing: nothing covers";
}

TEST(Blasts, NoWallIsEverMissed) {
    // A closed box around the blast, one input step thick: nothing outside is seen.
    const double thin = 1 / 4096.0;
    std::string box;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vec3 low{-2, -2, -2}, high{2, 2, 2};
            (side < 0 ? high : low)[axis] = side * (2 - thin);
            box += map_text::box(low, high, "rock");
        }
    const World world = test::brush_world(box);
    scenes::Rng rng(1);
    int inside = 0;
    for (int k = 0; k < 3000; ++k) {
        const Vec3 to = test::random_vector(rng, 0.1, 20);
        const bool out = max_abs(to) > 2, in = max_abs(to) < 2 - thin;
        if (!out && !in) continue;
        inside += in;
        EXPECT_EQ(exposure(world, {0.1, 0.2, 0.3}, std::span(&to, 1)), in ? 1 : 0);
    }
    EXPECT_GT(inside, 100);
}

TEST(Blasts, PushAwayAndLessFartherOff) {
    const World world = test::ground();
    Bodies bodies;
    std::vector<BodyId> ids;
    for (int k = 0; k < 4; ++k) ids.push_back(add_body(bodies, body_here(ball(0.2), {0.5 + k, 0, 1})));
    for (std::uint32_t k = 0; k < 4; ++k) bodies.slots[k].asleep = true, bodies.slots[k].island = k;
    const Blast blast{{0, 0, 1}, 3, 500};
    const PushReport report = blast_push(world, bodies, blast);
    EXPECT_EQ(report.reached, 3u);
    EXPECT_EQ(report.pushed, 3u);
    double before = INFINITY;
    for (int k = 0; k < 3; ++k) {
        const Body& body = *bodies.find(ids[std::size_t(k)]);
        EXPECT_FALSE(body.asleep);
        EXPECT_EQ(body.velocity.y, 0);
        EXPECT_EQ(body.spin, Vec3{});
        EXPECT_LT(body.velocity.x, before);
        before = body.velocity.x;
        const double area = 3.14159265358979323846 * 0.2 * 0.2;
        EXPECT_NEAR(body.velocity.x * body.shape.mass(), blast_impulse(blast, body.position, area).x, 1e-9);
    }
    EXPECT_EQ(bodies.find(ids[3])->velocity, Vec3{});
    EXPECT_TRUE(bodies.find(ids[3])->asleep);
}

TEST(Blasts, PushNobodyBehindAWall) {
    Bodies bodies;
    const BodyId id = add_body(bodies, body_here(ball(0.2), {3, 0, 0.5}));
    bodies.slots[0].asleep = true;
    const Blast blast{{1, 0, 0.5}, 6, 500};
    const PushReport report = blast_push(with_wall(3), bodies, blast);
    EXPECT_EQ(report.reached, 1u);
    EXPECT_EQ(report.pushed, 0u);
    EXPECT_TRUE(bodies.find(id)->asleep);
    EXPECT_EQ(bodies.find(id)->velocity, Vec3{});
    EXPECT_EQ(blast_push(with_wall(0.1), bodies, blast).pushed, 1u);
}

TEST(Blasts, TurnWhatIsHalfCovered) {
    // Two balls on a bar upright behind a wall that covers the lower one: the upper one is pushed away.
    const Sphere spheres[] = {{{0, 0, 0.4}, 0.2}, {{0, 0, -0.4}, 0.2}};
    const BodyShape bar = make_body_shape(spheres, mass_of_box({0.2, 0.2, 0.6}, 1000)).value();
    Bodies bodies;
    add_body(bodies, body_here(bar, {3, 0, 1}));
    const Blast blast{{1, 0, 1}, 6, 500};
    EXPECT_EQ(blast_push(with_wall(1.05), bodies, blast).pushed, 1u);
    EXPECT_GT(bodies.slots[0].velocity.x, 0);
    EXPECT_GT(bodies.slots[0].spin.y, 0.1) << "its top goes away from the blast";
    const double covered = bodies.slots[0].velocity.x;
    bodies.slots[0].velocity = bodies.slots[0].spin = {};
    blast_push(with_wall(0.1), bodies, blast);
    EXPECT_NEAR(bodies.slots[0].velocity.x, 2 * covered, 1e-9);
    EXPECT_NEAR(bodies.slots[0].spin.y, 0, 1e-9);
}

TEST(Blasts, PartsCover) {
    const World world = test::ground();
    const World wall = test::brush_world(map_text::box({-0.25, -20, 0}, {0.25, 20, 9}, "rock"));
    const RigidMotion aside{{2, 0, 0}, {0, 0, 0, 1}, {0, 60, 0}, {}};
    const MovingPart parts[] = {MovingPart(wall, aside)};
    const Sphere player[] = {{{4, 0, 0.4}, 0.3}, {{4, 0, 1.6}, 0.3}};
    const Vec3 point{4, 0, 1}, at{0, 0, 0.5};
    const Blast blast{at, 8, 400};
    for (const double gone : {0.0, 1.0}) {
        const Scene scene{world, parts, gone, 1};
        EXPECT_EQ(exposure(scene, at, player), gone);
        EXPECT_EQ(exposure(scene, at, std::span(&point, 1)), gone);
        Bodies bodies;
        add_body(bodies, body_here(ball(0.5), {4, 0, 0.5}));
        EXPECT_EQ(blast_push(scene, bodies, blast).pushed, std::size_t(gone));
        EXPECT_EQ(bodies.slots[0].velocity.x > 0, gone == 1);
        Debris debris;
        const BlastResult result = explode(scene, bodies, debris, blast, {}, {});
        EXPECT_EQ(result.push.reached, 1u);
        EXPECT_EQ(result.push.pushed, std::size_t(gone));
        EXPECT_EQ(hash_world(result.carve.world), hash_world(world));
    }
    EXPECT_EQ(exposure(Scene{world, parts, 2, 2}, at, player), 0) << "no stretch";
}

TEST(Blasts, GiveNoMoreThanTheGreatestSpeed) {
    const World world = test::ground();
    const Sphere off{{0.5, 0, 0}, 0.5};
    const BodyShape light = make_body_shape({&off, 1}, mass_of_box({0.3, 0.3, 0.3}, 1)).value();
    Bodies bodies;
    add_body(bodies, body_here(light, {1, 0.3, 1}));
    blast_push(world, bodies, {{0, 0, 1}, 6, 5000}, {.max_speed = 12});
    EXPECT_NEAR(length(bodies.slots[0].velocity), 12, 1e-9);
    EXPECT_NEAR(length(bodies.slots[0].spin) * light.reach(), 12, 1e-9);
    bodies.slots[0].velocity = {};
    blast_push(world, bodies, {{0, 0, 1}, 6, 5000}, {.max_speed = INFINITY});
    EXPECT_GT(length(bodies.slots[0].velocity), 100);
    const std::uint64_t before = hash_bodies(bodies);
    EXPECT_EQ(blast_push(world, bodies, {{0, 0, 1}, kNone, 5000}).reached, 0u);
    EXPECT_EQ(blast_push(world, bodies, {{0, 0, 1}, 6, 5000}, {.max_speed = kNone}).reached, 0u);
    EXPECT_EQ(hash_bodies(bodies), before);
}

}  // namespace
}  // namespace firma
