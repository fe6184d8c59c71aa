// SPDX-License-Identifier: MIT
// A world's bounds, rooms, solid and tree, for programs and for people.
#include "cli/describe_world.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "cli/numbers.h"
#include "firma/matter.h"
#include "firma/rooms.h"
#include "firma/solid.h"

namespace firma::cli {

namespace {

Json bounds_json(const Box& bounds) {
    if (bounds.empty()) return nullptr;
    return {{"low", bounds.low}, {"high", bounds.high}};
}

Json rooms_json(const World& world) {
    Json rooms = Json::array();
    for (std::uint32_t k = 0; k < world.room_count(); ++k) {
        const RoomInfo room = *room_info(world, RoomId{k});
        Json portals = Json::array();
        for (const PortalId portal : room.portals) portals.push_back(portal.value);
        rooms.push_back({{"id", k},
                         {"name", room.name},
                         {"exterior", room.exterior},
                         {"faces", room.faces},
                         {"bounds", bounds_json(room.bounds)},
                         {"portals", std::move(portals)}});
    }
    return rooms;
}

/// What it is made of; of a table those that it has.
Json matters_json(const World& world) {
    const MatterCounts counts = count_matters(world);
    Json of = Json::array();
    for (std::uint32_t k = 0; k < counts.of_matter.size(); ++k)
        if (counts.of_matter[k] > 0) of.push_back({{"name", matter(world, k).name}, {"pieces", counts.of_matter[k]}});
    return {{"pieces", counts.pieces},
            {"protected", counts.protected_pieces},
            {"rest", matter(world, counts.rest).name},
            {"of", std::move(of)}};
}

Json portals_json(const World& world) {
    Json portals = Json::array();
    for (std::uint32_t k = 0; k < portal_count(world); ++k) {
        const PortalInfo portal = *portal_info(world, PortalId{k});
        portals.push_back({{"id", k},
                           {"name", portal.name},
                           {"rooms", {portal.rooms[0].value, portal.rooms[1].value}},
                           {"open", portal.open},
                           {"polygons", portal.polygons},
                           {"bounds", bounds_json(portal.bounds)}});
    }
    return portals;
}

}  // namespace

void add_world(Json& json, const World& world) {
    json["bounds"] = bounds_json(world.bounds());
    json["rooms"] = rooms_json(world);
    json["portals"] = portals_json(world);
    const TreeStatistics tree = world.statistics();
    json["tree"] = {{"faces", tree.faces},      {"blocks", tree.blocks}, {"bins", tree.nodes},
                    {"leaf_bins", tree.leaves}, {"depth", tree.depth},   {"largest_bin", tree.max_leaf_faces},
                    {"overlap", tree.overlap},  {"bytes", tree.bytes},   {"bytes_per_face", tree.bytes_per_face()}};
    const SolidMeasures solid = measure_solid(world);
    json["solid"] = {{"faces", solid.facets}, {"volume", solid.volume}, {"area", solid.area}};
    json["matter"] = matters_json(world);
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

namespace {

/// "3 pieces: brick 2, wood 1; 1 may not be carved"; "rock"
std::string matters_text(const World& world, const MatterCounts& counts) {
    const auto name = [&](std::uint32_t k) {
        const std::string& text = matter(world, k).name;
        return text.empty() ? "other" : text;
    };
    if (counts.pieces == 0) return name(counts.rest);
    std::string text = counted(counts.pieces, "piece");
    const char* between = ": ";
    for (std::uint32_t k = 0; k < counts.of_matter.size(); ++k) {
        if (counts.of_matter[k] == 0) continue;
        text += between + name(k) + " " + grouped(counts.of_matter[k]);
        between = ", ";
    }
    if (counts.protected_pieces > 0) text += fmt::format("; {} may not be carved", grouped(counts.protected_pieces));
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
    if (const MatterCounts matters = count_matters(world); matters.pieces > 0 || matters.rest != 0)
        text += info_row("matter", matters_text(world, matters));
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
