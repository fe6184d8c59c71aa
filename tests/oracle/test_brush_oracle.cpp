// SPDX-License-Identifier: MIT
// The oracle of joined volumes, on bodies whose volume is known.
#include <gtest/gtest.h>

#include "tests/reference/brush_oracle.h"

namespace firma {
namespace {

using reference::BrushBody;
using reference::half_space;
using reference::joined_volume;
using reference::LongReal;
using reference::Rational;

/// Input steps.
BrushBody box(const InputPoint& low, const InputPoint& high) {
    BrushBody body;
    for (int axis = 0; axis < 3; ++axis) {
        InputPoint u{0, 0, 0}, v{0, 0, 0};
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        const auto plane = [&](const InputPoint& at, const InputPoint& a, const InputPoint& b) {
            return half_space(
                plane_through(at, {at.x + a.x, at.y + a.y, at.z + a.z}, {at.x + b.x, at.y + b.y, at.z + b.z}));
        };
        body.push_back(plane(high, u, v));
        body.push_back(plane(low, v, u));
    }
    return body;
}

TEST(BrushOracle, BoxesThatOverlapCountOnce) {
    const std::vector<BrushBody> apart{box({0, 0, 0}, {10, 10, 10}), box({20, 0, 0}, {30, 10, 10})};
    EXPECT_EQ(joined_volume(apart), 2000);
    const std::vector<BrushBody> in_each_other{box({0, 0, 0}, {10, 10, 10}), box({5, 5, 5}, {15, 15, 15}),
                                               box({2, 2, 2}, {4, 4, 4})};
    EXPECT_EQ(joined_volume(in_each_other), 1875);
    const std::vector<BrushBody> touching{box({0, 0, 0}, {10, 10, 10}), box({10, 0, 0}, {20, 10, 10}),
                                          box({0, 0, 0}, {10, 10, 10})};
    EXPECT_EQ(joined_volume(touching), 2000);
    EXPECT_EQ(joined_volume({}), 0);
}

TEST(BrushOracle, CutsAtTiltedPlanesAreExact) {
    // x / 3 + y / 5 + z / 7 <= 1 in the corner of a box: a tetrahedron of 3 * 5 * 7 / 6, a box of 2 inside it or out.
    BrushBody corner = box({0, 0, 0}, {100, 100, 100});
    corner.push_back(half_space(plane_through({3, 0, 0}, {0, 5, 0}, {0, 0, 7})));
    const LongReal off = abs(joined_volume(std::vector<BrushBody>{corner}) - LongReal(105) / 6);
    EXPECT_LT(off, LongReal("1e-90"));
    // What of the unit cube at (1, 1, 1) sticks out: beyond x / 3 + y / 5 + z / 7 = 1.
    const LongReal both = joined_volume(std::vector<BrushBody>{corner, box({0, 0, 0}, {1, 1, 1})});
    EXPECT_LT(abs(both - LongReal(105) / 6), LongReal("1e-90"));
    EXPECT_GT(joined_volume(std::vector<BrushBody>{corner, box({1, 1, 1}, {2, 2, 2})}), LongReal(105) / 6);
}

TEST(BrushOracle, SidesOfPoints) {
    const std::vector<BrushBody> brushes{box({0, 0, 0}, {10, 10, 10})};
    const auto side = [&](int x) {
        const Rational at[3] = {Rational(x) / 3, 5, 5};
        return reference::side_of_brushes(brushes, at);
    };
    EXPECT_EQ(side(29), 1);
    EXPECT_EQ(side(30), 0);
    EXPECT_EQ(side(31), -1);
}

TEST(BrushOracle, TellsHowFarPlanesWereMoved) {
    const BrushBody once = box({0, 0, 0}, {10, 10, 10}), now = box({0, 0, 0}, {10, 13, 10});
    EXPECT_EQ(reference::farthest_moved(now, once), 3);
    EXPECT_EQ(reference::farthest_moved(once, once), 0);
}

}  // namespace
}  // namespace firma
