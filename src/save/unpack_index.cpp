// SPDX-License-Identifier: MIT
// The index of a saved world. Nodes come with their children before them, so each is complete when it is read, and none
// can be its own child.
#include "save/unpack_index.h"

#include <algorithm>

#include "base/pool.h"
#include "save/sections.h"
#include "solid/build_blocks.h"

namespace firma {
namespace {

constexpr std::uint32_t kMostBins = 2 * kNodeItems - 1;

/// A box within the world, of numbers.
bool usable(const BoxF& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(double(box.low[axis]) >= -kWorldRim && box.low[axis] <= box.high[axis] &&
              double(box.high[axis]) <= kWorldRim))
            return false;
    return true;
}

class IndexReader {
public:
    IndexReader(Sections& sections, const UnpackedData& data, const FaceSet& faces, Damage& damage)
        : data_(data), faces_(faces), damage_(damage) {
        blocks_ = sections.entries(kIndexBlocksSection, 4);
        block_faces_ = sections.entries(kIndexFacesSection, 4);
        nodes_ = sections.entries(kIndexNodesSection, kNodeBytes);
        bins_ = sections.entries(kIndexBinsSection, kBinBytes);
        children_ = sections.entries(kIndexChildrenSection, 4);
        roots_ = sections.entries(kIndexRootsSection, 4);
    }

    std::optional<UnpackedIndex> read() {
        if (damage_.error()) return {};
        for (std::size_t k = 0; k < blocks_.count(); ++k)
            if (!read_block(k)) return {};
        for (std::size_t k = 0; k < nodes_.count(); ++k)
            if (!read_node(k)) return {};
        for (const Entries* part : {&block_faces_, &bins_, &children_})
            if (part->left() > 0)
                return damage_.report(part->type(), part->taken(), "belongs to nothing"), std::nullopt;
        if (roots_.count() != 2 + data_.rooms) {
            damage_.report(roots_.type(),
                           "has not an entry for the solid, for what is castable only, and for each room");
            return {};
        }
        UnpackedIndex index;
        for (std::size_t k = 0; k < roots_.count(); ++k) {
            const std::uint32_t root = read_u32(roots_.at(k));
            if (root != kNoEntry && root >= made_.size())
                return damage_.report(roots_.type(), k, "names a node that is not there"), std::nullopt;
            Ref<const Node> node = root == kNoEntry ? Ref<const Node>() : made_[root];
            if (k < 2)
                (k == 0 ? index.solid : index.castable) = std::move(node);
            else
                index.rooms.push_back(std::move(node));
        }
        if (facets_below(index.solid) + facets_below(index.castable) != faces_.faces.size()) {
            damage_.report(roots_.type(), "does not lead to as many faces as there are");
            return {};
        }
        return index;
    }

private:
    static std::size_t facets_below(const Ref<const Node>& root) { return root ? root->facets_below : 0; }

    bool read_block(std::size_t entry) {
        const std::uint32_t count = read_u32(blocks_.at(entry));
        const auto fault = [&](const char* reason) { return damage_.report(blocks_.type(), entry, reason); };
        if (count == 0 || count > kNodeItems) return fault("does not hold 1 to 64 faces");
        if (count > block_faces_.left()) return fault("holds more faces than there are");
        numbers_.clear();
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t at = block_faces_.taken();
            numbers_.push_back(read_u32(block_faces_.take(1)));
            if (numbers_.back() >= faces_.faces.size())
                return damage_.report(block_faces_.type(), at, "names a face that is not there");
            if (faces_.faces[numbers_.back()].part != faces_.faces[numbers_[0]].part)
                return fault("holds faces of several rooms");
        }
        made_blocks_.push_back(make_block(faces_, numbers_, scratch_));
        return true;
    }

