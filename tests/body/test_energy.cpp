// SPDX-License-Identifier: MIT
// No step makes energy of nothing, however fast a body turns where it touches.
#include <gtest/gtest.h>

#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using scenes::Rng;
using test::body_here;
using test::ground;

/// Nine balls in a row, 1.4 m long.
BodyShape row_of_balls() {
    SphereSet spheres;
    for (int k = -4; k <= 4; ++k) spheres.push_back({{k * 0.15, 0, 0}, 0.1});
    return make_body_shape(spheres, mass_of_box({0.7, 0.1, 0.1}, 700)).value();
}

double energy_in(const Body& body, const Vec3& gravity) {
    return kinetic_energy(body) - body.shape.mass() * dot(gravity, body.position);
}

/// What a free spin gains and gives back (docs/bodies.md), joules: of the row of balls no more than 0.022 times the
/// square of the angle of a substep, of what turns. One of more than 0.8 radians is divided: no more than 2%.
double gain_of_spin(const Body& body, const StepOptions& options) {
    const double angle = length(body.spin) / options.substeps_a_second;
    const double turns = kinetic_energy(body) - 0.5 * body.shape.mass() * dot(body.velocity, body.velocity);
    return (angle < 0.8 ? 0.022 * angle * angle : 0.02) * turns;
}

TEST(Energy, AFreeSpinGainsNoMoreThanItIsAllowedBelow) {
    const World world = ground();
    StepOptions options;
    options.gravity = {};
    Rng rng(1);
    for (const double speed : {10.0, 50.0, 100.0, 150.0, 200.0, 300.0, 1000.0, 10000.0})
        for (int k = 0; k < 10; ++k) {
            Bodies bodies;
            Body row = body_here(row_of_balls(), {0, 0, 100});
            row.rotation = random_turn(rng.next());
            row.spin = rng.direction() * speed;
            add_body(bodies, row);
            double least = kinetic_energy(row), most = least;
            for (int tick = 0; tick < 240; ++tick) {
                step(bodies, world, 1.0 / 60, options);
                least = std::min(least, kinetic_energy(bodies.slots[0]));
                most = std::max(most, kinetic_energy(bodies.slots[0]));
            }
            EXPECT_LE(most - least, gain_of_spin(row, options)) << speed << " rad/s, " << k;
        }
}

/// Metres: contacts that were pressed in lift what lies on them by as much.
constexpr double kLift = 1e-5;

/// Joules: after no step more than after any step before.
void expect_no_more(const World& world, Body body, int steps) {
    const StepOptions options;
    Bodies bodies;
    const BodyId id = add_body(bodies, body);
    double least = energy_in(body, options.gravity);
    for (int k = 0; k < steps; ++k) {
        step(bodies, world, 1.0 / 60, options);
        const Body& now = *bodies.find(id);
        ASSERT_TRUE(is_finite(now.velocity) && is_finite(now.spin)) << k;
        const double energy = energy_in(now, options.gravity);
        const double lift = kLift * body.shape.mass() * length(options.gravity);
        ASSERT_LE(energy, least + gain_of_spin(now, options) + lift) << k;
        least = std::min(least, energy);
    }
}

TEST(Energy, APlankShotIntoACornerComesToRest) {
    const World world = read_world(FIRMA_ROOT "/levels/first.obj").value();
    Body plank = body_here(row_of_balls(), {40.476567081175245, 23.684715698007494, 2.7595082473625894});
    plank.rotation = {-0.1691905981802302, -0.36818520437511415, -0.5041552189703165, 0.7626543856503177};
    plank.velocity = {83.14271460748401, -147.5755963097422, -81.94584183389412};
    plank.spin = {-0.18003405770286918, -2.1257295296527445, 0.6793823488987982};
    plank.friction = 0.6;
    plank.restitution = 0.1;
    expect_no_more(world, plank, 600);
}

TEST(Energy, PlanksShotIntoTheGround) {
    const World world = ground();
    for (int shot = 0; shot < 40; ++shot) {
        Rng rng{std::uint64_t(shot)};
        Body plank = body_here(row_of_balls(), {0, 0, 1});
        plank.rotation =
            normalised(Quaternion{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
        plank.velocity = {rng.uniform(-100, 100), rng.uniform(-100, 100), rng.uniform(-200, -20)};
        plank.spin = test::random_vector(rng, 0, 200);
        plank.friction = 0.6;
        expect_no_more(world, plank, 120);
    }
}

/// Rows of balls of all lengths, thrown about.
std::vector<BodyId> throw_rows(Bodies& bodies, const World& world, Rng& rng) {
    std::vector<BodyId> thrown;
    for (int k = 0; k < 20; ++k) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = axis == 2 ? rng.uniform(0.5, 6) : rng.uniform(2, 40);
        SphereSet spheres;
        const int count = 2 + int(rng.uniform(0, 8));
        for (int ball = 0; ball < count; ++ball) {
            const double y = rng.uniform(-0.05, 0.05), z = rng.uniform(-0.05, 0.05), radius = rng.uniform(0.04, 0.1);
            spheres.push_back({{(ball - 0.5 * (count - 1)) * 0.12, y, z}, radius});
        }
        Body row = body_here(make_body_shape(spheres, mass_of_box({0.06 * count, 0.1, 0.1}, 700)).value(), at);
        row.velocity = rng.direction();
        row.velocity *= rng.uniform(5, 150);
        row.spin = rng.direction();
        row.spin *= rng.uniform(0, 200);
        row.restitution = 0.1;
        row.friction = 0.6;
        if (locate(world, at).where == Where::kAir) thrown.push_back(add_body(bodies, row));
    }
    return thrown;
}

// One of these comes between two things with no room to move: it fell on and on in its place.
TEST(Energy, WhatHasNoRoomToMoveComesToRest) {
    const World world = test::depot_world();
    std::size_t seen = 0;
    for (const int seed : {8, 19, 31}) {
        Rng rng{std::uint64_t(seed)};
        Bodies bodies;
        const std::vector<BodyId> thrown = throw_rows(bodies, world, rng);
        seen += thrown.size();
        std::vector<Vec3> last(thrown.size());
        std::vector<int> still(thrown.size());
        for (int k = 0; k < 240; ++k) {
            step(bodies, world, 1.0 / 60);
            for (std::size_t one = 0; one < thrown.size(); ++one) {
                const Body& body = *bodies.find(thrown[one]);
                const bool is_fast = length(body.velocity) + length(body.spin) * 0.3 > 5;
                still[one] = is_fast && length(body.position - last[one]) < 1e-5 ? still[one] + 1 : 0;
                last[one] = body.position;
                ASSERT_LT(still[one], 20) << "seed " << seed << " body " << one;
            }
        }
    }
    EXPECT_GT(seen, 20u);
}

}  // namespace
}  // namespace firma
