// SPDX-License-Identifier: MIT
// Crossings in their order along each edge.
#include "carve/order_cuts.h"

#include "carve/sort_along.h"

namespace firma {
namespace {

const Plane& plane_crossed(const CutInput& in, const CutPoint& crossing) {
    return crossing.of_world ? in.cutter.planes[crossing.face]->plane : in.patch.faces[crossing.face].plane->plane;
}

const ExactPoint& start_of(const CutInput& in, const CutPoint& crossing) {
    return crossing.of_world ? in.patch.vertices[in.patch.edges[crossing.edge].vertex[0]].point
                             : in.cutter.points[in.cutter.edges[crossing.edge].a];
}

class Orderer {
public:
    Orderer(const CutInput& in, const Crossings& crossings, CutOrder& order)
        : in_(in), crossings_(crossings), order_(order) {}

    Verdict order() {
        order_.along.clear();
        order_.world_cuts.assign(in_.patch.edges.size(), {});
        order_.cutter_cuts.assign(in_.cutter.edges.size(), {});
        const Verdict verdict = order_edges(true, order_.world_cuts);
        return verdict == Verdict::kFine ? order_edges(false, order_.cutter_cuts) : verdict;
    }

private:
    /// Orders crossings of one edge: b comes before a when it lies on the start's side of a's plane.
    Verdict order_along(const CutOrder::Range& range) {
        const auto begin = order_.along.begin() + range.first;
        const auto before = [&](std::uint32_t a, std::uint32_t b) {
            const CutPoint& at_a = crossings_.points[a];
            const Plane& plane = plane_crossed(in_, at_a);
            return -exact_side(plane, crossings_.points[b].point) * exact_side(plane, start_of(in_, at_a));
        };
        if (!sort_along(begin, begin + range.count, before)) return Verdict::kDegenerate;
        for (std::uint32_t k = 1; k < range.count; ++k)
            if (enters(in_, crossings_.points[begin[k - 1]]) == enters(in_, crossings_.points[begin[k]]))
                return Verdict::kBroken;
        return Verdict::kFine;
    }

    Verdict order_edges(bool of_world, std::vector<CutOrder::Range>& ranges) {
        for (const std::uint32_t crossing : crossings_.met)
            if (crossings_.points[crossing].of_world == of_world) ++ranges[crossings_.points[crossing].edge].count;
        std::uint32_t total = std::uint32_t(order_.along.size());
        for (CutOrder::Range& range : ranges) {
            range.first = total;
            total += range.count;
            range.count = 0;
        }
        order_.along.resize(total);
        for (const std::uint32_t crossing : crossings_.met) {
            if (crossings_.points[crossing].of_world != of_world) continue;
            CutOrder::Range& range = ranges[crossings_.points[crossing].edge];
            order_.along[range.first + range.count++] = crossing;
        }
        for (const CutOrder::Range& range : ranges) {
            if (range.count == 0) continue;
            const Verdict verdict = order_along(range);
            if (verdict != Verdict::kFine) return verdict;
        }
        return Verdict::kFine;
    }

    const CutInput& in_;
    const Crossings& crossings_;
    CutOrder& order_;
};

}  // namespace

bool enters(const CutInput& in, const CutPoint& crossing) {
    return exact_side(plane_crossed(in, crossing), start_of(in, crossing)) > 0;
}

Verdict order_cuts(const CutInput& in, const Crossings& crossings, CutOrder& order) {
    return Orderer(in, crossings, order).order();
}

}  // namespace firma
