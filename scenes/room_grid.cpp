// SPDX-License-Identifier: MIT
// A building of any size.
#include "scenes/room_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace firma::scenes {
namespace {

constexpr int kRoom[3] = {8, 8, 4};  // metres of air

std::uint64_t mixed(std::uint64_t x) {
    return Rng(x).next();
}

/// Which cells of one cubic metre are air.
class Cells {
public:
    explicit Cells(const RoomGrid& grid) {
        const int rooms[3] = {grid.rooms_x, grid.rooms_y, grid.rooms_z};
        for (int axis = 0; axis < 3; ++axis) size_[axis] = rooms[axis] * (kRoom[axis] + 1) + 1;
        air_.assign(std::size_t(size_[0]) * size_[1] * size_[2], false);
        Rng rng(grid.seed);
        for (int k = 0; k < grid.rooms_z; ++k)
            for (int j = 0; j < grid.rooms_y; ++j)
                for (int i = 0; i < grid.rooms_x; ++i) dig_room(grid, {i, j, k}, rng);
    }

    bool air(std::array<int, 3> cell) const {
        for (int axis = 0; axis < 3; ++axis)
            if (cell[axis] < 0 || cell[axis] >= size_[axis]) return false;
        return air_[index(cell)];
    }
    int size(int axis) const { return size_[axis]; }

private:
    std::size_t index(std::array<int, 3> cell) const {
        return (std::size_t(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0];
    }

    void dig(std::array<int, 3> from, std::array<int, 3> extent) {
        for (int z = from[2]; z < from[2] + extent[2]; ++z)
            for (int y = from[1]; y < from[1] + extent[1]; ++y)
                for (int x = from[0]; x < from[0] + extent[0]; ++x) air_[index({x, y, z})] = true;
    }

    /// The room and, as chance will have it, doorways to the next ones.
    void dig_room(const RoomGrid& grid, std::array<int, 3> room, Rng& rng) {
        std::array<int, 3> at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = room[axis] * (kRoom[axis] + 1) + 1;
        const auto [x, y, z] = at;
        dig(at, {kRoom[0], kRoom[1], kRoom[2]});
        if (room[0] + 1 < grid.rooms_x && rng.chance(0.6)) dig({x + kRoom[0], y + 2 + int(rng.below(4)), z}, {1, 2, 3});
        if (room[1] + 1 < grid.rooms_y && rng.chance(0.6)) dig({x + 2 + int(rng.below(4)), y + kRoom[1], z}, {2, 1, 3});
        if (room[2] + 1 < grid.rooms_z && rng.chance(0.3))
            dig({x + 2 + int(rng.below(4)), y + 2 + int(rng.below(4)), z + kRoom[2]}, {2, 2, 1});
    }

    int size_[3];
    std::vector<bool> air_;
};

class Mason {
public:
    Mason(const RoomGrid& grid, const Cells& cells) : grid_(grid), cells_(cells) {}

    Level build() {
        level_.name = "room_grid";
        level_.materials = {""};
        level_.groups = {""};
        for (int z = 0; z < cells_.size(2); ++z)
            for (int y = 0; y < cells_.size(1); ++y)
                for (int x = 0; x < cells_.size(0); ++x)
                    if (cells_.air({x, y, z})) wall_in({x, y, z});
        level_.source_faces = std::uint32_t(level_.faces.size());
        return std::move(level_);
    }

private:
    /// A panel wherever the next cell is rock.
    void wall_in(std::array<int, 3> cell) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                std::array<int, 3> next = cell;
                next[axis] += side == 0 ? -1 : 1;
                if (!cells_.air(next)) add_panel(cell, axis, side);
            }
    }

