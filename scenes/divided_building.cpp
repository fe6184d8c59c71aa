// SPDX-License-Identifier: MIT
// A building divided by portals.
#include "scenes/divided_building.h"

#include <algorithm>
#include <cmath>

#include "level/find_solids.h"

namespace firma::scenes {
namespace {

constexpr std::array<int, 3> kAirOfRoom{4, 4, 3};  // metres of air
/// Lattice points outside the building, each way, where it stands in the open.
constexpr int kOutdoorReach = 4;

}  // namespace

DividedBuilding::DividedBuilding(const BuildingPlan& plan) : plan_(plan) {
    const Cell rooms{plan.rooms_x, plan.rooms_y, plan.rooms_z};
    for (int axis = 0; axis < 3; ++axis) size_[axis] = rooms[axis] * (kAirOfRoom[axis] + 1) + 1;
    cells_.assign(std::size_t(size_[0]) * size_[1] * size_[2], kRock);
    vertex_at_.assign(std::size_t(size_[0] + 1) * (size_[1] + 1) * (size_[2] + 1), ~0u);
    if (plan.outdoors) rooms_ = 1;
    Rng rng(plan.seed);
    for (int z = 0; z < rooms[2]; ++z)
        for (int y = 0; y < rooms[1]; ++y)
            for (int x = 0; x < rooms[0]; ++x) dig_room({x, y, z}, rng);
    add_faces();
    for (PortalPart& portal : portals_) portal.open = !rng.chance(plan.closed);
}

int DividedBuilding::room_of(Cell cell) const {
    for (int axis = 0; axis < 3; ++axis)
        if (cell[axis] < 0 || cell[axis] >= size_[axis]) return plan_.outdoors ? 0 : kRock;
    return cells_[(std::size_t(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0]];
}

void DividedBuilding::set(Cell from, Cell extent, int room) {
    for (int z = from[2]; z < from[2] + extent[2]; ++z)
        for (int y = from[1]; y < from[1] + extent[1]; ++y)
            for (int x = from[0]; x < from[0] + extent[0]; ++x)
                cells_[(std::size_t(z) * size_[1] + y) * size_[0] + x] = room;
}

/// A doorway belongs to the room that it leads from, or is one.
void DividedBuilding::dig_doorway(Cell from, Cell extent, Rng& rng) {
    if (!rng.chance(0.75)) return;
    int room = rooms_;
    if (rng.chance(0.5)) {
        Cell before = from;
        for (int axis = 0; axis < 3; ++axis)
            if (extent[axis] == 1) --before[axis];
        room = room_of(before);
        if (room == kRock) return;
    } else {
        ++rooms_;
    }
    set(from, extent, room);
}

void DividedBuilding::dig_room(Cell place, Rng& rng) {
    Cell at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = place[axis] * (kAirOfRoom[axis] + 1) + 1;
    const auto [x, y, z] = at;
    const int pieces_x = rng.chance(0.4) ? 2 : 1, pieces_y = 1 + int(place[0] + place[1]) % 2;
    for (int j = 0; j < pieces_y; ++j)
        for (int i = 0; i < pieces_x; ++i)
            set({x + i * 2, y + j * 2, z}, {4 / pieces_x, 4 / pieces_y, kAirOfRoom[2]}, rooms_++);
    // Within the half of the wall that one piece has, so that a doorway has one room on each side.
    const auto along = [&] { return rng.chance(0.5) ? 0 : 2; };
    const int a = along(), b = along(), c = int(rng.below(4)), d = int(rng.below(4));
    if (place[0] + 1 < plan_.rooms_x || plan_.outdoors) dig_doorway({x + 4, y + a, z}, {1, 2, 2}, rng);
    if (place[1] + 1 < plan_.rooms_y || plan_.outdoors) dig_doorway({x + b, y + 4, z}, {2, 1, 2}, rng);
    if (place[2] + 1 < plan_.rooms_z) dig_doorway({x + c, y + d, z + kAirOfRoom[2]}, {1, 1, 1}, rng);
}

void DividedBuilding::add_faces() {
    level_.name = "divided_building";
    level_.materials = {"wall", "door"};
    level_.groups = {""};
    for (int z = -1; z <= size_[2]; ++z)
        for (int y = -1; y <= size_[1]; ++y)
            for (int x = -1; x <= size_[0]; ++x)
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {0, 1}) {
                        const Cell cell{x, y, z};
                        Cell next = cell;
                        next[axis] += side == 0 ? -1 : 1;
                        const int room = room_of(cell), beyond = room_of(next);
                        if (room == kRock || room == beyond) continue;
                        if (beyond == kRock)
                            add_panel(cell, axis, side, room);
                        else if (side == 1)
                            add_portal_square(cell, axis, room, beyond);
                    }
    level_.source_faces = std::uint32_t(level_.faces.size());
}

/// The corners of one side of a cell, counter-clockwise seen from within.
std::array<DividedBuilding::Cell, 4> DividedBuilding::square(Cell cell, int axis, int side) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    cell[axis] += side;
    std::array<Cell, 4> corner{cell, cell, cell, cell};
    ++corner[1][u];
    ++corner[2][u];
    ++corner[2][v];
    ++corner[3][v];
    if (side == 1) std::swap(corner[1], corner[3]);
    return corner;
}

