// SPDX-License-Identifier: MIT
// A cut that touches goes in steps all the way: none of them does more than a small part of a large cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "carve/cut_job.h"
#include "firma/solid.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

/// Thin walls side by side along an axis, half a metre each, a metre of air between; they do not touch.
Solid walls(int axis, int count) {
    Solid solid;
    const Cutter box = make_crater(CutterShape::kBox, 0);
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
    for (int k = 0; k < count; ++k) {
        const auto first = std::uint32_t(vertices.size());
        for (const Vec3& vertex : box.vertices()) {
            Vec3 at{vertex.x * count, vertex.y * count, vertex.z};
            at[axis] = vertex[axis] * 0.25 + 1.5 * (k - count / 2);
            vertices.push_back(at);
        }
        for (CutterTriangle triangle : box.triangles()) {
            for (std::uint32_t& corner : triangle) corner += first;
            triangles.push_back(triangle);
        }
    }
    return unite(solid, make_cutter(vertices, triangles, "walls").value(), Pose()).solid;
}

struct SteppedCut {
    std::size_t count = 0;
    SolidChange change;
    CarveStatus status;
};

SteppedCut cut_in_steps(const Solid& solid, const Cutter& cutter) {
    CutJob job(solid, cutter, Pose(), {}, CarveKind::kCarve);
    SteppedCut steps;
    while (job.step()) ++steps.count;
    steps.status = job.status();
    if (steps.status == CarveStatus::kDone) steps.change = job.take_change();
    return steps;
}

TEST(CutSlices, StepsGrowWithWhatACutMeets) {
    std::size_t before = 0;
    for (const int count : {4, 8, 16}) {
        // Walls across walls, as high: their tops lie in one plane, so that the cut touches.
        const Solid solid = walls(0, count);
        const SteppedCut steps = cut_in_steps(solid, cutter_from_solid(walls(1, count)).value());
        ASSERT_EQ(steps.status, CarveStatus::kDone);
        // Of each wall all sides but the two ends.
        EXPECT_EQ(steps.change.removed.size(), std::size_t(4 * count));
        // As many crossings as the square of the walls; each has edges of its own.
        const std::size_t crossings = std::size_t(count) * std::size_t(count);
        EXPECT_GT(steps.count, 3 * crossings);
        EXPECT_GT(steps.count, 3 * before);
        before = steps.count;
    }
}

TEST(CutSlices, ACutInStepsIsTheCutInOneGo) {
    const Solid solid = walls(0, 8);
    const Cutter cutter = cutter_from_solid(walls(1, 8)).value();
    const SolidResult whole = subtract(solid, cutter, Pose());
    ASSERT_TRUE(whole.done());
    const SteppedCut steps = cut_in_steps(solid, cutter);
    EXPECT_EQ(steps.change.added.faces.size(), whole.report.faces_added);
    EXPECT_NEAR(whole.report.volume, 8 * 8 * 0.5 * 0.5 * 2, 1e-9);
    EXPECT_FALSE(check_solid(whole.solid));
}

}  // namespace
}  // namespace firma
