// SPDX-License-Identifier: MIT
// Faces as triangles: all of them, none without area, the same however faces are kept.
#include "firma/triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "geometry/triangulate_convex.h"
#include "scenes/divided_building.h"
#include "scenes/rng.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

/// A convex polygon with corners along its sides: a triangle or more, in a plane of slope, each side divided.
std::vector<GridPoint> notched(scenes::Rng& rng) {
    static const std::vector<std::vector<std::array<int, 2>>> shapes{{{0, 0}, {60, 0}, {0, 60}},
                                                                     {{0, 0}, {60, 0}, {60, 60}, {0, 60}},
                                                                     {{0, 0}, {60, 0}, {120, 60}, {60, 120}, {0, 60}}};
    const auto& shape = shapes[rng.below(std::uint32_t(shapes.size()))];
    const int sx = int(rng.below(5)) - 2, sy = int(rng.below(5)) - 2;
    std::vector<GridPoint> corners;
    const auto put = [&](int x, int y) { corners.push_back({x, y, sx * x + sy * y}); };
    for (std::size_t k = 0; k < shape.size(); ++k) {
        const auto &a = shape[k], &b = shape[(k + 1) % shape.size()];
        put(a[0], a[1]);
        const int parts = 1 + int(rng.below(4));  // 60 is divided by 1, 2, 3, 4 without a rest
        for (int p = 1; p < parts; ++p) put(a[0] + (b[0] - a[0]) * p / parts, a[1] + (b[1] - a[1]) * p / parts);
    }
    std::rotate(corners.begin(), corners.begin() + rng.below(std::uint32_t(corners.size())), corners.end());
    return corners;
}

std::int64_t twice_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (std::int64_t(b.x) - a.x) * (std::int64_t(c.y) - a.y) -
           (std::int64_t(b.y) - a.y) * (std::int64_t(c.x) - a.x);
}

TEST(TriangulateConvex, EveryTriangleHasAreaAndTogetherTheyAreThePolygon) {
    scenes::Rng rng(1);
    for (int k = 0; k < 3000; ++k) {
        const std::vector<GridPoint> corners = notched(rng);
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangulate_convex(corners, triangles);
        ASSERT_EQ(triangles.size(), corners.size() - 2);
        std::int64_t sum = 0, whole = 0;
        std::multiset<std::array<std::uint32_t, 2>> sides;
        for (const auto& [a, b, c] : triangles) {
            const std::int64_t area = twice_area(corners[a], corners[b], corners[c]);
            ASSERT_GT(area, 0);
            sum += area;
            for (const auto& side : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) sides.insert(side);
        }
        for (std::size_t c = 1; c + 1 < corners.size(); ++c)
            whole += twice_area(corners[0], corners[c], corners[c + 1]);
        ASSERT_EQ(sum, whole);
        for (std::uint32_t c = 0; c < corners.size(); ++c)
            ASSERT_EQ(sides.count({c, (c + 1) % std::uint32_t(corners.size())}), 1u) << "no corner is left out";
    }
    std::vector<std::array<std::uint32_t, 3>> none;
    triangulate_convex(std::vector<GridPoint>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, none);
    triangulate_convex(std::vector<GridPoint>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, none);
    EXPECT_TRUE(none.empty());
}

World carved_building() {
    World world =
        assemble_world(scenes::DividedBuilding({.rooms_x = 3, .rooms_y = 3, .closed = 0.3, .seed = 2}).parts()).value();
    for (int k = 0; k < 12; ++k) {
        const Hit hit = cast(world, Ray{{2.0 + k, 2.0 + 0.7 * k, 1.5}, {0, 0, -9}});
        if (!hit) continue;
        world = carve(world, make_crater(CutterShape::kRocky, std::uint64_t(k)), {.position = hit.point}).world;
    }
    return world;
}

