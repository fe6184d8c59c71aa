// SPDX-License-Identifier: MIT
// Changing a tree of blocks: find what is touched, place what comes, rebuild from the bottom up.
// Source: for where a face goes, A. Guttman, R-Trees: A Dynamic Index Structure for Spatial Searching, 1984, section
// 3.2; for blocks that split and merge, R. Bayer, E. McCreight, Organization and Maintenance of Large Ordered Indices,
// 1972.
#include "tree/edit_blocks.h"

#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/fetch_ahead.h"
#include "tree/append_faces.h"
#include "tree/bin_growth.h"

namespace firma {
namespace {

constexpr std::size_t kFindsInAStep = 32;
constexpr std::size_t kPlacesInAStep = 128;
constexpr std::size_t kLeavesTogether = 8;  ///< leaf blocks rebuilt in one step
constexpr std::size_t kSmall = 32;          ///< faces in blocks side by side that become one leaf block
constexpr std::size_t kFewestChildren = 8;  ///< a block of fewer hands them to the block above

/// What is rebuilt from scratch divides by the rules for so many levels of bins, and halves what is left by count.
int depth_of_rebuilt(std::size_t faces) {
    return std::bit_width(faces) + 16;
}

/// A deeper tree is rebuilt from scratch, and is then less deep than this: log2(faces / 64) levels halve any rest.
int deepest_of(std::size_t faces) {
    return 2 * std::bit_width(faces) + 16;
}

void append_face(const FaceSet& from, const FaceSet::Entry& face, FaceSet& to) {
    FaceSet::Entry entry = face;
    entry.first_corner = std::uint32_t(to.corners.size());
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
        to.corners.push_back(std::uint32_t(to.vertices.size()));
        to.vertices.push_back(from.corner(face, c));
    }
    to.faces.push_back(entry);
}

}  // namespace

BlockEdit::BlockEdit(Ref<const Block> root, const TreeOptions& options) : root_(std::move(root)), options_(options) {}

void BlockEdit::remove(const Block* leaf, std::uint32_t slot) {
    FIRMA_ASSERT(leaf && !leaf->holds_blocks() && slot < leaf->faces.size(), "remove() takes a face of the tree");
    FIRMA_ASSERT(touched_.empty(), "all changes come before the first step()");
    removed_.push_back({leaf, slot});
}

void BlockEdit::add(FaceSet&& faces) {
    FIRMA_ASSERT(touched_.empty(), "all changes come before the first step()");
    if (added_.faces.empty()) {
        added_ = std::move(faces);
        return;
    }
    for (const FaceSet::Entry& face : faces.faces) append_face(faces, face, added_);
    for (Ref<const FaceOwner>& owner : faces.owners) added_.owners.push_back(std::move(owner));
}

