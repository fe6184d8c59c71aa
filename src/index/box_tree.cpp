// SPDX-License-Identifier: MIT
// Builds the tree from the top: across the longest axis of the centres, through the middle of their range.
#include "index/box_tree.h"

#include <cstring>
#include <utility>

namespace firma {
namespace {

/// Taken together by a processor (as GCC and Clang write it): an axis each; the last is not used.
using FourOf [[gnu::vector_size(16)]] = std::int32_t;

/// The sides of a box that another number stands behind. Whole lines of memory: what stands behind them is in the last
/// place.
struct FourSides {
    FourOf low, high;

    explicit FourSides(const GridBox& box) {
        static_assert(sizeof(GridPoint) == 12 && sizeof(BoxTree::Item) == 28);
        std::memcpy(&low, reinterpret_cast<const char*>(&box), sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&box) + sizeof(GridPoint), sizeof high);
    }
    FourSides(const FourOf& low_side, const FourOf& high_side) : low(low_side), high(high_side) {}

    void add(const FourSides& other) {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
    /// Rounded down.
    FourOf centre() const { return (low & high) + ((low ^ high) >> 1); }
    bool meets(const FourSides& other) const {
        const FourOf apart = (low > other.high) | (other.low > high);
        return (apart[0] | apart[1] | apart[2]) == 0;
    }
    GridBox box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

}  // namespace

BoxTree::BoxTree(std::span<const GridBox> boxes) {
    items_.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) items_.push_back({boxes[k], std::uint32_t(k)});
    nodes_.reserve(boxes.size());
    if (!boxes.empty()) build(0, std::uint32_t(boxes.size()), 0);
}

void BoxTree::build(std::uint32_t first, std::uint32_t count, int depth) {
    FourSides around(items_[first].box), centres(around.centre(), around.centre());
    for (std::uint32_t k = first + 1; k < first + count; ++k) {
        const FourSides sides(items_[k].box);
        const FourOf centre = sides.centre();
        around.add(sides);
        centres.add({centre, centre});
    }
    const std::size_t at = nodes_.size();
    nodes_.push_back({around.box(), first, count});
    if (count <= kLeafItems) return;
    std::uint32_t left = depth < kFreeDepth ? divide(first, count, centres.box()) : 0;
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

std::size_t BoxTree::find_near(const GridBox& box, std::uint32_t least, std::vector<Item>& near) const {
    const FourSides sides(box);
    const auto meets = [&](const GridBox& other) { return sides.meets(FourSides(other)); };
    std::uint32_t waiting[kDeepest + 1];
    waiting[0] = 0;
    std::size_t found = 0;
    for (int count = 1; count > 0;) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        if (node.count == 0) {  // a child is written down whether it counts or not: that is hard to predict
            waiting[count] = node.first;
            count += meets(nodes_[node.first].box);
            waiting[count] = at + 1;
            count += meets(nodes_[at + 1].box);
            continue;
        }
        if (near.size() < found + kLeafItems) near.resize(2 * near.size() + kLeafItems);
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            near[found] = items_[k];
            found += std::size_t(items_[k].number > least) & std::size_t(meets(items_[k].box));
        }
    }
    return found;
}

std::size_t BoxTree::those_meeting(const Item& item, std::span<const Item> near, std::uint32_t* met) {
    const FourSides sides(item.box);
    std::size_t count = 0;
    for (const Item& other : near) {  // all are written down: whether one counts is hard to predict
        met[count] = other.number;
        count += std::size_t(other.number > item.number) & std::size_t(sides.meets(FourSides(other.box)));
    }
    return count;
}

}  // namespace firma
