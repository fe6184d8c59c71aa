// SPDX-License-Identifier: MIT
// A world's bounds, rooms, solid and tree, for programs and for people.
#include "cli/describe_world.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/numbers.h"
#include "firma/rooms.h"
#include "firma/solid.h"

namespace firma::cli {

namespace {

void add_bounds(JsonWriter& json, const Box& bounds) {
    if (bounds.empty()) {
        json.add_null("bounds");
        return;
    }
    json.open_object("bounds");
    json.add("low", bounds.low);
    json.add("high", bounds.high);
    json.close();
}

void add_rooms(JsonWriter& json, const World& world) {
    json.open_array("rooms");
    for (std::uint32_t k = 0; k < world.room_count(); ++k) {
        const RoomInfo room = *room_info(world, RoomId{k});
        json.open_object();
        json.add("id", k);
        json.add("name", room.name);
        json.add("exterior", room.exterior);
        json.add("faces", room.faces);
        add_bounds(json, room.bounds);
        json.open_array("portals");
        for (const PortalId portal : room.portals) json.add({}, portal.value);
        json.close();
        json.close();
    }
    json.close();
    json.open_array("portals");
    for (std::uint32_t k = 0; k < portal_count(world); ++k) {
        const PortalInfo portal = *portal_info(world, PortalId{k});
        json.open_object();
        json.add("id", k);
        json.add("name", portal.name);
        json.open_array("rooms");
        for (const RoomId room : portal.rooms) json.add({}, room.value);
        json.close();
        json.add("open", portal.open);
        json.add("polygons", portal.polygons);
        add_bounds(json, portal.bounds);
        json.close();
    }
    json.close();
}

}  // namespace

void add_world(JsonWriter& json, const World& world) {
    add_bounds(json, world.bounds());
    add_rooms(json, world);
    const TreeStatistics tree = world.statistics();
    json.open_object("tree");
    json.add("faces", tree.faces);
    json.add("blocks", tree.blocks);
    json.add("bins", tree.nodes);
    json.add("leaf_bins", tree.leaves);
    json.add("depth", tree.depth);
    json.add("largest_bin", tree.max_leaf_faces);
    json.add("overlap", tree.overlap);
    json.add("bytes", tree.bytes);
    json.add("bytes_per_face", tree.bytes_per_face());
    json.close();
    const SolidMeasures solid = measure_solid(world);
    json.open_object("solid");
    json.add("faces", solid.facets);
    json.add("volume", solid.volume);
    json.add("area", solid.area);
    json.close();
}

std::string info_row(const char* what, const std::string& value) {
    return fmt::format("{:<16}{}\n", what, value);
}

namespace {

/// "23, one of them the exterior; 35 portals between them"
std::string rooms_text(const World& world) {
    std::string text = grouped(world.room_count());
    bool exterior = false;
    for (std::uint32_t k = 0; k < world.room_count(); ++k) exterior = exterior || room_info(world, RoomId{k})->exterior;
    if (exterior && world.room_count() > 1) text += ", one of them the exterior";
    if (const std::size_t portals = portal_count(world); portals > 0)
        text += fmt::format("; {} between them", counted(portals, "portal"));
    return text;
}

}  // namespace

std::string world_text(const World& world) {
    std::string text;
    if (const Box bounds = world.bounds(); !bounds.empty()) {
        const Vec3 size = bounds.high - bounds.low;
        text += info_row("bounds", fmt::format("({}, {}, {}) .. ({}, {}, {}) m", bounds.low.x, bounds.low.y,
                                               bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z));
        text += info_row("size", fmt::format("{} x {} x {} m", size.x, size.y, size.z));
    }
    text += info_row("rooms", rooms_text(world));
    const SolidMeasures solid = measure_solid(world);
    text += info_row("solid", solid.facets == 0 ? "no face bounds a solid"
                                                : fmt::format("{} faces bound {:.6g} m3 of {}, by {:.6g} m2",
                                                              grouped(solid.facets), std::fabs(solid.volume),
                                                              solid.volume < 0 ? "air" : "rock", solid.area));
    const TreeStatistics tree = world.statistics();
    text += info_row(
        "tree",
        fmt::format("{} nodes, {} of them leaves, in {} blocks; depth {}; fullest leaf {} faces; overlap {:.3f}",
                    grouped(tree.nodes), grouped(tree.leaves), grouped(tree.blocks), tree.depth,
                    grouped(tree.max_leaf_faces), tree.overlap));
    text += info_row("memory", fmt::format("{}, {:.0f} bytes a face", bytes_text(tree.bytes), tree.bytes_per_face()));
    return text;
}

}  // namespace firma::cli
