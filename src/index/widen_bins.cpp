// SPDX-License-Identifier: MIT
// From a binary tree of bins to wide nodes over the same items.
#include "index/widen_bins.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "index/box_growth.h"

namespace firma {

// ---- what is chosen ----

std::uint32_t BinWidener::add_part(const BinTree& tree, std::uint32_t bin, const Rule& rule) {
    const auto index = std::uint32_t(parts_.size());
    const BinNode& node = tree.nodes[bin];
    Part& made = parts_.emplace_back();
    made.bin = &node;
    made.what = bin;
    made.is_item = node.count <= rule.up_to || (rule.undivided && node.left == 0);

    if (parts_[index].is_item) return index;
    if (node.left == 0) {
        for (std::uint32_t lanes = 1; lanes < node.count; ++lanes)
            parts_[index].surface[lanes - 1] = float(half_area(node.box));
        return index;
    }
    const std::uint32_t left = add_part(tree, node.left, rule), right = add_part(tree, node.right, rule);
    parts_[index].left = left;
    parts_[index].right = right;
    choose_lanes(parts_[index]);
    return index;
}

/// From what is best for its two parts.
void BinWidener::choose_lanes(Part& part) const {
    const Part &left = parts_[part.left], &right = parts_[part.right];
    float least[kLanes];
    for (std::uint32_t lanes = 2; lanes <= kLanes; ++lanes) {
        least[lanes - 1] = std::numeric_limits<float>::infinity();
        for (std::uint32_t k = 1; k < lanes; ++k) {
            const float surface = left.surface[k - 1] + right.surface[lanes - k - 1];
            if (!(surface < least[lanes - 1])) continue;
            least[lanes - 1] = surface;
            part.left_lanes[lanes - 1] = std::uint8_t(k);
        }
    }
    part.left_lanes[0] = part.left_lanes[kLanes - 1];  // of a wide node of its own
    part.surface[0] = float(half_area(part.bin->box)) + least[kLanes - 1];
    for (std::uint32_t lanes = 2; lanes <= kLanes; ++lanes) {
        const bool fewer = part.surface[lanes - 2] < least[lanes - 1];
        part.surface[lanes - 1] = fewer ? part.surface[lanes - 2] : least[lanes - 1];
        if (fewer) part.left_lanes[lanes - 1] = 0;
    }
}

void BinWidener::add_tree_items(const BinTree& tree, const Part& part, Lanes& into) {
    for (std::uint32_t k = part.bin->first; k < part.bin->first + part.bin->count; ++k)
        into.add({&tree.items[k].box, k, Lane::kTreeItem});
}

/// A part over so many lanes at most.
void BinWidener::spread(const BinTree& tree, std::uint32_t index, std::uint32_t lanes, Lanes& into) const {
    const Part& part = parts_[index];
    while (lanes > 1 && part.left != 0 && part.left_lanes[lanes - 1] == 0) --lanes;
    if (part.is_item) return into.add({&part.bin->box, part.what, Lane::kBinItem});
    if (part.left == 0 && lanes >= part.bin->count) return add_tree_items(tree, part, into);
    if (part.left == 0 || lanes == 1) return into.add({&part.bin->box, index, Lane::kPart});
    spread(tree, part.left, part.left_lanes[lanes - 1], into);
    spread(tree, part.right, lanes - part.left_lanes[lanes - 1], into);
}

/// What the lanes of a part's own wide node lead to.
BinWidener::Lanes BinWidener::lanes_of(const BinTree& tree, std::uint32_t index, std::uint32_t depth) const {
    Lanes found;
    const Part& part = parts_[index];
    if (part.is_item) {
        found.add({&part.bin->box, part.what, Lane::kBinItem});
    } else if (part.left == 0) {
        add_tree_items(tree, part, found);
    } else if (depth <= kFreeDepth) {
        spread(tree, part.left, part.left_lanes[0], found);
        spread(tree, part.right, kLanes - part.left_lanes[0], found);
    } else {
        found.add({&part.bin->box, index, Lane::kPart});
        while (open_one(tree, found)) {
        }
    }
    return found;
}

/// Opens the first of the lanes that can be opened.
bool BinWidener::open_one(const BinTree& tree, Lanes& found) const {
    for (std::uint32_t k = 0; k < found.count; ++k) {
        if (found.lanes[k].kind != Lane::kPart) continue;
        const Part& part = parts_[found.lanes[k].what];
        Lanes opened;
        if (part.left == 0) {
            add_tree_items(tree, part, opened);
        } else {
            spread(tree, part.left, 1, opened);
            spread(tree, part.right, 1, opened);
        }
        if (found.count - 1 + opened.count > kLanes) continue;
        std::move_backward(found.lanes + k + 1, found.lanes + found.count,
                           found.lanes + found.count - 1 + opened.count);
        std::copy(opened.lanes, opened.lanes + opened.count, found.lanes + k);
        found.count += opened.count - 1;
        return true;
    }
    return false;
}

// ---- what is made of it ----

/// @return the part's height
std::uint16_t BinWidener::measure(const BinTree& tree, std::uint32_t index) {
    const Lanes found = lanes_of(tree, index, 1);
    std::uint16_t below = 0;
    for (std::uint32_t k = 0; k < found.count; ++k)
        if (found.lanes[k].kind == Lane::kPart) below = std::max(below, measure(tree, found.lanes[k].what));
    return parts_[index].height = std::uint16_t(below + 1);
}

/// Whether a part that is met so deep in a node has a node of its own: every second one, counted from below.
bool BinWidener::starts_node(const Part& part, std::uint32_t depth) const {
    constexpr std::uint32_t kAboveEachOther = 2;  // wide nodes of a node
    return part.height != 0 && (depth > kAboveEachOther || part.height % kAboveEachOther == 0);
}

std::uint32_t BinWidener::choose_all(const BinTree& tree) {
    parts_.clear();
    const std::uint32_t top = add_part(tree, 0, {kNodeItems, false});
    measure(tree, top);
    return top;
}

std::span<const BinWidener::Item> BinWidener::widen(Node& node, const BinTree& tree, std::uint32_t top) {
    parts_.clear();
    fill(node, tree, add_part(tree, top, {0, true}), false);
    return items_;
}

std::span<const BinWidener::Item> BinWidener::widen_items(Node& node, const BinTree& tree, std::uint32_t top) {
    parts_.clear();
    fill(node, tree, add_part(tree, top, {0, false}), true);
    return items_;
}

void BinWidener::hang(Node& node, const Item& item, const Node* child) {
    node.wide[item.above].lead_to(item.lane, child->wide.data());
    node.children.emplace_back(child);
    node.facets_below += child->facets_below;
    node.depth = std::max(node.depth, std::uint16_t(item.depth + child->depth));
}

void BinWidener::fill(Node& node, const BinTree& tree, std::uint32_t index, bool bins_are_one_item) {
    wide_.clear();
    lane_items_.clear();
    items_.clear();
    links_.clear();
    next_item_ = 0;
    node.box = parts_[index].bin->box;
    put(tree, index, 1, bins_are_one_item);
    node.wide = PoolVector<WideNode>(wide_.begin(), wide_.end());
    node.lane_items = PoolVector<LaneItems>(lane_items_.begin(), lane_items_.end());
    node.depth = 0;
    for (const Item& item : items_) node.depth = std::max(node.depth, std::uint16_t(item.depth));
    for (const Link& link : links_) node.wide[link.above].lead_to(link.lane, &node.wide[link.number]);
}

void BinWidener::put(const BinTree& tree, std::uint32_t index, std::uint32_t depth, bool bins_are_one_item) {
    const Lanes found = lanes_of(tree, index, depth);
    const auto number = std::uint32_t(wide_.size());
    const GridBox* boxes[kLanes];
    for (std::uint32_t k = 0; k < found.count; ++k) boxes[k] = found.lanes[k].box;
    set_boxes(wide_.emplace_back(), {boxes, found.count});
    lane_items_.emplace_back().count = std::uint8_t(found.count);
    for (std::uint32_t k = 0; k < found.count; ++k) {
        const Lane& lane = found.lanes[k];
        lane_items_[number].first[k] = std::uint8_t(next_item_);
        const bool is_part = lane.kind == Lane::kPart;
        if (is_part && !starts_node(parts_[lane.what], depth + 1)) {
            links_.push_back({number, k, std::uint32_t(wide_.size())});
            put(tree, lane.what, depth + 1, bins_are_one_item);
            continue;
        }
        items_.push_back({lane.what, number, k, depth, is_part});
        next_item_ += lane.kind == Lane::kBinItem && !bins_are_one_item ? tree.nodes[lane.what].count : 1;
    }
    LaneItems& made = lane_items_[number];
    std::fill(made.first + found.count, std::end(made.first), std::uint8_t(next_item_));
}

}  // namespace firma
