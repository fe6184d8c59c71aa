// SPDX-License-Identifier: MIT
// Convex pieces as they are handed out.
#pragma once

#include <optional>

#include "convex/grid_hull.h"
#include "convex/merge_convex.h"
#include "firma/convex_pieces.h"

namespace firma {

/// @return nothing where the planes make no solid
std::optional<ConvexBody> piece_of_shape(ConvexSpace& space, const ConvexShape& shape, double density);

ConvexBody piece_of_hull(const ConvexSpace& space, const SolidSides& solid, const GridHull& hull, double overhang,
                         double density);

/// Rounded corners of a solid.
std::vector<GridPoint> corners_of_sides(const ConvexSpace& space, const FaceSides& sides);

}  // namespace firma
