// SPDX-License-Identifier: MIT
// From crossings to labels.
#include "carve/label.h"

#include <algorithm>

#include "carve/sort_along.h"

namespace firma {
namespace {

const Plane& plane_crossed(const Cut& cut, const CutPoint& crossing) {
    return crossing.of_world ? cut.cutter->planes[crossing.face]->plane : cut.patch->faces[crossing.face].plane->plane;
}

const ExactPoint& start_of(const Cut& cut, const CutPoint& crossing) {
    return crossing.of_world ? cut.patch->vertices[cut.patch->edges[crossing.edge].vertex[0]].point
                             : cut.cutter->points[cut.cutter->edges[crossing.edge].a];
}

/// Whether the edge goes inward here: it starts in front of the plane that it crosses.
bool enters(const Cut& cut, const CutPoint& crossing) {
    return exact_side(plane_crossed(cut, crossing), start_of(cut, crossing)) > 0;
}

/// Orders crossings [first, first + count) of one edge: b comes before a when it lies on the start's side of a's plane.
Verdict order_along(Cut& cut, std::uint32_t first, std::uint32_t count) {
    const auto begin = cut.along.begin() + first;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const CutPoint& at_a = cut.crossings[a];
        const Plane& plane = plane_crossed(cut, at_a);
        return -exact_side(plane, cut.crossings[b].point) * exact_side(plane, start_of(cut, at_a));
    };
    if (!sort_along(begin, begin + count, before)) {
        for (std::uint32_t k = 1; k < count; ++k) {
            if (before(begin[k - 1], begin[k]) > 0) continue;
            cut.crossing_touches(cut.crossings[begin[k - 1]]);
            cut.crossing_touches(cut.crossings[begin[k]]);
        }
        return Verdict::kDegenerate;
    }
    for (std::uint32_t k = 1; k < count; ++k)
        if (enters(cut, cut.crossings[begin[k - 1]]) == enters(cut, cut.crossings[begin[k]])) return Verdict::kBroken;
    return Verdict::kFine;
}

Verdict order_edges(Cut& cut, bool of_world, std::vector<Cut::Range>& ranges) {
    for (const std::uint32_t crossing : cut.met)
        if (cut.crossings[crossing].of_world == of_world) ++ranges[cut.crossings[crossing].edge].count;
    std::uint32_t total = std::uint32_t(cut.along.size());
    for (Cut::Range& range : ranges) {
        range.first = total;
        total += range.count;
        range.count = 0;
    }
    cut.along.resize(total);
    for (const std::uint32_t crossing : cut.met) {
        if (cut.crossings[crossing].of_world != of_world) continue;
        Cut::Range& range = ranges[cut.crossings[crossing].edge];
        cut.along[range.first + range.count++] = crossing;
    }
    Verdict all = Verdict::kFine;
    for (const Cut::Range& range : ranges) {
        if (range.count == 0) continue;
        const Verdict verdict = order_along(cut, range.first, range.count);
        if (verdict != Verdict::kFine) all = verdict;
        if (cut.stops_at(verdict)) break;
    }
    return all;
}

/// Sets a label; false when another stands there.
bool set(Where& label, Where value) {
    if (label == Where::kUnknown) label = value;
    return label == value;
}

/// Labels spread along edges without a cut until none is left to tell.
class Flood {
public:
    explicit Flood(std::vector<Where>& labels) : labels_(labels), first_(labels.size() + 1, 0) {}

    void count(std::uint32_t a, std::uint32_t b) {
        ++first_[a + 1];
        ++first_[b + 1];
        ends_.push_back({a, b});
    }
    void ready() {
        for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
        others_.resize(2 * ends_.size());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (const auto& [a, b] : ends_) {
            others_[next[a]++] = b;
            others_[next[b]++] = a;
        }
    }
    /// From a vertex with a label; false where it meets another label.
    bool spread(std::uint32_t from) {
        waiting_.assign(1, from);
        while (!waiting_.empty()) {
            const std::uint32_t vertex = waiting_.back();
            waiting_.pop_back();
            for (std::uint32_t k = first_[vertex]; k < first_[vertex + 1]; ++k) {
                Where& label = labels_[others_[k]];
                if (label == labels_[vertex]) continue;
                if (label != Where::kUnknown) return false;
                label = labels_[vertex];
                waiting_.push_back(others_[k]);
            }
        }
        return true;
    }
    bool spread_all() {
        for (std::uint32_t vertex = 0; vertex < labels_.size(); ++vertex)
            if (labels_[vertex] != Where::kUnknown && !spread(vertex)) return false;
        return true;
    }

private:
    std::vector<Where>& labels_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;
    std::vector<std::uint32_t> first_, others_, waiting_;
};

/// Surely; the point lies within a step of its rounded one.
bool is_outside(const CutterSolid& cutter, const GridPoint& p) {
    const GridBox& box = cutter.box;
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < std::int64_t(box.low[axis]) - 1 || p[axis] > std::int64_t(box.high[axis]) + 1) return true;
    GridBox at;
    at.add(p);
    return cutter.bevelled.clear_of(at, 1, [&](std::size_t) { return p; }, 1);
}

