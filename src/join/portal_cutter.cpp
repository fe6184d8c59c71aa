// SPDX-License-Identifier: MIT
// Where portals end faces, and each other.
#include "join/portal_cutter.h"

#include <algorithm>

namespace firma {

void PortalCutter::set_portals(std::span<const JoinPiece> portals) {
    planes_.clear();
    std::vector<GridBox> boxes;
    for (const JoinPiece& portal : portals) {
        planes_.push_back(portal.piece.plane);
        boxes.push_back(portal.piece.box(tables_.points));
    }
    tree_ = BoxTree(boxes);
}

void PortalCutter::divide_at_portals(std::vector<JoinPiece>& pieces) {
    ConvexPiece behind, front;
    for (std::size_t k = 0; k < pieces.size(); ++k) {  // parts in front are added, and come to their turn
        near_.clear();
        tree_.for_each_meeting(pieces[k].piece.box(tables_.points), [&](std::uint32_t portal) {
            near_.push_back(portal);
            return false;
        });
        std::sort(near_.begin(), near_.end());
        for (const std::uint32_t portal : near_) {
            if (same_plane(pieces[k].piece.plane, planes_[portal])) continue;
            divide(tables_, pieces[k].piece, planes_[portal], behind, front);
            if (behind.sides.empty() || front.sides.empty()) continue;
            JoinPiece other = pieces[k];
            other.piece = front;
            pieces[k].piece = behind;
            pieces.push_back(std::move(other));
        }
    }
}

bool PortalCutter::ends_at_portal(std::uint32_t from, std::uint32_t to, PlaneId plane) const {
    const PointTable& points = tables_.points;
    GridBox side;
    side.add(points.point(from).rounded());
    side.add(points.point(to).rounded());
    return tree_.for_each_meeting(side, [&](std::uint32_t portal) {
        const PlaneId other = planes_[portal];
        return !same_plane(other, plane) && points.side(other, from) == 0 && points.side(other, to) == 0;
    });
}

void PortalCutter::merge_between_portals(std::vector<JoinPiece>& pieces) const {
    merge_pieces(tables_, pieces,
                 [&](std::uint32_t from, std::uint32_t to, PlaneId plane) { return ends_at_portal(from, to, plane); });
}

}  // namespace firma
