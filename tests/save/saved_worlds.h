// SPDX-License-Identifier: MIT
// Worlds to be saved, cut and uncut, and files to be damaged on purpose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/save.h"
#include "save/crc32c.h"
#include "save/sections.h"
#include "scenes/rng.h"
#include "tests/world/two_halves.h"

namespace firma {

/// Adds a box to an .obj, its fronts outward, or inward for a room.
inline void add_box(std::string& text, const Vec3& low, const Vec3& high, bool room) {
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(k & 1 ? high.x : low.x) + " " + std::to_string(k & 2 ? high.y : low.y) + " " +
                std::to_string(k & 4 ? high.z : low.z) + "\n";
    constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : kSides) {
        text += "f";
        for (int k = 0; k < 4; ++k) text += " " + std::to_string(side[room ? 3 - k : k] - 8);
        text += "\n";
    }
}

inline World world_of(const std::string& text, const WorldOptions& options = {}) {
    return make_world(read_obj(text, "level").value(), options).value();
}

/// A room of 8 m in endless rock, with a pillar; two materials.
inline World room_world(const WorldOptions& options = {}) {
    std::string text = "usemtl rock\n";
    add_box(text, {-4, -4, -2}, {4, 4, 2}, true);
    text += "usemtl pillar\n";
    add_box(text, {-1, -1, -1}, {1, 0, 1}, false);
    return world_of(text, options);
}

/// A crater where a ray from within the world's bounds meets it.
inline bool cut_somewhere(World& world, scenes::Rng& rng, double radius, const char* material = "crater") {
    const Box bounds = world.bounds();
    Vec3 from, way;
    for (int axis = 0; axis < 3; ++axis) from[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
    for (int axis = 0; axis < 3; ++axis) way[axis] = rng.uniform(-1, 1);
    const Hit hit = cast(world, {from, 0}, way * 1000);
    const std::uint64_t seed = rng.next();
    if (!hit.touched()) return false;
    Pose pose;
    pose.position = hit.point;
    pose.scale = radius * rng.uniform(0.5, 1.5);
    constexpr CutterShape kShapes[] = {CutterShape::kRocky, CutterShape::kDrill, CutterShape::kBox,
                                       CutterShape::kWedge, CutterShape::kBox,   CutterShape::kWedge,
                                       CutterShape::kBox,   CutterShape::kWedge};
    const CutterShape shape = kShapes[seed % 8];  // mostly small ones
    const CarveResult result = carve(world, make_crater(shape, seed), pose, {material});
    world = result.world;
    return result.done();
}

inline World cut_room(int tries, std::uint64_t seed, double radius = 0.7) {
    World world = room_world();
    scenes::Rng rng(seed);
    for (int k = 0; k < tries; ++k) cut_somewhere(world, rng, radius);
    return world;
}

/// Small enough to try everything on.
inline World tiny_world() {
    World world = room_world();
    Pose pose;
    pose.position = {0, 4, 0};
    pose.scale = 0.5;
    return carve(world, make_crater(CutterShape::kWedge, 1), pose, {"crater"}).world;
}

/// A wall with a picture, one whose picture has two parts, and one without.
inline World papered_world() {
    return world_of(
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 4\nv 4 0 4\nv 0 4 4\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.75\n"
        "usemtl paper\nf 1/1 2/2 3/3 4/4\nf 2/1 1/2 5/5 6/4\nf 1 4 7 5\n");
}

/// Two rooms with names, a closed door between them, and a portal that is gone.
inline World two_rooms() {
    WorldParts parts = two_halves_parts();
    parts.rooms[0].name = "hall";
    parts.rooms[1].name = "a room whose name is too long to be kept within a string";
    parts.portals[0].open = false;
    PortalPart gone;
    gone.rooms = {RoomId{1}, RoomId{1}};
    parts.portals.push_back(gone);
    return assemble_world(std::move(parts)).value();
}

// ---- files ----

inline void put_u32(std::vector<std::byte>& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = std::byte(value >> 8 * k & 255);
}

/// Where the content of a section lies, by its number in the table.
struct SectionPlace {
    SectionType type = 0;
    std::size_t entry = 0;  ///< in the table
    std::size_t first = 0, length = 0;
};

inline std::vector<SectionPlace> section_places(std::span<const std::byte> bytes) {
    std::vector<SectionPlace> places;
    for (std::size_t k = 0; k < read_u32(bytes.data() + 12); ++k) {
        const std::size_t entry = kHeadBytes + k * kTableEntryBytes;
        const std::byte* at = bytes.data() + entry;
        places.push_back({read_u32(at), entry, std::size_t(read_u64(at + 8)), std::size_t(read_u64(at + 16))});
    }
    return places;
}

/// Makes all checksums right again, of a file whose table is whole.
inline void fix_checksums(std::vector<std::byte>& bytes) {
    const std::span<const std::byte> all(bytes);
    const std::vector<SectionPlace> places = section_places(bytes);
    for (const SectionPlace& place : places)
        put_u32(bytes, place.entry + 24, crc32c(all.subspan(place.first, place.length)));
    put_u32(bytes, 28, crc32c(all.subspan(kHeadBytes, places.size() * kTableEntryBytes), crc32c(all.first(28))));
}

}  // namespace firma
