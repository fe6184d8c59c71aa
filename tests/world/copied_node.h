// SPDX-License-Identifier: MIT
// Nodes and blocks once more, to be changed.
#pragma once

#include "index/node.h"
#include "solid/block.h"

namespace firma::test {

/// All that a node says itself; `children` are those of the copy, in the same order.
inline Ref<Node> copied_node(const Node& node, PoolVector<Ref<const Node>> children = {}) {
    Ref<Node> made(new Node);
    made->facets_below = node.facets_below;
    made->depth = node.depth;
    made->box = node.box;
    made->facets = node.facets;
    made->wide = node.wide;
    made->lane_items = node.lane_items;
    made->children = std::move(children);
    for (WideNode& wide : made->wide)
        for (std::uint32_t lane = 0; lane < made->items_of(wide).count; ++lane) {
            if (wide.leads_to_facets(lane)) continue;
            if (const Node* const child = made->node_below(wide, lane))
                wide.lead_to(lane, child->wide.data());
            else
                wide.lead_to(lane, made->wide.data() + (wide.wide(lane) - node.wide.data()));
        }
    return made;
}

/// A leaf gets a block of its own to be changed, otherwise the same.
inline Block& own_block(Node& leaf) {
    const Block& from = block_of(leaf);
    Ref<Block> made(new Block);
    made->part = from.part;
    made->mask_of_all = from.mask_of_all;
    made->faces = from.faces;
    made->owners = from.owners;
    made->lanes = from.lanes;
    for (FaceLanes& lanes : made->lanes) {
        lanes.block = made.get();
        lanes.faces = made->faces.data();
    }
    for (WideNode& wide : leaf.wide)
        for (std::uint32_t lane = 0; lane < WideNode::kLanes; ++lane)
            if (wide.leads_to_facets(lane) && wide.facets(lane))
                wide.lead_to_facets(
                    lane, made->lanes.data() + (static_cast<const FaceLanes*>(wide.facets(lane)) - from.lanes.data()));
    leaf.facets = Ref<const IndexedFacets>(made.get());
    return *made;
}

}  // namespace firma::test
