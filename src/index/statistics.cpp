// SPDX-License-Identifier: MIT
// What an index came to.
#include "index/statistics.h"

#include <algorithm>

namespace firma {
namespace {

/// Half the surface of what two boxes share; 0 when they lie beside each other. (Boxes of flat walls have no volume to
/// share.)
double half_area(const BoxF& a, const BoxF& b) {
    double extent[3];
    for (int axis = 0; axis < 3; ++axis) {
        extent[axis] = double(std::min(a.high[axis], b.high[axis])) - double(std::max(a.low[axis], b.low[axis]));
        const bool thick = a.low[axis] < a.high[axis] && b.low[axis] < b.high[axis];
        if (extent[axis] < 0 || (extent[axis] == 0 && thick)) return 0;
    }
    return extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0];
}

class Counter {
public:
    TreeStatistics total(const Node& root) {
        count_node(root, 0);
        const std::size_t inner = statistics_.nodes - statistics_.leaves;
        statistics_.overlap = inner ? overlap_sum_ / double(inner) : 0;
        return statistics_;
    }

private:
    void count_node(const Node& node, int depth) {
        ++statistics_.blocks;
        statistics_.bytes += bytes_of(node);
        if (node.is_leaf()) {
            statistics_.faces += node.facets_below;
            statistics_.bytes += node.facets->bytes();
        }
        count_wide(node, node.wide[0], depth);
    }

    void count_wide(const Node& node, const WideNode& wide, int depth) {
        ++statistics_.nodes;
        const LaneItems& items = node.items_of(wide);
        add_overlap(wide, items.count);
        for (std::uint32_t lane = 0; lane < items.count; ++lane) {
            if (wide.leads_to_facets(lane))
                count_leaf(items.items(lane), depth + 1);
            else if (const Node* const below = node.node_below(wide, lane))
                count_node(*below, depth + 1);
            else
                count_wide(node, *wide.wide(lane), depth + 1);
        }
    }

    void count_leaf(std::size_t faces, int depth) {
        ++statistics_.nodes;
        ++statistics_.leaves;
        statistics_.depth = std::max(statistics_.depth, depth);
        statistics_.max_leaf_faces = std::max(statistics_.max_leaf_faces, faces);
    }

    void add_overlap(const WideNode& wide, std::uint32_t lanes) {
        BoxF around = wide.box(0);
        double shared = 0;
        for (std::uint32_t k = 0; k < lanes; ++k) {
            const BoxF box = wide.box(k);
            for (int axis = 0; axis < 3; ++axis) {
                around.low[axis] = std::min(around.low[axis], box.low[axis]);
                around.high[axis] = std::max(around.high[axis], box.high[axis]);
            }
            for (std::uint32_t other = 0; other < k; ++other) shared += half_area(box, wide.box(other));
        }
        const double whole = half_area(around, around);
        overlap_sum_ += whole > 0 ? shared / whole : 0;
    }

    TreeStatistics statistics_;
    double overlap_sum_ = 0;
};

}  // namespace

std::size_t bytes_of(const Node& node) {
    return pool_size(sizeof(Node)) + pool_size_of(node.wide) + pool_size_of(node.lane_items) +
           pool_size_of(node.children);
}

TreeStatistics tree_statistics(const Node& root) {
    return Counter().total(root);
}

}  // namespace firma
