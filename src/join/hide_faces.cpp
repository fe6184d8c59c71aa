// SPDX-License-Identifier: MIT
// What of a polygon lies in a convex body, taken off it, exactly: plane by plane what lies in front is outside.
#include "join/hide_faces.h"

namespace firma {
namespace {

/// Whether a plane of the body has all of the polygon in front of it, or the polygon's plane all of the body on one
/// side: nearly always so for what only lies close by.
bool apart(const JoinTables& tables, const BrushShape& body, const ConvexPiece& piece) {
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
        if (!any_behind) return true;
    }
    if (coplanar) return false;
    bool any_behind = false, any_front = false;
    for (std::size_t k = 0; k < body.corners.size() && !(any_behind && any_front); ++k) {
        const int side = points.side(piece.plane, body.corners[k]);
        any_behind |= side < 0;
        any_front |= side > 0;
    }
    return !(any_behind && any_front);
}

}  // namespace

/// @return whether the body hides some of it: then `outside_` is what is left
bool FaceHider::hide_one(const BrushShape& body, const CoplanarRule& rule, const ConvexPiece& piece) {
    outside_.clear();
    if (apart(tables_, body, piece)) return false;
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

bool FaceHider::hide(const BrushShape& body, const CoplanarRule& rule, std::vector<ConvexPiece>& pieces) {
    bool any = false;
    left_.clear();
    for (ConvexPiece& piece : pieces) {
        if (hide_one(body, rule, piece)) {
            any = true;
            for (ConvexPiece& part : outside_) left_.push_back(std::move(part));
        } else {
            left_.push_back(std::move(piece));
        }
    }
    std::swap(left_, pieces);
    return any;
}

}  // namespace firma
