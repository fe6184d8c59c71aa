// SPDX-License-Identifier: MIT
// Which faces a ray need not look at: none that it meets.
#include "carve/exact_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

struct RayCounts {
    int near = 0, far = 0, met = 0;
};

/// Triangles of small corners, so that rays meet corners and edges too.
RayCounts judge_rays(std::uint64_t seed, int reach) {
    scenes::Rng rng(seed);
    const auto number = [&] { return int(rng.below(std::uint32_t(2 * reach + 1))) - reach; };
    const auto point = [&] {
        const int x = number(), y = number(), z = number();
        return InputPoint{x, y, z};
    };
    RayCounts counts;
    for (int k = 0; k < 2000; ++k) {
        const std::array<InputPoint, 3> corners{point(), point(), point()};
        const Plane face = plane_through(corners[0], corners[1], corners[2]);
        if (!face.valid()) continue;
        std::array<ExactPoint, 3> points;
        std::array<Plane, 3> across;
        std::vector<ExactRay::Edge> edges;
        Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
        for (std::size_t c = 0; c < 3; ++c) {
            points[c] = ExactPoint(corners[c]);
            across[c] = edge_plane(corners[c], corners[(c + 1) % 3], face);
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], points[c].approximate()[axis]);
                high[axis] = std::max(high[axis], points[c].approximate()[axis]);
            }
        }
        for (std::size_t c = 0; c < 3; ++c) edges.push_back({&points[c], &points[(c + 1) % 3], &across[c]});
        const ExactRay ray(ExactPoint(point()), int(rng.below(ExactRay::kWays)));
        const ExactRay::Crossing crossing = ray.meet(face, edges, 1e18);
        const bool may_meet = ray.may_meet(low, high);
        (may_meet ? counts.near : counts.far) += 1;
        // A line in the face's plane is unsure however far it runs from the face.
        if (crossing != ExactRay::Crossing::kCrosses && crossing != ExactRay::Crossing::kOn) continue;
        ++counts.met;
        EXPECT_TRUE(may_meet);
    }
    return counts;
}

TEST(ExactRay, FacesThatItMayMeet) {
    for (const int reach : {3, 40, 30'000'000}) {
        const RayCounts counts = judge_rays(std::uint64_t(reach), reach);
        EXPECT_GT(counts.near, 100) << reach;
        EXPECT_GT(counts.far, 100) << reach;
        EXPECT_GT(counts.met, 50) << reach;
    }
}

}  // namespace
}  // namespace firma
