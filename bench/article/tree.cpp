// SPDX-License-Identifier: MIT
// What the tree of bins buys as levels grow, and what each of its stop rules and both ways of splitting do.
#include "article/questions.h"

#include <cstdio>
#include <memory>

#include "firma/queries.h"
#include "support/race.h"
#include "support/sets.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

/// All faces in a row, ready to be tested one after the other.
class FlatFaces {
public:
    explicit FlatFaces(const Level& level) {
        corners_.reserve(level.corners.size());
        for (const LevelFace& face : level.faces) {
            const std::size_t first = corners_.size();
            Box box;
            for (std::uint32_t c = 0; c < face.corner_count; ++c) {
                corners_.push_back(to_metres(level.vertices[level.corners[face.first_corner + c]]));
                box.add(corners_.back());
            }
            shapes_.push_back(make_shape({corners_.data() + first, face.corner_count}));
            boxes_.push_back({{box.low.x, box.low.y, box.low.z}, {box.high.x, box.high.y, box.high.z}});
        }
    }

    First cast(const CastQuery& move, bool by_boxes) const {
        Sweep sweep;
        if (make_sweep(move.sphere, move.path, sweep) != Status::kHit) return {};
        const SweepBox boxes(sweep);
        First first;
        first.latest = sweep.end;
        double nearest;
        for (std::uint32_t k = 0; k < shapes_.size(); ++k)
            if (!by_boxes || boxes.enters(boxes_[k], first.latest, nearest))
                first.offer(cast_sweep_polygon(sweep, shapes_[k], Sides::kFront, first.latest), k);
        return first;
    }

private:
    struct FlatBox {
        double low[3], high[3];
    };
    std::vector<Vec3> corners_;
    std::vector<PolygonShape> shapes_;
    std::vector<FlatBox> boxes_;
};

std::size_t disagreements(const World& world, const FlatFaces& flat, const std::vector<CastQuery>& moves) {
    std::size_t wrong = 0;
    for (const CastQuery& move : moves) {
        const Hit hit = cast(world, move.sphere, move.path);
        const First first = flat.cast(move, true);
        wrong += hit.touched() != first.contact.touched() || (hit.touched() && hit.face.id.value != first.face);
    }
    return wrong;
}

bool measure_growth(const Settings& settings) {
    Table table("tree_growth",
                {"faces", "no boxes, us", "boxes, no tree, us", "tree, us", "boxes to tree", "no boxes to tree",
                 "bins a cast", "boxes a cast", "faces looked at a cast", "share of faces", "answers differ"});
    for (const std::size_t faces : {1000, 10000, 100000, 1000000}) {
        if (settings.quick && faces > 10000) break;
        const Scene scene = rooms_scene(faces, settings.few(4000));
        const World world = world_of(scene.level);
        const FlatFaces flat(scene.level);
        const std::vector<CastQuery>& moves = scene.sets[0].moves;
        // Without a tree a cast costs as much as the level is large: few of them are enough.
        const std::size_t few = std::max<std::size_t>(4, std::min<std::size_t>(moves.size(), 4000000 / faces));
        const std::vector<CastQuery> flat_moves(moves.begin(), moves.begin() + std::ptrdiff_t(few));
        const auto flat_run = [&](bool by_boxes) {
            for (const CastQuery& move : flat_moves) keep(flat.cast(move, by_boxes).latest);
        };
        const std::vector<Contender> contenders{{"tree",
                                                 [&] {
                                                     for (const CastQuery& move : moves)
                                                         keep(cast(world, move.sphere, move.path).fraction);
                                                 }},
                                                {"boxes", [&] { flat_run(true); }},
                                                {"no boxes", [&] { flat_run(false); }}};
        const std::vector<Lap> laps = race(contenders, std::min(settings.rounds, 5));
        const double tree = laps[0].seconds / double(moves.size()), boxes = laps[1].seconds / double(few),
                     none = laps[2].seconds / double(few);
        CastCounts counts;
        CastOptions options;
        options.counts = &counts;
        for (const CastQuery& move : moves) keep(cast(world, move.sphere, move.path, options).fraction);
        const double n = double(moves.size()), all = double(scene.level.faces.size());
        table.add({count(scene.level.faces.size()), number(none * 1e6), number(boxes * 1e6), number(tree * 1e6),
                   times(boxes / tree), times(none / tree), number(double(counts.nodes) / n),
                   number(double(counts.boxes) / n), number(double(counts.faces) / n),
                   percent(double(counts.faces) / n / all), count(disagreements(world, flat, flat_moves))});
    }
    return table.finish(settings.csv);
}

