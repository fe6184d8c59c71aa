// SPDX-License-Identifier: MIT
// The face across an exact edge: a traversal to the middle of the edge as casts meet it, which lies in the box of the
// facet beside it; of each facet there with that side, its face is asked for the edge.
#include "solid/edge_key.h"

#include "index/traverse.h"

namespace firma {
namespace {

bool has_grid_ends(const SolidEdge& edge) {
    return edge.vertex[0]->point.on_grid() && edge.vertex[1]->point.on_grid();
}

/// From `from` to `to`: the other way around than who asks.
struct AcrossVisitor {
    const EdgeKey& key;
    const bool forward;
    const GridPoint from, to;
    const Vec3 middle;  ///< exact: two 32-bit numbers and their mean fit a double
    FacetPlace found{};

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (middle[axis] < double(box.low[axis]) || middle[axis] > double(box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (block.faces[slot].solid && has_side(block, block.faces[slot]) && has_edge(block, block.faces[slot])) {
                found = {&block, slot};
                return true;
            }
        return false;
    }

    /// Of an edge that is a point on the surface grid: a corner.
    bool has_side(const Block& block, const FaceRecord& face) const {
        const auto corners = block.corners_of(face);
        const GridPoint* last = &block.vertices[corners.back()];
        for (const std::uint16_t corner : corners) {
            const GridPoint* next = &block.vertices[corner];
            if (*next == to && (*last == from || from == to)) return true;
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
    AcrossVisitor visitor{use.key, !use.forward, use.to, use.from, (to_metres(use.from) + to_metres(use.to)) * 0.5};
    traverse(root, visitor);
    return visitor.found;
}

}  // namespace firma
