// SPDX-License-Identifier: MIT
// What sleeps on a face wakes when that is no more there, whatever has its id then.
#include <gtest/gtest.h>

#include "firma/carve.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

World with_pit(const World& world, double x, double y, double half) {
    const CarveResult cut =
        carve(world, test::box_mesh({x - half, y - half, -2}, {x + half, y + half, 1}).cutter().value(), {});
    EXPECT_TRUE(cut.done());
    return cut.world;
}

/// Between two steps an edit is undone and another made: the numbers of its faces begin where those of the other did.
TEST(Waking, AnotherEditInPlaceOfOneThatWasUndone) {
    const World ground = test::ground();
    for (int k = 0; k < 24; ++k) {
        // On each side of a pit, and under it another.
        const double x = 6.0 * (k % 6) - 15, y = 6.0 * (k / 6) - 9;
        const World first = with_pit(ground, 1, 2, 1);
        if (std::abs(x - 1) < 2 && std::abs(y - 2) < 2) continue;
        Bodies bodies;
        const BodyId id = add_body(bodies, test::body_here(test::ball(0.25), {x, y, 0.25}));
        test::run(bodies, first, 90);
        ASSERT_TRUE(bodies.find(id)->asleep);
        const World second = with_pit(ground, x, y, 1);
        test::run(bodies, second, 30);
        EXPECT_LT(bodies.find(id)->position.z, -0.5) << k;
        // What the other edit leaves in place lets it sleep on or wake: it stays where it is.
        Bodies others;
        const BodyId other = add_body(others, test::body_here(test::ball(0.25), {x, y, 0.25}));
        test::run(others, first, 90);
        test::run(others, with_pit(ground, x + 3, y, 1), 30);
        EXPECT_NEAR(others.find(other)->position.z, 0.25, 2e-3) << k;
    }
}

}  // namespace
}  // namespace firma
