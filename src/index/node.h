// SPDX-License-Identifier: MIT
// Nodes: the immutable pieces that an index is stored in, up to 64 items each, so that an edit can replace one.
//
// A node holds a small tree of wide nodes over its items. Items are facets, kept by somebody else, or further nodes:
// nodes nest, and the wide nodes of all of them together are one tree. An index follows from the facets it lies over
// and may be thrown away: no id, answer, hash or file depends on it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fetch_ahead.h"
#include "base/pool.h"
#include "base/ref.h"
#include "geometry/grid_box.h"
#include "index/wide_node.h"

namespace firma {

/// The most items of a node, and the most facets kept together.
inline constexpr std::uint32_t kNodeItems = 64;

/// The deepest an index may be, wide nodes above an item. Over 64 items there are thirteen above each other at most, as
/// each but the last takes seven of them away, of the first four at least one; a build or an edit that ends up deeper
/// is joined anew from its leaves: then there are fewer than seven nodes above each other.
inline constexpr int kDeepestTree = 96;

/// Facets that are kept together, in the order in which a leaf node leads to them. An index keeps them alive
/// and never looks inside.
class IndexedFacets : public RefCounted, public Pooled {
public:
    virtual ~IndexedFacets() = default;
    /// Memory they take; without what they share with others.
    virtual std::size_t bytes() const = 0;
};

class Node : public RefCounted, public Pooled {
public:
    /// What it shares with others lies scattered, and each counts one user less.
    ~Node() {
        for (const Ref<const Node>& child : children) fetch_ahead(child.get());
    }

    // First, beside the count of users: of most nodes an edit reads no more.
    std::uint32_t facets_below = 0;  ///< facets here, or in all nodes below
    std::uint16_t depth = 0;         ///< wide nodes above the deepest item, from wide[0] on down through children
    GridBox box;                     ///< around all that lies below

    PoolVector<WideNode> wide;             ///< wide[0] is the root; never empty
    PoolVector<LaneItems> lane_items;      ///< of each
    PoolVector<Ref<const Node>> children;  ///< items that are nodes; then there are no facets here
    Ref<const IndexedFacets> facets;       ///< items that are facets; null where they are nodes

    bool is_leaf() const { return children.empty(); }

    /// @param of  one of `wide`
    const LaneItems& items_of(const WideNode& of) const { return lane_items[std::size_t(&of - wide.data())]; }
    /// Whether a lane leads to one of `children`, not to more boxes.
    bool leads_to_node(const WideNode& of, std::uint32_t lane) const {
        return !is_leaf() && items_of(of).items(lane) == 1;
    }
    /// That one, or null.
    const Node* node_below(const WideNode& of, std::uint32_t lane) const {
        return leads_to_node(of, lane) ? children[items_of(of).first[lane]].get() : nullptr;
    }
};

}  // namespace firma
