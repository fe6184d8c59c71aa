// SPDX-License-Identifier: MIT
// An index over portals.
#include "world/portal_index.h"

namespace firma {

Ref<const Node> portal_leaf(std::uint32_t number, const GridBox& box) {
    Ref<Node> leaf(new Node);
    leaf->facets_below = 1;
    leaf->box = box;
    leaf->depth = 1;
    WideNode& wide = leaf->wide.emplace_back();
    const GridBox* const boxes[] = {&leaf->box};
    set_boxes(wide, boxes);
    for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) wide.first[k + 1] = 1;
    wide.facets[0] = 1;
    leaf->facets = Ref<const IndexedFacets>(new IndexedPortal(number));
    return Ref<const Node>(leaf.get());
}

}  // namespace firma
