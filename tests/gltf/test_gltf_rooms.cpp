// SPDX-License-Identifier: MIT
// A mesh divided into rooms by its portals.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cli/write_glb.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

/// A channel like a U, 8 m high and 2 m long, whose largest faces look at each other.
void add_channel(SmallGltf& file, int& corners, int& indices) {
    constexpr int kPoints = 11;
    constexpr float kOutline[kPoints][2] = {{0, 0},     {1.5f, -0.5f}, {3, 0},     {3.5f, 4}, {3, 8},    {2.75f, 8},
                                            {2.75f, 1}, {0.25f, 1},    {0.25f, 8}, {0, 8},    {-0.5f, 4}};
    std::vector<float> points;
    for (const float y : {0.0f, 2.0f})
        for (const auto& [x, z] : kOutline) points.insert(points.end(), {x, y, z});
    std::vector<std::uint8_t> list;
    const auto triangle = [&](int a, int b, int c) {
        for (const int k : {a, b, c}) list.push_back(std::uint8_t(k));
    };
    for (int k = 0; k < kPoints; ++k) {
        const int next = (k + 1) % kPoints;
        triangle(k, next + kPoints, next);
        triangle(k, k + kPoints, next + kPoints);
    }
    for (const std::vector<int>& strip : {std::vector{9, 10, 0, 7, 8}, {0, 1, 2, 6, 7}, {2, 3, 4, 5, 6}})
        for (std::size_t k = 2; k < strip.size(); ++k) {
            triangle(strip[0], strip[k - 1], strip[k]);
            triangle(strip[0] + kPoints, strip[k] + kPoints, strip[k - 1] + kPoints);
        }
    corners = file.vectors<float>(points);
    indices = file.indices<std::uint8_t>(list);
}

/// Meshes: 0 a box of 1 m with its fronts outside, 1 the same with fronts inside, 2 a square of 1 m in y and z, front
/// toward +x, 3 the channel. All from the origin.
std::string scene(const std::string& nodes) {
    SmallGltf file;
    std::vector<std::uint16_t> inside = box_triangles();
    for (std::size_t k = 0; k < inside.size(); k += 3) std::swap(inside[k], inside[k + 1]);
    const int corners = file.vectors(box_corners(1, 1, 1));
    const int outward = file.indices(box_triangles()), inward = file.indices(inside);
    const int square = file.vectors<float>({0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1});
    const int two = file.indices<std::uint8_t>({0, 1, 2, 0, 2, 3});
    int channel = 0, around = 0;
    add_channel(file, channel, around);
    file.meshes = R"({"primitives":[)" + primitive(corners, outward) + R"(]},{"primitives":[)" +
                  primitive(corners, inward) + R"(]},{"primitives":[)" + primitive(square, two) +
                  R"(]},{"primitives":[)" + primitive(channel, around) + "]}";
    file.nodes = nodes;
    file.scenes = "";
    return file.text();
}

std::string node(int mesh, const Vec3& at, const Vec3& size, const std::string& name = "") {
    const auto list = [](const Vec3& v) {
        return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
    };
    return R"({"mesh":)" + std::to_string(mesh) + R"(,"name":")" + name + R"(","translation":)" + list(at) +
           R"(,"scale":)" + list(size) + "}";
}

struct Made {
    World world;
    GltfRooms report;
};

Made make(const std::vector<std::string>& nodes) {
    std::string list;
    for (const std::string& one : nodes) list += (list.empty() ? "" : ",") + one;
    Made made;
    const Result<World> world = make_world(read_good(scene(list), {.up = 1}), {}, &made.report);
    EXPECT_TRUE(world);
    if (!world) return made;
    made.world = world.value();
    const auto fault = check_world(made.world);
    EXPECT_FALSE(fault) << fault->what;
    const auto solid = check_solid(made.world);
    EXPECT_FALSE(solid) << solid->what;
    return made;
}

RoomId room_at(const World& world, const Vec3& point) {
    const Location where = locate(world, point);
    EXPECT_EQ(where.where, Where::kAir) << point.x;
    return where.room;
}

double area_of(const std::vector<std::vector<Vec3>>& polygons) {
    double area = 0;
    for (const std::vector<Vec3>& polygon : polygons)
        for (std::size_t k = 2; k < polygon.size(); ++k)
            area += length(cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0])) / 2;
    return area;
}

