// SPDX-License-Identifier: MIT
// An index over portals.
#include "world/portal_index.h"

namespace firma {

Ref<const Node> portal_leaf(std::uint32_t number, const GridBox& box) {
    Ref<Node> leaf(new Node);
    leaf->facets_below = 1;
    leaf->bins.push_back({to_floats(box), 0, 1});
    leaf->facets = Ref<const IndexedFacets>(new IndexedPortal(number));
    return Ref<const Node>(leaf.get());
}

}  // namespace firma
