// SPDX-License-Identifier: MIT
// What a cast by room looks at, beside one of the same faces in one tree: it saves what other rooms hold, and has the
// portals to ask. Counted, as counts repeat; times are bench_levels' to take. Boxes one by one, without lanes; and
// eight at a time, where a tree's upper nodes cost little: there rooms save less, and nothing where one is most of the
// level.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "firma/brush_world.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/one_tree.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"
#include "solid/build_blocks.h"
#include "tests/openarena_maps.h"
#include "tests/sample.h"
#include "world/sweep_lanes.h"
#include "world/sweep_world.h"

namespace firma {
namespace {

struct Started {
    Sphere sphere;
    Vec3 path;
    RoomId room;
};

/// From the air of rooms that are closed, clear of the walls.
std::vector<Started> starts_in(const World& world, double radius, double longest, std::size_t many) {
    scenes::Rng rng(31);
    const Box box = world.bounds();
    std::vector<Started> starts;
    while (starts.size() < many) {
        Started start;
        start.sphere.radius = radius;
        for (int axis = 0; axis < 3; ++axis) start.sphere.centre[axis] = rng.uniform(box.low[axis], box.high[axis]);
        const Location where = locate(world, start.sphere.centre);
        if (where.where != Where::kAir || room_info(world, where.room)->exterior) continue;
        if (closest(world, start.sphere.centre, radius + 1e-3)) continue;
        // One after the other, so that every compiler draws the same starts.
        const double far = rng.uniform(0.1, longest);
        start.path = rng.direction() * far;
        start.room = where.room;
        starts.push_back(start);
    }
    return starts;
}

struct Bounds {
    double boxes;    ///< at most so many of those in one tree
    double faces;    ///< at most so many of those that are asked for there
    double touched;  ///< at most so many faces are asked for a cast that touches something
};

/// Same answers, for fewer boxes of nodes, faces and portals.
void expect_less(const World& world, const World& one, const Bounds& most) {
    for (const auto& [radius, longest] : {std::pair{0.3, 2.0}, {0.3, 50.0}, {0.0, 50.0}}) {
        CastCounts by_room, in_one;
        std::size_t touched = 0;
        // Short ones test few faces.
        for (const Started& start : starts_in(world, radius, longest, longest < 10 ? 4000 : 1000)) {
            const Hit a = cast(world, start.sphere, start.path, {.counts = &by_room, .room = start.room});
            const Hit b = cast(one, start.sphere, start.path, {.counts = &in_one});
            EXPECT_EQ(a.status, b.status);
            EXPECT_EQ(a.fraction, b.fraction);
            touched += a.touched();
        }
        EXPECT_LT(double(by_room.nodes + by_room.boxes), most.boxes * double(in_one.nodes + in_one.boxes))
            << "radius " << radius << ", up to " << longest << " m";
        EXPECT_LE(double(by_room.faces), most.touched * double(touched)) << "radius " << radius;
        EXPECT_LE(double(by_room.faces), most.faces * double(in_one.faces))
            << "radius " << radius << ", up to " << longest << " m";
    }
}

/// Lanes leave hardly more faces to ask for than are met, in one tree as by room: what differs is in which order they
/// come.
void expect_less_by_lanes(const World& world, const World& one, double share) {
    expect_less(world, one, {.boxes = share, .faces = 1.1, .touched = 1.4});
}

void expect_less_one_by_one(const World& world, const World& one, double share) {
    take_lane_kernel(nullptr);
    expect_less(world, one, {.boxes = share, .faces = share < 0.95 ? 1 : 1.05, .touched = 4});
    if (!lane_kernels().empty()) take_lane_kernel(&lane_kernels()[0]);
}

TEST(RoomTrees, CastsByRoomLookAtLessThanThoseInOneTree) {
    const World depot = make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value(), {}).value();
    const World one = scenes::in_one_tree(depot);
    expect_less_one_by_one(depot, one, 0.9);
    expect_less_by_lanes(depot, one, 0.9);
}

/// Maps of which one room is most of the air, so that rooms save little; czest2ctf's has 44 portals.
TEST(RoomTrees, DividedBySurfaceAreaCastsLookAtLess) {
    const BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    WorldOptions options;
    const World by_area = scenes::in_one_tree(make_world(level, options).value());
    options.tree.split = Split::kLongestAxis;
    const World in_halves = scenes::in_one_tree(make_world(level, options).value());
    for (const bool lanes : {false, true}) {
        if (lanes && lane_kernels().empty()) break;
        take_lane_kernel(lanes ? &lane_kernels()[0] : nullptr);
        CastCounts a, b;
        for (const Started& start : starts_in(by_area, 0.3, 50, 1000)) {
            EXPECT_EQ(cast(by_area, start.sphere, start.path, {.counts = &a}).fraction,
                      cast(in_halves, start.sphere, start.path, {.counts = &b}).fraction);
        }
        EXPECT_LT(double(a.nodes + a.boxes), 0.95 * double(b.nodes + b.boxes));
    }
}

TEST(RoomTrees, AlsoWhereOneRoomIsMostOfTheLevel) {
    std::size_t tried = 0;
    for (const std::filesystem::path& map : openarena_maps()) {
        const std::string name = map.stem().string();
        if (name != "czest2ctf" && name != "ctf_compromise") continue;
        SCOPED_TRACE(name);
        const World world = make_world(read_brush_level(map.string()).value(), {}).value();
        const World one = scenes::in_one_tree(world);
        expect_less_one_by_one(world, one, 0.94);
        expect_less_by_lanes(world, one, 1.2);
        ++tried;
    }
    if (tried == 0) GTEST_SKIP() << kNoOpenArena;
}

/// Faces of 3 to 64 corners anywhere, at the world's rim as well.
TEST(RoomTrees, ABoxOfAFaceIsAroundItsCorners) {
    scenes::Rng rng(7);
    const auto steps = [&] {
        return rng.chance(0.1) ? INT32_MIN : rng.chance(0.1) ? INT32_MAX : std::int32_t(rng.uniform(-0x1p31, 0x1p31));
    };
    for (int k = 0; k < test::sample(2000); ++k) {
        FaceSet faces;
        GridBox expected;
        std::vector<GridPoint> corners;
        for (std::uint32_t c = 3 + rng.below(62); c > 0; --c) {
            GridPoint& corner = corners.emplace_back();
            for (int axis = 0; axis < 3; ++axis) corner[axis] = steps();
            expected.add(corner);
        }
        add_facet(faces, corners, {.id = {0}});
        const std::vector<PartIndex> made = build_blocks(faces, {});
        const Block& block = block_of(*made[0].root);
        const FaceRecord& face = block.faces[0];
        std::vector<GridPoint> kept;
        block.for_each_corner(face, [&](const GridPoint& corner) { kept.push_back(corner); });
        ASSERT_EQ(kept, corners);
        for (std::uint32_t c = 0; c < corners.size(); ++c) ASSERT_EQ(block.corner(face, c), corners[c]);
        const Vec3 low = to_metres(expected.low), high = to_metres(expected.high);
        const BoxD box = box_of_face(block, face);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(box.low[axis], low[axis]);
            EXPECT_EQ(box.high[axis], high[axis]);
        }
    }
}

}  // namespace
}  // namespace firma