    void add_panel(std::array<int, 3> cell, int axis, int side) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<int, 3> at = cell;
        at[axis] += side;
        std::array<std::uint32_t, 4> corner;  // around the axis, counter-clockwise
        corner[0] = vertex(at);
        ++at[u];
        corner[1] = vertex(at);
        ++at[v];
        corner[2] = vertex(at);
        --at[u];
        corner[3] = vertex(at);
        if (side == 1) std::swap(corner[1], corner[3]);  // the air lies below: look down
        if (grid_.jitter == 0) return add_face({corner[0], corner[1], corner[2], corner[3]});
        if (mixed(corner[0] * 31ull + corner[2]) & 1) {
            add_face({corner[0], corner[1], corner[2]});
            add_face({corner[0], corner[2], corner[3]});
        } else {
            add_face({corner[0], corner[1], corner[3]});
            add_face({corner[1], corner[2], corner[3]});
        }
    }

    std::uint32_t vertex(std::array<int, 3> at) {
        const std::uint64_t key = (std::uint64_t(at[2]) * 4096 + at[1]) * 4096 + at[0];
        const auto [found, is_new] = vertices_.try_emplace(key, std::uint32_t(level_.vertices.size()));
        if (is_new) {
            Rng rng(mixed(key) ^ grid_.seed);
            GridPoint point;
            for (int axis = 0; axis < 3; ++axis) {
                const double metres = at[axis] + grid_.jitter * rng.uniform(-1, 1);
                point[axis] = std::int32_t(std::lround(metres * kInputSteps)) * kSurfacePerInput;
            }
            level_.vertices.push_back(point);
        }
        return found->second;
    }

    void add_face(std::initializer_list<std::uint32_t> corners) {
        LevelFace face;
        face.first_corner = std::uint32_t(level_.corners.size());
        face.corner_count = std::uint32_t(corners.size());
        face.source = std::uint32_t(level_.faces.size());
        level_.corners.insert(level_.corners.end(), corners);
        level_.faces.push_back(face);
    }

    const RoomGrid& grid_;
    const Cells& cells_;
    Level level_;
    std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
};

/// In a room of its own, `clearance` away from where walls can be; half the time within 0.3 m of that from one.
Vec3 point_in_air(const RoomGrid& grid, double clearance, Rng& rng) {
    const int room[3] = {int(rng.below(std::uint32_t(grid.rooms_x))), int(rng.below(std::uint32_t(grid.rooms_y))),
                         int(rng.below(std::uint32_t(grid.rooms_z)))};
    const double margin = grid.jitter + clearance + 0.001;
    const int near_axis = rng.chance(0.5) ? int(rng.below(3)) : -1;
    const bool near_low = rng.chance(0.5);
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = room[axis] * (kRoom[axis] + 1) + 1 + margin;
        const double high = low + kRoom[axis] - 2 * margin;
        point[axis] = rng.uniform(low, high);
        if (axis == near_axis) point[axis] = near_low ? low + rng.uniform(0, 0.3) : high - rng.uniform(0, 0.3);
    }
    return point;
}

}  // namespace

Level room_grid(const RoomGrid& grid) {
    return Mason(grid, Cells(grid)).build();
}

RoomGrid room_grid_of(std::size_t triangles) {
    constexpr double kTrianglesOfRoom = 500;
    RoomGrid grid;
    const double rooms = std::max(1.0, double(triangles) / kTrianglesOfRoom);
    grid.rooms_z = std::max(1, int(std::lround(std::cbrt(rooms))));
    grid.rooms_y = std::max(1, int(std::lround(std::sqrt(rooms / grid.rooms_z))));
    grid.rooms_x = std::max(1, int(std::lround(rooms / grid.rooms_z / grid.rooms_y)));
    return grid;
}

std::vector<CastQuery> casts_in_rooms(const RoomGrid& grid, const CastRange& range, std::size_t count,
                                      std::uint64_t seed) {
    Rng rng(seed);
    std::vector<CastQuery> moves(count);
    for (CastQuery& move : moves) {
        move.sphere.radius = rng.uniform(range.radius_low, range.radius_high);
        move.sphere.centre = point_in_air(grid, move.sphere.radius, rng);
        const Vec3 direction = rng.direction();  // one draw a statement: compilers order operands differently
        move.path = direction * rng.uniform(range.length_low, range.length_high);
    }
    return moves;
}

}  // namespace firma::scenes
