// SPDX-License-Identifier: MIT
// What of a polygon lies in a convex body, taken off it, exactly: plane by plane what lies in front is outside.
#include "join/hide_faces.h"

namespace firma {
namespace {

enum class Meeting {
    kApart,  ///< a plane of the body has all of the polygon in front of it, or the polygon's all of the body: so it is
             ///< nearly always with what only lies close by
    kEdge,   ///< the body stands on the polygon's front with an edge
    kPossible,  ///< only dividing the polygon tells
};

/// @param edge  for kEdge: its corners
Meeting meeting(const ExactTables& tables, const BrushShape& body, const ConvexPiece& piece, std::uint32_t (&edge)[2]) {
    const auto& points = tables.points;
    bool coplanar = false;
    for (const BrushShape::Face& face : body.faces) {
        if (same_plane(face.piece.plane, piece.plane)) {
            coplanar = true;
            continue;
        }
        bool any_behind = false;
        for (std::size_t k = 0; k < piece.sides.size() && !any_behind; ++k)
            any_behind = points.side(face.piece.plane, piece.corner(k)) < 0;
        if (!any_behind) return Meeting::kApart;
    }
    if (coplanar) return Meeting::kPossible;
    bool any_behind = false, any_front = false;
    std::size_t on = 0;
    for (std::size_t k = 0; k < body.corners.size() && !(any_behind && any_front); ++k) {
        const int side = points.side(piece.plane, body.corners[k]);
        any_behind |= side < 0;
        any_front |= side > 0;
        if (side == 0 && on < 2) edge[on] = body.corners[k];
        on += side == 0;
    }
    if (any_behind && any_front) return Meeting::kPossible;
    return on == 2 && any_front ? Meeting::kEdge : Meeting::kApart;
}

/// A plane of the body, other than the polygon's, that holds an edge of it which lies in the polygon.
/// @return kNoPlane when the edge does not reach into the polygon
PlaneId plane_of_edge(const ExactTables& tables, const BrushShape& body, const ConvexPiece& piece,
                      const std::uint32_t (&edge)[2]) {
    const auto& points = tables.points;
    for (const PieceSide& side : piece.sides)
        if (points.side(side.plane, edge[0]) >= 0 && points.side(side.plane, edge[1]) >= 0) return kNoPlane;
    for (const BrushShape::Face& face : body.faces)
        if (points.side(face.piece.plane, edge[0]) == 0 && points.side(face.piece.plane, edge[1]) == 0)
            return face.piece.plane;
    return kNoPlane;
}

}  // namespace

/// Where the body stands on the polygon with an edge, that has to become an edge of the polygon as well: air on one
/// side of it is not the air on the other.
/// @return whether anything became of it: then `outside_` is what is left
bool FaceHider::hide_one(const BrushShape& body, const CoplanarRule& rule, const ConvexPiece& piece) {
    outside_.clear();
    std::uint32_t edge[2];
    const Meeting how = meeting(tables_, body, piece, edge);
    if (how == Meeting::kApart) return false;
    if (how == Meeting::kEdge) {
        const PlaneId plane = plane_of_edge(tables_, body, piece, edge);
        if (plane == kNoPlane) return false;
        divide(tables_, piece, plane, behind_, front_);
        if (behind_.sides.empty() || front_.sides.empty()) return false;
        outside_.push_back(behind_);
        outside_.push_back(front_);
        return true;
    }
    rest_ = piece;
    for (const BrushShape::Face& face : body.faces) {
        const PlaneId plane = face.piece.plane;
        if (same_plane(plane, piece.plane)) {
            if (!(plane == piece.plane ? rule.same_way : rule.against)) return false;
            continue;
        }
        divide(tables_, rest_, plane, behind_, front_);
        if (behind_.sides.empty()) return false;
        if (!front_.sides.empty()) outside_.push_back(front_);
        std::swap(rest_, behind_);
    }
    return true;
}

void FaceHider::hide(const BrushShape& body, const CoplanarRule& rule, std::vector<ConvexPiece>& pieces) {
    left_.clear();
    for (ConvexPiece& piece : pieces) {
        if (hide_one(body, rule, piece)) {
            for (ConvexPiece& part : outside_) left_.push_back(std::move(part));
        } else {
            left_.push_back(std::move(piece));
        }
    }
    std::swap(left_, pieces);
}

}  // namespace firma