TEST(GltfRooms, APortalDividesARoom) {
    for (const double sticks_out : {0.0, 1.0}) {
        const Vec3 at{4, -sticks_out, -sticks_out}, size{1, 4 + 2 * sticks_out, 4 + 2 * sticks_out};
        const Made made = make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, at, size, "portal A")});
        EXPECT_EQ(made.report.undivided, "");
        EXPECT_TRUE(made.report.idle.empty());
        EXPECT_EQ(made.world.room_count(), 2u);
        ASSERT_EQ(portal_count(made.world), 1u);
        const PortalInfo portal = *portal_info(made.world, PortalId{0});
        EXPECT_EQ(portal.name, "portal A");
        EXPECT_EQ(area_of(portal_polygons(made.world, PortalId{0})), 16);
        const RoomId low = room_at(made.world, {1, 2, 2}), high = room_at(made.world, {7, 2, 2});
        EXPECT_NE(low, high);
        EXPECT_EQ(portal.rooms[0], high);  // the square looks toward +x
        EXPECT_EQ(portal.rooms[1], low);
        EXPECT_EQ(locate(made.world, {-1, 2, 2}).where, Where::kSolid);
        EXPECT_EQ(measure_solid(made.world).volume, -128);
        RoomTrail trail;
        EXPECT_TRUE(cast(made.world, {{1, 2, 2}, 0.25}, {20, 0, 0}, {.room = low, .trail = &trail}));
        EXPECT_EQ(trail.count, 2u);
    }
}

// Filled by hand, and wrongly: a GltfLevel is a public struct.
TEST(GltfRooms, PortalsThatAreNoPolygonsAreRefused) {
    const std::string text = scene(node(1, {0, 0, 0}, {8, 4, 4}) + "," + node(2, {4, 0, 0}, {1, 4, 4}, "portal A"));
    const GltfLevel gltf = read_good(text);
    ASSERT_EQ(gltf.portals.size(), 1u);
    ASSERT_TRUE(make_world(gltf).ok());
    const auto said = [&](const auto& change) {
        GltfLevel changed = gltf;
        change(changed.portals[0].polygons[0]);
        const Result<World> world = make_world(changed);
        return world.ok() ? "" : world.error().text();
    };
    const std::string refused =
        "a.glb: portal 0: a polygon of it is not convex and planar, of 3 to 64 corners on the input grid";
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon.clear(); }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon.resize(65); }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon[1] = polygon[0]; }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) { polygon[1].x += 64; }), refused);
    EXPECT_EQ(said([](std::vector<GridPoint>& polygon) {
                  for (GridPoint& point : polygon) point.x += 1;
              }),
              refused);
}

TEST(GltfRooms, PillarsHangWhereTheyStand) {
    const Made made = make({node(1, {0, 0, 0}, {8, 4, 4}), node(0, {1, 1, 1}, {1, 1, 1}), node(0, {6, 1, 1}, {1, 1, 2}),
                            node(2, {4, 0, 0}, {1, 4, 4}, "portal")});
    EXPECT_EQ(made.world.room_count(), 2u);
    EXPECT_NE(room_at(made.world, {0.5, 0.5, 0.5}), room_at(made.world, {7.5, 0.5, 0.5}));
    EXPECT_EQ(locate(made.world, {1.5, 1.5, 1.5}).where, Where::kSolid);
    EXPECT_EQ(room_info(made.world, room_at(made.world, {0.5, 2, 2}))->bounds.high.x, 4);
}

TEST(GltfRooms, WhatLooksAtItselfHangsWhereItStandsToo) {
    const Made made = make(
        {node(1, {0, 0, 0}, {16, 8, 12}), node(2, {12, 0, 0}, {1, 8, 12}, "portal"), node(3, {2, 2, 2}, {1, 1, 1})});
    EXPECT_EQ(made.report.undivided, "");
    EXPECT_EQ(made.world.room_count(), 2u);
    EXPECT_EQ(room_at(made.world, {1, 1, 1}), room_at(made.world, {3.5, 3, 5}));
}

TEST(GltfRooms, APortalThroughAPillarHasAHole) {
    const Made made =
        make({node(1, {0, 0, 0}, {8, 4, 4}), node(0, {3, 1, 1}, {2, 1, 1}), node(2, {4, 0, 0}, {1, 4, 4}, "portal")});
    EXPECT_EQ(made.world.room_count(), 2u);
    ASSERT_EQ(portal_count(made.world), 1u);
    EXPECT_EQ(area_of(portal_polygons(made.world, PortalId{0})), 15);
    EXPECT_EQ(measure_solid(made.world).volume, -126);
}

