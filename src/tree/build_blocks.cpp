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

Ref<const Block> build_blocks(const FaceSet& faces, const TreeOptions& options) {
    return BlockBuilder().build(faces, options);
}

}  // namespace firma