bool BlockEdit::step() {
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

// ---- what is touched ----

void BlockEdit::find_some() {
    if (!root_) {
        result_ = builder_.build(added_, options_);
        phase_ = Phase::kDone;
        return;
    }
    if (touched_.empty()) touched_.push_back({.block = root_.get()});
    for (std::size_t left = kFindsInAStep; left > 0 && next_ < removed_.size(); ++next_) {
        const auto [leaf, slot] = removed_[next_];
        const auto [known, is_new] = leaves_.try_emplace(leaf, kNone);
        if (is_new) {
            known->second = find_leaf(leaf, leaf->box_of(leaf->faces[slot]));
            FIRMA_ASSERT(known->second != kNone, "remove() takes a face of the tree");
            --left;
        }
        if (known->second != kNone) goes_.push_back({known->second, slot});
    }
    if (next_ < removed_.size()) return;
    std::sort(goes_.begin(), goes_.end());
    goes_.erase(std::unique(goes_.begin(), goes_.end()), goes_.end());
    next_ = 0;
    phase_ = Phase::kPlace;
}

std::uint32_t BlockEdit::touch(std::uint32_t parent, std::uint32_t item, int depth) {
    for (std::uint32_t k = touched_[parent].first_child; k != kNone; k = touched_[k].next_sibling)
        if (touched_[k].item == item) return k;
    const auto index = std::uint32_t(touched_.size());
    touched_.push_back({.block = touched_[parent].block->children[item].get(),
                        .item = item,
                        .depth = depth,
                        .next_sibling = touched_[parent].first_child});
    touched_[parent].first_child = index;
    return index;
}

/// Touches a leaf block and what lies above it.
/// @param box  of one of its faces: every bin on the way contains it, and few others do
/// @return kNone when the tree has no such leaf
std::uint32_t BlockEdit::find_leaf(const Block* leaf, const GridBox& box) {
    if (leaf == root_.get()) return 0;
    struct Way {
        std::uint32_t item;
        int depth;
    };
    std::vector<Way> way;
    const Bounds bounds(box);
    const auto search = [&](const auto& self, const Block& in, std::uint32_t index, int below) -> bool {
        const Bin& here = in.bins[index];
        if (!contains(here.box, bounds)) return false;
        if (!here.is_leaf()) return self(self, in, index + 1, below + 1) || self(self, in, here.first, below + 1);
        if (!in.holds_blocks()) return false;
        const Block& child = *in.children[here.first];
        way.push_back({here.first, below});
        if (&child == leaf || self(self, child, 0, below)) return true;
        way.pop_back();
        return false;
    };
    if (!search(search, *root_, 0, 0)) return kNone;
    std::uint32_t at = 0;
    for (const Way& step : way) at = touch(at, step.item, step.depth);
    return at;
}

// ---- where faces go ----

void BlockEdit::place_some() {
    const std::size_t end = std::min(added_.faces.size(), next_ + kPlacesInAStep);
    for (; next_ < end; ++next_) comes_.push_back({place(added_.box_of(added_.faces[next_])), std::uint32_t(next_)});
    if (next_ < added_.faces.size()) return;
    std::sort(comes_.begin(), comes_.end());
    gather_leaves();
    next_ = touched_.size();
    phase_ = Phase::kRebuild;
    if (goes_.empty() && comes_.empty()) {
        result_ = root_;
        phase_ = Phase::kDone;
    }
}

/// @return the leaf block, touched
std::uint32_t BlockEdit::place(const GridBox& box) {
    const Bounds bounds(box);
    std::uint32_t at = 0;
    const Block* block = root_.get();
    int depth = 0;
    std::uint32_t index = 0;
    while (block->holds_blocks()) {
        const Bin& bin = block->bins[index];
        if (bin.is_leaf()) {
            at = touch(at, bin.first, depth);
            block = touched_[at].block;
            index = 0;
            continue;
        }
        index = goes_right(block->bins[index + 1].box, block->bins[bin.first].box, bounds) ? bin.first : index + 1;
        ++depth;
    }
    return at;
}

// ---- from the bottom up ----

/// Divides the touched leaf blocks below each block into groups to be rebuilt together: what an edit moves about in one
/// place is then divided anew as a whole, and blocks do not grow into each other.
void BlockEdit::gather_leaves() {
    std::vector<std::uint32_t> leaves;
    for (const Touched& parent : touched_) {
        leaves.clear();
        for (std::uint32_t k = parent.first_child; k != kNone; k = touched_[k].next_sibling)
            if (!touched_[k].block->holds_blocks()) leaves.push_back(k);
        std::sort(leaves.begin(), leaves.end(), [&](std::uint32_t x, std::uint32_t y) {
            return touched_[x].item < touched_[y].item;  // not in the order they were come upon
        });
        if (leaves.size() < 2) continue;
        items_.clear();
        for (const std::uint32_t leaf : leaves) items_.push_back(BlockItem::of(*touched_[leaf].block, false));
        joiner_.divide(items_);
        joiner_.group(kLeavesTogether, nodes_);
        for (const std::uint32_t node : nodes_) {
            std::uint32_t last = kNone;
            joiner_.for_each_below(node, [&](std::uint32_t item) {
                if (last != kNone) {
                    touched_[last].next_together = leaves[item];
                    touched_[leaves[item]].follows = true;
                }
                last = leaves[item];
            });
        }
    }
}

void BlockEdit::rebuild_one() {
    Touched& touched = touched_[--next_];
    touched.first_piece = std::uint32_t(pieces_.size());
    if (touched.block->holds_blocks())
        rebuild_inner(std::uint32_t(next_));
    else
        rebuild_leaves(std::uint32_t(next_));
    touched.pieces = std::uint32_t(pieces_.size()) - touched.first_piece;
    if (next_ == 0) finish();
}

/// Puts what a leaf block will hold at the end of `faces_`.
void BlockEdit::append_changed(std::uint32_t index) {
    auto go = std::lower_bound(goes_.begin(), goes_.end(), Change{index, 0});
    append_faces(*touched_[index].block, faces_, [&](std::uint32_t slot) {
        if (go == goes_.end() || *go != Change{index, slot}) return true;
        ++go;
        return false;
    });
    for (auto come = std::lower_bound(comes_.begin(), comes_.end(), Change{index, 0});
         come != comes_.end() && come->leaf == index; ++come)
        append_face(added_, added_.faces[come->index], faces_);
}

void BlockEdit::rebuild_leaves(std::uint32_t index) {
    const Touched& touched = touched_[index];
    if (touched.follows) return;
    clear(faces_);
    for (std::uint32_t k = index; k != kNone; k = touched_[k].next_together) append_changed(k);
    TreeOptions rules = options_;
    rules.max_depth = std::min(rules.max_depth, touched.depth + depth_of_rebuilt(faces_.faces.size()));
    const Ref<const Block> built = builder_.build(faces_, rules, touched.depth);
    if (!built) return;
    if (!built->holds_blocks()) return pieces_.push_back(keep(built));
    for (const Ref<const Block>& block : built->children) pieces_.push_back(keep(block));
}

/// A block that the edit made.
BlockItem BlockEdit::keep(Ref<const Block> block) {
    made_.push_back(std::move(block));
    return BlockItem::of(*made_.back(), true);
}

void BlockEdit::rebuild_inner(std::uint32_t index) {
    collect_items(touched_[index]);
    // A block over nothing but leaf blocks leaves them to the block above, which divides those of all its touched
    // children as a whole: otherwise blocks side by side grow into each other, edit by edit.
    if (items_.empty() && index != 0) return void(pieces_.insert(pieces_.end(), loose_.begin(), loose_.end()));
    if (!items_.empty() && loose_.size() >= kFewestChildren) join_loose();
    items_.insert(items_.end(), loose_.begin(), loose_.end());
    if (items_.empty()) return;
    divide_items();
    join_items(index == 0 ? 2 : kFewestChildren);
}

/// The children as they are now, what took the place of touched ones and the others: leaf blocks in `loose_`, those
/// above leaf blocks in `items_`.
void BlockEdit::collect_items(const Touched& touched) {
    const Block& block = *touched.block;
    for (const Ref<const Block>& child : block.children) fetch_ahead(child.get());
    touched_by_.assign(block.children.size(), kNone);
    for (std::uint32_t k = touched.first_child; k != kNone; k = touched_[k].next_sibling)
        touched_by_[touched_[k].item] = k;
    items_.clear();
    loose_.clear();
    const auto add = [&](const BlockItem& item) { (item.of_faces ? loose_ : items_).push_back(item); };
    for (const Bin& bin : block.bins) {
        if (!bin.is_leaf()) continue;
        const Block& child = *block.children[bin.first];
        const std::uint32_t by = touched_by_[bin.first];
        if (by == kNone) {
            add({&child, bin.box, !child.holds_blocks(), false});
            continue;
        }
        for (std::uint32_t k = 0; k < touched_[by].pieces; ++k) add(pieces_[touched_[by].first_piece + k]);
    }
}

/// Makes blocks of the loose leaf blocks, which become items.
void BlockEdit::join_loose() {
    std::swap(items_, loose_);
    divide_items();
    const auto from = std::ptrdiff_t(pieces_.size());
    join_items(2);
    std::swap(items_, loose_);
    items_.insert(items_.end(), pieces_.begin() + from, pieces_.end());
    pieces_.resize(std::size_t(from));
    loose_.clear();
}

/// Blocks side by side in the division, a new one among them, that together hold few faces become one.
void BlockEdit::divide_items() {
    joiner_.divide(items_);
    const auto is_small = [](const BlockItem& item) { return item.is_new && item.block->faces_below < kSmall; };
    if (!std::any_of(items_.begin(), items_.end(), is_small)) return;
    joiner_.merge(items_, kSmall, [&](std::uint32_t node) {
        clear(faces_);
        joiner_.for_each_below(node, [&](std::uint32_t item) { append_all_faces(*items_[item].block, faces_); });
        return keep(builder_.build(faces_, options_));
    });
}

/// One block over the items, divided already, or several when there are more than 64; themselves when they are few.
void BlockEdit::join_items(std::size_t fewest) {
    joiner_.group(kBlockItems, nodes_);
    const bool few = joiner_.count_below(0) < fewest;
    for (const std::uint32_t node : nodes_) {
        if (few || joiner_.count_below(node) == 1) {
            joiner_.for_each_below(node, [&](std::uint32_t item) {
                pieces_.push_back(items_[item]);
                pieces_.back().is_new = true;
            });
            continue;
        }
        Ref<const Block> joined = joiner_.join(items_, node);
        if (joined->depth > deepest_of(joined->faces_below)) joined = from_scratch(*joined);
        pieces_.push_back(keep(std::move(joined)));
    }
}

Ref<const Block> BlockEdit::from_scratch(const Block& block) {
    clear(faces_);
    append_all_faces(block, faces_);
    TreeOptions rules = options_;
    rules.max_depth = std::min(rules.max_depth, depth_of_rebuilt(faces_.faces.size()));
    return builder_.build(faces_, rules);
}

/// What took the root's place becomes one block.
void BlockEdit::finish() {
    phase_ = Phase::kDone;
    items_.assign(pieces_.begin() + touched_[0].first_piece, pieces_.end());
    while (items_.size() > 1) {
        joiner_.divide(items_);
        const auto from = std::ptrdiff_t(pieces_.size());
        join_items(2);
        items_.assign(pieces_.begin() + from, pieces_.end());
    }
    if (!items_.empty()) result_ = Ref<const Block>(items_[0].block);
    if (result_ && result_->depth > kDeepestTree) result_ = from_scratch(*result_);
    made_.clear();
}

}  // namespace firma
