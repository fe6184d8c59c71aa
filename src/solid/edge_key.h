// SPDX-License-Identifier: MIT
// What tells an edge of a solid from all others, so that the two faces that share it know each other without a patch
// that holds both; by the rules that SolidPatch goes by.
#pragma once

#include <cstdint>

#include "base/table_key.h"
#include "solid/solid_face.h"

namespace firma {

/// The edge as an object; or, of one between two points of the grid that is not doubled, its ends: a face beside it may
/// be one that no cut has touched, which has no objects.
struct EdgeKey {
    const SolidEdge* stored = nullptr;  ///< null: by its ends
    GridPoint low, high;                ///< its ends, rounded, in order of coordinates

    std::uint64_t hash() const {
        return stored ? reinterpret_cast<std::uintptr_t>(stored) : point_key(low) + 3 * point_key(high);
    }
    friend bool operator==(const EdgeKey& a, const EdgeKey& b) {
        return a.stored == b.stored && (a.stored || (a.low == b.low && a.high == b.high));
    }
};

/// How a face uses an edge.
struct KeyedUse {
    EdgeKey key;
    bool forward = false;  ///< of an object: along it; else from `low` to `high`

    /// Where it starts and ends, rounded.
    GridPoint from, to;
};

/// Of the grid, both ends.
KeyedUse keyed_use(const GridPoint& from, const GridPoint& to);
KeyedUse keyed_use(const SolidEdge& edge, bool reversed);

/// Calls `function(use)` for each edge of the exact face of a facet, loop by loop.
template <class Function>
void for_each_use(const SolidFace& face, const Function& function) {
    for (const SolidUse& use : face.uses) function(keyed_use(use.edge(), use.reversed()));
}
template <class Function>
void for_each_use(const FacetPlace& facet, const Function& function) {
    const FaceRecord& record = facet.record();
    if (const FaceOwner* owner = facet.block->owner_of(record))
        return for_each_use(static_cast<const SolidFace&>(*owner), function);
    for (std::size_t k = 0; k < record.corner_count; ++k)
        function(keyed_use(facet.block->corner(record, k),
                           facet.block->corner(record, k + 1u < record.corner_count ? k + 1 : 0)));
}

/// A facet of the face that shares an edge with another one: the face that uses it the other way.
/// @param root  of an index over the solid
/// @param use   of a face of it, or of a piece of one
/// @return one without a block where there is none
/// Never allocates. Costs a walk through the index to the middle of the edge.
FacetPlace find_across(const Node& root, const KeyedUse& use);

}  // namespace firma
