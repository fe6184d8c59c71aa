// SPDX-License-Identifier: MIT
// From faces to a tree of blocks: first one binary tree of bins over all faces, then cut into blocks.
#include "tree/build_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tree/split_bin.h"

namespace firma {
namespace {

/// A bin of the whole tree, before it is cut into blocks.
struct Node {
    GridBox box;
    std::uint32_t first = 0, count = 0;  ///< items below
    std::uint32_t left = 0, right = 0;   ///< 0: a leaf
};

float round_down(double value) {
    const float f = float(value);
    return double(f) > value ? std::nextafterf(f, -std::numeric_limits<float>::infinity()) : f;
}

float round_up(double value) {
    return -round_down(-value);
}

BoxF to_floats(const GridBox& box) {
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return {{round_down(low.x), round_down(low.y), round_down(low.z)},
            {round_up(high.x), round_up(high.y), round_up(high.z)}};
}

class Builder {
public:
    Builder(const FaceSet& faces, const TreeOptions& options) : faces_(faces), options_(options) {
        options_.max_depth = std::clamp(options_.max_depth, 0, 64);
        options_.faces_per_bin = std::max(options_.faces_per_bin, 1);
        items_.resize(faces.faces.size());
        for (std::uint32_t k = 0; k < items_.size(); ++k) {
            const FaceSet::Entry& face = faces.faces[k];
            items_[k].face = k;
            for (std::uint32_t c = 0; c < face.corner_count; ++c)
                items_[k].box.add(faces.vertices[faces.corners[face.first_corner + c]]);
        }
    }

    Ref<const Block> build() {
        nodes_.reserve(items_.size());
        divide(0, std::uint32_t(items_.size()), 0);
        return pack(0);
    }

private:
    std::span<BuildItem> items(std::uint32_t first, std::uint32_t count) { return {items_.data() + first, count}; }

    bool done(const Node& node, int depth) const {
        if (node.count <= std::uint32_t(options_.faces_per_bin) || depth >= options_.max_depth) return true;
        return options_.min_bin_volume > 0 && node.box.volume() < options_.min_bin_volume;
    }

    std::uint32_t divide(std::uint32_t first, std::uint32_t count, int depth) {
        const auto index = std::uint32_t(nodes_.size());
        Node node;
        node.first = first;
        node.count = count;
        for (const BuildItem& item : items(first, count)) node.box.add(item.box);
        nodes_.push_back(node);

        const bool is_done = done(node, depth);
        if (is_done && count <= kBlockItems) {
            // Standard libraries partition in different orders; faces lie in a bin by their own.
            const std::span<BuildItem> bin = items(first, count);
            std::sort(bin.begin(), bin.end(), [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
            return index;
        }
        const auto left = std::uint32_t(is_done ? split_by_count(items(first, count))
                                                : split_bin(items(first, count), node.box, options_.split));
        nodes_[index].left = divide(first, left, depth + 1);
        nodes_[index].right = divide(first + left, count - left, depth + 1);
        return index;
    }

    /// The bins below `top` that become blocks of their own: the fullest is opened until there are 64 or all fit a leaf
    /// block.
    std::vector<std::uint32_t> choose_children(std::uint32_t top) const {
        std::vector<std::uint32_t> chosen{top};
        while (chosen.size() < kBlockItems) {
            const auto fullest = std::max_element(chosen.begin(), chosen.end(), [&](std::uint32_t a, std::uint32_t b) {
                return nodes_[a].count < nodes_[b].count;
            });
            const Node& node = nodes_[*fullest];
            if (node.count <= kBlockItems) break;
            *fullest = node.left;
            chosen.insert(fullest + 1, node.right);
        }
        std::sort(chosen.begin(), chosen.end());
        return chosen;
    }

    Ref<const Block> pack(std::uint32_t top) {
        Ref<Block> block(new Block);
        if (nodes_[top].count <= kBlockItems) {
            add_face_bins(*block, top);
            add_faces(*block, nodes_[top]);
        } else {
            const std::vector<std::uint32_t> chosen = choose_children(top);
            add_block_bins(*block, top, chosen);
        }
        block->bins.shrink_to_fit();
        return Ref<const Block>(block.get());
    }

    /// Appends a bin for `index` and those below it; `leaf` says which items a bin holds, none for one to be opened.
    template <class Leaf>
    void add_bins(Block& block, std::uint32_t index, const Leaf& leaf) {
        const Node& node = nodes_[index];
        const std::size_t at = block.bins.size();
        block.bins.push_back({to_floats(node.box), 0, 0});
        if (leaf(index, block.bins[at])) return;
        add_bins(block, node.left, leaf);
        block.bins[at].first = std::uint32_t(block.bins.size());
        add_bins(block, node.right, leaf);
    }

    void add_face_bins(Block& block, std::uint32_t top) {
        const std::uint32_t base = nodes_[top].first;
        add_bins(block, top, [&](std::uint32_t index, Bin& bin) {
            const Node& node = nodes_[index];
            if (node.left != 0) return false;
            bin.first = node.first - base;
            bin.count = node.count;
            return true;
        });
    }

    void add_block_bins(Block& block, std::uint32_t top, const std::vector<std::uint32_t>& chosen) {
        add_bins(block, top, [&](std::uint32_t index, Bin& bin) {
            if (!std::binary_search(chosen.begin(), chosen.end(), index)) return false;
            bin.first = std::uint32_t(block.children.size());
            bin.count = 1;
            block.children.push_back(pack(index));
            return true;
        });
        block.children.shrink_to_fit();
    }

    void add_faces(Block& block, const Node& node) {
        std::vector<std::uint32_t> used;  // vertices of the block, sorted
        for (const BuildItem& item : items(node.first, node.count)) {
            const FaceSet::Entry& face = faces_.faces[item.face];
            const auto corners = faces_.corners.begin() + face.first_corner;
            used.insert(used.end(), corners, corners + face.corner_count);
        }
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        block.vertices.reserve(used.size());
        for (const std::uint32_t vertex : used) block.vertices.push_back(faces_.vertices[vertex]);

        block.faces.reserve(node.count);
        for (const BuildItem& item : items(node.first, node.count)) add_face(block, faces_.faces[item.face], used);
        block.corner_vertices.shrink_to_fit();
    }

    /// In order of first use: never by address.
    static std::uint16_t owner_index(Block& block, const FaceOwner* owner) {
        for (std::size_t k = block.owners.size(); k-- > 0;)
            if (block.owners[k].get() == owner) return std::uint16_t(k);
        block.owners.emplace_back(owner);
        return std::uint16_t(block.owners.size() - 1);
    }

    void add_face(Block& block, const FaceSet::Entry& face, const std::vector<std::uint32_t>& used) {
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
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const std::uint32_t vertex = faces_.corners[face.first_corner + c];
            const auto at = std::lower_bound(used.begin(), used.end(), vertex) - used.begin();
            block.corner_vertices.push_back(std::uint16_t(at));
        }
        block.faces.push_back(record);
    }

    const FaceSet& faces_;
    TreeOptions options_;
    std::vector<BuildItem> items_;
    std::vector<Node> nodes_;
};

}  // namespace

Ref<const Block> build_blocks(const FaceSet& faces, const TreeOptions& options) {
    if (faces.faces.empty()) return {};
    return Builder(faces, options).build();
}

}  // namespace firma
