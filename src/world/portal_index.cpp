// SPDX-License-Identifier: MIT
// An index over portals.
#include "world/portal_index.h"

#include <algorithm>
#include <iterator>

namespace firma {

Ref<const Node> portal_leaf(std::uint32_t number, const GridBox& box) {
    Ref<Node> leaf(new Node);
    leaf->facets_below = 1;
    leaf->box = box;
    leaf->depth = 1;
    WideNode& wide = leaf->wide.emplace_back();
    const GridBox* const boxes[] = {&leaf->box};
    set_boxes(wide, boxes);
    wide.lead_to_facets(0, nullptr);
    LaneItems& items = leaf->lane_items.emplace_back();
    items.count = 1;
    std::fill(items.first + 1, std::end(items.first), std::uint8_t(1));
    leaf->facets = Ref<const IndexedFacets>(new IndexedPortal(number));
    return Ref<const Node>(leaf.get());
}

}  // namespace firma
