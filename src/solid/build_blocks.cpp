// SPDX-License-Identifier: MIT
// From faces to blocks, and an index over them.
#include "solid/build_blocks.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/pool.h"
#include "index/divide_together.h"
#include "index/join_nodes.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

TreeOptions in_range(TreeOptions options) {
    options.max_depth = std::clamp(options.max_depth, 0, 64);
    options.faces_per_leaf = std::max(options.faces_per_leaf, 1);
    return options;
}

/// The stop rules of a bin's depth and size.
bool ends_here(std::span<const BuildItem> items, const GridBox& box, int depth, const TreeOptions& options) {
    if (depth >= options.max_depth || items.size() == 1) return true;
    return options.min_node_volume > 0 && box.volume() < options.min_node_volume;
}

/// The one of its faces.
bool has_few(const FaceSet& faces, std::span<const BuildItem> items, const TreeOptions& options) {
    // In eights, as casts look at them.
    const std::size_t most =
        (std::size_t(options.faces_per_leaf) + FaceLanes::kLanes - 1) / FaceLanes::kLanes * FaceLanes::kLanes;
    if (items.size() > most) return false;
    std::size_t triangles = 0;
    for (const BuildItem& item : items) triangles += faces.faces[item.face].corner_count - 2;
    return triangles <= most;
}

/// Faces that casts look at together are divided, too, where the boxes around two parts of them have less than this
/// share of the surface: large faces of levels, of which a cast would often look at some for the sake of others.
constexpr double kApart = 0.55;

/// In order of first use: never by address.
std::uint32_t owner_index(Block& block, const FaceOwner* owner) {
    for (std::size_t k = block.owners.size(); k-- > 0;)
        if (block.owners[k].get() == owner) return std::uint32_t(k);
    block.owners.emplace_back(owner);
    return std::uint32_t(block.owners.size() - 1);
}

void add_face(Block& block, const FaceSet::Entry& face) {
    FaceRecord record;
    record.id = face.id;
    record.source = face.source;
    record.material = face.material;
    record.mask = face.mask;
    record.two_sided = face.two_sided;
    record.solid = face.solid;
    record.edit = face.edit;
    record.owner = face.owner ? owner_index(block, face.owner) : kNoOwner;
    record.corner_count = face.corner_count & kLastCornerCount;
    block.mask_of_all &= face.mask;
    block.faces.push_back(record);
}

/// One block of some faces, in this order; without its lanes, which have the corners.
/// @param items  faces of one part, 1 to kNodeItems
Ref<Block> make_block(const FaceSet& faces, std::span<const BuildItem> items) {
    Ref<Block> block(new Block);
    block->part = faces.faces[items[0].face].part;
    block->faces.reserve(items.size());
    for (const BuildItem& item : items) add_face(*block, faces.faces[item.face]);
    block->owners.shrink_to_fit();
    return block;
}

}  // namespace

Ref<const Node> BlockBuilder::build(const FaceSet& faces, const TreeOptions& options, std::size_t by_area,
                                    LongWork* work) {
    if (faces.faces.empty()) return {};
    const std::size_t apart = options.split == Split::kSurfaceArea ? FaceLanes::kLanes : 0;
    if (!divide(faces, options, {.above = by_area, .apart = apart}, work)) return {};
    const auto leaf_of = [&](std::uint32_t bin) {
        if (kHasLongWork && !packed_.empty()) return std::move(packed_[bin]);
        return pack_leaf(bin, layout_);
    };
    packed_.clear();
    if (kHasLongWork && work && !pack_leaves(*work)) return {};
    const Ref<const Node> root = widener_.widen_all(tree_, leaf_of);
    return join_nodes({&root, 1});
}

bool BlockBuilder::pack_leaves(LongWork& work) {
    constexpr std::size_t kTogether = 64;  // leaves
    std::vector<std::uint32_t> leaves, open{0};
    while (!open.empty()) {
        const BinNode& node = tree_.nodes[open.back()];
        if (node.count <= kNodeItems) leaves.push_back(open.back());
        open.pop_back();
        if (node.count > kNodeItems) open.insert(open.end(), {node.right, node.left});
    }
    packed_.resize(tree_.nodes.size());
    return work.each((leaves.size() + kTogether - 1) / kTogether, [&](std::size_t part) {
        FaceLayout layout;
        std::size_t done = 0;
        const std::size_t end = std::min(leaves.size(), (part + 1) * kTogether);
        for (std::size_t k = part * kTogether; k < end; ++k) {
            packed_[leaves[k]] = pack_leaf(leaves[k], layout);
            done += tree_.nodes[leaves[k]].count;
        }
        work.add(done);
    });
}

void BlockBuilder::build_leaves(const FaceSet& faces, const TreeOptions& options,
                                std::vector<Ref<const Node>>& leaves) {
    if (faces.faces.empty()) return;
    divide(faces, options, {.above = 0, .apart = 0});
    const auto below = [&](const auto& self, std::uint32_t bin) -> void {
        const BinNode& node = tree_.nodes[bin];
        if (node.count <= kNodeItems) return leaves.push_back(pack_leaf(bin, layout_));
        self(self, node.left);
        self(self, node.right);
    };
    below(below, 0);
}

