// SPDX-License-Identifier: MIT
// The faces that a cut may touch, taken out of the tree.
#include "carve/gather.h"

#include "base/fetch_ahead.h"
#include "tree/box_tree.h"
#include "tree/rounded_box.h"

namespace firma {
namespace {

/// A box in metres: whole surface steps, so exact in double.
struct Bounds {
    Vec3 low, high;

    explicit Bounds(const GridBox& box) : low(to_metres(box.low)), high(to_metres(box.high)) {}
    bool meets(const BoxF& box) const {
        for (int axis = 0; axis < 3; ++axis)
            if (double(box.high[axis]) < low[axis] || double(box.low[axis]) > high[axis]) return false;
        return true;
    }
};

/// Calls `function(bin)` for the leaf bins that a box meets, left to right.
template <class Function>
void for_each_bin(const Block& block, const Bounds& bounds, const Function& function) {
    const auto below = [&](const auto& self, std::uint32_t index) -> void {
        const Bin& bin = block.bins[index];
        if (!bounds.meets(bin.box)) return;
        if (bin.is_leaf()) return function(bin);
        self(self, index + 1);
        self(self, bin.first);
    };
    below(below, 0);
}

void fetch_contents_ahead(const Block& block) {
    const auto fetch = [](const auto& array) { fetch_ahead(array.data(), array.size() * sizeof(array[0])); };
    fetch(block.bins);
    fetch(block.children);
    fetch(block.faces);
    fetch(block.vertices);
    fetch(block.corner_vertices);
    fetch(block.owners);
}

/// The leaf blocks that may have faces in a box, in the tree's order. Level by level, as blocks lie scattered in
/// memory: those of a level are waited for together.
std::vector<const Block*> leaf_blocks(const Block& root, const Bounds& bounds) {
    std::vector<const Block*> blocks{&root}, below;
    for (bool deeper = root.holds_blocks(); deeper;) {
        deeper = false;
        below.clear();
        for (const Block* block : blocks) {
            if (!block->holds_blocks()) {
                below.push_back(block);
                continue;
            }
            for_each_bin(*block, bounds, [&](const Bin& bin) {
                below.push_back(block->children[bin.first].get());
                fetch_ahead(below.back(), sizeof(Block));
            });
        }
        for (const Block* block : below) {
            deeper |= block->holds_blocks();
            fetch_contents_ahead(*block);
        }
        blocks.swap(below);
    }
    return blocks;
}

/// Calls `function(slot, face)` for those faces of a leaf bin that bound solids.
template <class Function>
void for_each_solid(const Block& block, const Bin& bin, const Function& function) {
    for (std::uint32_t slot = bin.first; slot < bin.first + bin.count; ++slot)
        if (block.faces[slot].solid) function(slot, block.faces[slot]);
}

}  // namespace

void gather_facets(const Block& root, const GridBox& box, std::vector<FacetPlace>& facets) {
    const Bounds bounds(box);
    for (const Block* block : leaf_blocks(root, bounds))
        for_each_bin(*block, bounds, [&](const Bin& bin) {
            for_each_solid(*block, bin, [&](std::uint32_t slot, const FaceRecord& face) {
                if (boxes_meet(block->box_of(face), box)) facets.push_back({block, slot});
            });
        });
}

void gather_facets(const Block& root, const GridBox& box, const BevelledBox& bevelled, std::int32_t steps,
                   std::vector<FacetPlace>& near, std::vector<FacetPlace>& others) {
    const Bounds bounds(box);
    for (const Block* block : leaf_blocks(root, bounds))
        for_each_bin(*block, bounds, [&](const Bin& bin) {
            const bool clear = bevelled.clear_of(to_grid(bin.box), steps);
            for_each_solid(*block, bin, [&](std::uint32_t slot, const FaceRecord& face) {
                const auto is_near = [&] {
                    const GridBox own = block->box_of(face);
                    const auto corner = [&](std::size_t k) { return block->corner(face, k); };
                    return boxes_meet(own, box) && !bevelled.clear_of(own, face.corner_count, corner, steps);
                };
                if (!clear && is_near())
                    near.push_back({block, slot});
                else if (face.owner != kNoOwner)
                    others.push_back({block, slot});
            });
        });
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
