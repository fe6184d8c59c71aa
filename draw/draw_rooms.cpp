// SPDX-License-Identifier: MIT
// Labels stand where the square around them that is all of one room is largest; portals are outlines, and lines where
// they are seen edge-on.
#include "draw/draw_rooms.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/room_colours.h"

namespace firma::draw {
namespace {

constexpr double kLetter = 5.6;    // pixels, of a name, about
constexpr int kLeastReach = 3;     // squares around a number, to each side
constexpr int kNameReach = 4;      // likewise around a number and a name
constexpr double kLineWidth = 14;  // pixels from the number down to the name

/// How many squares to each side of one are of the same room, itself counted: the largest square around it.
std::vector<int> reach_of(const PlanRaster& raster, const std::vector<std::uint32_t>& room) {
    std::vector<int> reach(room.size());
    const auto step = [&](int x, int y, int side) {  // from the three neighbours on one side, and one beside
        const std::size_t here = raster.at(x, y);
        int least = reach[here];
        for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(-1, -1), std::pair(0, -1), std::pair(1, -1)}) {
            const int a = x + side * dx, b = y + side * dy;
            const bool same =
                a >= 0 && b >= 0 && a < raster.width && b < raster.height && room[raster.at(a, b)] == room[here];
            least = std::min(least, same ? reach[raster.at(a, b)] + 1 : 1);
        }
        reach[here] = least;
    };
    std::fill(reach.begin(), reach.end(), raster.width + raster.height);
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) step(x, y, 1);
    for (int y = raster.height; y-- > 0;)
        for (int x = raster.width; x-- > 0;) step(x, y, -1);
    return reach;
}

/// Squares in a row, from one to both sides, that are of its room: the fewer of both.
int run_around(const PlanRaster& raster, const std::vector<std::uint32_t>& room, int x, int y) {
    const std::uint32_t own = room[raster.at(x, y)];
    int run = 0;
    while (x - run >= 0 && x + run < raster.width && room[raster.at(x - run, y)] == own &&
           room[raster.at(x + run, y)] == own)
        ++run;
    return run;
}

/// What lies beyond the cut.
std::vector<Vec3> beyond(const View& view, const std::vector<Vec3>& polygon, double cut) {
    const double limit = view.toward * cut;
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
        const double a = limit - view.nearness(here), b = limit - view.nearness(next);
        if (a >= 0) kept.push_back(here);
        if ((a >= 0) != (b >= 0)) kept.push_back(here + (next - here) * (a / (a - b)));
    }
    return kept;
}

std::string title_of(const World& world, std::uint32_t id, const PortalInfo& portal) {
    std::string title = "portal " + std::to_string(id);
    if (!portal.name.empty()) title.append(" ").append(portal.name);
    return title + ": " + room_label(world, portal.rooms[0]) + " - " + room_label(world, portal.rooms[1]) +
           (portal.open ? "" : ", closed");
}

}  // namespace

std::size_t label_rooms(SvgText& svg, const World& world, const PlanRaster& raster, std::span<const RoomId> rooms) {
    std::vector<std::uint32_t> room(raster.face.size(), PlanRaster::kNothing);
    for (std::size_t k = 0; k < room.size(); ++k)
        if (raster.face[k] != PlanRaster::kNothing) room[k] = rooms[raster.face[k]].value;
    const std::vector<int> reach = reach_of(raster, room);
    struct Place {
        int x = 0, y = 0, reach = 0;
    };
    std::vector<Place> best(world.room_count());
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const std::size_t at = raster.at(x, y);
            if (room[at] != PlanRaster::kNothing && reach[at] > best[room[at]].reach)
                best[room[at]] = {x, y, reach[at]};
        }
    std::size_t count = 0;
    for (std::uint32_t id = 0; id < best.size(); ++id) {
        const Place& place = best[id];
        if (place.reach < kLeastReach) continue;
        ++count;
        const std::string_view name = room_info(world, {id})->name;
        const double half = kLetter * double(name.size()) / 2;
        const bool named = !name.empty() && place.reach >= kNameReach &&
                           run_around(raster, room, place.x, place.y) * PlanRaster::kCell >= half;
        PagePoint at = raster.middle(place.x, place.y);
        at.y += named ? -1 : 4;
        svg.label(at, std::to_string(id), "class=\"room\"");
        if (named) svg.label({at.x, at.y + kLineWidth}, name, "class=\"room name\"");
    }
    return count;
}

std::size_t draw_portals(SvgText& svg, const View& view, const World& world, const PlanRaster& raster,
                         const std::optional<double>& cut) {
    std::size_t count = 0;
    for (std::uint32_t id = 0; id < portal_count(world); ++id) {
        const PortalInfo portal = *portal_info(world, {id});
        SvgText seen, hidden;
        for (std::vector<Vec3> polygon : portal_polygons(world, {id})) {
            if (cut) polygon = beyond(view, polygon, *cut);
            if (polygon.size() < 3) continue;
            const bool shows = is_seen(raster, view, polygon);
            if (cut && !shows) continue;
            SvgText& path = shows ? seen : hidden;
            for (std::size_t k = 0; k < polygon.size(); ++k) path.raw(k == 0 ? "M" : " ").point(view.place(polygon[k]));
            path.raw("Z");
        }
        if (seen.size() + hidden.size() > 0) ++count;
        for (const SvgText* path : {&hidden, &seen}) {
            if (path->size() == 0) continue;
            svg.raw("<path class=\"portal ").raw(portal.open ? "open" : "closed");
            svg.raw(path == &hidden ? " hidden" : "").raw("\" d=\"").raw(path->text()).raw("\"><title>");
            svg.words(title_of(world, id, portal)).raw("</title></path>\n");
        }
    }
    return count;
}

const char* room_styles() {
    return ".room{font-size:13px;font-weight:bold;text-anchor:middle;stroke:#fff;stroke-width:3;stroke-opacity:.75;"
           "paint-order:stroke;stroke-linejoin:round}.room.name{font-size:10px;font-weight:normal}"
           ".portal{stroke-width:2.4;stroke-linejoin:round;fill-opacity:.15}"
           ".open{stroke:#00796b;fill:#00bfa5}.closed{stroke:#b71c1c;fill:#e53935;fill-opacity:.45;stroke-width:3.4}"
           ".hidden{stroke-opacity:.4;fill-opacity:.08;stroke-dasharray:3 2}";
}

}  // namespace firma::draw
