// SPDX-License-Identifier: MIT
// The faces of a solid that a cut may touch.
#include "carve/gather.h"

#include <algorithm>
#include <functional>

#include "base/fetch_ahead.h"
#include "base/sort.h"
#include "index/box_tree.h"
#include "index/rounded_box.h"
#include "index/traverse.h"

namespace firma {
namespace {

template <class Array>
void fetch_array_ahead(const Array& array) {
    fetch_ahead(array.data(), array.size() * sizeof(array[0]));
}

void fetch_contents_ahead(const Node& node) {
    fetch_array_ahead(node.wide);
    fetch_array_ahead(node.lane_items);
    fetch_array_ahead(node.children);
    if (node.facets) fetch_ahead(node.facets.get(), sizeof(Block));
}

void fetch_contents_ahead(const Block& block) {
    fetch_array_ahead(block.faces);
    fetch_array_ahead(block.lanes);
    fetch_array_ahead(block.owners);
}

/// The leaves that may have faces in a box. Level by level, as nodes lie scattered in memory: those of a level are
/// waited for together.
/// @param lacked  not 0: of blocks whose faces' masks may lack some of these bits
std::vector<const Node*> leaves_near(const Node* root, const GridBox& box, std::uint32_t lacked = 0) {
    std::vector<const Node*> nodes, below;
    if (!root) return nodes;
    nodes.push_back(root);
    for (bool deeper = !root->is_leaf(); deeper;) {
        deeper = false;
        below.clear();
        for (const Node* node : nodes) {
            if (node->is_leaf()) {
                below.push_back(node);
                continue;
            }
            for_each_item_meeting(*node, box, [&](const WideNode& wide, std::uint32_t lane) {
                below.push_back(node->node_below(wide, lane));
                fetch_ahead(below.back(), sizeof(Node));
            });
        }
        for (const Node* node : below) {
            deeper |= !node->is_leaf();
            fetch_contents_ahead(*node);
        }
        nodes.swap(below);
    }
    if (lacked != 0)
        std::erase_if(nodes, [&](const Node* leaf) { return (block_of(*leaf).mask_of_all & lacked) == lacked; });
    for (const Node* leaf : nodes) fetch_contents_ahead(block_of(*leaf));
    return nodes;
}

/// Calls `function(slot, face)` for the faces below a lane.
template <class Function>
void for_each_face(const Node& leaf, const WideNode& wide, std::uint32_t lane, const Function& function) {
    const Block& block = block_of(leaf);
    const LaneItems& items = leaf.items_of(wide);
    for (std::uint32_t slot = items.first[lane]; slot < items.first[lane + 1]; ++slot)
        function(slot, block.faces[slot]);
}

void sort_by_id(std::vector<FacetPlace>& facets, std::size_t first) {
    sort_range(std::span(facets).subspan(first),
               [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
}

}  // namespace

void gather_facets(const Node* root, const GridBox& box, std::vector<FacetPlace>& facets, std::uint32_t lacked) {
    const std::size_t first = facets.size();
    for (const Node* leaf : leaves_near(root, box, lacked)) {
        const Block& block = block_of(*leaf);
        for_each_item_meeting(*leaf, box, [&](const WideNode& wide, std::uint32_t lane) {
            for_each_face(*leaf, wide, lane, [&](std::uint32_t slot, const FaceRecord& face) {
                if (lacked != 0 && (face.mask & lacked) == lacked) return;
                if (boxes_meet(block.box_of(face), box)) facets.push_back({&block, slot});
            });
        });
    }
    sort_by_id(facets, first);
}

std::vector<FacetPlace> all_facets(const Node* root) {
    GridBox everywhere;
    everywhere.add(GridPoint{INT32_MIN, INT32_MIN, INT32_MIN});
    everywhere.add(GridPoint{INT32_MAX, INT32_MAX, INT32_MAX});
    std::vector<FacetPlace> facets;
    gather_facets(root, everywhere, facets);
    return facets;
}

std::size_t count_faces(std::span<const FacetPlace> facets) {
    std::vector<const FaceOwner*> owners;
    std::size_t without = 0;
    for (const FacetPlace& facet : facets) {
        const FaceOwner* owner = facet.block->owner_of(facet.record());
        if (owner)
            owners.push_back(owner);
        else
            ++without;
    }
    sort_range(owners, [](const FaceOwner* a, const FaceOwner* b) { return std::less<>()(a, b); });
    return without + std::size_t(std::unique(owners.begin(), owners.end()) - owners.begin());
}

bool gather_facets(const Node* root, const GridBox& box, const BevelledBox& bevelled, std::int32_t steps,
                   std::size_t most_faces, std::vector<FacetPlace>& near, std::vector<FacetPlace>& others) {
    const std::size_t first = near.size();
    // Faces have a facet at least. Counted anew once there are twice as many.
    std::size_t count_at = most_faces;
    const auto too_many = [&] {
        if (near.size() - first <= count_at) return false;
        count_at = 2 * (near.size() - first);
        return count_faces(std::span(near).subspan(first)) > most_faces;
    };
    for (const Node* leaf : leaves_near(root, box)) {
        if (too_many()) return false;
        const Block& block = block_of(*leaf);
        for_each_item_meeting(*leaf, box, [&](const WideNode& wide, std::uint32_t lane) {
            const bool clear = bevelled.clear_of(to_grid(wide.box(lane)), steps);
            for_each_face(*leaf, wide, lane, [&](std::uint32_t slot, const FaceRecord& face) {
                const auto is_near = [&] {
                    const GridBox own = block.box_of(face);
                    const auto corner = [&](std::size_t k) { return block.corner(face, k); };
                    return boxes_meet(own, box) && !bevelled.clear_of(own, face.corner_count, corner, steps);
                };
                if (!clear && is_near())
                    near.push_back({&block, slot});
                else if (face.owner != kNoOwner)
                    others.push_back({&block, slot});
            });
        });
    }
    count_at = std::min(count_at, most_faces);
    if (too_many()) return false;
    sort_by_id(near, first);
    return true;
}

void gather_face(const Node* root, const FacetPlace& face, std::vector<FacetPlace>& facets) {
    const FaceOwner* owner = face.block->owner_of(face.record());
    if (!owner) return facets.push_back(face);
    const std::size_t first = facets.size();
    const auto take_those_of = [&](const Block& block) {
        for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot)
            if (block.owner_of(block.faces[slot]) == owner) facets.push_back({&block, slot});
        return facets.size() - first == owner->facets;
    };
    if (!take_those_of(*face.block))
        for (const Node* leaf : leaves_near(root, owner->box))
            if (const Block& block = block_of(*leaf); &block != face.block && take_those_of(block)) break;
    sort_by_id(facets, first);
}

GridBox grown(const GridBox& box, std::int32_t steps) {
    GridBox result;
    for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = box.low[axis] >= INT32_MIN + steps ? box.low[axis] - steps : INT32_MIN;
        result.high[axis] = box.high[axis] <= INT32_MAX - steps ? box.high[axis] + steps : INT32_MAX;
    }
    return result;
}

}  // namespace firma
