// SPDX-License-Identifier: MIT
// None through a wall, of bodies: rooms whose walls are one step of the input grid thick, with air beyond. Each body
// stays in the room that it was thrown in.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/carve.h"
#include "scenes/level_cuts.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_bodies.h"
#include "tests/sample.h"

namespace firma::test {
namespace {

using scenes::Rng;

constexpr double kRoom = 4;  // metres, each way

/// Rooms in a row along x, from the origin up. The floor of the one in the middle may be thicker than its walls.
struct Row {
    int rooms = 1;
    double thin = 1.0 / 4096, floor = 1.0 / 4096;  // metres

    double end() const { return rooms * kRoom; }
    /// The one that is in the middle, or before it.
    int middle() const { return (rooms - 1) / 2; }

    World world() const {
        const auto box = [](const Vec3& low, const Vec3& high) { return map_text::box(low, high, "rock"); };
        std::string text = box({0, 0, kRoom}, {end() + thin, kRoom, kRoom + thin});
        text += box({0, -thin, -thin}, {end() + thin, 0, kRoom + thin});
        text += box({0, kRoom, -thin}, {end() + thin, kRoom + thin, kRoom + thin});
        for (int k = 0; k <= rooms; ++k) text += box({k * kRoom, 0, 0}, {k * kRoom + thin, kRoom, kRoom});
        for (int k = 0; k < rooms; ++k) {
            const double down = k == middle() ? floor : thin;
            text += box({k * kRoom, 0, -down}, {k * kRoom + kRoom + (k + 1 == rooms ? thin : 0), kRoom, 0});
        }
        return brush_world(text);
    }
    /// Of a point in the air; -1 where it is in none. Air below the floor and above its lower side is that of a crater.
    int room_of(const Vec3& at) const {
        const int room = int(std::floor(at.x / kRoom));
        if (room < 0 || room >= rooms || at.y <= 0 || at.y >= kRoom || at.z >= kRoom) return -1;
        return at.z > (room == middle() ? -floor : -thin) ? room : -1;
    }
};

/// Throws bodies about in each room, again each half second, and looks at each sphere's centre after each step.
void throw_about(const Row& row, const World& world, double rate, std::uint64_t seed) {
    Rng rng(seed);
    const Level walls = scenes::cut_places(world).inside;
    Bodies bodies;
    const int each_room = sample(12);
    std::vector<int> rooms, seen(std::size_t(row.rooms));
    while (int(rooms.size()) < each_room * row.rooms) {
        const Body body = reference::random_body(world, walls, rng);
        const int room = row.room_of(body.position);
        ASSERT_GE(room, 0);
        if (++seen[std::size_t(room)] > each_room) continue;
        rooms.push_back(room);
        add_body(bodies, body);
    }
    reference::BodyDepths depths(true);
    const int steps = int(2 * rate), each = int(rate / 2);
    std::size_t bounces = 0;
    for (int k = 0; k < steps; ++k) {
        if (k > 0 && k % each == 0)
            for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
                wake_body(bodies, {slot, bodies.slots[slot].use});
                const Vec3 way = rng.direction();
                bodies.slots[slot].velocity = way * std::pow(10.0, rng.uniform(0, 3));
                bodies.slots[slot].spin = rng.direction() * rng.uniform(0, 200);
            }
        bounces += step(bodies, world, 1 / rate).bounces;
        ASSERT_EQ(depths.fault(world, bodies), "") << "step " << k;
        for (std::size_t one = 0; one < rooms.size(); ++one) {
            const Pose pose = pose_of(bodies.slots[one]);
            const TurnMatrix turn = matrix_of(pose.rotation);
            for (const Sphere& sphere : bodies.slots[one].shape.spheres())
                ASSERT_EQ(row.room_of(pose.position + turn * sphere.centre), rooms[one])
                    << "step " << k << ", body " << one;
        }
    }
    EXPECT_GT(bounces, rooms.size());
}

TEST(ThinWalls, NoBodyLeavesAClosedRoom) {
    for (const double thin : {1.0 / 4096, 1.0 / 256}) {
        const Row room{1, thin, thin};
        for (const double rate : {60.0, 30.0}) throw_about(room, room.world(), rate, 1);
    }
}

TEST(ThinWalls, NoBodyLeavesItsRoomInARow) {
    for (const double thin : {1.0 / 4096, 1.0 / 256}) {
        const Row row{3, thin, thin};
        for (const double rate : {60.0, 30.0}) throw_about(row, row.world(), rate, 2);
    }
}

/// Its lowest point, of the level with a crater in the floor of the middle room.
double lowest(const World& world, double above) {
    double low = 0;
    for (const Face& face : world.faces())
        for (const Vec3& corner : face.corners)
            if (corner.z > above) low = std::min(low, corner.z);
    return low;
}

TEST(ThinWalls, NoBodyLeavesThroughTheBottomOfACrater) {
    // The floor ends one step of the grid, or two, below the deepest point of the crater.
    constexpr double kGridStep = 1.0 / 4096;
    const Cutter crater = make_crater(CutterShape::kRocky, 3);
    const Row thick{3, kGridStep, 3};
    const Pose pose = pose_at(1.5 * kRoom, kRoom / 2, 0, 1.2);
    const CarveResult first = carve(thick.world(), crater, pose);
    ASSERT_TRUE(first.done());
    const double deepest = lowest(first.world, -2.9);
    ASSERT_LT(deepest, -0.5);
    const Row row{3, kGridStep, -(std::floor(deepest / kGridStep) - 1) * kGridStep};
    const CarveResult cut = carve(row.world(), crater, pose);
    ASSERT_TRUE(cut.done());
    ASSERT_EQ(lowest(cut.world, -row.floor), deepest);
    ASSERT_LE(row.floor + deepest, 2 * kGridStep);
    for (const double rate : {60.0, 30.0}) throw_about(row, cut.world, rate, 3);
}

}  // namespace
}  // namespace firma::test
