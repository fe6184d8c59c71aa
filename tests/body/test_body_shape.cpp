// SPDX-License-Identifier: MIT
// Shapes of bodies: principal axes, mass, where they are put.
#include <gtest/gtest.h>

#include <cmath>

#include "body/principal_axes.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"

namespace firma {
namespace {

using test::box_body;

/// The tensor of these moments about axes that are turned.
std::array<Vec3, 3> turned_tensor(const Vec3& moments, const Quaternion& turn) {
    const TurnMatrix axes = matrix_of(turn);
    std::array<Vec3, 3> tensor{};
    for (std::size_t i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) tensor[i][j] += moments[k] * axes.rows[i][k] * axes.rows[j][k];
    return tensor;
}

TEST(BodyShape, PrincipalAxesAreThoseOfTheTensor) {
    scenes::Rng rng(1);
    for (int k = 0; k < 2000; ++k) {
        Vec3 moments{rng.uniform(1, 3), rng.uniform(1, 3), rng.uniform(1, 3)};
        if (k % 3 == 0) moments.y = moments.x;
        const std::array<Vec3, 3> tensor = turned_tensor(moments, random_turn(rng.next()));
        const PrincipalAxes axes = principal_axes(tensor);
        EXPECT_GE(axes.moments.x, axes.moments.y);
        EXPECT_GE(axes.moments.y, axes.moments.z);
        const std::array<Vec3, 3> again = turned_tensor(axes.moments, axes.rotation);
        for (std::size_t row = 0; row < 3; ++row) EXPECT_LT(length(again[row] - tensor[row]), 1e-14);
    }
    const PrincipalAxes plain = principal_axes({Vec3{1, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 3}});
    EXPECT_EQ(plain.moments, (Vec3{3, 2, 1}));
}

TEST(BodyShape, MassOfABoxIsThatOfItsSolid) {
    const World world = test::brush_world(map_text::box({-2, -1, -3}, {2, 1, 3}, "rock"));
    const MassProperties solid = mass_properties(world.solid(), 500), box = mass_of_box({2, 1, 3}, 500);
    EXPECT_DOUBLE_EQ(box.mass, solid.mass);
    for (std::size_t row = 0; row < 3; ++row) EXPECT_LT(length(box.inertia[row] - solid.inertia[row]), 1e-9);
}

TEST(BodyShape, IsWhereItsFrameIsPut) {
    MassProperties mass = mass_of_box({0.5, 0.25, 0.125}, 1000);
    mass.centre = {1, 2, 3};
    const Sphere sphere{{1.25, 2, 3}, 0.1};
    const BodyShape shape = make_body_shape({&sphere, 1}, mass).value();
    EXPECT_EQ(shape.centre(), mass.centre);
    EXPECT_NEAR(shape.reach(), 0.35, 1e-15);
    scenes::Rng rng(2);
    for (int k = 0; k < 100; ++k) {
        Pose pose;
        pose.position = rng.direction() * 10;
        pose.rotation = random_turn(rng.next());
        const Body body = body_at(shape, pose);
        EXPECT_LT(length(body.position - (pose.position + matrix_of(pose.rotation) * mass.centre)), 1e-14);
        const Pose again = pose_of(body);
        EXPECT_LT(length(again.position - pose.position), 1e-14);
    }
}

TEST(BodyShape, WhatCannotBeABodyIsSaid) {
    const MassProperties mass = mass_of_ball(1, 1000);
    const auto reason = [&](SphereSet spheres, const MassProperties& of) {
        const Result<BodyShape> shape = make_body_shape(spheres, of);
        return shape ? std::string("fine") : shape.error().text();
    };
    EXPECT_EQ(reason({{{0, 0, 0}, 1}}, mass), "fine");
    EXPECT_EQ(reason({}, mass), "a body has 1 to 4096 spheres, not 0");
    EXPECT_EQ(reason({{{0, 0, 0}, 1}, {{0, 0, 0}, 0}}, mass), "sphere 1 is not finite or has no radius");
    EXPECT_EQ(reason({{{NAN, 0, 0}, 1}}, mass), "sphere 0 is not finite or has no radius");
    EXPECT_EQ(reason({{{0, 0, 0}, 1}}, {}), "the mass is not finite or not above zero");
    MassProperties needle = mass;
    needle.inertia[2] = {};
    EXPECT_EQ(reason({{{0, 0, 0}, 1}}, needle), "the inertia is not that of a solid");
}

TEST(Bodies, SlotsAreUsedAgainUnderOtherNames) {
    Bodies bodies;
    const BodyId a = add_body(bodies, test::body_here(test::ball(1), {0, 0, 0}));
    const BodyId b = add_body(bodies, test::body_here(test::ball(1), {5, 0, 0}));
    remove_body(bodies, a);
    EXPECT_EQ(bodies.find(a), nullptr);
    ASSERT_NE(bodies.find(b), nullptr);
    const BodyId c = add_body(bodies, test::body_here(test::ball(2), {9, 0, 0}));
    EXPECT_EQ(c.slot, a.slot);
    EXPECT_FALSE(c == a);
    EXPECT_EQ(bodies.find(a), nullptr);
    EXPECT_EQ(bodies.find(c)->position, (Vec3{9, 0, 0}));
    EXPECT_EQ(bodies.find({77, 1}), nullptr);
    remove_body(bodies, a);
    push_body(bodies, a, {1, 0, 0}, {0, 0, 0});
    wake_body(bodies, a);
    EXPECT_EQ(bodies.slots.size(), 2u);
}

TEST(Bodies, APushBesideTheMiddleTurns) {
    Bodies bodies;
    const BodyId id = add_body(bodies, test::body_here(test::ball(0.5), {0, 0, 0}));
    const double mass = bodies.find(id)->shape.mass();
    push_body(bodies, id, {0, 0, mass}, {0.5, 0, 0});
    EXPECT_NEAR(bodies.find(id)->velocity.z, 1, 1e-15);
    EXPECT_NEAR(bodies.find(id)->spin.y, -0.5 / (0.4 * 0.25), 1e-12);
}

}  // namespace
}  // namespace firma