TEST(GltfRooms, CrossingPortalsMakeFour) {
    // The second lies along x: a square turned about y by a quarter.
    const std::string along =
        R"({"mesh":2,"name":"portal B","translation":[0,0,2],"rotation":[0,1,0,1],"scale":[1,4,8]})";
    const Made made = make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, {4, 0, 0}, {1, 4, 4}, "portal A"), along});
    EXPECT_EQ(made.world.room_count(), 4u);
    EXPECT_EQ(portal_count(made.world), 4u);
    const RoomId a = room_at(made.world, {1, 2, 1}), b = room_at(made.world, {7, 2, 3});
    const auto path = find_path(made.world, a, b);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->size(), 2u);
}

TEST(GltfRooms, OfPortalsInOnePlaceTheFirstCounts) {
    const std::string hall = node(1, {0, 0, 0}, {8, 4, 4});
    const Made twice =
        make({hall, node(2, {4, 0, 0}, {1, 4, 4}, "portal A"), node(2, {4, 0, 0}, {1, 4, 4}, "portal B")});
    EXPECT_EQ(twice.world.room_count(), 2u);
    ASSERT_EQ(portal_count(twice.world), 1u);
    EXPECT_EQ(portal_info(twice.world, PortalId{0})->name, "portal A");
    const Made partly =
        make({hall, node(2, {4, 0, 0}, {1, 3, 4}, "portal A"), node(2, {4, 2, 0}, {1, 9, 4}, "portal B")});
    EXPECT_EQ(partly.world.room_count(), 2u);
    ASSERT_EQ(portal_count(partly.world), 2u);
    EXPECT_EQ(area_of(portal_polygons(partly.world, PortalId{0})), 12);
    EXPECT_EQ(area_of(portal_polygons(partly.world, PortalId{1})), 4);
    // From behind it is the same place.
    const std::string turned =
        R"({"mesh":2,"name":"portal B","translation":[4,2,4],"rotation":[0,1,0,0],"scale":[1,2,4]})";
    const Made back = make({hall, node(2, {4, 0, 0}, {1, 3, 4}, "portal A"), turned});
    EXPECT_EQ(back.world.room_count(), 2u);
    ASSERT_EQ(portal_count(back.world), 2u);
    EXPECT_EQ(area_of(portal_polygons(back.world, PortalId{1})), 4);
}

TEST(GltfRooms, TheExteriorIsARoom) {
    // A hollow block: rock between two boxes.
    const Made made = make({node(0, {-1, -1, -1}, {10, 6, 6}), node(1, {0, 0, 0}, {8, 4, 4}),
                            node(2, {4, -3, -3}, {1, 10, 10}, "portal")});
    ASSERT_EQ(made.world.room_count(), 3u);
    const RoomId outside = room_at(made.world, {-5, 2, 2});
    EXPECT_TRUE(room_info(made.world, outside)->exterior);
    EXPECT_EQ(room_at(made.world, {20, 2, 2}), outside);
    ASSERT_EQ(portal_count(made.world), 1u);
    EXPECT_EQ(area_of(portal_polygons(made.world, PortalId{0})), 16);
    EXPECT_EQ(made.report.idle, std::vector<std::uint32_t>{0});  // what of it stands in the open divides nothing
}

TEST(GltfRooms, AFloatingPortalIsIdle) {
    const Made made = make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, {4, 1, 1}, {1, 2, 2}, "portal")});
    EXPECT_EQ(made.world.room_count(), 1u);
    EXPECT_EQ(portal_count(made.world), 0u);
    EXPECT_EQ(made.report.idle, std::vector<std::uint32_t>{0});
    EXPECT_EQ(made.report.undivided, "");
}

TEST(GltfRooms, WhatIsNoSolidIsPutWhereItLies) {
    // An open square between the two rooms' middles, and one through the portal.
    const Made made =
        make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, {4, 0, 0}, {1, 4, 4}, "portal"), node(2, {6, 1, 1}, {1, 1, 1}),
              R"({"mesh":2,"translation":[3,1,2],"rotation":[0,1,0,1],"scale":[1,1,2]})"});
    EXPECT_EQ(made.world.room_count(), 2u);
    const RoomId low = room_at(made.world, {1, 2, 1}), high = room_at(made.world, {7, 2, 3});
    const Made bare = make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, {4, 0, 0}, {1, 4, 4}, "portal")});
    EXPECT_GT(room_info(made.world, low)->faces, room_info(bare.world, low)->faces);
    EXPECT_GT(room_info(made.world, high)->faces, room_info(bare.world, high)->faces + 1);
    EXPECT_EQ(cast(made.world, {{7.5, 1.5, 1.5}, 0}, {-7, 0, 0}, {.sides = Sides::kBoth, .room = high}).point.x, 6);
}

