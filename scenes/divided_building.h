// SPDX-License-Identifier: MIT
// A building of rooms in a grid, divided by portals: doorways, some of them rooms of their own, and rooms that portals
// in mid-air divide into halves and quarters; in rock, or standing in the open, with doors outside.
//
// Walls are panels of a metre, on a lattice whose corners are moved by up to `jitter`, except where rooms meet: so
// portals are plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firma/level.h"
#include "scenes/rng.h"
#include "world/assemble_world.h"

namespace firma::scenes {

struct BuildingPlan {
    int rooms_x = 2, rooms_y = 2, rooms_z = 1;
    double jitter = 0.15;   ///< metres, each way
    bool outdoors = false;  ///< air around it instead of rock
    double closed = 0;      ///< share of portals that are closed
    std::uint64_t seed = 1;
};

class DividedBuilding {
public:
    static constexpr int kRock = -1;

    explicit DividedBuilding(const BuildingPlan& plan);

    /// All its faces, as of one room.
    const Level& level() const { return level_; }
    /// The same faces, ids and order, by rooms, with portals.
    WorldParts parts() const;
    int rooms() const { return rooms_; }

    /// The room of the cell that a point lies in, or kRock; nothing so near to a wall that its jitter may decide.
    std::optional<int> room_at(const Vec3& point) const;

    /// In the air, `clearance` away from all walls; now and then right beside a portal, or on one.
    Vec3 point_in_air(double clearance, Rng& rng) const;

private:
    using Cell = std::array<int, 3>;

    int room_of(Cell cell) const;
    bool is_free(const Vec3& point, double clearance) const;
    void set(Cell from, Cell extent, int room);
    void dig_room(Cell room, Rng& rng);
    void dig_doorway(Cell from, Cell extent, Rng& rng);
    void add_faces();
    void add_panel(Cell cell, int axis, int side, int room);
    void add_portal_square(Cell cell, int axis, int room, int beyond);
    std::array<Cell, 4> square(Cell cell, int axis, int side) const;
    GridPoint lattice_point(Cell at) const;
    std::uint32_t vertex(Cell at);

    BuildingPlan plan_;
    Cell size_;
    int rooms_ = 0;
    std::vector<int> cells_;
    Level level_;
    std::vector<int> room_of_face_;
    std::vector<std::uint32_t> vertex_at_;
    std::vector<PortalPart> portals_;
    std::vector<std::array<int, 4>> portal_keys_;  ///< rooms, axis, place
    std::vector<Vec3> beside_portals_;
};

}  // namespace firma::scenes
