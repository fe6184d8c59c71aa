// SPDX-License-Identifier: MIT
// Many convex brushes become one closed solid.
#include "join/join_brushes.h"

#include <algorithm>

#include "join/hide_faces.h"
#include "join/merge_pieces.h"
#include "tree/box_tree.h"

namespace firma {
namespace {

constexpr std::size_t kMostPlanes = std::size_t(1) << 21;
constexpr int kMostRounds = 32;  ///< of leaving out what keeps the rest from being joined

const char* reason_of(BrushFault fault) {
    switch (fault) {
        case BrushFault::kEmpty:
            return "its planes leave no volume";
        case BrushFault::kOpen:
            return "its planes do not close it, or it reaches out of the world";
        case BrushFault::kTooMany:
            return "it has more than 1024 planes";
        case BrushFault::kNone:
            break;
    }
    return "";
}

bool is_solid(BrushKind kind) {
    return kind == BrushKind::kSolid || kind == BrushKind::kSky;
}

class BrushJoiner {
public:
    explicit BrushJoiner(const BrushLevel& level)
        : level_(level), made_(std::make_unique<JoinedLevel>()), hider_(made_->tables) {}

    Result<std::unique_ptr<JoinedLevel>> join() {
        if (level_.sides.size() >= kMostPlanes / 2)
            return Error{ErrorCode::kTooLarge, level_.name, "a level has fewer than 2^20 brush sides"};
        make_shapes();
        for (int round = 0; round < kMostRounds; ++round) {
            cut_faces();
            cut_portals();
            merge();
            if (arrange_all()) break;
        }
        find_rooms();
        return std::move(made_);
    }

private:
    JoinTables& tables() { return made_->tables; }

    void make_shapes() {
        shapes_.resize(level_.brushes.size());
        used_.resize(level_.brushes.size());
        brush_of_side_.resize(level_.sides.size());
        std::vector<PlaneId> planes;
        for (std::uint32_t b = 0; b < level_.brushes.size(); ++b) {
            const Brush& brush = level_.brushes[b];
            planes.clear();
            for (std::uint32_t k = 0; k < brush.side_count; ++k) {
                const BrushSide& side = level_.sides[brush.first_side + k];
                brush_of_side_[brush.first_side + k] = b;
                planes.push_back(tables().planes.add(
                    plane_through(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2]))));
            }
            if (!is_solid(brush.kind) && brush.kind != BrushKind::kPortal) continue;
            const BrushFault fault = make_brush_shape(tables(), planes, shapes_[b]);
            used_[b] = fault == BrushFault::kNone;
            if (!used_[b]) leave_out(b, reason_of(fault));
        }
    }

    void leave_out(std::uint32_t brush, const char* reason) {
        used_[brush] = false;
        made_->left_out.push_back({brush, reason});
    }

    bool in_solid(std::uint32_t brush) const { return used_[brush] && is_solid(level_.brushes[brush].kind); }

    /// Of each face what no other brush hides. Of faces of two brushes that look the same way the one of the lower
    /// number stays; of faces that lie against each other neither.
    void cut_faces() {
        made_->faces.clear();
        solids_.clear();
        std::vector<GridBox> boxes;
        for (std::uint32_t b = 0; b < shapes_.size(); ++b) {
            if (!in_solid(b)) continue;
            solids_.push_back(b);
            boxes.push_back(shapes_[b].box);
        }
        solid_tree_ = BoxTree(boxes);
        for (const std::uint32_t b : solids_)
            for (const BrushShape::Face& face : shapes_[b].faces) {
                pieces_.assign(1, face.piece);
                hide_in_solids(face.piece.box(tables().points), b);
                add_pieces(level_.brushes[b].first_side + face.side, made_->faces);
            }
    }

    /// @param brush  the pieces are of this one; or ~0, then what lies on the solid goes as well
    void hide_in_solids(const GridBox& box, std::uint32_t brush) {
        near_.clear();
        solid_tree_.for_each_meeting(box, [&](std::uint32_t k) {
            if (solids_[k] != brush) near_.push_back(solids_[k]);
            return false;
        });
        std::sort(near_.begin(), near_.end());
        for (const std::uint32_t other : near_) {
            if (pieces_.empty()) return;
            hider_.hide(shapes_[other], {.same_way = other < brush, .against = true}, pieces_);
        }
    }

    void add_pieces(std::uint32_t source, std::vector<JoinPiece>& to) {
        const BrushSide& side = level_.sides[source];
        for (ConvexPiece& piece : pieces_) to.push_back({std::move(piece), source, side.material, side.mask});
    }

