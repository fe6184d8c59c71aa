// SPDX-License-Identifier: MIT
// Changing an index: find what is touched, place what is added, make nodes anew from the bottom up.
// Source: for where a leaf goes, A. Guttman, R-Trees: A Dynamic Index Structure for Spatial Searching, 1984, section
// 3.2; for nodes that split and merge, R. Bayer, E. McCreight, Organization and Maintenance of Large Ordered Indices,
// 1972.
#include "index/edit_nodes.h"

#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/fetch_ahead.h"
#include "index/box_growth.h"
#include "index/traverse.h"

namespace firma {
namespace {

constexpr std::size_t kFindsInAStep = 32;
constexpr std::size_t kPlacesInAStep = 64;
constexpr double kCoversMuch = 0.1;         ///< of a node's surface: worth making anew with it
constexpr std::size_t kFewestChildren = 8;  ///< a node of fewer hands them to the node above

/// A deeper node is built anew over its leaves, and is then less deep than this.
int deepest_of(std::size_t facets) {
    return std::bit_width(facets) + 8;
}

/// The child whose box has to grow least for one more.
std::uint32_t child_to_grow(const Node& node, const GridBox& added) {
    std::uint32_t best = 0;
    Growth least(node.children[0]->box, added);
    for (std::uint32_t k = 1; k < node.children.size(); ++k) {
        const Growth growth(node.children[k]->box, added);
        if (!growth.better_than(least)) continue;
        best = k;
        least = growth;
    }
    return best;
}

}  // namespace

bool NodeEdit::step() {
    switch (phase_) {
        case Phase::kFind:
            find_some();
            break;
        case Phase::kPlace:
            place_some();
            break;
        case Phase::kRebuild:
            rebuild_one();
            break;
        case Phase::kDone:
            break;
    }
    return phase_ != Phase::kDone;
}

/// Over a single leaf, or nothing, there are no nodes to be kept.
void NodeEdit::start_over_leaf() {
    std::vector<Ref<const Node>> leaves;
    const bool stays = root_ && std::none_of(removed_.begin(), removed_.end(), [&](const Removed& removed) {
                           return removed.facets == root_->facets.get();
                       });
    FIRMA_ASSERT(removed_.empty() || (root_ && !stays), "remove() takes a leaf of the index");
    if (stays) leaves.push_back(root_);
    leaves.insert(leaves.end(), added_.begin(), added_.end());
    result_ = join_nodes(leaves);
    phase_ = Phase::kDone;
}

// ---- what is touched ----

void NodeEdit::find_some() {
    if (removed_.empty() && added_.empty()) {
        result_ = root_;
        phase_ = Phase::kDone;
        return;
    }
    if (!root_ || root_->is_leaf()) return start_over_leaf();
    if (touched_.empty()) touched_.push_back({.node = root_.get()});
    for (std::size_t left = kFindsInAStep; left > 0 && next_ < removed_.size(); --left, ++next_) {
        const bool found = find_leaf(removed_[next_]);
        FIRMA_ASSERT(found, "remove() takes a leaf of the index");
        static_cast<void>(found);
    }
    if (next_ < removed_.size()) return;
    next_ = 0;
    next_added_.assign(added_.size(), kNone);
    phase_ = Phase::kPlace;
}

std::uint32_t NodeEdit::touch(std::uint32_t parent, std::uint32_t item) {
    for (std::uint32_t k = touched_[parent].first_child; k != kNone; k = touched_[k].next_sibling)
        if (touched_[k].item == item) return k;
    const auto index = std::uint32_t(touched_.size());
    touched_.push_back({.node = touched_[parent].node->children[item].get(),
                        .item = item,
                        .next_sibling = touched_[parent].first_child});
    touched_[parent].first_child = index;
    return index;
}

/// Touches a leaf and what lies above it.
/// @return false when the index has no such leaf
bool NodeEdit::find_leaf(const Removed& removed) {
    std::vector<std::uint32_t> way;
    const auto search = [&](const auto& self, const Node& in, const WideNode& wide) -> bool {
        const unsigned around = lanes_around(wide, removed.box);
        for (std::uint32_t lane = 0; around >> lane; ++lane) {
            if (!(around >> lane & 1)) continue;
            const Node* const child = in.node_below(wide, lane);
            if (!child) {
                if (self(self, in, *wide.wide(lane))) return true;
                continue;
            }
            way.push_back(in.items_of(wide).first[lane]);
            if (child->is_leaf() ? child->facets.get() == removed.facets : self(self, *child, child->wide[0]))
                return true;
            way.pop_back();
        }
        return false;
    };
    if (!search(search, *root_, root_->wide[0])) return false;
    std::uint32_t at = 0;
    for (const std::uint32_t item : way) at = touch(at, item);
    return true;
}

// ---- where leaves go ----

void NodeEdit::place_some() {
    const std::size_t end = std::min(added_.size(), next_ + kPlacesInAStep);
    for (; next_ < end; ++next_) {
        Touched& parent = touched_[place(added_[next_]->box)];
        next_added_[next_] = parent.first_added;
        parent.first_added = std::uint32_t(next_);
    }
    if (next_ < added_.size()) return;
    touch_beside();
    next_ = touched_.size();
    phase_ = Phase::kRebuild;
}

/// The touched node above leaves that a box goes below.
std::uint32_t NodeEdit::place(const GridBox& box) {
    std::uint32_t at = 0;
    for (;;) {
        const Node& node = *touched_[at].node;
        const std::uint32_t item = child_to_grow(node, box);
        if (node.children[item]->is_leaf()) return at;
        at = touch(at, item);
    }
}

// ---- what lies beside it ----

/// For each node with touched children over leaves, one or two more of its children: see the head of edit_nodes.h.
void NodeEdit::touch_beside() {
    const std::size_t count = touched_.size();
    for (std::uint32_t parent = 0; parent < count; ++parent) {
        if (touched_[parent].first_child == kNone) continue;
        for (const double least : {0.0, kCoversMuch}) {
            const std::uint32_t item = find_beside(parent, least);
            if (item == kNone) break;
            touch(parent, item);
        }
    }
}

/// Of the children over leaves that are not touched, the one that covers most of one that is; or none.
/// @param least  so large a share of its surface at least
std::uint32_t NodeEdit::find_beside(std::uint32_t parent, double least) {
    const auto over_leaves = [](const Node& node) { return !node.is_leaf() && node.children[0]->is_leaf(); };
    const Node& node = *touched_[parent].node;
    for (const Ref<const Node>& child : node.children) fetch_ahead(child.get(), sizeof(Node));
    touched_by_.assign(node.children.size(), kNone);
    std::vector<GridBox> here;
    for (std::uint32_t k = touched_[parent].first_child; k != kNone; k = touched_[k].next_sibling) {
        touched_by_[touched_[k].item] = k;
        if (over_leaves(*touched_[k].node)) here.push_back(touched_[k].node->box);
    }
    if (here.empty()) return kNone;
    std::uint32_t found = kNone;
    double most = least;
    for (std::uint32_t item = 0; item < node.children.size(); ++item) {
        if (touched_by_[item] != kNone) continue;
        const Node& child = *node.children[item];
        double shared = 0;
        for (const GridBox& box : here) shared = std::max(shared, shared_half_area(child.box, box) / half_area(box));
        if (shared <= most || !over_leaves(child)) continue;
        found = item;
        most = shared;
    }
    return found;
}

// ---- nodes made anew ----

void NodeEdit::rebuild_one() {
    Touched& touched = touched_[--next_];
    touched.first_piece = std::uint32_t(pieces_.size());
    if (!touched.node->is_leaf()) rebuild_inner(std::uint32_t(next_));
    touched.pieces = std::uint32_t(pieces_.size()) - touched.first_piece;
    if (next_ == 0) finish();
}

/// A node that the edit made.
NodeItem NodeEdit::keep(Ref<const Node> node) {
    made_.push_back(std::move(node));
    return NodeItem::of(*made_.back());
}

void NodeEdit::rebuild_inner(std::uint32_t index) {
    collect_items(touched_[index]);
    // A node over nothing but leaves leaves them to the node above, which divides those of all its touched children as
    // a whole: otherwise nodes side by side grow into each other, edit by edit.
    if (items_.empty() && index != 0) return void(pieces_.insert(pieces_.end(), loose_.begin(), loose_.end()));
    if (!items_.empty() && loose_.size() >= kFewestChildren) join_loose();
    items_.insert(items_.end(), loose_.begin(), loose_.end());
    if (items_.empty()) return;
    joiner_.divide(items_);
    join_items(index == 0 ? 2 : kFewestChildren);
}

/// The children as they are now, what took the place of touched ones and the others: leaves in `loose_`, those above
/// leaves in `items_`.
void NodeEdit::collect_items(const Touched& touched) {
    const Node& node = *touched.node;
    for (const Ref<const Node>& child : node.children) fetch_ahead(child.get());
    touched_by_.assign(node.children.size(), kNone);
    for (std::uint32_t k = touched.first_child; k != kNone; k = touched_[k].next_sibling)
        touched_by_[touched_[k].item] = k;
    items_.clear();
    loose_.clear();
    const auto add = [&](const NodeItem& item) { (item.is_leaf ? loose_ : items_).push_back(item); };
    for (std::uint32_t item = 0; item < node.children.size(); ++item) {
        const std::uint32_t by = touched_by_[item];
        if (by == kNone) {
            add(NodeItem::of(*node.children[item]));
            continue;
        }
        for (std::uint32_t k = 0; k < touched_[by].pieces; ++k) add(pieces_[touched_[by].first_piece + k]);
    }
    for (std::uint32_t k = touched.first_added; k != kNone; k = next_added_[k]) add(NodeItem::of(*added_[k]));
}

/// Makes nodes of the loose leaves, which become items.
void NodeEdit::join_loose() {
    std::swap(items_, loose_);
    joiner_.divide(items_);
    const auto from = std::ptrdiff_t(pieces_.size());
    join_items(2);
    std::swap(items_, loose_);
    items_.insert(items_.end(), pieces_.begin() + from, pieces_.end());
    pieces_.resize(std::size_t(from));
    loose_.clear();
}

/// One node over the items, divided already, or several when there are more than 64; themselves when they are few.
void NodeEdit::join_items(std::size_t fewest) {
    joiner_.group(kNodeItems, groups_);
    const bool few = joiner_.count_below(0) < fewest;
    for (const std::uint32_t group : groups_) {
        if (few || joiner_.count_below(group) == 1) {
            joiner_.for_each_below(group, [&](std::uint32_t item) { pieces_.push_back(items_[item]); });
            continue;
        }
        Ref<const Node> joined = joiner_.join(items_, group);
        if (joined->depth > deepest_of(joined->facets_below)) joined = over_leaves(joined);
        pieces_.push_back(keep(std::move(joined)));
    }
}

Ref<const Node> NodeEdit::over_leaves(const Ref<const Node>& node) {
    std::vector<Ref<const Node>> leaves;
    for_each_leaf(node, [&](const Ref<const Node>& leaf) { leaves.push_back(leaf); });
    return join_nodes(leaves);
}

/// What took the root's place becomes one node.
void NodeEdit::finish() {
    phase_ = Phase::kDone;
    items_.assign(pieces_.begin() + touched_[0].first_piece, pieces_.end());
    while (items_.size() > 1) {
        joiner_.divide(items_);
        const auto from = std::ptrdiff_t(pieces_.size());
        join_items(2);
        items_.assign(pieces_.begin() + from, pieces_.end());
    }
    if (!items_.empty()) result_ = Ref<const Node>(items_[0].node);
    if (result_ && result_->depth > kDeepestTree) result_ = over_leaves(result_);
    made_.clear();
}

}  // namespace firma