struct Rules {
    std::string name;
    TreeOptions options;
};

std::vector<Rules> all_rules() {
    std::vector<Rules> all{{"as Firma has them (depth 48, 4 faces, no volume)", {}}};
    for (const int depth : {8, 12, 16}) {
        all.push_back({"depth " + std::to_string(depth), {}});
        all.back().options.max_depth = depth;
    }
    for (const int faces : {1, 2, 8, 16, 32, 64}) {
        all.push_back({"faces a bin " + std::to_string(faces), {}});
        all.back().options.faces_per_leaf = faces;
    }
    for (const double volume : {1.0, 10.0, 100.0}) {
        all.push_back({"bin volume " + number(volume) + " m3", {}});
        all.back().options.min_node_volume = volume;
    }
    const std::size_t longest = all.size();
    for (std::size_t k = 0; k < longest; ++k) {
        const TreeOptions& o = all[k].options;
        if (o.max_depth != 48 || o.min_node_volume != 0 || o.faces_per_leaf > 16) continue;
        all.push_back({"by surface area, faces a bin " + std::to_string(o.faces_per_leaf), o});
        all.back().options.split = Split::kSurfaceArea;
    }
    return all;
}

bool measure_rules(const Settings& settings, const Scene& scene) {
    const std::vector<Rules> rules = all_rules();
    std::vector<World> worlds(rules.size());
    std::vector<Contender> builds;
    for (std::size_t k = 0; k < rules.size(); ++k)
        builds.push_back({"", [&, k] { worlds[k] = world_of(scene.level, rules[k].options); }});
    const std::vector<Lap> built = race(builds, std::min(settings.rounds, 5));
    std::vector<std::vector<Lap>> laps;
    for (const CastSet& set : scene.sets) {
        std::vector<Contender> contenders;
        for (const World& world : worlds)
            contenders.push_back({"", [&world, &set] {
                                      for (const CastQuery& move : set.moves)
                                          keep(cast(world, move.sphere, move.path).fraction);
                                  }});
        laps.push_back(race(contenders, settings.rounds));
    }
    Table table("tree_rules_" + scene.name,
                {"rule", "build ms", "build", "bins", "deepest", "fullest bin", "overlap", "bytes a face",
                 "bins a cast", "boxes a cast", "faces looked at a cast", "k casts/s", "spheres, short",
                 "spheres, 50 m", "rays, short", "rays, long"});
    for (std::size_t k = 0; k < rules.size(); ++k) {
        const TreeStatistics s = worlds[k].statistics();
        CastCounts counts;
        CastOptions options;
        options.counts = &counts;
        const std::vector<CastQuery>& moves = scene.sets[0].moves;
        for (const CastQuery& move : moves) keep(cast(worlds[k], move.sphere, move.path, options).fraction);
        const double n = double(moves.size());
        table.add({rules[k].name, number(built[k].seconds * 1e3), times(built[k].ratio), count(s.nodes),
                   count(std::size_t(s.depth)), count(s.max_leaf_faces), percent(s.overlap), number(s.bytes_per_face()),
                   number(double(counts.nodes) / n), number(double(counts.boxes) / n), number(double(counts.faces) / n),
                   number(n / laps[0][k].seconds / 1e3), times(laps[0][k].ratio), times(laps[1][k].ratio),
                   times(laps[2][k].ratio), times(laps[3][k].ratio)});
    }
    return table.finish(settings.csv);
}

}  // namespace

int measure_tree(const Settings& settings) {
    const std::size_t faces = settings.quick ? 2000 : 100000, casts = settings.few(10000);
    const bool growth = measure_growth(settings);
    const bool rooms = measure_rules(settings, rooms_scene(faces, casts));
    const bool ground = measure_rules(settings, terrain_scene(faces, casts));
    return growth && rooms && ground ? 0 : 1;
}

}  // namespace firma::bench
