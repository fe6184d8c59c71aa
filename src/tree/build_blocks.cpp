// SPDX-License-Identifier: MIT
// From faces to a tree of blocks: first one binary tree of bins over all faces, then cut into blocks.
#include "tree/build_blocks.h"

#include <algorithm>

namespace firma {
namespace {

TreeOptions in_range(TreeOptions options) {
    options.max_depth = std::clamp(options.max_depth, 0, 64);
    options.faces_per_bin = std::max(options.faces_per_bin, 1);
    return options;
}

/// The stop rules.
bool is_done(std::size_t count, const GridBox& box, int depth, const TreeOptions& options) {
    if (count <= std::size_t(options.faces_per_bin) || depth >= options.max_depth) return true;
    return options.min_bin_volume > 0 && box.volume() < options.min_bin_volume;
}

/// The bins below `top` that become blocks of their own: the fullest is opened until there are 64 or all fit a leaf
/// block.
std::vector<std::uint32_t> choose_children(const BinTree& tree, std::uint32_t top) {
    const std::vector<BinNode>& nodes = tree.nodes;
    std::vector<std::uint32_t> chosen{top};
    while (chosen.size() < kBlockItems) {
        const auto fullest = std::max_element(chosen.begin(), chosen.end(), [&](std::uint32_t a, std::uint32_t b) {
            return nodes[a].count < nodes[b].count;
        });
        const BinNode& node = nodes[*fullest];
        if (node.count <= kBlockItems) break;
        *fullest = node.left;
        chosen.insert(fullest + 1, node.right);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

/// In order of first use: never by address.
std::uint16_t owner_index(Block& block, const FaceOwner* owner) {
    for (std::size_t k = block.owners.size(); k-- > 0;)
        if (block.owners[k].get() == owner) return std::uint16_t(k);
    block.owners.emplace_back(owner);
    return std::uint16_t(block.owners.size() - 1);
}

}  // namespace

Ref<const Block> BlockBuilder::build(const FaceSet& faces, const TreeOptions& options, int depth) {
    if (faces.faces.empty()) return {};
    faces_ = &faces;
    tree_.items.resize(faces.faces.size());
    tree_.nodes.clear();
    tree_.nodes.reserve(faces.faces.size());
    for (std::uint32_t k = 0; k < tree_.items.size(); ++k) {
        tree_.items[k] = {faces.box_of(faces.faces[k]), k};
    }
    const TreeOptions rules = in_range(options);
    divide_bins(tree_, 0, std::uint32_t(tree_.items.size()), depth,
                [&](std::span<BuildItem> items, const GridBox& box, int at) -> std::size_t {
                    if (!is_done(items.size(), box, at, rules)) return split_bin(items, box, rules.split);
                    return items.size() <= kBlockItems ? 0 : split_by_count(items);
                });
    return pack(0);
}

Ref<const Block> BlockBuilder::pack(std::uint32_t top) {
    return tree_.nodes[top].count <= kBlockItems ? pack_faces(top) : pack_blocks(top);
}

Ref<const Block> BlockBuilder::pack_faces(std::uint32_t top) {
    Ref<Block> block(new Block);
    const BinNode& node = tree_.nodes[top];
    bins_.clear();
    int deepest = 0;
    append_bins(tree_, top, 0, bins_, [&](std::uint32_t index, Bin& bin, int depth) {
        const BinNode& it = tree_.nodes[index];
        if (it.left != 0) return false;
        bin.first = it.first - node.first;
        bin.count = it.count;
        deepest = std::max(deepest, depth);
        return true;
    });
    block->bins.assign(bins_.begin(), bins_.end());
    block->depth = std::uint16_t(deepest);
    block->faces_below = node.count;

    std::size_t corners = 0;
    for (const BuildItem& item : tree_.items_of(node)) corners += faces_->faces[item.face].corner_count;
    vertices_.start(corners);
    block->faces.reserve(node.count);
    block->corner_vertices.reserve(corners);
    for (const BuildItem& item : tree_.items_of(node)) add_face(*block, faces_->faces[item.face]);
    block->vertices.assign(vertices_.vertices.begin(), vertices_.vertices.end());
    block->owners.shrink_to_fit();
    return Ref<const Block>(block.get());
}

void BlockBuilder::add_face(Block& block, const FaceSet::Entry& face) {
    FaceRecord record;
    record.id = face.id;
    record.source = face.source;
    record.material = face.material;
    record.mask = face.mask;
    record.two_sided = face.two_sided;
    record.solid = face.solid;
    record.edit = face.edit;
    record.owner = face.owner ? owner_index(block, face.owner) : kNoOwner;
    record.first_corner = std::uint16_t(block.corner_vertices.size());
    record.corner_count = std::uint8_t(face.corner_count);
    for (std::uint32_t c = 0; c < face.corner_count; ++c)
        block.corner_vertices.push_back(vertices_.index_of(faces_->corner(face, c)));
    block.faces.push_back(record);
}

Ref<const Block> BlockBuilder::pack_blocks(std::uint32_t top) {
    Ref<Block> block(new Block);
    const std::vector<std::uint32_t> chosen = choose_children(tree_, top);
    bins_.clear();
    std::vector<int> depths;
    append_bins(tree_, top, 0, bins_, [&](std::uint32_t index, Bin& bin, int depth) {
        if (!std::binary_search(chosen.begin(), chosen.end(), index)) return false;
        bin.first = std::uint32_t(depths.size());
        bin.count = 1;
        depths.push_back(depth);
        return true;
    });
    block->bins.assign(bins_.begin(), bins_.end());
    block->faces_below = tree_.nodes[top].count;
    block->children.reserve(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        block->children.push_back(pack(chosen[k]));
        block->depth = std::uint16_t(std::max<int>(block->depth, depths[k] + block->children[k]->depth));
    }
    return Ref<const Block>(block.get());
}

// By surface area also where faces are split otherwise: blocks that edits made overlap more than bins do, and a walk
// pays for overlap here more than anywhere.
void BlockBuilder::divide(std::span<const Ref<const Block>> blocks) {
    constexpr int kUnevenLevels = 12;  // then in halves: what the rule peels off one by one must not make a deep tree
    tree_.items.resize(blocks.size());
    tree_.nodes.clear();
    halved_.clear();
    for (std::uint32_t k = 0; k < blocks.size(); ++k) tree_.items[k] = {to_grid(blocks[k]->bins[0].box), k};
    divide_bins(tree_, 0, std::uint32_t(blocks.size()), 0,
                [&](std::span<BuildItem> items, const GridBox&, int depth) -> std::size_t {
                    if (items.size() == 1) return 0;
                    if (items.size() == 2) {  // either way alike
                        if (items[1].face < items[0].face) std::swap(items[0], items[1]);
                        return 1;
                    }
                    const std::size_t left = depth < kUnevenLevels ? split_by_area(items) : 0;
                    if (left != 0) return left;
                    halved_.push_back(std::uint32_t(tree_.nodes.size() - 1));
                    return split_by_count(items);
                });
}

Ref<const Block> BlockBuilder::join(std::span<const Ref<const Block>> blocks) {
    return join_below(0, blocks);
}

Ref<const Block> BlockBuilder::join_group(std::span<const Ref<const Block>> blocks, const Group& group) {
    // Each block is a leaf of the division, so the bins below one stand in a row with it, one less than twice as many.
    const std::uint32_t end = group.bin + 2 * tree_.nodes[group.bin].count - 1;
    const auto halved = std::lower_bound(halved_.begin(), halved_.end(), group.bin);
    if (halved != halved_.end() && *halved < end) return {};
    return join_below(group.bin, blocks);
}

Ref<const Block> BlockBuilder::join_below(std::uint32_t top, std::span<const Ref<const Block>> blocks) {
    Ref<Block> block(new Block);
    block->children.reserve(tree_.nodes[top].count);
    bins_.clear();
    append_bins(tree_, top, 0, bins_, [&](std::uint32_t index, Bin& bin, int depth) {
        const BinNode& node = tree_.nodes[index];
        if (node.left != 0) return false;
        const Ref<const Block>& child = blocks[tree_.items[node.first].face];
        bin.first = std::uint32_t(block->children.size());
        bin.count = 1;
        block->children.push_back(child);
        block->faces_below += child->faces_below;
        block->depth = std::uint16_t(std::max<int>(block->depth, depth + child->depth));
        return true;
    });
    block->bins.assign(bins_.begin(), bins_.end());
    return Ref<const Block>(block.get());
}

void BlockBuilder::group(std::span<const Ref<const Block>> blocks, std::size_t most_blocks, std::size_t most_faces,
                         std::vector<std::uint32_t>& order, std::vector<Group>& groups) const {
    order.clear();
    groups.clear();
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {  // parents stand before their children, left before right
        const BinNode& node = tree_.nodes[n];
        if (node.first < order.size()) continue;  // of a group already
        std::size_t faces = 0;
        for (const BuildItem& item : tree_.items_of(node)) faces += blocks[item.face]->faces_below;
        if (node.count > 1 && (node.count > most_blocks || faces > most_faces)) continue;
        for (const BuildItem& item : tree_.items_of(node)) order.push_back(item.face);
        groups.push_back({order.size(), std::uint32_t(n)});
    }
}

Ref<const Block> build_blocks(const FaceSet& faces, const TreeOptions& options) {
    return BlockBuilder().build(faces, options);
}

}  // namespace firma
