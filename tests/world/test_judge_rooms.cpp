// SPDX-License-Identifier: MIT
// The judge of rooms must be able to find fault.
#include <gtest/gtest.h>

#include "tests/reference/judge_rooms.h"
#include "tests/world/two_halves.h"

namespace firma {
namespace {

using reference::RoomBounds;
using reference::unclosed_room;

World without_portal() {
    WorldParts parts = two_halves_parts();
    parts.portals[0].polygons.clear();
    return assemble_world(std::move(parts)).value();
}

World with_portal_turned() {
    WorldParts parts = two_halves_parts();
    std::swap(parts.portals[0].rooms[0], parts.portals[0].rooms[1]);
    return assemble_world(std::move(parts)).value();
}

/// The far wall of room 1 is in the tree of room 0.
World with_face_in_wrong_room() {
    WorldParts parts = two_halves_parts();
    FaceSet &from = parts.rooms[1].faces, &to = parts.rooms[0].faces;
    FaceSet::Entry face = from.faces.back();
    const auto first = std::uint32_t(to.corners.size());
    for (std::uint32_t k = 0; k < face.corner_count; ++k) {
        to.corners.push_back(std::uint32_t(to.vertices.size()));
        to.vertices.push_back(from.vertices[from.corners[face.first_corner + k]]);
    }
    face.first_corner = first;
    to.faces.push_back(face);
    from.faces.pop_back();
    return assemble_world(std::move(parts)).value();
}

const Vec3 kInFirst{1, 2, 3}, kInSecond{7, 1, 2}, kInRock{3, 2, 5};

TEST(JudgeRooms, FindsNothingInASoundWorld) {
    for (const bool open : {true, false}) {
        const World world = two_halves(open);
        EXPECT_EQ(unclosed_room(world), "");
        const RoomBounds rooms(world);
        for (const Vec3& point : {kInFirst, kInSecond, kInRock}) EXPECT_EQ(rooms.judge(point), "");
        EXPECT_EQ(reference::closed_rooms(world), std::vector<bool>(2, true));
    }
    EXPECT_EQ(reference::judge_way(two_halves(), kInFirst, kInSecond), "");
}

TEST(JudgeRooms, FindsARoomThatIsNotClosed) {
    EXPECT_NE(unclosed_room(without_portal()), "");
    EXPECT_NE(unclosed_room(with_portal_turned()), "");
    EXPECT_NE(unclosed_room(with_face_in_wrong_room()), "");
}

TEST(JudgeRooms, FindsAPointInTheWrongRoom) {
    for (const World& world : {without_portal(), with_portal_turned(), with_face_in_wrong_room()}) {
        const RoomBounds rooms(world);
        EXPECT_NE(rooms.judge(kInFirst) + rooms.judge(kInSecond), "");
    }
}

TEST(JudgeRooms, FindsCastsThatDifferByRoom) {
    std::uint32_t passed = 0;
    EXPECT_EQ(reference::judge_cast_by_room(two_halves(), {kInFirst, 0.1}, {20, 0, 0}, passed), "");
    EXPECT_EQ(passed, 2u);
    EXPECT_NE(reference::judge_cast_by_room(without_portal(), {kInFirst, 0.1}, {20, 0, 0}, passed), "");
}

TEST(JudgeRooms, TellsWhichRoomsAreClosed) {
    WorldParts parts = two_halves_parts();
    parts.rock_outside = false;
    parts.rooms[1].exterior = true;
    EXPECT_EQ(reference::closed_rooms(assemble_world(std::move(parts)).value()), std::vector<bool>(2, false));
}

}  // namespace
}  // namespace firma