void DividedBuilding::add_panel(Cell cell, int axis, int side, int room) {
    std::array<std::uint32_t, 4> corner;
    const std::array<Cell, 4> at = square(cell, axis, side);
    for (int k = 0; k < 4; ++k) corner[k] = vertex(at[k]);
    const auto add = [&](std::initializer_list<std::uint32_t> corners) {
        LevelFace face;
        face.first_corner = std::uint32_t(level_.corners.size());
        face.corner_count = std::uint32_t(corners.size());
        face.source = std::uint32_t(level_.faces.size());
        level_.corners.insert(level_.corners.end(), corners);
        level_.faces.push_back(face);
        room_of_face_.push_back(room);
    };
    if (plan_.jitter == 0) return add({corner[0], corner[1], corner[2], corner[3]});
    if (Rng(corner[0] * 31ull + corner[2]).chance(0.5)) {
        add({corner[0], corner[1], corner[2]});
        add({corner[0], corner[2], corner[3]});
    } else {
        add({corner[0], corner[1], corner[3]});
        add({corner[1], corner[2], corner[3]});
    }
}

/// Squares of two rooms in one plane are one portal.
void DividedBuilding::add_portal_square(Cell cell, int axis, int room, int beyond) {
    const std::array<int, 4> key{room, beyond, axis, cell[axis]};
    const auto found = std::find(portal_keys_.begin(), portal_keys_.end(), key);
    const auto index = std::size_t(found - portal_keys_.begin());
    if (found == portal_keys_.end()) {
        portal_keys_.push_back(key);
        PortalPart portal;
        portal.rooms = {RoomId{std::uint32_t(room)}, RoomId{std::uint32_t(beyond)}};
        portal.name = "portal " + std::to_string(index);
        portal.material = 1;
        portals_.push_back(portal);
    }
    std::vector<GridPoint> polygon;
    Vec3 middle;
    for (const Cell& at : square(cell, axis, 1)) {
        polygon.push_back(lattice_point(at));
        middle = middle + to_metres(polygon.back()) * 0.25;
    }
    portals_[index].polygons.push_back(polygon);
    beside_portals_.push_back(middle);
}

