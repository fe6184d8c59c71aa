// SPDX-License-Identifier: MIT
// Culling faces by their boxes: the box of the path, outcodes, slabs; and whether boxes of faces are better stored or
// computed each time.
//
// The faces asked about are those in the bins that the box of a cast's path meets: what the article's system has left
// to test one by one.
#include "article/questions.h"

#include <cmath>
#include <cstdio>

#include "support/race.h"
#include "support/sets.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

struct FaceBox {
    float low[3], high[3];
};

/// A cast as the three ways want it.
struct Query {
    CastQuery move;
    Sweep sweep;
    SweepBox slabs;
    Vec3 end;
    double path_low[3], path_high[3];  ///< box around the whole path, radius included

    explicit Query(const CastQuery& from)
        : move(from), sweep(made(from)), slabs(sweep), end(from.sphere.centre + from.path) {
        for (int axis = 0; axis < 3; ++axis) {
            const double a = move.sphere.centre[axis], b = end[axis], r = move.sphere.radius;
            path_low[axis] = (a < b ? a : b) - r;
            path_high[axis] = (a < b ? b : a) + r;
        }
    }

private:
    static Sweep made(const CastQuery& move) {
        Sweep sweep;
        make_sweep(move.sphere, move.path, sweep);
        return sweep;
    }
};

/// "At most six comparisons."
template <class AnyBox>
bool path_box_meets(const Query& query, const AnyBox& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (query.path_low[axis] > double(box.high[axis]) || query.path_high[axis] < double(box.low[axis]))
            return false;
    return true;
}

struct GrownBox {
    double low[3], high[3];
    GrownBox(const FaceBox& box, double radius) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = double(box.low[axis]) - radius;
            high[axis] = double(box.high[axis]) + radius;
        }
    }
    unsigned outcode(const Vec3& p) const {
        unsigned code = 0;
        for (int axis = 0; axis < 3; ++axis) {
            code |= unsigned(p[axis] < low[axis]) << (2 * axis);
            code |= unsigned(p[axis] > high[axis]) << (2 * axis + 1);
        }
        return code;
    }
};

/// The article's segment against box, by outcodes. `printed` divides as the article has it in print: upside down.
template <bool printed>
bool outcodes_meet(const Query& query, const FaceBox& face) {
    const GrownBox box(face, query.move.sphere.radius);
    const Vec3 &v0 = query.move.sphere.centre, &v1 = query.end;
    const unsigned from = box.outcode(v0), to = box.outcode(v1);
    if (from == 0 || to == 0) return true;
    if (from & to) return false;
    const unsigned crossed = from | to;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            if (!(crossed & (1u << (2 * axis + side)))) continue;
            const double plane = side == 0 ? box.low[axis] : box.high[axis];
            const double dist =
                printed ? (v1[axis] - v0[axis]) / (plane - v0[axis]) : (plane - v0[axis]) / (v1[axis] - v0[axis]);
            const Vec3 at = (v1 - v0) * dist + v0;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (at[u] >= box.low[u] && at[u] <= box.high[u] && at[v] >= box.low[v] && at[v] <= box.high[v]) return true;
        }
    return false;
}

/// clip_segment_box() of firma/polygon.h: outcodes, grown by the rounding of their own arithmetic.
bool firma_outcodes_meet(const Query& query, const FaceBox& face) {
    const GrownBox grown(face, query.move.sphere.radius);
    return clip_segment_box(
        query.move.sphere.centre, query.move.path,
        {{grown.low[0], grown.low[1], grown.low[2]}, {grown.high[0], grown.high[1], grown.high[2]}});
}

template <class AnyBox>
bool slabs_meet(const Query& query, const AnyBox& box) {
    double nearest;
    return query.slabs.enters(box, query.sweep.end, nearest);
}

/// A face where the tree has it.
struct Spot {
    const Block* block;
    std::uint32_t slot;
};

/// The faces of the boxes that a query's path meets.
struct Gather {
    const Query& query;
    std::vector<Spot>& spots;
    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        return path_box_meets(query, box);
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) spots.push_back({&block, slot});
        return false;
    }
};

struct Setup {
    World world;
    std::vector<FaceBox> boxes;  ///< by face id
    std::vector<Query> queries;
    std::vector<std::vector<Spot>> spots;  ///< by query
    std::size_t tests = 0;

