// SPDX-License-Identifier: MIT
// Changing which faces there are, block by block.
#include "solid/edit_blocks.h"

#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "index/box_growth.h"
#include "index/traverse.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

constexpr std::size_t kPlacesInAStep = 128;
constexpr std::size_t kBlocksTogether = 32;  ///< divided anew in one step

/// What is divided anew is so by the rules for so many levels of bins; what is left then is halved by count.
int depth_of_rebuilt(std::size_t faces) {
    return std::bit_width(faces) + 16;
}

}  // namespace

BlockEdit::BlockEdit(const TreeOptions& options) : options_(options) {}

void BlockEdit::remove(const FacetPlace& facet) {
    FIRMA_ASSERT(facet.block && facet.slot < facet.block->faces.size(), "remove() takes a face of a block");
    FIRMA_ASSERT(phase_ == Phase::kStart, "all changes come before the first step()");
    std::uint32_t& known = number_of_.at(reinterpret_cast<std::uintptr_t>(facet.block));
    if (known == FlatMap::kNone) {
        known = std::uint32_t(blocks_.size());
        blocks_.push_back(facet.block);
    }
    goes_.push_back({known, facet.slot});
}

void BlockEdit::add(FaceSet&& faces) {
    FIRMA_ASSERT(phase_ == Phase::kStart && added_.faces.empty(), "faces are added once, before the first step()");
    added_ = std::move(faces);
}

bool BlockEdit::step() {
    switch (phase_) {
        case Phase::kStart:
            start();
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

/// In an order of their own, not that in which faces were removed.
void BlockEdit::sort_blocks() {
    const std::vector<const Block*> before = blocks_;
    std::sort(blocks_.begin(), blocks_.end(),
              [](const Block* a, const Block* b) { return a->faces[0].id < b->faces[0].id; });
    for (std::uint32_t k = 0; k < blocks_.size(); ++k) number_of_.at(reinterpret_cast<std::uintptr_t>(blocks_[k])) = k;
    for (Change& change : goes_) change.place = number_of_.find(reinterpret_cast<std::uintptr_t>(before[change.place]));
}

void BlockEdit::start() {
    sort_blocks();
    std::sort(goes_.begin(), goes_.end());
    goes_.erase(std::unique(goes_.begin(), goes_.end()), goes_.end());
    std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> of_parts;
    for (std::uint32_t k = 0; k < blocks_.size(); ++k) {
        const std::uint32_t part = blocks_[k]->part;
        std::uint32_t& known = tree_of_part_.at(part);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(of_parts.size());
            of_parts.push_back({part, {}});
        }
        of_parts[known].second.push_back(k);
    }
    for (const auto& [part, blocks] : of_parts) group_blocks(part, blocks);
    phase_ = Phase::kPlace;
}

void BlockEdit::group_blocks(std::uint32_t part, const std::vector<std::uint32_t>& blocks) {
    std::vector<NodeItem> items;
    for (const std::uint32_t k : blocks) items.push_back({nullptr, blocks_[k]->box(), true});
    joiner_.divide(items);
    std::vector<std::uint32_t> nodes;
    joiner_.group(kBlocksTogether, nodes);
    PartTree& tree = trees_.emplace_back();
    tree.part = part;
    group_below(tree, blocks, 0);
}

std::uint32_t BlockEdit::group_below(PartTree& tree, const std::vector<std::uint32_t>& blocks, std::uint32_t node) {
    const auto at = std::uint32_t(tree.nodes.size());
    const BinNode& it = joiner_.tree().nodes[node];
    tree.nodes.push_back({it.box, kNone, kNone, kNone});
    if (joiner_.count_below(node) <= kBlocksTogether) {
        tree.nodes[at].group = std::uint32_t(groups_.size());
        Group& group = groups_.emplace_back();
        group.part = tree.part;
        joiner_.for_each_below(node, [&](std::uint32_t item) { group.blocks.push_back(blocks[item]); });
        return at;
    }
    const std::uint32_t left = group_below(tree, blocks, it.left), right = group_below(tree, blocks, it.right);
    tree.nodes[at].left = left;
    tree.nodes[at].right = right;
    return at;
}

void BlockEdit::place_some() {
    const std::size_t end = std::min(added_.faces.size(), next_ + kPlacesInAStep);
    for (; next_ < end; ++next_) comes_.push_back({place(added_.faces[next_]), std::uint32_t(next_)});
    if (next_ < added_.faces.size()) return;
    std::sort(comes_.begin(), comes_.end());
    next_ = 0;
    phase_ = groups_.empty() ? Phase::kDone : Phase::kRebuild;
}

/// The group that a face goes to: one of its part, down the tree to where boxes have to grow least.
std::uint32_t BlockEdit::place(const FaceSet::Entry& face) {
    std::uint32_t& known = tree_of_part_.at(face.part);
    if (known == FlatMap::kNone) {
        known = std::uint32_t(trees_.size());
        trees_.push_back({face.part, {{{}, kNone, kNone, std::uint32_t(groups_.size())}}});
        groups_.emplace_back().part = face.part;
    }
    const PartTree& tree = trees_[known];
    const GridBox box = added_.box_of(face);
    std::uint32_t at = 0;
    while (tree.nodes[at].group == kNone) {
        const std::uint32_t left = tree.nodes[at].left, right = tree.nodes[at].right;
        at = goes_right(tree.nodes[left].box, tree.nodes[right].box, box) ? right : left;
    }
    return tree.nodes[at].group;
}

void BlockEdit::rebuild_one() {
    clear(faces_);
    for (const std::uint32_t block : groups_[next_].blocks) {
        auto goes = std::lower_bound(goes_.begin(), goes_.end(), Change{block, 0});
        append_faces(*blocks_[block], faces_, [&](std::uint32_t slot) {
            if (goes == goes_.end() || *goes != Change{block, slot}) return true;
            ++goes;
            return false;
        });
    }
    const auto group = std::uint32_t(next_);
    for (auto comes = std::lower_bound(comes_.begin(), comes_.end(), Change{group, 0});
         comes != comes_.end() && comes->place == group; ++comes)
        append_face(added_, added_.faces[comes->index], faces_);
    TreeOptions rules = options_;
    rules.max_depth = std::min(rules.max_depth, depth_of_rebuilt(faces_.faces.size()));
    builder_.build_leaves(faces_, rules, made_);
    if (++next_ == groups_.size()) phase_ = Phase::kDone;
}

}  // namespace firma