GridPoint DividedBuilding::lattice_point(Cell at) const {
    // Not where rooms meet.
    int first = kRock;
    bool moves = true;
    for (int k = 0; k < 8; ++k) {
        const int room = room_of({at[0] - (k & 1), at[1] - (k >> 1 & 1), at[2] - (k >> 2)});
        if (room == kRock) continue;
        if (first == kRock) first = room;
        moves &= room == first;
    }
    Rng rng(Rng(std::uint64_t(at[0] + 9) << 40 | std::uint64_t(at[1] + 9) << 20 | std::uint64_t(at[2] + 9)).next() ^
            plan_.seed);
    GridPoint point;
    for (int axis = 0; axis < 3; ++axis) {
        const double metres = at[axis] + (moves ? plan_.jitter : 0) * rng.uniform(-1, 1);
        point[axis] = std::int32_t(std::lround(metres * kInputSteps)) * kSurfacePerInput;
    }
    return point;
}

std::uint32_t DividedBuilding::vertex(Cell at) {
    std::uint32_t& known = vertex_at_[(std::size_t(at[2]) * (size_[1] + 1) + at[1]) * (size_[0] + 1) + at[0]];
    if (known == ~0u) {
        known = std::uint32_t(level_.vertices.size());
        level_.vertices.push_back(lattice_point(at));
    }
    return known;
}

WorldParts DividedBuilding::parts() const {
    WorldParts parts;
    parts.name = level_.name;
    parts.materials = level_.materials;
    parts.rock_outside = !plan_.outdoors;
    parts.portals = portals_;
    parts.rooms.resize(std::size_t(rooms_));
    for (int room = 0; room < rooms_; ++room) parts.rooms[room].name = "room " + std::to_string(room);
    parts.rooms[0].exterior = plan_.outdoors;
    const LevelSolids solids = find_solids(level_);
    auto stored = solids.stored.begin();
    for (std::uint32_t k = 0; k < level_.faces.size(); ++k) {
        const LevelFace& face = level_.faces[k];
        FaceSet& set = parts.rooms[room_of_face_[k]].faces;
        set.faces.push_back({.id = {k},
                             .source = face.source,
                             .material = face.material,
                             .mask = face.mask,
                             .first_corner = std::uint32_t(set.corners.size()),
                             .corner_count = face.corner_count,
                             .two_sided = face.two_sided,
                             .solid = solids.solid[k]});
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(level_.vertices[level_.corners[face.first_corner + c]]);
        }
        if (stored == solids.stored.end() || stored->first != k) continue;
        set.faces.back().owner = stored->second.get();
        set.owners.emplace_back(stored->second.get());
        ++stored;
    }
    return parts;
}

std::optional<int> DividedBuilding::room_at(const Vec3& point) const {
    const auto cell_of = [](const Vec3& p) {
        return Cell{int(std::floor(p.x)), int(std::floor(p.y)), int(std::floor(p.z))};
    };
    const int room = room_of(cell_of(point));
    const double reach = plan_.jitter + 1e-6;
    for (int k = 0; k < 8; ++k) {
        const Vec3 away{k & 1 ? reach : -reach, k & 2 ? reach : -reach, k & 4 ? reach : -reach};
        if ((room_of(cell_of(point + away)) == kRock) != (room == kRock)) return {};
    }
    return room;
}

bool DividedBuilding::is_free(const Vec3& point, double clearance) const {
    const double reach = plan_.jitter + clearance + 1e-3;
    Cell low{}, high{};
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = int(std::floor(point[axis] - reach));
        high[axis] = int(std::floor(point[axis] + reach));
    }
    for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int x = low[0]; x <= high[0]; ++x)
                if (room_of({x, y, z}) == kRock) return false;
    return true;
}

Vec3 DividedBuilding::point_in_air(double clearance, Rng& rng) const {
    const double out = plan_.outdoors ? kOutdoorReach : 0;
    for (;;) {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(-out, size_[axis] + out);
        if (!beside_portals_.empty() && rng.chance(0.4)) {
            point = beside_portals_[rng.below(std::uint32_t(beside_portals_.size()))];
            const double away = rng.chance(0.3) ? 0 : rng.chance(0.5) ? 1e-9 : 0.6;
            for (int axis = 0; axis < 3; ++axis) point[axis] += rng.uniform(-away, away);
        }
        if (is_free(point, clearance)) return point;
    }
}

}  // namespace firma::scenes
