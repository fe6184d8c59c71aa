// SPDX-License-Identifier: MIT
// Cutters thinner than the surface grid: what they leave is closed, and a point beside it is not taken to be in it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "cast/side_met.h"
#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using namespace test;

Vec3 random_steps(scenes::Rng& rng, int most) {
    const auto steps = [&] { return (int(rng.below(2 * std::uint32_t(most) + 1)) - most) / kInputSteps; };
    const double x = steps(), y = steps(), z = steps();
    return {x, y, z};
}

/// A prism over a triangle with one short side, half a metre to two long; nothing where it is flat.
std::optional<Cutter> needle(scenes::Rng& rng) {
    const Vec3 at = random_steps(rng, 4096), way = random_steps(rng, 8192);
    const std::array<Vec3, 3> base{at, at + random_steps(rng, 1), at + random_steps(rng, 128)};
    TriangleMesh mesh;
    for (const Vec3& corner : base) mesh.vertices.push_back(corner);
    for (const Vec3& corner : base) mesh.vertices.push_back(corner + way);
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    const double volume = dot(cross(base[1] - base[0], base[2] - base[0]), way);
    if (volume == 0) return std::nullopt;
    if (volume < 0) mesh.turn_over();
    return mesh.cutter().value();
}

/// A block with slopes.
Solid sloped_block(scenes::Rng& rng) {
    Level level = box_level({-1, -1, -1}, {1, 1, 1});
    const Solid block = make_solid(level).value();
    TriangleMesh slope;
    slope.vertices = {random_steps(rng, 8192), random_steps(rng, 8192), random_steps(rng, 8192), {0.01, 0.02, -3}};
    slope.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const Vec3 &a = slope.vertices[0], &b = slope.vertices[1], &c = slope.vertices[2], &d = slope.vertices[3];
    if (dot(cross(b - a, c - a), d - a) > 0) slope.turn_over();
    const Result<Cutter> cutter = slope.cutter();
    return cutter ? subtract(block, cutter.value(), Pose()).solid : block;
}

TEST(NeedleCutters, LeaveSolidsClosed) {
    scenes::Rng rng(77);
    int cut = 0;
    for (int k = 0; k < sample(1500); ++k) {
        const Solid before = sloped_block(rng);
        const std::optional<Cutter> cutter = needle(rng);
        if (!cutter) continue;
        for (const bool fill : {false, true}) {
            const SolidResult made = fill ? unite(before, *cutter, Pose()) : subtract(before, *cutter, Pose());
            ASSERT_NE(made.status, CarveStatus::kRefused) << k << made.error.text();
            if (!made.done()) continue;
            ++cut;
            const auto fault = check_solid(made.solid);
            ASSERT_FALSE(fault) << k << (fill ? " filled: " : " carved: ") << fault->what;
        }
    }
    EXPECT_GT(cut, sample(1000));
}

/// locate() asks rays: this is the way of the first one, so that it passes a needle whose corners are rounded.
TEST(NeedleCutters, APointBesideOneIsInTheAir) {
    scenes::Rng rng(78);
    int asked = 0;
    for (int k = 0; k < sample(3000); ++k) {
        const std::optional<Cutter> cutter = needle(rng);
        if (!cutter) continue;
        const SolidResult made = unite(sloped_block(rng), *cutter, Pose());
        if (!made.done()) continue;
        const auto v = cutter->vertices();
        const Vec3 normal = cross(v[2] - v[0], v[3] - v[0]);
        if (std::fabs(dot(normal, kRayWays[0])) < 0.05 * length(normal)) continue;  // such a point may lie in it
        for (int tries = 0; tries < 20; ++tries) {
            const Vec3 across = v[2] + (v[tries % 2 == 0 ? 0 : 1] - v[2]) * rng.uniform();
            const Vec3 inside = across + (v[3] - v[0]) * rng.uniform();
            const Vec3 point = inside - kRayWays[0] * rng.uniform(0.1, 0.2);
            if (std::fmax(std::fmax(std::fabs(point.x), std::fabs(point.y)), std::fabs(point.z)) < 1) continue;
            ++asked;
            ASSERT_NE(locate(made.solid, point), Where::kSolid) << k << " " << tries;
        }
    }
    EXPECT_GT(asked, sample(10000));
}

}  // namespace
}  // namespace firma
