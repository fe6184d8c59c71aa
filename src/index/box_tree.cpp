// SPDX-License-Identifier: MIT
// Builds the tree from the top: across the longest axis of the centres, through the middle of their range.
#include "index/box_tree.h"

#include <utility>

namespace firma {
namespace {

/// A box's centre, rounded down.
GridPoint centre_of(const GridBox& box) {
    GridPoint centre;
    for (int axis = 0; axis < 3; ++axis)
        centre[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) >> 1);
    return centre;
}

}  // namespace

BoxTree::BoxTree(std::span<const GridBox> boxes) {
    items_.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) items_.push_back({boxes[k], std::uint32_t(k)});
    nodes_.reserve(boxes.size());
    if (!boxes.empty()) build(0, std::uint32_t(boxes.size()), 0);
}

void BoxTree::build(std::uint32_t first, std::uint32_t count, int depth) {
    GridBox box, centres;
    for (std::uint32_t k = first; k < first + count; ++k) {
        box.add(items_[k].box);
        centres.add(centre_of(items_[k].box));
    }
    const std::size_t at = nodes_.size();
    nodes_.push_back({box, first, count});
    if (count <= kLeafItems) return;
    std::uint32_t left = depth < kFreeDepth ? divide(first, count, centres) : 0;
    if (left == 0) left = count / 2;  // as they stand: centres in one place, or a division that got nowhere
    nodes_[at].count = 0;
    build(first, left, depth + 1);
    nodes_[at].first = std::uint32_t(nodes_.size());
    build(first + left, count - left, depth + 1);
}

/// Puts those with centres in the lower half of the range first. Both sides get some, but where all centres are one: 0.
/// Our own loop, as std::partition leaves the order to the library.
std::uint32_t BoxTree::divide(std::uint32_t first, std::uint32_t count, const GridBox& centres) {
    int axis = 0;
    std::int64_t longest = -1;
    for (int k = 0; k < 3; ++k) {
        const std::int64_t extent = std::int64_t(centres.high[k]) - centres.low[k];
        if (extent > longest) {
            longest = extent;
            axis = k;
        }
    }
    if (longest == 0) return 0;
    const std::int64_t middle = (std::int64_t(centres.low[axis]) + centres.high[axis]) >> 1;
    std::uint32_t low = first, high = first + count;
    while (low < high) {
        const GridBox& box = items_[low].box;
        if ((std::int64_t(box.low[axis]) + box.high[axis]) >> 1 <= middle)
            ++low;
        else
            std::swap(items_[low], items_[--high]);
    }
    return low - first;
}

}  // namespace firma