/// @return false when the work was stopped
bool BlockBuilder::divide(const FaceSet& faces, const TreeOptions& options, const ByArea& by_area, LongWork* work) {
    faces_ = &faces;
    tree_.items.resize(faces.faces.size());
    tree_.nodes.clear();
    tree_.nodes.reserve(faces.faces.size());
    for (std::uint32_t k = 0; k < tree_.items.size(); ++k) {
        tree_.items[k] = {faces.box_of(faces.faces[k]), k};
    }
    const TreeOptions rules = in_range(options);
    const auto split = [&](std::span<BuildItem> items, const GridBox& box, int at) -> std::size_t {
        if (ends_here(items, box, at, rules)) return items.size() <= kNodeItems ? 0 : split_by_count(items);
        if (!has_few(faces, items, rules)) {
            // Those that casts look at together need not be divided well.
            if (items.size() <= FaceLanes::kLanes) return split_bin(items, box, Split::kLongestAxis);
            if (items.size() <= by_area.above) return split_bin(items, box, rules.split);
            const std::size_t left = split_by_area(items, box);
            return left != 0 ? left : split_by_count(items);
        }
        if (items.size() <= by_area.apart) return split_apart(items, box, kApart);
        return items.size() <= kNodeItems ? 0 : split_by_count(items);
    };
    if (kHasLongWork && work) {
        if (!divide_together(tree_, split, *work)) return false;
        constexpr std::size_t kTogether = 4096;  // bins
        return work->each((tree_.nodes.size() + kTogether - 1) / kTogether, [&](std::size_t part) {
            const std::size_t end = std::min(tree_.nodes.size(), (part + 1) * kTogether);
            for (std::size_t k = part * kTogether; k < end; ++k) sort_by_id(tree_.nodes[k]);
        });
    }
    divide_bins(tree_.items, tree_.nodes, 0, std::uint32_t(tree_.items.size()), 0, split);
    sort_bins_by_id();
    return true;
}

void BlockBuilder::sort_bins_by_id() {
    for (const BinNode& bin : tree_.nodes) sort_by_id(bin);
}

/// Of faces that casts look at together: of several that are met at one time the one of the lowest id counts.
void BlockBuilder::sort_by_id(const BinNode& bin) {
    if (bin.left != 0) return;
    const auto by_id = [&](const BuildItem& a, const BuildItem& b) {
        return faces_->faces[a.face].id < faces_->faces[b.face].id;
    };
    const std::span<BuildItem> items = tree_.items_of(bin.first, bin.count);
    if (!std::is_sorted(items.begin(), items.end(), by_id)) std::sort(items.begin(), items.end(), by_id);
}

Ref<const Node> BlockBuilder::pack_leaf(std::uint32_t top, FaceLayout& layout) const {
    Ref<Node> leaf(new Node);
    const BinNode& node = tree_.nodes[top];
    leaf->facets_below = node.count;
    const Ref<Block> block = make_block(*faces_, tree_.items_of(node));
    layout.make(*leaf, *block, *faces_, tree_, top);
    leaf->facets = Ref<const IndexedFacets>(block.get());
    return Ref<const Node>(leaf.get());
}

std::vector<PartIndex> build_blocks(const FaceSet& faces, const TreeOptions& options, LongWork* work) {
    std::vector<PartIndex> parts;
    if (faces.faces.empty()) return parts;
    std::optional<PoolInLargePages> large_pages;  // of what no crater will change
    if (std::none_of(faces.faces.begin(), faces.faces.end(), [](const FaceSet::Entry& face) { return face.solid; }))
        large_pages.emplace();
    BlockBuilder builder;
    const auto part_of = [](const FaceSet::Entry& face) { return face.part; };
    const std::uint32_t first = faces.faces[0].part;
    if (std::all_of(faces.faces.begin(), faces.faces.end(),
                    [&](const FaceSet::Entry& face) { return face.part == first; })) {
        if (const Ref<const Node> root = builder.build(faces, options, ~std::size_t{}, work))
            parts.push_back({first, root});
        return parts;
    }
    std::vector<std::uint32_t> order(faces.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t one = part_of(faces.faces[a]), other = part_of(faces.faces[b]);
        return one != other ? one < other : a < b;  // in each part as they came
    });
    FaceSet some;
    for (std::size_t k = 0; k < order.size();) {
        const std::uint32_t part = part_of(faces.faces[order[k]]);
        some = {};
        for (; k < order.size() && part_of(faces.faces[order[k]]) == part; ++k)
            append_face(faces, faces.faces[order[k]], some);
        // As edits divide: casts go through one room's index after another, and the middle of a room's box is rarely
        // where its walls part.
        const Ref<const Node> root = builder.build(some, options, kNodeItems, work);
        if (!root) return {};
        parts.push_back({part, root});
    }
    return parts;
}

}  // namespace firma
