// SPDX-License-Identifier: MIT
// Edges and vertices: culled against the box of the path or not; those that faces share tested once a cast or each
// time.
//
// Whole casts with copies of cast/cast_sphere_polygon.cpp's loop over a face's rim, each different in one thing. What a
// face answers must not change; casts whose answers differ are counted.
#include "article/questions.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "cast/cast_sphere_edge.h"
#include "cast/cast_sphere_face.h"
#include "cast/cast_sphere_vertex.h"
#include "cast/start_contact.h"
#include "firma/queries.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"
#include "support/race.h"
#include "support/sets.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

/// How much there was to do.
struct RimCounts {
    std::uint64_t rims = 0, vertices = 0, edges = 0, vertices_culled = 0, edges_culled = 0;
};

/// The box of the path up to `latest`, grown by the radius and by rounding.
struct PathBox {
    double low[3], high[3];

    PathBox(const Sweep& sweep, double latest) {
        const Vec3 end = sweep.at(latest);
        for (int axis = 0; axis < 3; ++axis) {
            const double a = sweep.start[axis], b = end[axis];
            const double margin = sweep.radius + rounding(16) * (std::fabs(a) + std::fabs(b) + sweep.radius);
            low[axis] = (a < b ? a : b) - margin;
            high[axis] = (a < b ? b : a) + margin;
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

/// Edges and vertices of a cast that were looked at already, by global vertex numbers. Emptied by counting up.
class Seen {
public:
    void next_cast() { ++cast_; }
    /// True the first time in a cast; also true again when the table is too full to remember.
    bool first_time(std::uint64_t key) {
        std::uint64_t at = key * 0x9E3779B97F4A7C15ull >> (64 - kBits);
        for (int probe = 0; probe < 4; ++probe, at = (at + 1) & (kSize - 1)) {
            Slot& slot = slots_[at];
            if (slot.cast != cast_) {
                slot = {key, cast_};
                return true;
            }
            if (slot.key == key) return false;
        }
        return true;
    }

private:
    static constexpr int kBits = 9;
    static constexpr std::uint64_t kSize = 1 << kBits;
    struct Slot {
        std::uint64_t key = 0, cast = 0;
    };
    std::array<Slot, kSize> slots_;
    std::uint64_t cast_ = 0;
};

void keep_earlier(Contact& best, const Entry& entry, Feature feature, std::size_t index) {
    if (entry.kind != Entry::kFound || (best.touched() && best.t <= entry.t)) return;
    best = {entry.t > 0 ? Status::kHit : Status::kInitialOverlap, feature, std::uint32_t(index), entry.t};
}

Entry vertex_entry(const Sweep& sweep, const Vec3& corner) {
    const Entry entry = enter_vertex(sweep, corner);
    return entry.kind == Entry::kDoubtful ? enter_vertex_precisely(sweep, corner) : entry;
}

Entry edge_entry(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    const Entry entry = enter_edge(sweep, a, b);
    return entry.kind == Entry::kDoubtful ? enter_edge_precisely(sweep, a, b) : entry;
}

/// Every edge and vertex, every time: Firma's.
struct PlainRim {
    void begin(const Sweep&) {}
    Contact operator()(const Sweep& sweep, const PolygonShape& polygon, const std::uint32_t*, double, RimCounts&) {
        Contact best;
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            keep_earlier(best, vertex_entry(sweep, polygon.corners[k]), Feature::kVertex, k);
            keep_earlier(best, edge_entry(sweep, polygon.corners[k], polygon.corners[polygon.next(k)]), Feature::kEdge,
                         k);
        }
        return best;
    }
};

/// The article's cull: an edge's box against the box of the path. By outcodes of the corners, which is the same test:
/// both ends beyond one side. A vertex must lie in the box.
template <bool shortened>
struct CulledRim {
    void begin(const Sweep&) {}
    Contact operator()(const Sweep& sweep, const PolygonShape& polygon, const std::uint32_t*, double latest,
                       RimCounts& counts) {
        const PathBox box(sweep, shortened ? latest : sweep.end);
        const std::size_t n = polygon.corners.size();
        unsigned codes[kMaxCorners];
        unsigned all = ~0u;
        for (std::size_t k = 0; k < n; ++k) all &= codes[k] = box.outcode(polygon.corners[k]);
        Contact best;
        ++counts.rims;
        counts.vertices += n;
        counts.edges += n;
        if (all) {
            counts.vertices_culled += n;
            counts.edges_culled += n;
            return best;
        }
        for (std::size_t k = 0; k < n; ++k) {
            if (codes[k] == 0)
                keep_earlier(best, vertex_entry(sweep, polygon.corners[k]), Feature::kVertex, k);
            else
                ++counts.vertices_culled;
            const std::size_t next = polygon.next(k);
            if (!(codes[k] & codes[next]))
                keep_earlier(best, edge_entry(sweep, polygon.corners[k], polygon.corners[next]), Feature::kEdge, k);
            else
                ++counts.edges_culled;
        }
        return best;
    }
};

/// A shared edge or vertex belongs to whichever face comes first.
struct OnceRim {
    Seen seen;
    void begin(const Sweep&) { seen.next_cast(); }
    Contact operator()(const Sweep& sweep, const PolygonShape& polygon, const std::uint32_t* vertices, double,
                       RimCounts& counts) {
        Contact best;
        ++counts.rims;
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            ++counts.vertices;
            ++counts.edges;
            const std::uint64_t a = vertices[k], b = vertices[polygon.next(k)];
            if (seen.first_time(~a))
                keep_earlier(best, vertex_entry(sweep, polygon.corners[k]), Feature::kVertex, k);
            else
                ++counts.vertices_culled;
            const std::uint64_t low = a < b ? a : b, high = a < b ? b : a;
            if (seen.first_time(low << 32 | high))
                keep_earlier(best, edge_entry(sweep, polygon.corners[k], polygon.corners[polygon.next(k)]),
                             Feature::kEdge, k);
            else
                ++counts.edges_culled;
        }
        return best;
    }
};

bool out_of_reach(const Sweep& sweep, const PlaneView& view, double latest) {
    if (view.height + view.height_error < -sweep.radius) return true;
    const double fall = (view.approach + view.approach_error) * latest;
    return view.height - view.height_error - sweep.radius > fall * (1 + rounding(8));
}

bool starts_clear(const Sweep& sweep, const PolygonShape& polygon) {
    for (int axis = 0; axis < 3; ++axis) {
        double low = polygon.corners[0][axis], high = low;
        for (const Vec3& corner : polygon.corners) {
            if (corner[axis] < low) low = corner[axis];
            if (corner[axis] > high) high = corner[axis];
        }
        const double p = sweep.start[axis];
        const double size = std::fabs(p) + std::fabs(low) + std::fabs(high) + sweep.radius;
        const double margin = sweep.radius + rounding(8) * size;
        if (p < low - margin || p > high + margin) return true;
    }
    return false;
}

/// A face of a walk, as cast_sweep_polygon() has it for spheres, with another rim.
template <class Rim>
struct FaceTest {
    const Level& level;
    Rim rim;
    RimCounts counts;
    const Sweep* sweep = nullptr;

