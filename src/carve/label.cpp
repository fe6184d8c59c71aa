// SPDX-License-Identifier: MIT
// From crossings to labels.
#include "carve/label.h"

namespace firma {
namespace {

/// Sets a label; false when another stands there.
bool set(CutSide& label, CutSide value) {
    if (label == CutSide::kUnknown) label = value;
    return label == value;
}

/// Labels spread along edges without a cut until none is left to tell.
class Flood {
public:
    explicit Flood(std::vector<CutSide>& labels) : labels_(labels), first_(labels.size() + 1, 0) {}

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
                CutSide& label = labels_[others_[k]];
                if (label == labels_[vertex]) continue;
                if (label != CutSide::kUnknown) return false;
                label = labels_[vertex];
                waiting_.push_back(others_[k]);
            }
        }
        return true;
    }
    bool spread_all() {
        for (std::uint32_t vertex = 0; vertex < labels_.size(); ++vertex)
            if (labels_[vertex] != CutSide::kUnknown && !spread(vertex)) return false;
        return true;
    }

private:
    std::vector<CutSide>& labels_;
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
bool label_ends_of_cut_edges(const CutInput& in, const Crossings& crossings, const CutOrder& order,
                             const std::vector<CutOrder::Range>& ranges, const Ends& ends,
                             std::vector<CutSide>& labels) {
    const auto enters_at = [&](std::uint32_t k) { return enters(in, crossings.points[order.along[k]]); };
    for (std::uint32_t edge = 0; edge < ranges.size(); ++edge) {
        const CutOrder::Range& range = ranges[edge];
        if (range.count == 0) continue;
        const auto [a, b] = ends(edge);
        const bool first_enters = enters_at(range.first);
        const bool last_enters = enters_at(range.first + range.count - 1);
        if (!set(labels[a], first_enters ? CutSide::kOutside : CutSide::kInside)) return false;
        if (!set(labels[b], last_enters ? CutSide::kInside : CutSide::kOutside)) return false;
    }
    return true;
}

Verdict label_world(const CutInput& in, const Crossings& crossings, const CutOrder& order,
                    std::vector<CutSide>& labels) {
    const SolidPatch& patch = in.patch;
    labels.assign(patch.vertices.size(), CutSide::kUnknown);
    const auto ends = [&](std::uint32_t edge) {
        return std::pair(patch.edges[edge].vertex[0], patch.edges[edge].vertex[1]);
    };
    if (!label_ends_of_cut_edges(in, crossings, order, order.world_cuts, ends, labels)) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v)
        if (is_outside(in.cutter, patch.vertices[v].point.rounded()) && !set(labels[v], CutSide::kOutside))
            return Verdict::kBroken;
    Flood flood(labels);
    for (std::uint32_t edge = 0; edge < patch.edges.size(); ++edge)
        if (order.world_cuts[edge].count == 0 && !patch.edges[edge].split())
            flood.count(patch.edges[edge].vertex[0], patch.edges[edge].vertex[1]);
    flood.ready();
    if (!flood.spread_all()) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
        if (labels[v] != CutSide::kUnknown) continue;
        const int side = side_of_cutter(in.cutter, patch.vertices[v].point);
        if (side == 0) return Verdict::kDegenerate;
        labels[v] = side > 0 ? CutSide::kInside : CutSide::kOutside;
        if (!flood.spread(v)) return Verdict::kBroken;
    }
    return Verdict::kFine;
}

Verdict label_cutter(const CutInput& in, const Crossings& crossings, const CutOrder& order, const LocateInSolid& locate,
                     std::vector<CutSide>& labels) {
    const CutterSolid& cutter = in.cutter;
    labels.assign(cutter.points.size(), CutSide::kUnknown);
    const auto ends = [&](std::uint32_t edge) { return std::pair(cutter.edges[edge].a, cutter.edges[edge].b); };
    if (!label_ends_of_cut_edges(in, crossings, order, order.cutter_cuts, ends, labels)) return Verdict::kBroken;
    Flood flood(labels);
    for (std::uint32_t edge = 0; edge < cutter.edges.size(); ++edge)
        if (order.cutter_cuts[edge].count == 0) flood.count(cutter.edges[edge].a, cutter.edges[edge].b);
    flood.ready();
    if (!flood.spread_all()) return Verdict::kBroken;
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
        if (labels[v] != CutSide::kUnknown) continue;
        labels[v] = locate(v);
        if (labels[v] == CutSide::kUnknown) return Verdict::kDegenerate;
        if (!flood.spread(v)) return Verdict::kBroken;
    }
    return Verdict::kFine;
}

}  // namespace

Verdict label_vertices(const CutInput& in, const Crossings& crossings, const CutOrder& order,
                       const LocateInSolid& locate, Labels& labels) {
    const Verdict world = label_world(in, crossings, order, labels.world);
    if (world != Verdict::kFine) return world;
    return label_cutter(in, crossings, order, locate, labels.cutter);
}

}  // namespace firma