    Setup(const Level& level, const std::vector<CastQuery>& moves) : world(world_of(level)), boxes(level.faces.size()) {
        const Node& root = *world.data().faces_of(0).tree;
        for_each_block(root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) {
                const CornerBox box(block, face);  // grid coordinates of these scenes fit a float
                for (int axis = 0; axis < 3; ++axis) {
                    boxes[face.id.value].low[axis] = float(box.low[axis]);
                    boxes[face.id.value].high[axis] = float(box.high[axis]);
                }
            }
        });
        for (const CastQuery& move : moves) queries.emplace_back(move);
        spots.resize(queries.size());
        for (std::size_t k = 0; k < queries.size(); ++k) {
            Gather gather{queries[k], spots[k]};
            traverse(root, gather);
            tests += spots[k].size();
        }
    }

    const FaceBox& box(const Spot& spot) const { return boxes[spot.block->faces[spot.slot].id.value]; }

    template <class Test>
    std::size_t count_met(const Test& test) const {
        std::size_t met = 0;
        for (std::size_t k = 0; k < queries.size(); ++k)
            for (const Spot& spot : spots[k]) met += test(queries[k], box(spot));
        return met;
    }

    /// Faces that are really touched, from either side, though the test says that they cannot be.
    template <class Test>
    std::size_t count_wrong(const Test& test) const {
        std::size_t wrong = 0;
        for (std::size_t k = 0; k < queries.size(); ++k)
            for (const Spot& spot : spots[k]) {
                if (test(queries[k], box(spot))) continue;
                const FaceShape shape(*spot.block, spot.block->faces[spot.slot]);
                const Sweep& sweep = queries[k].sweep;
                wrong += cast_sweep_polygon(sweep, shape.polygon, Sides::kBoth, sweep.end).touched();
            }
        return wrong;
    }
};

void measure_culls(const Setup& setup, const std::string& name, int rounds, Table& table) {
    std::vector<std::vector<FaceBox>> boxes(setup.queries.size());  // in the order of the tests: no memory to wait for
    for (std::size_t k = 0; k < boxes.size(); ++k)
        for (const Spot& spot : setup.spots[k]) boxes[k].push_back(setup.box(spot));
    struct Way {
        const char* name;
        bool (*test)(const Query&, const FaceBox&);
    };
    const Way ways[] = {{"box of the path", &path_box_meets<FaceBox>},
                        {"outcodes, as printed", &outcodes_meet<true>},
                        {"outcodes, mended", &outcodes_meet<false>},
                        {"outcodes, Firma's clip_segment_box", &firma_outcodes_meet},
                        {"slabs, Firma's tree", &slabs_meet<FaceBox>}};
    std::vector<Contender> contenders;
    for (const Way& way : ways)
        contenders.push_back({way.name, [&setup, &boxes, way] {
                                  for (std::size_t k = 0; k < boxes.size(); ++k)
                                      for (const FaceBox& box : boxes[k]) keep(way.test(setup.queries[k], box));
                              }});
    const std::vector<Lap> laps = race(contenders, rounds);
    const double tests = double(setup.tests);
    double culled_by_path = 1;
    for (std::size_t k = 0; k < laps.size(); ++k) {
        const double met = double(setup.count_met(ways[k].test)), casts = double(setup.queries.size());
        const double culled = tests - met;
        if (k == 0) culled_by_path = culled;
        table.add({name, ways[k].name, number(tests / casts), number(met / casts), percent(culled / tests),
                   times(culled / culled_by_path), number(laps[k].seconds / tests * 1e9), times(laps[k].ratio),
                   count(setup.count_wrong(ways[k].test))});
    }
}

/// Faces' boxes on the way through the tree: stored, or computed from corners each time.
void measure_storage(const Setup& setup, const std::string& name, int rounds, Table& table) {
    const auto each = [&setup](const auto& test) {
        for (std::size_t k = 0; k < setup.queries.size(); ++k)
            for (const Spot& spot : setup.spots[k]) keep(test(setup.queries[k], spot));
    };
    const std::vector<Contender> contenders{
        {"computed from corners (Firma)",
         [&] {
             each([](const Query& q, const Spot& s) {
                 return slabs_meet(q, CornerBox(*s.block, s.block->faces[s.slot]));
             });
         }},
        {"stored, 24 bytes of float",
         [&] { each([&setup](const Query& q, const Spot& s) { return slabs_meet(q, setup.box(s)); }); }}};
    const std::vector<Lap> laps = race(contenders, rounds);
    for (std::size_t k = 0; k < laps.size(); ++k)
        table.add({name, contenders[k].name, number(laps[k].seconds / double(setup.tests) * 1e9), times(laps[k].ratio),
                   k == 0 ? "0" : "24"});
}

