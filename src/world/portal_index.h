// SPDX-License-Identifier: MIT
// An index over portals, for rays, boxes and points: the same nodes as an index over facets, a leaf a portal.
#pragma once

#include <cstdint>

#include "geometry/grid_box.h"
#include "index/node.h"
#include "index/rounded_box.h"
#include "index/traverse.h"

namespace firma {

/// What a leaf of the index lies over.
class IndexedPortal final : public IndexedFacets {
public:
    explicit IndexedPortal(std::uint32_t portal) : number(portal) {}
    std::size_t bytes() const override { return pool_size(sizeof *this); }

    const std::uint32_t number;
};

/// A leaf over one portal.
Ref<const Node> portal_leaf(std::uint32_t number, const GridBox& box);

/// Calls `function(number)` for each portal whose box meets one, and perhaps for others near it, until it returns true;
/// in no order that means anything.
/// @return whether it did
template <class Function>
bool for_each_portal_meeting(const Node& root, const GridBox& box, const Function& function) {
    const auto below = [&](const auto& self, const Node& node, const WideNode& wide) -> bool {
        if (node.is_leaf()) return function(static_cast<const IndexedPortal&>(*node.facets).number);
        const unsigned met = lanes_meeting(wide, box);
        for (std::uint32_t lane = 0; met >> lane; ++lane) {
            if (!(met >> lane & 1)) continue;
            const Node* const child = node.node_below(wide, lane);
            if (self(self, child ? *child : node, *wide.wide(lane))) return true;
        }
        return false;
    };
    return below(below, root, root.wide[0]);
}

/// Calls `function(number)` for each portal of whose boxes in the index, rounded outward, `meets(box)` says yes to all,
/// until it returns true; in no order that means anything. Allocates nothing.
/// @param meets  of a BoxF
template <class Meets, class Function>
void for_each_portal_in(const Node& root, const Meets& meets, const Function& function) {
    struct Visitor {
        const Meets& meets;
        const Function& function;
        bool enter(const BoxF& box, double& nearest) const {
            nearest = 0;
            return meets(box);
        }
        bool still(double) const { return true; }
        bool facets(const IndexedFacets& facets, std::uint32_t, std::uint32_t) const {
            return function(static_cast<const IndexedPortal&>(facets).number);
        }
    } visitor{meets, function};
    traverse(root, visitor);
}

/// The same by boxes of the grid.
template <class Meets, class Function>
void for_each_indexed_portal(const Node& root, const Meets& meets, const Function& function) {
    for_each_portal_in(root, [&](const BoxF& box) { return meets(to_grid(box)); }, function);
}

}  // namespace firma