void expect_all_of(const TriangleMesh& made, const std::vector<Face>& faces) {
    ASSERT_EQ(made.sources.size(), faces.size());
    ASSERT_EQ(made.positions.size(), made.normals.size());
    ASSERT_EQ(made.corners.size(), made.faces.size());
    std::map<FaceId, const Face*> by_id;
    for (const Face& face : faces) by_id[face.id] = &face;
    std::size_t triangles = 0, vertices = 0;
    for (std::size_t k = 0; k < made.sources.size(); ++k) {
        const TriangleMesh::Source& source = made.sources[k];
        const Face& face = *by_id.at(source.face);
        EXPECT_EQ(source.room, face.room);
        EXPECT_EQ(source.source, face.source);
        EXPECT_EQ(source.source_edit, face.source_edit);
        EXPECT_EQ(source.material, face.material);
        EXPECT_EQ(source.first_triangle, triangles);
        EXPECT_EQ(source.first_vertex, vertices);
        EXPECT_EQ(source.vertex_count, face.corners.size());
        EXPECT_EQ(source.triangle_count, face.corners.size() - 2);
        if (k > 0) {
            const TriangleMesh::Source& before = made.sources[k - 1];
            EXPECT_LT(std::pair(before.material, before.face), std::pair(source.material, source.face));
        }
        for (std::uint32_t t = 0; t < source.triangle_count; ++t) {
            EXPECT_EQ(made.faces[triangles + t], face.id);
            for (const std::uint32_t corner : made.corners[triangles + t]) {
                EXPECT_GE(corner, source.first_vertex);
                EXPECT_LT(corner, source.first_vertex + source.vertex_count);
            }
        }
        triangles += source.triangle_count;
        vertices += source.vertex_count;
    }
    EXPECT_EQ(triangles, made.corners.size());
    EXPECT_EQ(vertices, made.positions.size());
    std::size_t in_runs = 0;
    for (const TriangleMesh::Run& run : made.runs) {
        EXPECT_EQ(run.first_triangle, in_runs);
        in_runs += run.triangle_count;
        for (std::uint32_t t = 0; t < run.triangle_count; ++t)
            for (const std::uint32_t corner : made.corners[run.first_triangle + t]) {
                EXPECT_GE(corner, run.first_vertex);
                EXPECT_LT(corner, run.first_vertex + run.vertex_count);
            }
    }
    EXPECT_EQ(in_runs, made.corners.size());
}

TEST(Triangles, OfAWorldARoomARegion) {
    const World world = carved_building();
    ASSERT_GT(world.solid().edits(), 5u);
    const std::vector<Face> faces = world.faces();
    const TriangleMesh all = triangles_of(world);
    expect_all_of(all, faces);
    EXPECT_GT(all.runs.size(), 1u);

    std::size_t in_rooms = 0;
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        std::vector<Face> own;
        const RoomId now = room_info(world, {room})->merged_into;
        for (const Face& face : faces)
            if (face.room == now) own.push_back(face);
        expect_all_of(triangles_of(world, RoomId{room}), own);
        in_rooms += now == RoomId{room} ? own.size() : 0;
    }
    EXPECT_EQ(in_rooms, faces.size());
    EXPECT_TRUE(triangles_of(world, RoomId{1000}).corners.empty());

    std::size_t in_regions = 0;
    for (const RegionHash& region : hash_regions(world))
        in_regions += triangles_of(world, region.region).sources.size();
    EXPECT_EQ(in_regions, faces.size());

    // Area by triangles, in double, is that of the faces.
    double area = 0;
    for (const auto& [a, b, c] : all.corners) {
        const auto at = [&](std::uint32_t k) {
            const auto& p = all.positions[k];
            return Vec3{double(p[0]), double(p[1]), double(p[2])};
        };
        const double own = length(cross(at(b) - at(a), at(c) - at(a))) / 2;
        area += own;
    }
    EXPECT_NEAR(area, measure_solid(world).area, 1e-3 * area);
}

TEST(Triangles, DoNotDependOnTheIndexAndKeepToTheOptions) {
    const World world = carved_building();
    const TriangleMesh one = triangles_of(world);
    const TriangleMesh two = triangles_of(rebuild_index(world, {.split = Split::kSurfaceArea, .faces_per_leaf = 1}));
    EXPECT_EQ(one.positions, two.positions);
    EXPECT_EQ(one.corners, two.corners);
    EXPECT_EQ(one.faces, two.faces);
    const TriangleMesh moved = triangles_of(world, {.origin = {1, 2, 3}});
    ASSERT_EQ(moved.positions.size(), one.positions.size());
    EXPECT_NEAR(moved.positions[0][1], one.positions[0][1] - 2, 1e-5);
    EXPECT_TRUE(triangles_of(world, {.origin = {NAN, 0, 0}}).corners.empty());
    EXPECT_TRUE(triangles_of(world, {.mask = 0}).corners.empty());
    EXPECT_LE(triangles_of(world, {.castable_only = false}).corners.size(), one.corners.size());
}

}  // namespace
}  // namespace firma
