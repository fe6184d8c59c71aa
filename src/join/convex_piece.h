// SPDX-License-Identifier: MIT
// Convex polygons in exact planes, bounded by exact planes, and how a plane divides one.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/exact_tables.h"
#include "geometry/grid_box.h"

namespace firma {

/// A polygon's side: from its corner to the next one's, in the plane `plane`, which the polygon lies behind.
struct PieceSide {
    std::uint32_t corner = 0;
    PlaneId plane = kNoPlane;
};

/// A convex polygon with area, counter-clockwise seen from the front of its plane. No two sides lie on one line.
struct ConvexPiece {
    PlaneId plane = kNoPlane;
    std::vector<PieceSide> sides;

    std::uint32_t corner(std::size_t k) const { return sides[k].corner; }
    std::size_t next(std::size_t k) const { return k + 1 < sides.size() ? k + 1 : 0; }
    std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : sides.size() - 1; }
    GridBox box(const PointTable& points) const {
        GridBox box;
        for (const PieceSide& side : sides) box.add(points.point(side.corner).rounded());
        return box;
    }
};

/// Divides a polygon by a plane that is not its own.
///
/// @param behind, front  what lies on either side; without sides when nothing with area does
void divide(ExactTables& tables, const ConvexPiece& piece, PlaneId by, ConvexPiece& behind, ConvexPiece& front);

}  // namespace firma
