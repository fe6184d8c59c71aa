// SPDX-License-Identifier: MIT
// Judges the rooms of a world.
#include "tests/reference/judge_rooms.h"
#include "firma/queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/reference/carve_oracle.h"
#include "tests/reference/directed_edges.h"
#include "tests/reference/facet_corners.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

std::string text_of(const Vec3& v) {
    char text[100];
    std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
    return text;
}

std::string text_of(const Location& where) {
    if (where.where == Where::kAir) return "in room " + std::to_string(where.room.value);
    return where.where == Where::kSolid ? "in the solid" : "nowhere it is sure of";
}

bool box_holds(const Box& box, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.low[axis] <= point[axis] && point[axis] <= box.high[axis])) return false;
    return true;
}

}  // namespace

bool same_hit(const Hit& a, const Hit& b) {
    return a.status == b.status && a.feature == b.feature && a.feature_index == b.feature_index &&
           a.fraction == b.fraction && a.safe_fraction == b.safe_fraction && a.centre == b.centre &&
           a.point == b.point && a.normal == b.normal && a.face_normal == b.face_normal && a.face == b.face &&
           a.material == b.material && a.portal == b.portal;
}

std::string unclosed_room(const World& world) {
    const Cells& cells = world.data().cells;
    std::vector<DirectedEdges> edges(world.room_count());
    for (std::uint32_t room = 0; room < world.room_count(); ++room)
        for (const FacetPlace& place : facets_of_room(world, room))
            if (place.record().solid) edges[room].add(place);
    for (std::uint32_t k = 0; k < cells.portal_count(); ++k) {
        const Portal& portal = cells.portal(k);
        if (portal.gone()) continue;
        const std::array<RoomId, 2> rooms = cells.rooms_of(portal);
        for (const PortalPolygon& polygon : portal.all_polygons()) {
            std::vector<GridPoint> corners(polygon.corners.begin(), polygon.corners.end());
            edges[rooms[0].value].add(corners);
            std::reverse(corners.begin(), corners.end());
            edges[rooms[1].value].add(corners);
        }
    }
    for (std::uint32_t room = 0; room < edges.size(); ++room)
        if (const std::string open = edges[room].first_open(); !open.empty())
            return "around room " + std::to_string(room) + " there is an " + open;
    return "";
}

std::vector<bool> closed_rooms(const World& world) {
    std::vector<bool> closed;
    for (std::uint32_t k = 0; k < world.room_count(); ++k) {
        bool open = !world.data().cells.known() && !world.data().rock_outside();
        for (std::uint32_t other = 0; other < world.room_count() && !open; ++other)
            open = room_info(world, {other})->exterior && find_path(world, {k}, {other}, Doors::kAllOpen).has_value();
        closed.push_back(!open);
    }
    return closed;
}

RoomBounds::RoomBounds(const World& world) : world_(world), rooms_(world.room_count()) {
    for (std::uint32_t room = 0; room < rooms_.size(); ++room) {
        rooms_[room].facets = facets_of_room(world, room);
        rooms_[room].exterior =
            world.data().cells.known() ? room_info(world, {room})->exterior : !world.data().rock_outside();
    }
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal) {
        const PortalInfo info = *portal_info(world, {portal});
        for (std::vector<Vec3> polygon : portal_polygons(world, {portal})) {
            rooms_[info.rooms[0].value].portals.push_back(polygon);
            std::reverse(polygon.begin(), polygon.end());
            rooms_[info.rooms[1].value].portals.push_back(std::move(polygon));
        }
    }
    for (Bounds& bounds : rooms_) {
        for (const FacetPlace& place : bounds.facets)
            for (const GridPoint& corner : grid_corners_of(place)) bounds.box.add(to_metres(corner));
        for (const std::vector<Vec3>& polygon : bounds.portals)
            for (const Vec3& corner : polygon) bounds.box.add(corner);
    }
}

std::string RoomBounds::judge(const Vec3& point, Location* found) const {
    Location where{Where::kSolid, {}};
    for (std::uint32_t room = 0; room < rooms_.size(); ++room) {
        const Bounds& bounds = rooms_[room];
        if (!bounds.exterior && !box_holds(bounds.box, point)) continue;
        // Fronts look into the room: its boundary winds -1 times around what is in it.
        double in = bounds.exterior - winding(bounds.facets, point);
        for (const std::vector<Vec3>& polygon : bounds.portals) in -= winding(polygon, point);
        if (std::fabs(in) < 1e-3) continue;
        if (std::fabs(in - 1) > 1e-3)
            return "room " + std::to_string(room) + " lies " + std::to_string(in) + " times around " + text_of(point);
        if (where.where == Where::kAir)
            return "two rooms, " + std::to_string(where.room.value) + " and " + std::to_string(room) + ", lie around " +
                   text_of(point);
        where = {Where::kAir, {room}};
    }
    if (found) *found = where;
    const Location said = locate(world_, point);
    if (said == where) return "";
    return text_of(point) + " lies " + text_of(where) + ", and locate() says " + text_of(said);
}

std::string judge_way(const World& world, const Vec3& from, const Vec3& to) {
    const Location start = locate(world, from), end = locate(world, to);
    if (start.where != Where::kAir || (end.where != Where::kAir && end.where != Where::kSolid)) return {};
    CastOptions options;
    options.room = start.room;
    std::array<RoomId, 256> passed;
    RoomTrail trail{passed};
    options.trail = &trail;
    const Hit hit = cast(world, {from, 0}, to - from, options);
    if (hit.touched()) return {};
    for (std::size_t k = 0; k < std::min<std::size_t>(trail.count, passed.size()); ++k)
        if (passed[k] == end.room) return {};
    return (end.where == Where::kSolid ? "a way into the solid meets nothing: from "
                                       : "a way through the air to another room passes no portal into it: from ") +
           text_of(from) + " to " + text_of(to);
}

std::string judge_cast_by_room(const World& world, const Sphere& sphere, const Vec3& path,
                               std::uint32_t& rooms_passed) {
    rooms_passed = 0;
    const Location start = locate(world, sphere.centre);
    if (start.where != Where::kAir || closest(world, sphere.centre, sphere.radius + 1e-5)) return "";
    RoomTrail trail;
    const Hit all = cast(world, sphere, path),
              by_room = cast(world, sphere, path, {.room = start.room, .trail = &trail});
    rooms_passed = trail.count;
    if (same_hit(all, by_room)) return "";
    char radius[40];
    std::snprintf(radius, sizeof radius, "%.17g", sphere.radius);
    return "a cast by room is another one: from " + text_of(sphere.centre) + " radius " + radius + " by " +
           text_of(path);
}

}  // namespace firma::reference