template <class Ends>
bool label_ends_of_cut_edges(const Cut& cut, const std::vector<Cut::Range>& ranges, std::vector<Where>& labels,
                             const Ends& ends) {
    for (std::uint32_t edge = 0; edge < ranges.size(); ++edge) {
        const Cut::Range& range = ranges[edge];
        if (range.count == 0) continue;
        const auto [a, b] = ends(edge);
        const bool first_enters = enters(cut, cut.crossings[cut.along[range.first]]);
        const bool last_enters = enters(cut, cut.crossings[cut.along[range.first + range.count - 1]]);
        if (!set(labels[a], first_enters ? Where::kOutside : Where::kInside)) return false;
        if (!set(labels[b], last_enters ? Where::kInside : Where::kOutside)) return false;
    }
    return true;
}

Verdict label_world(Cut& cut) {
    const SolidPatch& patch = *cut.patch;
    std::vector<Where>& labels = cut.world_label;
    labels.assign(patch.vertices.size(), Where::kUnknown);
    const auto ends = [&](std::uint32_t edge) {
        return std::pair(patch.edges[edge].vertex[0], patch.edges[edge].vertex[1]);
    };
    if (!label_ends_of_cut_edges(cut, cut.world_cuts, labels, ends)) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v)
        if (is_outside(*cut.cutter, patch.vertices[v].point.rounded()) && !set(labels[v], Where::kOutside))
            return Verdict::kBroken;
    Flood flood(labels);
    for (std::uint32_t edge = 0; edge < patch.edges.size(); ++edge)
        if (cut.world_cuts[edge].count == 0 && !patch.edges[edge].split())
            flood.count(patch.edges[edge].vertex[0], patch.edges[edge].vertex[1]);
    flood.ready();
    if (!flood.spread_all()) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
        if (labels[v] != Where::kUnknown) continue;
        const int side = side_of_cutter(*cut.cutter, patch.vertices[v].point);
        if (side == 0) return Verdict::kDegenerate;
        labels[v] = side > 0 ? Where::kInside : Where::kOutside;
        if (!flood.spread(v)) return Verdict::kBroken;
    }
    return Verdict::kFine;
}

Verdict label_cutter(Cut& cut, const LocateInSolid& locate) {
    const CutterSolid& cutter = *cut.cutter;
    std::vector<Where>& labels = cut.cutter_label;
    labels.assign(cutter.points.size(), Where::kUnknown);
    const auto ends = [&](std::uint32_t edge) { return std::pair(cutter.edges[edge].a, cutter.edges[edge].b); };
    if (!label_ends_of_cut_edges(cut, cut.cutter_cuts, labels, ends)) return Verdict::kBroken;
    Verdict verdict = Verdict::kFine;
    Flood flood(labels);
    for (std::uint32_t edge = 0; edge < cutter.edges.size(); ++edge)
        if (cut.cutter_cuts[edge].count == 0) flood.count(cutter.edges[edge].a, cutter.edges[edge].b);
    flood.ready();
    if (!flood.spread_all()) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
        if (labels[v] != Where::kUnknown) continue;
        labels[v] = locate(v);
        if (labels[v] == Where::kUnknown) {
            cut.touches(v);
            verdict = Verdict::kDegenerate;
            if (!cut.collects) return verdict;
            labels[v] = Where::kOutside;  // whatever it is: the rest of its shell need not be asked
        }
        if (!flood.spread(v)) return Verdict::kBroken;
    }
    return verdict;
}

}  // namespace

Verdict order_cuts(Cut& cut) {
    cut.along.clear();
    cut.world_cuts.assign(cut.patch->edges.size(), {});
    cut.cutter_cuts.assign(cut.cutter->edges.size(), {});
    const Verdict world = order_edges(cut, true, cut.world_cuts);
    if (cut.stops_at(world)) return world;
    const Verdict cutter = order_edges(cut, false, cut.cutter_cuts);
    return cutter == Verdict::kFine ? world : cutter;
}

Verdict label_vertices(Cut& cut, const LocateInSolid& locate) {
    const Verdict verdict = label_world(cut);
    return verdict == Verdict::kFine ? label_cutter(cut, locate) : verdict;
}

}  // namespace firma
