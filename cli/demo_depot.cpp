// SPDX-License-Identifier: MIT
// Where things stand in tools/depot, in metres: 32 units are one.
#include "cli/demo_depot.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "cli/fire_blast.h"
#include "cli/numbers.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"

namespace firma::cli {

namespace {

// The bridge lies along y between the hall's walls at 0 and 14.
constexpr Vec3 kBridge{14, 7, 3.75}, kUnderBridge{14, 7, 1.5}, kBridgeEnds[] = {{14, 2, 3.75}, {14, 12, 3.75}};
constexpr double kBridgeRadius = 2.2;
constexpr std::uint64_t kBridgeSeed = 3;
constexpr double kDensity = 2400;  // of concrete, kg/m3

// The wall lies across x from 6.25 to 6.3125.
constexpr Vec3 kWall{6.28125, 18, 1.5}, kWestOfWall{3, 18, 1.5}, kEastOfWall{9, 18, 1.5}, kThroughWall{12, 0, 0};
constexpr double kHoleRadius = 0.5;
constexpr std::uint64_t kHoleSeed = 7;

std::string_view name_at(const World& world, const Vec3& point) {
    const std::optional<RoomInfo> room = room_info(world, locate(world, point).room);
    return room ? room->name : "";
}

Fired shoot(World& world, const Vec3& at, double radius, std::uint64_t seed) {
    FireOptions options;
    options.carve.chunks = ChunkOptions{.density = kDensity};
    Pose pose;
    pose.position = at;
    pose.scale = radius;
    return fire_cut(world, make_crater(CutterShape::kRocky, seed), pose, options);
}

DemoBridge shoot_bridge(World& world) {
    DemoBridge bridge;
    for (const Vec3& end : kBridgeEnds) {
        const Fired fired = shoot(world, end, kBridgeRadius, kBridgeSeed);
        ++bridge.shots;
        bridge.seconds += fired.seconds;
        bridge.chunks += fired.result.report.chunks;
        bridge.crumbs += fired.result.report.crumbs;
        for (const Chunk& chunk : fired.result.chunks) {
            bridge.volume += chunk.mass.volume;
            bridge.mass += chunk.mass.mass;
            if (chunk.mass.mass <= bridge.largest_mass) continue;
            bridge.largest_mass = chunk.mass.mass;
            bridge.largest_volume = chunk.mass.volume;
            bridge.centre = chunk.origin + chunk.mass.centre;
        }
    }
    return bridge;
}

/// Goes from room to room by portals, as a walker's would.
DemoSight look_through_wall(const World& world) {
    CastOptions options;
    options.room = kLocateRoom;
    const Hit hit = cast(world, Ray{kWestOfWall, kThroughWall}, options);
    if (!hit.touched()) return {};
    const std::optional<RoomInfo> room = room_info(world, room_of(world, hit));
    return {length(kThroughWall) * hit.fraction, world.material_name(hit.material),
            std::string(room ? room->name : "")};
}

double area_of(const std::vector<Vec3>& polygon) {
    Vec3 sum;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum = sum + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return length(sum) / 2;
}

DemoHole shoot_wall(World& world) {
    DemoHole hole;
    hole.before = look_through_wall(world);
    const std::size_t portals = portal_count(world);
    const Fired fired = shoot(world, kWall, kHoleRadius, kHoleSeed);
    hole.seconds = fired.seconds;
    hole.portals = fired.result.report.portals;
    hole.after = look_through_wall(world);
    if (portal_count(world) == portals) return hole;
    hole.portal = {std::uint32_t(portals)};
    const std::optional<PortalInfo> info = portal_info(world, hole.portal);
    for (int side = 0; side < 2; ++side)
        if (const auto room = room_info(world, info->rooms[std::size_t(side)])) hole.rooms[side] = room->name;
    for (const std::vector<Vec3>& polygon : portal_polygons(world, hole.portal)) hole.area += area_of(polygon);
    return hole;
}

std::string bridge_text(const DemoBridge& bridge) {
    if (bridge.chunks == 0) return "nothing came loose";
    const Vec3& centre = bridge.centre;
    return fmt::format(
        "a chunk of {:.2f} cubic metres, {} kg, around ({:.1f}, {:.1f}, {:.1f}) leaves, and {} of the rails; {}",
        bridge.largest_volume, grouped(std::uint64_t(std::llround(bridge.largest_mass))), centre.x, centre.y, centre.z,
        grouped(bridge.chunks - 1), seconds_text(bridge.seconds));
}

std::string sight_text(const DemoSight& sight) {
    if (sight.material.empty()) return "nothing";
    return fmt::format("{} in {} after {:.2f} m", sight.material, sight.room, sight.distance);
}

Json sight_json(const DemoSight& sight) {
    return {{"distance", sight.distance}, {"material", sight.material}, {"room", sight.room}};
}

}  // namespace

bool is_depot(const World& world) {
    return name_at(world, kUnderBridge) == "hall" && name_at(world, kWestOfWall) == "office_west" &&
           name_at(world, kEastOfWall) == "office_middle" && locate(world, kBridge).where == Where::kSolid &&
           locate(world, kWall).where == Where::kSolid;
}

std::optional<DemoDepot> shoot_depot(const World& world) {
    if (!is_depot(world)) return {};
    DemoDepot depot;
    depot.after = world;
    depot.bridge = shoot_bridge(depot.after);
    depot.hole = shoot_wall(depot.after);
    return depot;
}

draw::Camera depot_camera() {
    draw::Camera camera;
    camera.eye = {10.5, 13.2, 5.9};
    camera.target = {17, 2, 2};
    return camera;
}

std::string depot_text(const DemoDepot& depot) {
    const DemoBridge& bridge = depot.bridge;
    const DemoHole& hole = depot.hole;
    const auto row = [](const char* what, const std::string& value) { return fmt::format("{:<24} {}\n", what, value); };
    std::string text = row("the bridge's both ends", bridge_text(bridge));
    text +=
        row("a hole in a thin wall",
            hole.portals == 0 ? "no portal was made"
                              : fmt::format("portal {} between {} and {}, {:.2f} square metres; {}", hole.portal.value,
                                            hole.rooms[0], hole.rooms[1], hole.area, seconds_text(hole.seconds)));
    return text + row("a cast at it",
                      fmt::format("met {} before, meets {} now", sight_text(hole.before), sight_text(hole.after)));
}

Json depot_json(const std::optional<DemoDepot>& depot) {
    if (!depot) return {};
    const DemoBridge& bridge = depot->bridge;
    const DemoHole& hole = depot->hole;
    Json json;
    json["bridge"] = {
        {"shots", bridge.shots},
        {"ms", 1e3 * bridge.seconds},
        {"chunks", bridge.chunks},
        {"crumbs", bridge.crumbs},
        {"volume", bridge.volume},
        {"mass", bridge.mass},
        {"largest", {{"volume", bridge.largest_volume}, {"mass", bridge.largest_mass}, {"centre", bridge.centre}}}};
    json["hole"] = {{"ms", 1e3 * hole.seconds},
                    {"portals", hole.portals},
                    {"portal", hole.portal.valid() ? Json(hole.portal.value) : Json()},
                    {"rooms", {hole.rooms[0], hole.rooms[1]}},
                    {"area", hole.area},
                    {"before", sight_json(hole.before)},
                    {"after", sight_json(hole.after)}};
    return json;
}

}  // namespace firma::cli
