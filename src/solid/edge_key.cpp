// SPDX-License-Identifier: MIT
// The face across an exact edge: a traversal to the middle of the edge as casts meet it, which lies in the box of the
// facet beside it; of each facet there with that side, its face is asked for the edge.
#include "solid/edge_key.h"

#include "index/node.h"

namespace firma {
namespace {

/// Half a step around it, where it lies between two.
GridBox around_middle(const GridPoint& from, const GridPoint& to) {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t twice = std::int64_t(from[axis]) + to[axis];
        box.low[axis] = std::int32_t(twice >> 1);
        box.high[axis] = std::int32_t((twice + 1) >> 1);
    }
    return box;
}

bool has_grid_ends(const SolidEdge& edge) {
    return edge.vertex[0]->point.on_grid() && edge.vertex[1]->point.on_grid();
}

/// From `from` to `to`: the other way around than who asks.
struct AcrossSearch {
    const EdgeKey& key;
    const bool forward;
    const GridPoint from, to;
    const GridBox middle;
    FacetPlace found{};

    bool below(const Node& node, const WideNode& wide) {
        const unsigned met = lanes_meeting(wide, middle);
        for (std::uint32_t lane = 0; met >> lane; ++lane) {
            if (!(met >> lane & 1)) continue;
            if (wide.leads_to_facets(lane)) {
                const LaneItems& items = node.items_of(wide);
                if (facets(as_block(*node.facets), items.first[lane], items.items(lane))) return true;
                continue;
            }
            const Node* const child = node.node_below(wide, lane);
            if (below(child ? *child : node, *wide.wide(lane))) return true;
        }
        return false;
    }
    bool facets(const Block& block, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (block.faces[slot].solid && has_side(block, block.faces[slot]) && has_edge(block, block.faces[slot])) {
                found = {&block, slot};
                return true;
            }
        return false;
    }

    /// Of an edge that is a point on the surface grid: a corner.
    bool has_side(const Block& block, const FaceRecord& face) const {
        GridPoint last = block.corner(face, face.corner_count - 1u);
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const GridPoint next = block.corner(face, k);
            if (next == to && (last == from || from == to)) return true;
            last = next;
        }
        return false;
    }
    bool has_edge(const Block& block, const FaceRecord& face) const {
        const auto* owner = static_cast<const SolidFace*>(block.owner_of(face));
        if (!owner) return !key.stored;  // its side is its edge
        for (const SolidUse& use : owner->uses) {
            if (key.stored ? use.address() == key.stored && use.reversed() != forward : is_along_ends(use)) return true;
        }
        return false;
    }
    bool is_along_ends(const SolidUse& use) const {
        const SolidEdge& edge = use.edge();
        return !edge.doubled && has_grid_ends(edge) && use.from().point.rounded() == from &&
               edge.vertex[!use.reversed()]->point.rounded() == to;
    }
};

}  // namespace

KeyedUse keyed_use(const GridPoint& from, const GridPoint& to) {
    const bool forward = from < to;
    return {{nullptr, forward ? from : to, forward ? to : from}, forward, from, to};
}

KeyedUse keyed_use(const SolidEdge& edge, bool reversed) {
    const GridPoint from = edge.vertex[reversed]->point.rounded(), to = edge.vertex[!reversed]->point.rounded();
    KeyedUse use = keyed_use(from, to);
    if (edge.doubled || !has_grid_ends(edge)) {
        use.key.stored = &edge;
        use.forward = !reversed;
    }
    return use;
}

FacetPlace find_across(const Node& root, const KeyedUse& use) {
    AcrossSearch search{use.key, !use.forward, use.to, use.from, around_middle(use.from, use.to)};
    search.below(root, root.wide[0]);
    return search.found;
}

}  // namespace firma
