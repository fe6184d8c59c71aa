// SPDX-License-Identifier: MIT
// Whether two levels were joined to the same: planes and points are compared, their numbers do not count.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "join/join_brushes.h"

namespace firma {

class JoinComparison {
public:
    JoinComparison(const JoinedLevel& a, const JoinedLevel& b) : a_(a), b_(b) {}

    /// @return what differs; empty: nothing. `loose` is not compared
    std::string difference() const {
        if (a_.faces.size() != b_.faces.size()) return count("faces", a_.faces.size(), b_.faces.size());
        if (a_.portal_pieces.size() != b_.portal_pieces.size()) return "the number of portal pieces";
        for (std::size_t k = 0; k < a_.faces.size(); ++k)
            if (!same(a_.faces[k], b_.faces[k])) return "face " + std::to_string(k);
        for (std::size_t k = 0; k < a_.portal_pieces.size(); ++k)
            if (!same(a_.portal_pieces[k], b_.portal_pieces[k])) return "portal piece " + std::to_string(k);
        if (!same_arrangement()) return "outlines or edges";
        if (a_.facets.first != b_.facets.first || a_.facets.corners != b_.facets.corners) return "facets";
        if (a_.rooms.count != b_.rooms.count || a_.rooms.of_side != b_.rooms.of_side) return "rooms";
        if (a_.idle_portals != b_.idle_portals || a_.hidden_portals != b_.hidden_portals) return "idle portals";
        const auto same_portal = [](const JoinPortal& p, const JoinPortal& q) {
            return p.source == q.source && p.polygons == q.polygons && std::equal(p.room, p.room + 2, q.room);
        };
        if (!std::equal(a_.portals.begin(), a_.portals.end(), b_.portals.begin(), b_.portals.end(), same_portal))
            return "portals";
        return "";
    }

private:
    static std::string count(const char* what, std::size_t a, std::size_t b) {
        return std::string(what) + ": " + std::to_string(a) + " and " + std::to_string(b);
    }

    bool same_plane(PlaneId p, PlaneId q) const { return a_.tables.planes.plane(p) == b_.tables.planes.plane(q); }

    bool same_point(std::uint32_t p, std::uint32_t q) const {
        const ExactPoint &x = a_.tables.points.point(p), &y = b_.tables.points.point(q);
        if (x.rounded() != y.rounded() || x.on_grid() != y.on_grid()) return false;
        for (int k = 0; k < 3 && !y.on_grid(); ++k)
            if (exact_side(*y.plane(k), x) != 0) return false;
        return true;
    }

    bool same(const JoinPiece& p, const JoinPiece& q) const {
        const auto same_side = [&](const PieceSide& s, const PieceSide& t) {
            return same_point(s.corner, t.corner) && same_plane(s.plane, t.plane);
        };
        return p.source == q.source && p.material == q.material && p.mask == q.mask &&
               same_plane(p.piece.plane, q.piece.plane) &&
               std::equal(p.piece.sides.begin(), p.piece.sides.end(), q.piece.sides.begin(), q.piece.sides.end(),
                          same_side);
    }

    bool same_arrangement() const {
        const Arrangement &p = a_.arrangement, &q = b_.arrangement;
        const auto same_step = [&](const JoinStep& s, const JoinStep& t) {
            return s.edge == t.edge && same_point(s.corner, t.corner);
        };
        const auto same_edge = [&](const JoinEdge& s, const JoinEdge& t) {
            return same_point(s.corner[0], t.corner[0]) && same_point(s.corner[1], t.corner[1]) &&
                   std::equal(s.face, s.face + 2, t.face) && same_plane(s.across, t.across) && s.doubled == t.doubled;
        };
        return p.first_step == q.first_step &&
               std::equal(p.steps.begin(), p.steps.end(), q.steps.begin(), q.steps.end(), same_step) &&
               std::equal(p.edges.begin(), p.edges.end(), q.edges.begin(), q.edges.end(), same_edge);
    }

    const JoinedLevel &a_, &b_;
};

/// The level with its planes as they were moved, and without what was left out for others' sake.
inline BrushLevel mended_level(const BrushLevel& level, const JoinedLevel& joined) {
    BrushLevel mended = level;
    for (const MovedSide& moved : joined.moved_sides)
        std::copy(moved.points.begin(), moved.points.end(), mended.sides[moved.side].points);
    for (const LeftOut& left : joined.left_out) mended.brushes[left.brush].kind = BrushKind::kData;
    return mended;
}

}  // namespace firma
