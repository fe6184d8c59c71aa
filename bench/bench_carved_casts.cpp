// SPDX-License-Identifier: MIT
// Casts in a world of a thousand craters: the tree that edits left behind against one built from scratch over the same
// facets.
#include <memory>

#include "firma/queries.h"
#include "scenes/cast_families.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "world/world_data.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;
using scenes::CastRange;

/// The same facets in a tree built over all of them.
World rebuilt(const World& world) {
    return rebuild_index(world, world.data().tree_options);
}

CastQuery cast_from(const Vec3& start, const CastRange& range, scenes::Rng& rng) {
    CastQuery move;
    move.sphere.centre = start;
    move.sphere.radius = rng.uniform(range.radius_low, range.radius_high);
    const Vec3 way = rng.direction();
    move.path = way * rng.uniform(range.length_low, range.length_high);
    return move;
}

/// From anywhere in the rooms, at least 0.7 m from where walls were.
std::vector<CastQuery> casts_in_rooms(int rooms, const CastRange& range, std::size_t count) {
    scenes::Rng rng(21);
    std::vector<CastQuery> moves;
    while (moves.size() < count) {
        const auto a = int(rng.below(std::uint32_t(rooms)));
        const auto b = int(rng.below(std::uint32_t(rooms)));
        Vec3 start = floor_of_room(a, b);
        for (int axis = 0; axis < 3; ++axis) start[axis] += axis == 2 ? rng.uniform(0.7, 5.3) : rng.uniform(-5.3, 5.3);
        moves.push_back(cast_from(start, range, rng));
    }
    return moves;
}

/// From the middles of craters, which are air, if not for the radius.
std::vector<CastQuery> casts_in_craters(int rooms, CraterPlaces places, std::size_t craters, const CastRange& range,
                                        std::size_t count) {
    scenes::Rng rng(22);
    std::vector<CastQuery> moves;
    while (moves.size() < count) {
        const std::size_t which = rng.below(std::uint32_t(craters));
        moves.push_back(cast_from(crater_pose(rooms, places, which).position, range, rng));
    }
    return moves;
}

struct Counted {
    CastCounts counts;
    std::uint64_t answers = 0;  ///< a hash of all
};

Counted count_casts(const World& world, const std::vector<CastQuery>& moves) {
    Counted counted;
    CastOptions options;
    options.counts = &counted.counts;
    for (const CastQuery& move : moves) {
        const Hit hit = cast(world, move.sphere, move.path, options);
        counted.answers = counted.answers * 0x9E3779B97F4A7C15ull + (hit.touched() ? hit.face.id.value + 1 : 0);
    }
    return counted;
}

void measure_casts(const World& world, const World& fresh, const std::string& name, const std::string& craters,
                   const std::vector<CastQuery>& moves, const Settings& settings, Table& table) {
    const auto casts_in = [&moves](const World& in) {
        return [&moves, &in] {
            for (const CastQuery& move : moves) keep(cast(in, move.sphere, move.path).fraction);
        };
    };
    const std::vector<Contender> contenders{{"fresh", casts_in(fresh)}, {"edited", casts_in(world)}};
    const std::vector<Lap> laps = race(contenders, settings.rounds);
    const Counted edited = count_casts(world, moves), built = count_casts(fresh, moves);
    const double n = double(moves.size());
    table.add({craters, name, count(world.face_count()), number(laps[0].seconds / n * 1e9),
               number(laps[1].seconds / n * 1e9), times(laps[1].ratio), number(double(built.counts.nodes) / n),
               number(double(edited.counts.nodes) / n), number(double(built.counts.boxes) / n),
               number(double(edited.counts.boxes) / n), number(double(built.counts.faces) / n),
               number(double(edited.counts.faces) / n), edited.answers == built.answers ? "same" : "DIFFER"});
}

int measure(const Settings& settings) {
    Table table("carved_casts",
                {"craters", "casts", "facets", "built anew, ns", "after edits, ns", "ratio", "bins, anew",
                 "bins, edits", "boxes, anew", "boxes, edits", "faces, anew", "faces, edits", "answers"});
    Table shape("carved_trees",
                {"craters", "facets", "tree", "bins", "deepest", "fullest bin", "overlap", "bytes a face"});
    const std::size_t craters = settings.quick ? 30 : 1000, casts = settings.few(10000);
    const Cutter cutter = crater();
    struct Level {
        int rooms;
        CraterPlaces places;
        std::string name;
    };
    for (const Level& level :
         {Level{2, CraterPlaces::kSpread, "10k, spread"}, Level{2, CraterPlaces::kCorner, "10k, in one corner"},
          Level{6, CraterPlaces::kSpread, "93k, spread"}}) {
        World world = carvable_world(crater_level(level.rooms));
        for (std::size_t k = 0; k < craters; ++k) cut_crater(world, cutter, crater_pose(level.rooms, level.places, k));
        const World fresh = rebuilt(world);
        for (const bool edited : {false, true}) {
            const TreeStatistics s = (edited ? world : fresh).statistics();
            shape.add({level.name, count(world.face_count()), edited ? "after edits" : "built anew", count(s.nodes),
                       count(std::size_t(s.depth)), count(s.max_leaf_faces), percent(s.overlap),
                       number(s.bytes_per_face())});
        }
        const auto row = [&](const std::string& name, const std::vector<CastQuery>& moves) {
            measure_casts(world, fresh, name, level.name, moves, settings, table);
        };
        row("spheres, short, in rooms", casts_in_rooms(level.rooms, scenes::kShortSpheres, casts));
        row("rays, long, in rooms", casts_in_rooms(level.rooms, scenes::kLongRays, casts));
        row("spheres, 50 m, in rooms", casts_in_rooms(level.rooms, scenes::kLongSpheres, casts));
        row("spheres, short, in craters",
            casts_in_craters(level.rooms, level.places, craters, scenes::kShortSpheres, casts));
        row("rays, short, in craters", casts_in_craters(level.rooms, level.places, craters, scenes::kShortRays, casts));
    }
    const bool fine = shape.finish(settings.csv);
    return table.finish(settings.csv) && fine ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Casts after a thousand craters: trees edited against trees built anew."));
}
