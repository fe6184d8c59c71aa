// SPDX-License-Identifier: MIT
// Polygons trimmed by several cutters at once, each of which may take of some: judged by samples.
#include "carve/trim_polygons.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "carve/place_solid.h"
#include "firma/level.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/carve/winding.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using Corners = std::vector<Vec3>;

/// Whether a point of its plane lies within a convex polygon.
bool holds(const Corners& polygon, const Vec3& normal, const Vec3& p) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[k], &b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        if (dot(cross(b - a, p - a), normal) < 0) return false;
    }
    return true;
}

TEST(TrimPolygons, ByCuttersThatOverlapAndTakeOfSome) {
    scenes::Rng rng(17);
    std::size_t in = 0, out = 0, shielded = 0;
    for (int round = 0; round < test::sample(40); ++round) {
        Level level = test::empty_level();
        std::vector<std::array<Vec3, 3>> triangles(12);
        for (std::array<Vec3, 3>& triangle : triangles) {
            Vec3 middle;
            for (int axis = 0; axis < 3; ++axis) middle[axis] = rng.uniform(-1.5, 1.5);
            for (Vec3& corner : triangle) corner = to_metres(snap(middle + rng.direction() * 2).value());
            test::add_polygon(level, {triangle.begin(), triangle.end()});
        }
        const World world = make_world(level).value();
        std::vector<FacetPlace> facets;
        for_each_block(*world.data().castable.root, [&](const Block& block) {
            for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) facets.push_back({&block, slot});
        });
        const std::size_t count = 1 + rng.next() % 5;
        std::vector<CutterSolid> cutters(count);
        std::vector<test::PlacedWinding> windings;
        std::vector<Trim> trims;
        std::vector<std::vector<bool>> takes(count, std::vector<bool>(facets.size()));
        for (std::size_t k = 0; k < count; ++k) {
            const Cutter cutter = make_crater(k % 2 ? CutterShape::kRocky : CutterShape::kWedge, 1 + rng.next() % 9);
            Pose pose =
                test::pose_at(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.5, 1.5));
            pose.rotation = random_turn(rng.next());
            ASSERT_FALSE(place_any_cutter(cutter, pose, cutters[k]));
            windings.emplace_back(cutter, pose);
            trims.push_back({&cutters[k], {}});
            for (std::uint32_t facet = 0; facet < facets.size(); ++facet)
                if (rng.next() % 2) {
                    takes[k][facet] = true;
                    trims.back().facets.push_back(facet);
                }
        }
        PolygonTrimmer trimmer(facets, trims, 1'000'000);
        PolygonTrimmer::End end;
        while ((end = trimmer.step()) == PolygonTrimmer::End::kGoesOn) {
        }
        ASSERT_EQ(end, PolygonTrimmer::End::kDone);
        for (std::uint32_t facet = 0; facet < facets.size(); ++facet) {
            const auto& [a, b, c] = triangles[facets[facet].record().source];
            const Vec3 normal = cross(b - a, c - a);
            FaceSet left;
            if (trimmer.fate(facet) != PolygonTrimmer::Fate::kGoes) trimmer.append_left(facet, left);
            std::vector<Corners> polygons;
            for (const FaceSet::Entry& face : left.faces) {
                polygons.emplace_back();
                for (std::size_t k = 0; k < face.corner_count; ++k)
                    polygons.back().push_back(to_metres(left.corner(face, k)));
            }
            for (int sample = 0; sample < 50; ++sample) {
                double u = rng.uniform(0, 1), v = rng.uniform(0, 1);
                if (u + v > 1) u = 1 - u, v = 1 - v;
                const Vec3 p = a + (b - a) * u + (c - a) * v;
                bool taken = false, clear = true, spared = false;
                for (std::size_t k = 0; k < count; ++k) {
                    const bool held = windings[k].holds(p);
                    spared |= held && !takes[k][facet];
                    taken |= held && takes[k][facet];
                    clear &= windings[k].is_clear(p, 1e-4);
                }
                if (!clear) continue;
                std::size_t around = 0;
                for (const Corners& polygon : polygons) around += holds(polygon, normal, p);
                EXPECT_EQ(around, taken ? 0u : 1u) << "round " << round << " facet " << facet;
                ++(taken ? in : out);
                shielded += spared && !taken;
            }
        }
    }
    EXPECT_GT(in, std::size_t(test::sample(500)));
    EXPECT_GT(out, std::size_t(test::sample(500)));
    EXPECT_GT(shielded, std::size_t(test::sample(50)));
}

}  // namespace
}  // namespace firma