    explicit FaceTest(const Level& from) : level(from) {}

    void begin(const Sweep& s) {
        sweep = &s;
        rim.begin(s);
    }
    void face(const Block& block, std::uint32_t slot, const SweepBox& boxes, First& first) {
        const FaceRecord& record = block.faces[slot];
        double nearest;
        if (!boxes.enters(CornerBox(block, record), first.latest, nearest)) return;
        const FaceShape shape(block, record);
        first.offer(contact(shape.polygon, record.id.value, first.latest), record.id.value);
    }
    Contact contact(const PolygonShape& polygon, std::uint32_t id, double latest) {
        const int facing = exact_facing(sweep->direction, polygon);
        if (facing >= 0) return {};
        const PlaneView view = view_plane(*sweep, polygon, facing);
        if (out_of_reach(*sweep, view, latest)) return {};
        if (std::fabs(view.height) - view.height_error <= sweep->radius && !starts_clear(*sweep, polygon)) {
            const StartContact start = start_contact(*sweep, polygon, facing);
            if (start.kind != StartContact::kApart) return start.contact;
        }
        if (view.height + view.height_error >= sweep->radius) {
            const Entry entry = enter_plane(*sweep, polygon, view);
            if (entry.kind == Entry::kNone) return {};
            if (foot_inside(*sweep, polygon, entry.t))
                return {entry.t > 0 ? Status::kHit : Status::kInitialOverlap, Feature::kFace, 0, entry.t};
        }
        return rim(*sweep, polygon, level.corners.data() + level.faces[id].first_corner, latest, counts);
    }
};

template <class Rim>
std::size_t differences(const World& world, const Level& level, const std::vector<CastQuery>& moves,
                        RimCounts& counts) {
    FaceTest<Rim> test(level);
    std::size_t wrong = 0;
    for (const CastQuery& move : moves) {
        const First first = walk(world, move, test);
        const Hit hit = cast(world, move.sphere, move.path);
        const bool touched = first.contact.touched();
        wrong += hit.touched() != touched ||
                 (touched && std::fabs(hit.fraction - test.sweep->fraction(first.contact.t)) > 1e-12);
    }
    counts = test.counts;
    return wrong;
}

template <class Rim>
Contender contender(const char* name, const World& world, const Level& level, const std::vector<CastQuery>& moves) {
    return {name, [&] {
                FaceTest<Rim> test(level);
                for (const CastQuery& move : moves) keep(walk(world, move, test).latest);
            }};
}

/// A rim that a cast came to, to be asked again by itself.
struct RimCall {
    const Sweep* sweep;
    std::vector<Vec3> corners;
    PolygonShape polygon;
    const std::uint32_t* vertices;
    double latest;
    bool begins_cast;
};

/// Notes down the rims on the way; answers as Firma does.
struct NotingRim : PlainRim {
    std::vector<RimCall> calls;
    std::vector<Sweep>* sweeps = nullptr;
    bool begins = false;
    void begin(const Sweep& sweep) {
        sweeps->push_back(sweep);
        begins = true;
    }
    Contact operator()(const Sweep& sweep, const PolygonShape& polygon, const std::uint32_t* vertices, double latest,
                       RimCounts& counts) {
        calls.push_back(
            {&sweeps->back(), {polygon.corners.begin(), polygon.corners.end()}, polygon, vertices, latest, begins});
        calls.back().polygon.corners = calls.back().corners;
        begins = false;
        return PlainRim::operator()(sweep, polygon, vertices, latest, counts);
    }
};

/// The rims alone: memory and tree left out.
std::vector<Lap> race_rims(const World& world, const Level& level, const std::vector<CastQuery>& moves, int rounds,
                           std::size_t& rims) {
    std::vector<Sweep> sweeps;
    sweeps.reserve(moves.size());
    FaceTest<NotingRim> test(level);
    test.rim.sweeps = &sweeps;
    for (const CastQuery& move : moves) walk(world, move, test);
    std::vector<RimCall>& calls = test.rim.calls;
    rims = calls.size();
    const auto ask = [&calls](auto rim) {
        RimCounts counts;
        for (const RimCall& call : calls) {
            if (call.begins_cast) rim.begin(*call.sweep);
            keep(rim(*call.sweep, call.polygon, call.vertices, call.latest, counts).t);
        }
        keep(counts);
    };
    const std::vector<Contender> contenders{{"", [&] { ask(PlainRim{}); }},
                                            {"", [&] { ask(CulledRim<false>{}); }},
                                            {"", [&] { ask(CulledRim<true>{}); }},
                                            {"", [&] { ask(OnceRim{}); }}};
    return race(contenders, rounds);
}

std::string share(std::uint64_t part, std::uint64_t whole) {
    return whole ? percent(double(part) / double(whole)) : "-";
}

void measure(const Scene& scene, const CastSet& set, int rounds, Table& table) {
    const World world = world_of(scene.level);
    const std::vector<Contender> contenders{
        contender<PlainRim>("every edge and vertex, each time", world, scene.level, set.moves),
        contender<CulledRim<false>>("culled against the box of the whole path", world, scene.level, set.moves),
        contender<CulledRim<true>>("culled against the box of the path so far (Firma)", world, scene.level, set.moves),
        contender<OnceRim>("shared ones once a cast", world, scene.level, set.moves)};
    const std::vector<Lap> laps = race(contenders, rounds);
    std::size_t rims = 0;
    const std::vector<Lap> alone = race_rims(world, scene.level, set.moves, rounds, rims);
    RimCounts counts[4];
    const std::size_t wrong[4] = {differences<PlainRim>(world, scene.level, set.moves, counts[0]),
                                  differences<CulledRim<false>>(world, scene.level, set.moves, counts[1]),
                                  differences<CulledRim<true>>(world, scene.level, set.moves, counts[2]),
                                  differences<OnceRim>(world, scene.level, set.moves, counts[3])};
    const double n = double(set.moves.size());
    for (std::size_t k = 0; k < laps.size(); ++k)
        table.add({scene.name + ", " + set.name, contenders[k].name, number(double(counts[1].rims) / n),
                   k ? share(counts[k].edges_culled, counts[k].edges) : "0%",
                   k ? share(counts[k].vertices_culled, counts[k].vertices) : "0%",
                   number(alone[k].seconds / double(rims) * 1e9), times(alone[k].ratio),
                   number(laps[k].seconds / n * 1e9), times(laps[k].ratio), count(wrong[k])});
}

}  // namespace

int measure_edges(const Settings& settings) {
    Table table("edges", {"casts", "edges and vertices", "rims a cast", "edges spared", "vertices spared", "ns a rim",
                          "rim", "ns a cast", "cast", "answers differ"});
    const std::size_t casts = settings.few(4000), faces = settings.quick ? 1000 : 50000;
    std::vector<Scene> all{rooms_scene(faces, casts)};
    all.push_back(terrain_scene(faces, casts));
    for (Scene& scene : all) {
        sort_like_tree(scene.level);
        for (const CastSet& set : scene.sets)
            if (set.name.starts_with("spheres")) measure(scene, set, settings.rounds, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace firma::bench
