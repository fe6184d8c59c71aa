// SPDX-License-Identifier: MIT
// What is light between the level and something heavy: it hands on what it is pushed with, and all comes to rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using scenes::Rng;
using test::body_here;
using test::box_body;
using test::ground;
using test::run;

/// Spheres of 3 cm in a row.
BodyShape splinter(double length) {
    SphereSet spheres;
    for (double x = -length / 2 + 0.03; x < length / 2; x += 0.05) spheres.push_back({{x, 0, 0}, 0.03});
    return make_body_shape(spheres, mass_of_box({length / 2, 0.03, 0.03}, 600)).value();
}

/// Some hundred times as heavy as a splinter.
BodyShape rock(Rng& rng) {
    SphereSet spheres{{{0, 0, 0}, 0.25}};
    for (int k = 0; k < 8; ++k) spheres.push_back({test::random_vector(rng, 0.2, 0.3), rng.uniform(0.05, 0.15)});
    return make_body_shape(spheres, mass_of_ball(0.4, 2400)).value();
}

struct Pile {
    World world = ground();
    Bodies bodies;
    std::size_t splinters = 0;
};

/// Rocks thrown down on splinters that lie on the ground.
Pile pile_of(std::uint64_t seed) {
    Rng rng(seed);
    Pile pile;
    for (int k = 0; k < 12; ++k) {
        const Vec3 at{rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8), 0.031 + 0.061 * k};
        Body body = body_here(splinter(rng.uniform(0.4, 1.2)), at);
        const double angle = rng.uniform(-1.5, 1.5);
        body.rotation = turn_by({0, 0, angle});
        body.rolling = 0.3;
        add_body(pile.bodies, body);
    }
    run(pile.bodies, pile.world, 60);
    pile.splinters = pile.bodies.slots.size();
    for (int k = 0; k < 6; ++k) {
        Body body = body_here(rock(rng), {rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8), 1.5 + 1.2 * k});
        body.velocity = {0, 0, -6};
        body.spin = test::random_vector(rng, 0, 6);
        body.rolling = 0.1;
        add_body(pile.bodies, body);
    }
    return pile;
}

/// Frames in a row in which it has a velocity and goes nowhere.
int frames_held(const Body& before, const Body& now, int frames) {
    const double seconds = 1.0 / 60;
    const bool wants = length(now.velocity) > 0.1, goes = length(now.position - before.position) > 1e-4 * seconds;
    return !now.asleep && wants && !goes ? frames + 1 : 0;
}

TEST(Wedged, RocksOnSplintersAreNotHeldInPlaceAndComeToRest) {
    for (const std::uint64_t seed : {3, 6, 9, 12}) {
        Pile pile = pile_of(seed);
        std::vector<int> held(pile.bodies.slots.size());
        int longest = 0;
        for (int frame = 0; frame < 480; ++frame) {
            const std::vector<Body> before = pile.bodies.slots;
            step(pile.bodies, pile.world, 1.0 / 60);
            for (std::size_t slot = pile.splinters; slot < held.size(); ++slot) {
                held[slot] = frames_held(before[slot], pile.bodies.slots[slot], held[slot]);
                longest = std::max(longest, held[slot]);
            }
        }
        std::size_t awake = 0;
        for (const Body& body : pile.bodies.slots) awake += !body.asleep;
        EXPECT_LT(longest, 10) << seed;
        EXPECT_EQ(awake, 0u) << seed;
    }
}

}  // namespace
}  // namespace firma