TEST(GltfRooms, WithoutASolidThereIsOneRoom) {
    const Made made = make({node(2, {0, 0, 0}, {1, 4, 4}), node(2, {4, 0, 0}, {1, 4, 4}, "portal")});
    EXPECT_EQ(made.report.undivided, "none of its faces bounds a solid");
    EXPECT_EQ(made.world.room_count(), 1u);
}

TEST(GltfRooms, DividedWorldsAreCarved) {
    const Made made = make({node(1, {0, 0, 0}, {8, 4, 4}), node(2, {4, 0, 0}, {1, 4, 4}, "portal")});
    const auto carved = [&](double x) {
        const CarveResult result =
            carve(made.world, make_crater(CutterShape::kRocky, 3), {.position = {x, 0, 2}, .scale = 1}, {"fresh"});
        EXPECT_EQ(result.status, CarveStatus::kDone);
        EXPECT_FALSE(check_world(result.world));
        EXPECT_LT(measure_solid(result.world).volume, -128.5);
        return result.world;
    };
    const World away = carved(1.5);
    EXPECT_EQ(area_of(portal_polygons(away, PortalId{0})), 16);
    EXPECT_NE(room_at(away, {1, 2, 2}), room_at(away, {7, 2, 2}));
    EXPECT_EQ(room_at(away, {1.5, -0.3, 2}), room_at(away, {1, 2, 2}));
    const World around = carved(4);  // a way past the portal: another portal
    EXPECT_NE(room_at(around, {1, 2, 2}), room_at(around, {7, 2, 2}));
    EXPECT_EQ(portal_count(around), 2u);
    EXPECT_EQ(area_of(portal_polygons(around, PortalId{0})), 16);
}

/// Our level with three portals through all of it, far beyond its rim.
TEST(GltfRooms, OurLevelInEight) {
    const World world = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
    std::string bytes;
    cli::write_glb(world, cli::GlbParts(world), 2, [&](std::string_view piece) { bytes += piece; });
    GltfLevel gltf = read_good(bytes);
    const Box bounds = bounds_of(gltf);
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::floor((bounds.low[axis] + bounds.high[axis]) / 2) + 0.25 + 1.0 / 4096;
        std::vector<GridPoint> polygon;
        for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            Vec3 corner;
            corner[axis] = at;
            corner[(axis + 1) % 3] = 1000 * u;
            corner[(axis + 2) % 3] = 1000 * v;
            polygon.push_back(*snap(corner));
        }
        gltf.portals.push_back({"portal " + std::to_string(axis), 0, {polygon}});
    }
    GltfRooms report;
    const World divided = make_world(gltf, {}, &report).value();
    ASSERT_EQ(report.undivided, "");
    const auto fault = check_world(divided);
    ASSERT_FALSE(fault) << fault->what;
    EXPECT_FALSE(check_solid(divided));
    EXPECT_GE(divided.room_count(), 4u);
    EXPECT_EQ(measure_solid(divided).volume, measure_solid(world).volume);

    // Whoever walks to a point through portals is where asking finds the point.
    std::mt19937 rng(3);
    std::uniform_real_distribution<double> share(0, 1);
    const auto anywhere = [&] {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = bounds.low[axis] + share(rng) * (bounds.high[axis] - bounds.low[axis]);
        return point;
    };
    int walked = 0, passed = 0;
    while (walked < 300) {
        const Vec3 from = anywhere();
        const Location start = locate(divided, from);
        EXPECT_EQ(start.where, locate(world, from).where);
        if (start.where != Where::kAir) continue;
        const Vec3 path = (anywhere() - from) * 0.3;
        RoomId rooms[16];
        RoomTrail trail{rooms};
        const Hit hit = cast(divided, {from, 0}, path, {.room = start.room, .trail = &trail});
        const Hit whole = cast(world, {from, 0}, path);
        EXPECT_EQ(hit.status, whole.status);
        EXPECT_NEAR(hit.fraction * length(path), whole.fraction * length(path), 1e-4);  // corners of cuts are rounded
        ++walked;
        if (hit.status != Status::kMiss || trail.count > 16) continue;
        EXPECT_EQ(rooms[trail.count - 1], locate(divided, from + path).room);
        passed += trail.count > 1;
    }
    EXPECT_GT(passed, 20);
}

}  // namespace
}  // namespace firma::gltf
