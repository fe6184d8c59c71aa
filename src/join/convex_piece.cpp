// SPDX-License-Identifier: MIT
// How a plane divides a convex polygon, exactly.
// Source: I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, 1974.
#include "join/convex_piece.h"

#include "base/assert.h"

namespace firma {

void divide(ExactTables& tables, const ConvexPiece& piece, PlaneId by, ConvexPiece& behind, ConvexPiece& front) {
    FIRMA_ASSERT(!same_plane(by, piece.plane), "a polygon is divided by a plane that crosses its own");
    behind.plane = front.plane = piece.plane;
    behind.sides.clear();
    front.sides.clear();
    const std::size_t count = piece.sides.size();
    thread_local std::vector<int> side_of;
    side_of.resize(count);
    bool any_behind = false, any_front = false;
    for (std::size_t k = 0; k < count; ++k) {
        side_of[k] = tables.points.side(by, piece.corner(k));
        any_behind |= side_of[k] < 0;
        any_front |= side_of[k] > 0;
    }
    if (!any_front) {
        behind.sides = piece.sides;
        return;
    }
    if (!any_behind) {
        front.sides = piece.sides;
        return;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const int here = side_of[k], there = side_of[piece.next(k)];
        const PieceSide& side = piece.sides[k];
        // A corner on the plane is one of both parts; where the outline leaves a part there, the plane bounds it.
        if (here <= 0) behind.sides.push_back({side.corner, here == 0 && there > 0 ? by : side.plane});
        if (here >= 0) front.sides.push_back({side.corner, here == 0 && there < 0 ? from_behind(by) : side.plane});
        if (here * there >= 0) continue;
        const std::uint32_t crossing = tables.points.add(piece.plane, side.plane, by);
        FIRMA_ASSERT(crossing != PointTable::kNone, "what lies between points of the world lies within it");
        behind.sides.push_back({crossing, here < 0 ? by : side.plane});
        front.sides.push_back({crossing, here > 0 ? from_behind(by) : side.plane});
    }
}

}  // namespace firma
