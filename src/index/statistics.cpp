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
        count_bin(node, 0, depth);
    }

    void count_bin(const Node& node, std::uint32_t index, int depth) {
        const Bin& bin = node.bins[index];
        if (bin.is_leaf() && !node.is_leaf()) return count_node(*node.children[bin.first], depth);
        ++statistics_.nodes;
        statistics_.depth = std::max(statistics_.depth, depth);
        if (bin.is_leaf()) {
            ++statistics_.leaves;
            statistics_.max_leaf_faces = std::max<std::size_t>(statistics_.max_leaf_faces, bin.count);
            return;
        }
        const double whole = half_area(bin.box, bin.box);
        const double shared = half_area(node.bins[index + 1].box, node.bins[bin.first].box);
        overlap_sum_ += whole > 0 ? shared / whole : 0;
        count_bin(node, index + 1, depth + 1);
        count_bin(node, bin.first, depth + 1);
    }

    TreeStatistics statistics_;
    double overlap_sum_ = 0;
};

}  // namespace

std::size_t bytes_of(const Node& node) {
    return pool_size(sizeof(Node)) + pool_size_of(node.bins) + pool_size_of(node.wide) + pool_size_of(node.children);
}

TreeStatistics tree_statistics(const Node& root) {
    return Counter().total(root);
}

}  // namespace firma