/// Whole casts with one way of boxing faces or another.
struct NoBox {
    const Sweep* sweep = nullptr;
    void begin(const Sweep& s) { sweep = &s; }
    bool meets(const Block&, const FaceRecord&, const SweepBox&, double) const { return true; }
    void face(const Block& block, std::uint32_t slot, const SweepBox& boxes, First& first) {
        test(*this, block, slot, boxes, first);
    }
    template <class Way>
    static void test(const Way& way, const Block& block, std::uint32_t slot, const SweepBox& boxes, First& first) {
        const FaceRecord& record = block.faces[slot];
        if (!way.meets(block, record, boxes, first.latest)) return;
        const FaceShape shape(block, record);
        first.offer(cast_sweep_polygon(*way.sweep, shape.polygon, Sides::kFront, first.latest), record.id.value);
    }
};
struct ComputedBox : NoBox {
    bool meets(const Block& block, const FaceRecord& record, const SweepBox& boxes, double latest) const {
        double nearest;
        return boxes.enters(CornerBox(block, record), latest, nearest);
    }
    void face(const Block& block, std::uint32_t slot, const SweepBox& boxes, First& first) {
        test(*this, block, slot, boxes, first);
    }
};
struct StoredBox : NoBox {
    const std::vector<FaceBox>& stored;
    explicit StoredBox(const std::vector<FaceBox>& all) : stored(all) {}
    bool meets(const Block&, const FaceRecord& record, const SweepBox& boxes, double latest) const {
        double nearest;
        return boxes.enters(stored[record.id.value], latest, nearest);
    }
    void face(const Block& block, std::uint32_t slot, const SweepBox& boxes, First& first) {
        test(*this, block, slot, boxes, first);
    }
};

void measure_whole_casts(const Setup& setup, const std::string& name, int rounds, Table& table) {
    const auto run = [&setup](auto way) {
        for (const Query& query : setup.queries) keep(walk(setup.world, query.move, way).latest);
    };
    const std::vector<Contender> contenders{{"computed from corners (Firma)", [&] { run(ComputedBox{}); }},
                                            {"stored, 24 bytes of float", [&] { run(StoredBox(setup.boxes)); }},
                                            {"none: bins only", [&] { run(NoBox{}); }}};
    const std::vector<Lap> laps = race(contenders, rounds);
    for (std::size_t k = 0; k < laps.size(); ++k)
        table.add({name, contenders[k].name, number(laps[k].seconds / double(setup.queries.size()) * 1e9),
                   times(laps[k].ratio)});
}

}  // namespace

int measure_boxes(const Settings& settings) {
    Table culls("box_culls", {"casts", "test", "faces tested a cast", "left a cast", "culled",
                              "culled, to the path's box", "ns a test", "to the path's box", "culled wrongly"});
    Table storage("face_boxes", {"casts", "box of a face", "ns a test", "ratio", "bytes more a face"});
    Table whole("face_boxes_whole_casts", {"casts", "box of a face", "ns a cast", "ratio"});
    const std::size_t casts = settings.few(2000);
    std::vector<Scene> all{rooms_scene(settings.quick ? 1000 : 100000, casts)};
    all.push_back(terrain_scene(settings.quick ? 1000 : 500000, casts));
    for (Scene& scene : all) {
        sort_like_tree(scene.level);
        for (CastSet& set : scene.sets) {
            if (set.name == "spheres, 50 m") set.moves.resize(settings.few(500));
            if (set.name == "rays, long") set.moves.resize(settings.few(500));
            const Setup setup(scene.level, set.moves);
            const std::string name = scene.name + ", " + set.name;
            measure_culls(setup, name, settings.rounds, culls);
            measure_storage(setup, name, settings.rounds, storage);
            measure_whole_casts(setup, name, settings.rounds, whole);
        }
    }
    const bool written = culls.finish(settings.csv);
    return storage.finish(settings.csv) && whole.finish(settings.csv) && written ? 0 : 1;
}

}  // namespace firma::bench