    bool read_node(std::size_t entry) {
        const std::byte* at = nodes_.at(entry);
        const std::uint32_t bins = read_u16(at), children = read_u16(at + 2), block = read_u32(at + 4);
        const auto fault = [&](const char* reason) { return damage_.report(nodes_.type(), entry, reason); };
        if ((children == 0) != (block != kNoEntry)) return fault("holds both faces and nodes, or neither");
        if (children == 1) return fault("holds a single node");
        if (children > kNodeItems || bins > kMostBins) return fault("holds more than a node can");
        if (children > children_.left() || bins > bins_.left()) return fault("holds more than there is");
        if (block != kNoEntry && block >= made_blocks_.size()) return fault("names a block that is not there");
        Ref<Node> node(new Node);
        node->children.reserve(children);
        std::size_t below = 0;
        for (std::uint32_t k = 0; k < children; ++k) {
            const std::size_t child = children_.taken();
            const std::uint32_t number = read_u32(children_.take(1));
            if (number >= made_.size())
                return damage_.report(children_.type(), child, "names a node that does not come before");
            node->children.push_back(made_[number]);
            below += made_[number]->facets_below;
        }
        if (block != kNoEntry) {
            if (!made_blocks_[block]->lanes.empty()) return fault("names a block that another one holds");
            node->facets = Ref<const IndexedFacets>(made_blocks_[block].get());
            below = made_blocks_[block]->faces.size();
        }
        if (below > faces_.faces.size()) return fault("holds more faces than there are");
        node->facets_below = std::uint32_t(below);
        if (!read_bins(*node, bins, children > 0 ? children : std::uint32_t(below), entry)) return false;
        if (block != kNoEntry)
            layout_.make(*node, *made_blocks_[block]);
        else
            widener_.widen(*node);
        made_.emplace_back(node.get());
        return true;
    }

    bool read_bins(Node& node, std::uint32_t count, std::uint32_t items, std::size_t entry) {
        const std::size_t before = bins_.taken();
        const std::byte* at = bins_.take(count);
        node.bins.resize(count);
        for (std::uint32_t k = 0; k < count; ++k, at += kBinBytes) {
            Bin& bin = node.bins[k];
            for (int axis = 0; axis < 3; ++axis) {
                bin.box.low[axis] = read_f32(at + 4 * axis);
                bin.box.high[axis] = read_f32(at + 12 + 4 * axis);
            }
            bin.first = read_u32(at + 24);
            bin.count = read_u32(at + 28);
            if (!usable(bin.box)) return damage_.report(bins_.type(), before + k, "its box is none within the world");
        }
        next_item_ = 0;
        int depth = 0;
        const std::uint32_t end = follow_bins(node, 0, 0, depth);
        if (end != count || next_item_ != items)
            return damage_.report(nodes_.type(), entry, "its tree nodes are not one tree over its items");
        if (depth > kDeepestTree) return damage_.report(nodes_.type(), entry, "makes an index deeper than any is");
        node.depth = std::uint16_t(depth);
        return true;
    }

    /// Goes through the bins in the order in which they must stand, each once; items likewise.
    /// @return where this subtree ends; 0 when it is none
    std::uint32_t follow_bins(const Node& node, std::uint32_t at, int above, int& deepest) {
        if (at >= node.bins.size()) return 0;
        const Bin& bin = node.bins[at];
        if (!bin.is_leaf()) {
            if (follow_bins(node, at + 1, above + 1, deepest) != bin.first || bin.first == 0) return 0;
            return follow_bins(node, bin.first, above + 1, deepest);
        }
        if (bin.first != next_item_ || bin.count > kNodeItems) return 0;
        next_item_ += bin.count;
        int depth = above;
        if (!node.is_leaf()) {
            if (bin.count != 1 || bin.first >= node.children.size()) return 0;
            depth += node.children[bin.first]->depth;
        }
        deepest = std::max(deepest, depth);
        return at + 1;
    }

    const UnpackedData& data_;
    const FaceSet& faces_;
    Damage& damage_;
    Entries blocks_, block_faces_, nodes_, bins_, children_, roots_;
    std::vector<Ref<Block>> made_blocks_;
    std::vector<Ref<const Node>> made_;
    std::vector<std::uint32_t> numbers_;
    VertexTable scratch_;
    FaceLayout layout_;
    BinWidener widener_;
    std::uint32_t next_item_ = 0;
};

}  // namespace

std::optional<UnpackedIndex> unpack_index(Sections& sections, const UnpackedData& data, const FaceSet& faces,
                                          Damage& damage) {
    if (!sections.has(kIndexRootsSection)) return {};
    const PoolInLargePages large_pages;
    return IndexReader(sections, data, faces, damage).read();
}

}  // namespace firma
