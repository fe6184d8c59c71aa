// SPDX-License-Identifier: MIT
// A hall with closets, in cells of 1 x 2 x 2 m: a face where a cell meets rock, a portal where it meets another room.
#include "scenes/hub.h"

#include <array>

namespace firma::scenes {
namespace {

constexpr int kRock = -1;

class HubBuilder {
public:
    explicit HubBuilder(const Hub& hub) : hub_(hub) {
        parts_.materials = {""};
        parts_.rock_outside = true;
        parts_.rooms.resize(std::size_t(hub.closets) + 1);
    }

    WorldParts build() {
        for (int x = 0; x <= hub_.closets; ++x)
            for (int y = -1; y <= 1; ++y)
                if (room_at(x, y) != kRock) add_cell(x, y);
        return std::move(parts_);
    }

private:
    /// y = 0: the hall.
    int room_at(int x, int y) const {
        if (x < 0 || x > hub_.closets) return kRock;
        if (y == 0) return int(hall_of(hub_).value);
        if (y < -1 || y > 1 || x % 2 == 0) return kRock;
        return int(room_of_closet(hub_, x - 1 + (y > 0)).value);
    }

    void add_cell(int x, int y) {
        const int room = room_at(x, y);
        const int a = x - hub_.closets / 2, b = a + 1, c = 2 * y, d = c + 2;
        add_face(room, {at(a, c, 0), at(b, c, 0), at(b, d, 0), at(a, d, 0)});
        add_face(room, {at(a, c, 2), at(a, d, 2), at(b, d, 2), at(b, c, 2)});
        add_side(room, room_at(x - 1, y), {at(a, c, 0), at(a, d, 0), at(a, d, 2), at(a, c, 2)});
        add_side(room, room_at(x + 1, y), {at(b, c, 0), at(b, c, 2), at(b, d, 2), at(b, d, 0)});
        add_side(room, room_at(x, y - 1), {at(a, c, 0), at(a, c, 2), at(b, c, 2), at(b, c, 0)});
        add_side(room, room_at(x, y + 1), {at(a, d, 0), at(b, d, 0), at(b, d, 2), at(a, d, 2)});
    }

    /// Each portal once, from the closet.
    void add_side(int room, int beyond, const std::array<GridPoint, 4>& corners) {
        if (beyond == kRock) return add_face(room, corners);
        if (beyond == room || room == int(hall_of(hub_).value)) return;
        PortalPart portal;
        portal.rooms = {RoomId{std::uint32_t(room)}, RoomId{std::uint32_t(beyond)}};
        portal.polygons.emplace_back(corners.begin(), corners.end());
        parts_.portals.push_back(std::move(portal));
    }

    void add_face(int room, const std::array<GridPoint, 4>& corners) {
        FaceSet& set = parts_.rooms[std::size_t(room)].faces;
        set.faces.push_back(
            {.id = {next_++}, .first_corner = std::uint32_t(set.corners.size()), .corner_count = 4, .solid = true});
        for (const GridPoint& corner : corners) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(corner);
        }
    }

    static GridPoint at(int x, int y, int z) {
        constexpr int kStep = int(kSurfaceSteps);
        return {x * kStep, y * kStep, z * kStep};
    }

    const Hub hub_;
    WorldParts parts_;
    std::uint32_t next_ = 0;
};

}  // namespace

WorldParts hub_parts(const Hub& hub) {
    return HubBuilder(hub).build();
}

Vec3 floor_of_closet(const Hub& hub, int closet) {
    return {closet / 2 * 2 + 1.5 - hub.closets / 2, closet % 2 ? 3.0 : -1.0, 0};
}

}  // namespace firma::scenes
