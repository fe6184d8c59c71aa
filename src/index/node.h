// SPDX-License-Identifier: MIT
// Nodes: the immutable pieces that an index is stored in, up to 64 items each, so that an edit can replace one.
//
// A node holds a small binary tree of bins over its items. Items are facets, kept by somebody else, or further nodes:
// nodes nest, and the bins of all of them together are the article's one tree. An index follows from the facets it lies
// over and may be thrown away: no id, answer, hash or file depends on it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fetch_ahead.h"
#include "base/pool.h"
#include "base/ref.h"
#include "index/bin.h"
#include "index/wide_node.h"

namespace firma {

/// The most items of a node, and the most facets kept together.
inline constexpr std::uint32_t kNodeItems = 64;

/// The deepest an index may be, bins above a leaf: 63 within a leaf node, and in a node above others 18 (twelve uneven
/// divisions, then halves), of which there are five above each other at most.
inline constexpr int kDeepestTree = 63 + 5 * 18;

/// Facets that are kept together, in the order in which the bins of a leaf node hold them. An index keeps them alive
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
    std::uint16_t depth = 0;         ///< bins above the deepest leaf bin, from bins[0] on down through children

    PoolVector<Bin> bins;                  ///< bins[0] is the root; never empty
    PoolVector<WideNode> wide;             ///< the bins as casts read them; wide[0] is the root. Empty: not over faces
    PoolVector<Ref<const Node>> children;  ///< items that are nodes; then there are no facets here
    Ref<const IndexedFacets> facets;       ///< items that are facets; null where they are nodes

    bool is_leaf() const { return children.empty(); }
};

}  // namespace firma
