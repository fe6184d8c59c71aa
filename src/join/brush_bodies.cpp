// SPDX-License-Identifier: MIT
// The brushes of a level as convex bodies, and what those of the solid hide.
#include "join/brush_bodies.h"

#include <algorithm>

namespace firma {

void BrushBodies::list_solids() {
    solids_.clear();
    std::vector<GridBox> boxes;
    for (std::uint32_t b = 0; b < shapes.size(); ++b) {
        if (!in_solid(b)) continue;
        solids_.push_back(b);
        boxes.push_back(shapes[b].box);
    }
    solid_tree_ = BoxTree(boxes);
}

void BrushBodies::hide_in_solids(const GridBox& box, std::uint32_t brush, std::vector<ConvexPiece>& pieces) {
    near_.clear();
    for_each_solid(box, [&](std::uint32_t other) {
        if (other != brush) near_.push_back(other);
    });
    std::sort(near_.begin(), near_.end());
    for (const std::uint32_t other : near_) {
        if (pieces.empty()) return;
        hider_.hide(shapes[other], {.same_way = other < brush, .against = true}, pieces);
    }
}

}  // namespace firma