    /// The parts of portals that lie in the air; then faces are divided where they meet one, and portals where they
    /// cross.
    void cut_portals() {
        std::vector<JoinPiece>& portals = made_->portal_pieces;
        portals.clear();
        std::vector<std::pair<PlaneId, const BrushShape*>> before;
        for (std::uint32_t b = 0; b < shapes_.size(); ++b) {
            if (!used_[b] || level_.brushes[b].kind != BrushKind::kPortal) continue;
            const std::size_t first = before.size();
            for (const BrushShape::Face& face : shapes_[b].faces) {
                const std::uint32_t source = level_.brushes[b].first_side + face.side;
                if (!level_.sides[source].portal) continue;
                pieces_.assign(1, face.piece);
                hide_in_solids(face.piece.box(tables().points), ~0u);
                for (std::size_t k = 0; k < first && !pieces_.empty(); ++k)
                    if (same_plane(before[k].first, face.piece.plane))
                        hider_.hide(*before[k].second, {.same_way = true, .against = true}, pieces_);
                add_pieces(source, portals);
                before.push_back({face.piece.plane, &shapes_[b]});
            }
        }
        std::vector<ConvexPiece> cutters;
        for (const JoinPiece& portal : portals) cutters.push_back(portal.piece);
        for (const ConvexPiece& cutter : cutters) {
            const GridBox box = cutter.box(tables().points);
            divide_all(portals, cutter.plane, box);
            divide_all(made_->faces, cutter.plane, box);
        }
        for (JoinPiece& portal : portals) portal.material = portal.source;  // so that others do not merge with it
        portal_boxes_.clear();
        for (const ConvexPiece& cutter : cutters)
            portal_boxes_.push_back({cutter.plane & ~1u, cutter.box(tables().points)});
        std::sort(portal_boxes_.begin(), portal_boxes_.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
    }

    void divide_all(std::vector<JoinPiece>& pieces, PlaneId by, const GridBox& box) {
        ConvexPiece behind, front;
        for (std::size_t k = 0, count = pieces.size(); k < count; ++k) {
            if (same_plane(pieces[k].piece.plane, by) || !boxes_meet(pieces[k].piece.box(tables().points), box))
                continue;
            divide(tables(), pieces[k].piece, by, behind, front);
            if (behind.sides.empty() || front.sides.empty()) continue;
            pieces[k].piece = behind;
            JoinPiece other = pieces[k];
            other.piece = front;
            pieces.push_back(std::move(other));
        }
    }

    /// Where a portal's plane meets the walls beside it, faces end: so that each lies in one room.
    bool ends_at_portal(std::uint32_t from, std::uint32_t to, PlaneId plane) {
        GridBox side;
        side.add(tables().points.point(from).rounded());
        side.add(tables().points.point(to).rounded());
        auto it = std::lower_bound(portal_boxes_.begin(), portal_boxes_.end(), plane & ~1u,
                                   [](const auto& entry, PlaneId id) { return entry.first < id; });
        for (; it != portal_boxes_.end() && it->first == (plane & ~1u); ++it)
            if (boxes_meet(it->second, side)) return true;
        return false;
    }

    void merge() {
        merge_pieces(tables(), made_->faces, [&](std::uint32_t from, std::uint32_t to, PlaneId plane) {
            return ends_at_portal(from, to, plane);
        });
        merge_pieces(tables(), made_->portal_pieces, [](std::uint32_t, std::uint32_t, PlaneId) { return false; });
    }

    /// @return false when some brushes had to be left out, and all is to be done again
    bool arrange_all() {
        std::vector<ConvexPiece> portals;
        for (const JoinPiece& portal : made_->portal_pieces) portals.push_back(portal.piece);
        std::vector<OpenEdge> open;
        made_->arrangement = arrange(tables(), made_->faces, portals, open);
        std::vector<PlaneId> planes;
        for (const JoinPiece& face : made_->faces) planes.push_back(face.piece.plane);
        for (const ConvexPiece& portal : portals) planes.push_back(portal.plane);
        made_->facets = make_join_facets(tables(), planes, made_->arrangement);

        bool good = true;
        const auto leave_out_of = [&](std::uint32_t polygon, const char* reason) {
            const std::size_t faces = made_->faces.size();
            const JoinPiece& piece = polygon < faces ? made_->faces[polygon] : made_->portal_pieces[polygon - faces];
            const std::uint32_t brush = brush_of_side_[piece.source];
            if (!used_[brush]) return;
            leave_out(brush, reason);
            good = false;
        };
        for (const OpenEdge& edge : open)
            for (const std::uint32_t polygon : edge.polygons)
                leave_out_of(polygon, "air and solid do not alternate around an edge of it");
        for (const std::uint32_t polygon : made_->facets.unsound)
            leave_out_of(polygon, "a face of it is too thin for the grid");
        return good;
    }

    void find_rooms() {
        JoinedLevel& made = *made_;
        const std::size_t faces = made.faces.size();
        made.rooms = RoomFinder(faces, made.portal_pieces.size(), made.facets).find(made.arrangement.seen_together);
        for (std::uint32_t k = 0; k < made.portal_pieces.size(); ++k) {
            const std::uint32_t front = made.rooms.of_side[faces + 2 * k], back = made.rooms.of_side[faces + 2 * k + 1];
            const std::uint32_t source = made.portal_pieces[k].source;
            if (front == back) {
                if (made.idle_portals.empty() || made.idle_portals.back() != source)
                    made.idle_portals.push_back(source);
                continue;
            }
            const auto same = [&](const JoinPortal& portal) {
                return portal.source == source && portal.room[0] == front && portal.room[1] == back;
            };
            auto it = std::find_if(made.portals.begin(), made.portals.end(), same);
            if (it == made.portals.end()) it = made.portals.insert(it, {source, {}, {front, back}});
            it->polygons.push_back(k);
        }
    }

    const BrushLevel& level_;
    std::unique_ptr<JoinedLevel> made_;
    FaceHider hider_;
    std::vector<BrushShape> shapes_;
    std::vector<bool> used_;
    std::vector<std::uint32_t> brush_of_side_;
    std::vector<std::uint32_t> solids_;  ///< brushes of the solid, ascending
    BoxTree solid_tree_;
    std::vector<ConvexPiece> pieces_;
    std::vector<std::uint32_t> near_;
    std::vector<std::pair<PlaneId, GridBox>> portal_boxes_;  ///< by plane
};

}  // namespace

Result<std::unique_ptr<JoinedLevel>> join_brushes(const BrushLevel& level) {
    return BrushJoiner(level).join();
}

}  // namespace firma
