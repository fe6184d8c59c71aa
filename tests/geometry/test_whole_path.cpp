// SPDX-License-Identifier: MIT
// Sides of edges by a path's whole numbers: the signs of exact_edge_side().
#include "geometry/whole_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "cast/sweep.h"
#include "geometry/exact_predicates.h"
#include "scenes/rng.h"
#include "tests/geometry/grid_corners.h"
#include "tests/sample.h"

namespace firma {
namespace {

/// On every n-th step of the surface grid, within so many metres of the origin.
GridPoint random_corner(scenes::Rng& rng, double size, std::int32_t n) {
    const auto at = [&] { return std::int32_t(rng.uniform(-size, size) * kSurfaceSteps) / n * n; };
    GridPoint corner;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = at();
    return corner;
}

Vec3 in_floats(const Vec3& v) {
    return {double(float(v.x)), double(float(v.y)), double(float(v.z))};
}

struct Counts {
    int known = 0, through_edges = 0, through_corners = 0;
};

void compare(const GridPoint (&corners)[3], const Vec3& start, const Vec3& target, Counts& counts) {
    Sweep sweep;
    if (make_sweep({start, 0}, target - start, sweep) != Status::kHit) return;
    const WholePath whole(sweep.start, sweep.direction);
    if (!whole.known()) return;
    ++counts.known;
    int signs[3], zeros = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        signs[k] =
            exact_edge_side(sweep.start, sweep.direction, to_metres(corners[k]), to_metres(corners[(k + 1) % 3]));
        zeros += signs[k] == 0;
    }
    counts.through_edges += zeros == 1;
    counts.through_corners += zeros > 1;
    for (unsigned open = 1; open < 8; ++open) {
        unsigned wanted = 0;
        for (unsigned k = 0; k < 3; ++k)
            if (open >> k & 1) wanted |= signs[k] > 0 ? unsigned(kSomePositive) : signs[k] < 0 ? kSomeNegative : 0u;
        EXPECT_EQ(whole.triangle_sides(GridCorners{corners}, open), wanted) << "edges " << open;
    }
}

TEST(WholePath, TellsTheSidesOfEdges) {
    scenes::Rng rng(7);
    Counts counts;
    for (int k = 0; k < test::sample(20000) && !HasFailure(); ++k) {
        static constexpr double kSizes[] = {0.5, 60, 8191};
        const double size = kSizes[rng.below(3)];
        const std::int32_t n = rng.chance(0.5) ? kSurfacePerInput : 1;
        GridPoint corners[3];
        for (GridPoint& corner : corners) corner = random_corner(rng, size, n);
        Vec3 target = to_metres(corners[rng.below(3)]);
        const std::uint32_t kind = rng.below(4);
        if (kind == 1) {  // in the middle of an edge, mostly exactly
            const Vec3 a = to_metres(corners[0]), b = to_metres(corners[1]);
            target = (a + b) * 0.5;
        } else if (kind == 2) {
            target = to_metres(random_corner(rng, size, n));
        }
        const Vec3 from = rng.chance(0.5) ? to_metres(random_corner(rng, size, n)) : rng.direction() * size;
        const Vec3 start = in_floats(from);
        compare(corners, start, kind == 3 ? start + in_floats(target - start) : target, counts);
    }
    EXPECT_GT(counts.known, test::sample(20000) / 2);
    EXPECT_GT(counts.through_edges, counts.known / 50);
    EXPECT_GT(counts.through_corners, counts.known / 50);
}

/// The farthest corners, the longest edges: nothing runs over.
TEST(WholePath, HoldsTheLargestNumbers) {
    Counts counts;
    const std::int32_t rim = INT32_MAX;
    for (unsigned signs = 0; signs < 512; ++signs) {
        GridPoint corners[3];
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                corners[c][axis] = signs >> (3 * c + axis) & 1 ? rim - 3 * c - axis : -rim + 2 * c + 5 * axis;
        for (const double far : {0x1p14, -0x1p14, 0x1p14 - 0x1p-30}) {
            const Vec3 start{far, -far, 0x1p14 - 0x1p-30};
            compare(corners, start, start + Vec3{2 - 0x1p-38, -2 + 0x1p-38, 1 + 0x1p-38}, counts);
            compare(corners, start, start + Vec3{0x1p-38, -2 + 0x1p-38, 2 - 0x1p-38}, counts);
        }
    }
    EXPECT_EQ(counts.known, 512 * 6);
}

TEST(WholePath, DoesNotKnowOthers) {
    const auto known = [](const Vec3& start, const Vec3& direction) { return WholePath(start, direction).known(); };
    EXPECT_TRUE(known({1, 2, 3}, {1, 0.5, 0}));
    EXPECT_FALSE(known({0.1, 2, 3}, {1, 0.5, 0}));
    EXPECT_FALSE(known({1, 2, 3}, {1, 0.1, 0}));
    EXPECT_FALSE(known({0x1p15, 2, 3}, {1, 0.5, 0}));
    EXPECT_FALSE(known({1, 2, 3}, {1, 0x1p-200, 0}));
}

}  // namespace
}  // namespace firma
