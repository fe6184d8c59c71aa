// SPDX-License-Identifier: MIT
// Levels of brushes: how long joining them takes, what casts by room cost beside casts in one tree over the level, and
// what rooms save when something changes.
//
// bench_levels [FOLDER]: the depot and, of a folder of OpenArena's maps (build/openarena by default), those that are
// there.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/one_tree.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"
#include "solid/build_blocks.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "world/world_data.h"

namespace firma::bench {
namespace {

struct OfLevel {
    std::string name;
    BrushLevel level;
    World world;
};

std::vector<std::string> files(const Settings& settings) {
    const std::string folder = settings.rest.empty() ? settings.repository + "/build/openarena" : settings.rest;
    std::vector<std::string> found{settings.repository + "/levels/depot.map"};
    std::error_code none;
    std::vector<std::string> maps;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".bsp") maps.push_back(entry.path().string());
    std::sort(maps.begin(), maps.end());
    if (settings.quick) maps.resize(std::min<std::size_t>(maps.size(), 2));
    found.insert(found.end(), maps.begin(), maps.end());
    return found;
}

/// One row a level; the world of those that casts are made in.
std::vector<OfLevel> join_all(const Settings& settings, Table& table) {
    std::vector<OfLevel> levels;
    for (const std::string& file : files(settings)) {
        double before = thread_seconds();
        Result<BrushLevel> level = read_brush_level(file);
        const double read = thread_seconds() - before;
        const std::string name = std::filesystem::path(file).stem().string();
        if (!level) {
            table.add({name, level.error().text()});
            continue;
        }
        before = thread_seconds();
        BrushWorldReport report;
        Result<World> world = make_world(level.value(), {}, &report);
        const double joined = thread_seconds() - before;
        if (!world) {
            table.add({name, world.error().text()});
            continue;
        }
        std::size_t not_joined = 0;
        for (const BrushNote& note : report.notes) not_joined += note.what == BrushNote::What::kNotJoined;
        table.add({name, count(level.value().brushes.size()), count(report.solid_faces),
                   count(world.value().face_count()), count(world.value().room_count()),
                   count(portal_count(world.value())), count(not_joined), count(report.planes_moved),
                   number(read * 1e3), number(joined * 1e3)});
        if (portal_count(world.value()) >= 20)
            levels.push_back({name, std::move(level).value(), std::move(world).value()});
    }
    return levels;
}

struct Move {
    Sphere sphere;
    Vec3 path;
    RoomId room;
};

std::vector<Move> moves_in(const World& world, double radius, double longest, std::size_t many) {
    scenes::Rng rng(31);
    const Box box = world.bounds();
    std::vector<Move> moves;
    while (moves.size() < many) {
        Move move;
        for (int axis = 0; axis < 3; ++axis) move.sphere.centre[axis] = rng.uniform(box.low[axis], box.high[axis]);
        const Location where = locate(world, move.sphere.centre);
        if (where.where != Where::kAir || room_info(world, where.room)->exterior) continue;
        if (closest(world, move.sphere.centre, radius + 1e-3)) continue;
        move.sphere.radius = radius;
        const Vec3 way = rng.direction();
        move.path = way * rng.uniform(0.1, longest);
        move.room = where.room;
        moves.push_back(move);
    }
    return moves;
}

void race_casts(const OfLevel& of, const Settings& settings, Table& table) {
    const World one = scenes::in_one_tree(of.world);
    struct Kind {
        const char* name;
        double radius, longest;
    };
    for (const Kind& kind :
         {Kind{"spheres, up to 2 m", 0.3, 2}, Kind{"spheres, up to 50 m", 0.3, 50}, Kind{"rays, up to 50 m", 0, 50}}) {
        const std::vector<Move> moves = moves_in(of.world, kind.radius, kind.longest, settings.few(5000));
        const auto casts = [&moves](const World& world, int how) {
            return [&moves, &world, how] {
                for (const Move& move : moves)
                    keep(cast(world, move.sphere, move.path,
                              {.room = how == 0   ? kAnyRoom
                                       : how == 1 ? move.room
                                                  : kLocateRoom})
                             .fraction);
            };
        };
        const std::vector<Contender> contenders{{"one tree", casts(one, 0)},
                                                {"by room", casts(of.world, 1)},
                                                {"all rooms", casts(of.world, 0)},
                                                {"located", casts(of.world, 2)}};
        const std::vector<Lap> laps = race(contenders, settings.rounds);
        double passed = 0;
        bool same = true;
        for (const Move& move : moves) {
            RoomTrail trail;
            const Hit hit = cast(of.world, move.sphere, move.path, {.room = move.room, .trail = &trail});
            passed += trail.count;
            same = same && hit.face == cast(one, move.sphere, move.path).face;
        }
        table.add({of.name, kind.name, number(laps[0].seconds / double(moves.size()) * 1e9), times(laps[1].ratio),
                   times(laps[2].ratio), times(laps[3].ratio), number(passed / double(moves.size())),
                   same ? "same" : "DIFFER"});
    }
}

/// What a change in one room costs: a crater, by rooms and in one tree; a door; the article's rule, which rebuilds the
/// tree of the touched room, against rebuilding that of the level.
void race_changes(const OfLevel& of, const Settings& settings, Table& table) {
    const World one = scenes::in_one_tree(of.world);
    const Cutter cutter = make_crater(CutterShape::kRocky, 7);
    scenes::Rng rng(5);
    struct Shot {
        Pose pose;
        std::uint32_t room;
    };
    std::vector<Shot> shots;
    for (const Move& move : moves_in(of.world, 0, 50, settings.few(2000))) {
        const Hit hit = cast(of.world, move.sphere, move.path, {.mask = kStopsSight, .room = move.room});
        if (!hit.touched() || shots.size() == 20) continue;
        Pose pose;
        pose.position = hit.point;
        pose.scale = 0.5;
        if (carve(of.world, cutter, pose).done()) shots.push_back({pose, room_of(of.world, hit).value});
    }
    const auto cuts = [&](const World& world) {
        return [&shots, &cutter, &world] {
            for (const Shot& shot : shots) keep(carve(world, cutter, shot.pose).world.face_count());
        };
    };
    const auto rebuild = [&shots](const World& world, bool rooms) {
        return [&shots, &world, rooms] {
            for (const Shot& shot : shots) {
                FaceSet faces;
                append_all_faces(*world.data().faces_of(rooms ? shot.room : 0).tree, faces);
                for (FaceSet::Entry& face : faces.faces) face.part = 0;
                keep(build_blocks(faces, world.data().tree_options)[0].root->facets_below);
            }
        };
    };
    const auto door = [&of, &shots] {
        for (std::size_t k = 0; k < shots.size(); ++k) keep(set_portal_open(of.world, {0}, false)->version());
    };
    const std::vector<Contender> contenders{{"rebuild the level", rebuild(one, false)},
                                            {"rebuild the room", rebuild(of.world, true)},
                                            {"a crater, one tree", cuts(one)},
                                            {"a crater, rooms", cuts(of.world)},
                                            {"a door", door}};
    const std::vector<Lap> laps = race(contenders, settings.rounds);
    std::vector<std::string> row{of.name, count(of.world.face_count()), count(of.world.room_count())};
    for (const Lap& lap : laps) row.push_back(number(lap.seconds / double(shots.size()) * 1e6));
    table.add(row);
}

int run(const Settings& settings) {
    Table joined("levels_join", {"level", "brushes", "faces of the solid", "facets", "rooms", "portals", "not joined",
                                 "planes moved", "read ms", "join ms"});
    const std::vector<OfLevel> levels = join_all(settings, joined);
    bool written = joined.finish(settings.csv);
    Table casts("room_casts",
                {"level", "casts", "one tree, ns", "by room", "all rooms", "located", "rooms a cast", "answers"});
    Table changes("room_changes",
                  {"level", "facets", "rooms", "rebuild the level's tree, us", "rebuild the room's tree, us",
                   "a crater in one tree, us", "a crater in rooms, us", "a door, us"});
    std::size_t shown = 0;
    for (const OfLevel& level : levels) {
        if (++shown > (settings.quick ? 1u : 5u)) break;
        race_casts(level, settings, casts);
        race_changes(level, settings, changes);
    }
    written = casts.finish(settings.csv) && written;
    return changes.finish(settings.csv) && written ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    return firma::bench::run(firma::bench::read_settings(
        argc, argv, "Joins the depot and a folder of OpenArena's maps, casts by room, and changes rooms."));
}
