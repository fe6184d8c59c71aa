// SPDX-License-Identifier: MIT
// Segment against box: never misses one that is met, seldom takes one that is not.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/polygon.h"
#include "scenes/rng.h"

namespace firma {
namespace {

/// The oracle: clip the parameter range by each axis in long double, with slack to either side.
bool meets(const Vec3& start, const Vec3& path, const Box& box, long double slack) {
    long double from = 0, to = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const long double low = box.low[axis] - slack - start[axis], high = box.high[axis] + slack - start[axis];
        const long double d = path[axis];
        if (d == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const long double a = low / d, b = high / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

TEST(ClipSegmentBox, AgreesWithClippingByAxes) {
    scenes::Rng rng(21);
    int met = 0, missed = 0;
    for (int k = 0; k < 200000; ++k) {
        const auto number = [&](double size) {
            return rng.chance(0.3) ? std::floor(rng.uniform(-4, 5)) : rng.uniform(-size, size);
        };
        const auto point = [&](double size) {
            const double x = number(size), y = number(size), z = number(size);
            return Vec3{x, y, z};
        };
        Box box;
        box.add(point(3));
        box.add(point(3));
        const Vec3 start = point(6);
        Vec3 path = point(10);
        if (rng.chance(0.2)) path[int(rng.below(3))] = 0;
        const bool answer = clip_segment_box(start, path, box);
        if (meets(start, path, box, 0)) {
            ASSERT_TRUE(answer);
        }
        if (!meets(start, path, box, 1e-12L)) {
            ASSERT_FALSE(answer);
        }
        (answer ? met : missed)++;
    }
    EXPECT_GT(met, 5000);
    EXPECT_GT(missed, 20000);
}

TEST(ClipSegmentBox, AwkwardOnes) {
    Box box;
    EXPECT_FALSE(clip_segment_box({0, 0, 0}, {1, 0, 0}, box)) << "an empty box";
    box.add(Vec3{0, 0, 0});
    EXPECT_TRUE(clip_segment_box({-1, 0, 0}, {2, 0, 0}, box)) << "a box that is a point";
    EXPECT_TRUE(clip_segment_box({0, 0, 0}, {0, 0, 0}, box)) << "a path that is a point in it";
    EXPECT_FALSE(clip_segment_box({1, 0, 0}, {0, 0, 0}, box)) << "a path that is a point beside it";
    box.add(Vec3{1, 1, 1});
    EXPECT_TRUE(clip_segment_box({-1, 1, 1}, {3, 0, 0}, box)) << "along its edge";
    EXPECT_TRUE(clip_segment_box({-1, 0, -1}, {2, 2, 2}, box)) << "through the middle of an edge";
    EXPECT_TRUE(clip_segment_box({-1, 2, 0.5}, {1, -1, 0}, box)) << "ends on a corner's edge";
}

}  // namespace
}  // namespace firma
