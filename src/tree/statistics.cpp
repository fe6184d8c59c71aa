// SPDX-License-Identifier: MIT
// What a tree came to.
#include "tree/statistics.h"

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
    TreeStatistics total(const Block& root) {
        count_block(root, 0);
        const std::size_t inner = statistics_.bins - statistics_.leaf_bins;
        statistics_.overlap = inner ? overlap_sum_ / double(inner) : 0;
        return statistics_;
    }

private:
    void count_block(const Block& block, int depth) {
        ++statistics_.blocks;
        statistics_.faces += block.faces.size();
        statistics_.bytes += bytes_of(block);
        count_bin(block, 0, depth);
    }

    void count_bin(const Block& block, std::uint32_t index, int depth) {
        const Bin& bin = block.bins[index];
        if (bin.is_leaf() && block.holds_blocks()) return count_block(*block.children[bin.first], depth);
        ++statistics_.bins;
        statistics_.depth = std::max(statistics_.depth, depth);
        if (bin.is_leaf()) {
            ++statistics_.leaf_bins;
            statistics_.largest_bin = std::max<std::size_t>(statistics_.largest_bin, bin.count);
            return;
        }
        const double whole = half_area(bin.box, bin.box);
        const double shared = half_area(block.bins[index + 1].box, block.bins[bin.first].box);
        overlap_sum_ += whole > 0 ? shared / whole : 0;
        count_bin(block, index + 1, depth + 1);
        count_bin(block, bin.first, depth + 1);
    }

    TreeStatistics statistics_;
    double overlap_sum_ = 0;
};

}  // namespace

std::size_t bytes_of(const Block& block) {
    return pool_size(sizeof(Block)) + pool_size_of(block.bins) + pool_size_of(block.children) +
           pool_size_of(block.faces) + pool_size_of(block.vertices) + pool_size_of(block.corner_vertices) +
           pool_size_of(block.owners);
}

TreeStatistics tree_statistics(const Block& root) {
    return Counter().total(root);
}

}  // namespace firma
