// SPDX-License-Identifier: MIT
// Each part of a world replaced alone: what follows from the faces follows again, and nothing else changes.
#include "world/replace.h"

#include <gtest/gtest.h>

#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "scenes/hub.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

using scenes::Hub;

const Hub kHub{8, true};

/// A hall with eight closets, a sign that is castable only in one of them.
WorldParts parts() {
    WorldParts parts = scenes::hub_parts(kHub);
    const Vec3 at = scenes::floor_of_closet(kHub, 3);
    FaceSet& faces = parts.rooms[scenes::room_of_closet(kHub, 3).value].faces;
    const auto first = std::uint32_t(faces.corners.size());
    for (const Vec3& corner : {at + Vec3{-0.25, 0, 1}, at + Vec3{0.25, 0, 1}, at + Vec3{0, 0, 1.5}}) {
        faces.corners.push_back(std::uint32_t(faces.vertices.size()));
        faces.vertices.push_back(snap(corner).value());
    }
    faces.faces.push_back({.id = {100'000}, .first_corner = first, .corner_count = 3, .two_sided = true});
    return parts;
}

/// Cuts into the rock below floors, where no portal is near.
World carved(const World& world, int count) {
    scenes::Rng rng(5);
    World now = world;
    for (int k = 0; k < count; ++k) {
        const Vec3 at = scenes::floor_of_closet(kHub, int(rng.below(8)));
        const Pose pose{.position = at + Vec3{0, 0, -0.1}, .rotation = random_turn(rng.next()), .scale = 0.4};
        const CarveResult cut = carve(now, make_crater(CutterShape::kRocky, rng.next()), pose);
        EXPECT_TRUE(cut.done());
        now = cut.world;
    }
    return now;
}

/// The same answers in all rooms and by room, the same faces by room, the same file.
void expect_same(const World& a, const World& b) {
    const auto fault = check_world(a);
    ASSERT_FALSE(fault) << fault->what;
    for (std::uint32_t room = 0; room < a.room_count(); ++room) {
        EXPECT_EQ(hash_room(a, {room}), hash_room(b, {room}));
        EXPECT_EQ(room_info(a, {room})->faces, room_info(b, {room})->faces);
    }
    scenes::Rng rng(9);
    int met = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 from = scenes::floor_of_closet(kHub, int(rng.below(8))) + Vec3{0, 0, 0.8};
        const Sphere sphere{from, rng.chance(0.5) ? 0 : 0.2};
        const Vec3 path = rng.direction() * rng.uniform(0.5, 6);
        for (const RoomId room : {kAnyRoom, kLocateRoom}) {
            const Hit one = cast(a, sphere, path, {.room = room}), two = cast(b, sphere, path, {.room = room});
            met += one.status != Status::kMiss;
            ASSERT_EQ(one.status, two.status);
            ASSERT_EQ(one.fraction, two.fraction);
            ASSERT_EQ(one.face, two.face);
            ASSERT_EQ(room_of(a, one), room_of(b, two));
        }
    }
    EXPECT_GT(met, 2000);
    const std::vector<std::byte> bytes = pack_world(a, {.index = false});
    EXPECT_TRUE(bytes == pack_world(b, {.index = false}));
    EXPECT_EQ(hash_world(unpack_world(bytes, "replaced").value()), hash_world(a));
}

TEST(Replace, TheSolid) {
    const World world = assemble_world(parts()).value();
    const World cut = carved(world, 1), same = with_solid(world, cut.solid());
    ASSERT_NE(hash_world(cut), hash_world(world));
    EXPECT_EQ(hash_world(same), hash_world(cut));
    expect_same(same, cut);
    const World back = with_solid(cut, world.solid());
    EXPECT_EQ(hash_solid(back), hash_solid(world));
    expect_same(with_solid(back, cut.solid()), with_solid(back, carved(world, 1).solid()));
    for (std::uint32_t room = 0; room < world.room_count(); ++room)
        EXPECT_EQ(hash_room(back, {room}), hash_room(world, {room}));
}

TEST(Replace, WhatIsCastableOnly) {
    const World world = assemble_world(parts()).value();
    const World bare = with_castable(world, {});
    EXPECT_FALSE(check_world(bare));
    EXPECT_EQ(bare.face_count(), world.face_count() - 1);
    EXPECT_EQ(hash_solid(bare), hash_solid(world));
    const RoomId room = scenes::room_of_closet(kHub, 3);
    EXPECT_NE(hash_room(bare, room), hash_room(world, room));
    const World back = with_castable(bare, world.data().castable);
    EXPECT_EQ(back.version(), 2u);
    for (std::uint32_t k = 0; k < world.room_count(); ++k) EXPECT_EQ(hash_room(back, {k}), hash_room(world, {k}));
    expect_same(back, with_castable(with_castable(world, {}), world.data().castable));
}

TEST(Replace, Cells) {
    const World world = assemble_world(parts()).value();
    // Another level's rooms over the same faces: portals closed, one room named.
    WorldParts other = parts();
    other.rooms[2].name = "larder";
    for (PortalPart& portal : other.portals) portal.open = false;
    const World closed = assemble_world(std::move(other)).value();
    const World same = with_cells(world, closed.data().cells);
    EXPECT_EQ(room_info(same, {2})->name, "larder");
    expect_same(same, with_cells(closed, closed.data().cells));
    const World cut = carved(world, 3);
    expect_same(with_cells(cut, closed.data().cells),
                with_solid(with_cells(carved(world, 2), closed.data().cells), cut.solid()));
}

}  // namespace
}  // namespace firma
