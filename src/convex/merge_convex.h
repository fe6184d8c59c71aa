// SPDX-License-Identifier: MIT
// Convex pieces that are convex together become one.
#pragma once

#include <cstdint>
#include <vector>

#include "convex/sides.h"
#include "join/brush_shape.h"

namespace firma {

/// A convex piece: the planes that bound it, each once, ascending; and its polygons.
struct ConvexShape {
    std::vector<PlaneId> planes;
    BrushShape shape;
    std::uint32_t number = 0;  ///< in the order in which pieces came about
};

/// @return false where the planes do not bound a body
bool make_convex_shape(ConvexSpace& space, std::vector<PlaneId> planes, ConvexShape& made);

/// Merges pairs as long as there is one whose union is convex, exactly: those with the largest face in common first.
/// @return how many pairs
std::size_t merge_convex(ConvexSpace& space, std::vector<ConvexShape>& pieces);

}  // namespace firma
