// SPDX-License-Identifier: MIT
// Many convex brushes become one closed solid.
#include "join/join_brushes.h"

#include <algorithm>

#include "join/hide_faces.h"
#include "join/merge_pieces.h"
#include "join/move_planes.h"
#include "join/portal_cutter.h"
#include "index/box_tree.h"

namespace firma {
namespace {

constexpr std::size_t kMostPlanes = std::size_t(1) << 21;
constexpr std::uint32_t kNoBrush = ~0u;
constexpr int kMostRounds = 32;  ///< of leaving out what keeps the rest from being joined

const char* reason_of(BrushFault fault) {
    switch (fault) {
        case BrushFault::kEmpty:
            return "its planes leave no volume; perhaps they look inward";
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
        : level_(level),
          made_(std::make_unique<JoinedLevel>()),
          cutter_(made_->tables),
          mover_(level, made_->tables),
          hider_(made_->tables) {
        used_.resize(level.brushes.size(), true);
        brush_of_side_.resize(level.sides.size());
        for (std::uint32_t b = 0; b < level.brushes.size(); ++b)
            for (std::uint32_t k = 0; k < level.brushes[b].side_count; ++k)
                brush_of_side_[level.brushes[b].first_side + k] = b;
    }

    Result<std::unique_ptr<JoinedLevel>> join() {
        if (level_.sides.size() >= kMostPlanes / 2)
            return Error{ErrorCode::kTooLarge, level_.name, "a level has fewer than 2^20 brush sides"};
        for (int round = 0; round < kMostRounds; ++round) {
            make_shapes();
            cut_faces();
            cut_portals();
            merge();
            arrange_all();
            if (mend(round < kMostRounds / 2)) break;
        }
        for (std::uint32_t side = 0; side < level_.sides.size(); ++side)
            made_->plane_of_side.push_back(mover_.of_side(side));
        find_rooms();
        return std::move(made_);
    }

private:
    JoinTables& tables() { return made_->tables; }

    void make_shapes() {
        shapes_.resize(level_.brushes.size());
        std::vector<PlaneId> planes;
        for (std::uint32_t b = 0; b < level_.brushes.size(); ++b) {
            const Brush& brush = level_.brushes[b];
            if (brush.kind == BrushKind::kData || !used_[b]) continue;
            planes.clear();
            for (std::uint32_t k = 0; k < brush.side_count; ++k) planes.push_back(mover_.of_side(brush.first_side + k));
            const BrushFault fault = make_brush_shape(tables(), planes, shapes_[b]);
            if (fault == BrushFault::kNone) continue;
            shapes_[b] = {};
            leave_out(b, reason_of(fault));
        }
    }

    void leave_out(std::uint32_t brush, const char* reason) {
        used_[brush] = false;
        made_->left_out.push_back({brush, reason, shapes_[brush].faces.empty()});
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

    /// @param brush  the pieces are of this one; of none, kNoBrush: then what lies on the solid goes as well
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
        made_->hidden_portals.clear();
        std::vector<std::pair<PlaneId, const BrushShape*>> before;
        for (std::uint32_t b = 0; b < shapes_.size(); ++b) {
            if (!used_[b] || level_.brushes[b].kind != BrushKind::kPortal) continue;
            const std::size_t first = before.size(), portals_before = portals.size();
            for (const BrushShape::Face& face : shapes_[b].faces) {
                const std::uint32_t source = level_.brushes[b].first_side + face.side;
                if (!level_.sides[source].portal) continue;
                pieces_.assign(1, face.piece);
                hide_in_solids(face.piece.box(tables().points), kNoBrush);
                for (std::size_t k = 0; k < first && !pieces_.empty(); ++k)
                    if (same_plane(before[k].first, face.piece.plane))
                        hider_.hide(*before[k].second, {.same_way = true, .against = true}, pieces_);
                add_pieces(source, portals);
                before.push_back({face.piece.plane, &shapes_[b]});
            }
            if (before.size() > first && portals.size() == portals_before) made_->hidden_portals.push_back(b);
        }
        cutter_.set_portals(portals);
        cutter_.divide_at_portals(portals);
        cutter_.divide_at_portals(made_->faces);
        for (JoinPiece& portal : portals) portal.material = portal.source;  // so that others do not merge with it
    }

    void merge() {
        cutter_.merge_between_portals(made_->faces);
        cutter_.merge_between_portals(made_->portal_pieces);
    }

    void arrange_all() {
        std::vector<ConvexPiece> portals;
        for (const JoinPiece& portal : made_->portal_pieces) portals.push_back(portal.piece);
        open_.clear();
        made_->arrangement = arrange(tables(), made_->faces, portals, open_);
        std::vector<PlaneId> planes;
        for (const JoinPiece& face : made_->faces) planes.push_back(face.piece.plane);
        for (const ConvexPiece& portal : portals) planes.push_back(portal.plane);
        made_->facets = make_join_facets(tables(), planes, made_->arrangement);
    }

    const JoinPiece& polygon(std::uint32_t index) const {
        const std::size_t faces = made_->faces.size();
        return index < faces ? made_->faces[index] : made_->portal_pieces[index - faces];
    }

    /// Moves planes that make outlines too thin for the surface grid; leaves out brushes where that is of no use.
    /// @return true when there is nothing to mend; else all is to be done again
    bool mend(bool may_move) {
        bool sound = true;
        const auto leave_out_of = [&](std::uint32_t index, const char* reason) {
            sound = false;
            const std::uint32_t brush = brush_of_side_[polygon(index).source];
            if (used_[brush]) leave_out(brush, reason);
        };
        for (const OpenEdge& edge : open_)
            for (const std::uint32_t index : edge.polygons)
                leave_out_of(index, "air and solid do not alternate around an edge of it");
        std::vector<PlaneMover::Outline> outlines;
        for (const std::uint32_t index : made_->facets.unsound) {
            PlaneMover::Outline& outline = outlines.emplace_back();
            outline.plane = polygon(index).piece.plane;
            for (const JoinStep& step : made_->arrangement.outline(index)) outline.corners.push_back(step.corner);
        }
        std::vector<bool> moved(outlines.size());
        if (may_move) moved = mover_.move(outlines, shapes_);
        for (std::size_t k = 0; k < outlines.size(); ++k) {
            sound = false;
            if (!moved[k]) leave_out_of(made_->facets.unsound[k], "a face of it is too thin for the grid");
        }
        made_->planes_moved = mover_.moved();
        return sound;
    }

    /// What is no part of the solid, kind by kind: what of its faces neither the solid nor its own kind hides.
    void cut_loose() {
        constexpr BrushKind kKinds[] = {BrushKind::kGlass, BrushKind::kPlayerClip, BrushKind::kShotClip,
                                        BrushKind::kLiquid};
        for (const BrushKind kind : kKinds) {
            std::vector<std::uint32_t> brushes;
            for (std::uint32_t b = 0; b < shapes_.size(); ++b)
                if (used_[b] && level_.brushes[b].kind == kind) brushes.push_back(b);
            add_loose(brushes);
        }
        for (const LeftOut& left : made_->left_out)  // by themselves: what keeps them apart may be each other
            if (!shapes_[left.brush].faces.empty()) add_loose({&left.brush, 1});
        cut_surfaces();
    }

    void add_loose(std::span<const std::uint32_t> brushes) {
        std::vector<GridBox> boxes;
        for (const std::uint32_t b : brushes) boxes.push_back(shapes_[b].box);
        const BoxTree tree(boxes);
        std::vector<JoinPiece> pieces;
        for (const std::uint32_t b : brushes)
            for (const BrushShape::Face& face : shapes_[b].faces) {
                const GridBox box = face.piece.box(tables().points);
                pieces_.assign(1, face.piece);
                hide_in_solids(box, kNoBrush);
                near_.clear();
                tree.for_each_meeting(box, [&](std::uint32_t k) {
                    if (brushes[k] != b) near_.push_back(brushes[k]);
                    return false;
                });
                std::sort(near_.begin(), near_.end());
                for (const std::uint32_t other : near_)
                    hider_.hide(shapes_[other], {.same_way = other < b, .against = true}, pieces_);
                add_pieces(level_.brushes[b].first_side + face.side, pieces);
            }
        cutter_.divide_at_portals(pieces);
        cutter_.merge_between_portals(pieces);
        for (LooseFacet& facet : make_loose_facets(tables(), pieces)) made_->loose.push_back(std::move(facet));
    }

    static bool same_outline(const ConvexPiece& a, const ConvexPiece& b) {
        return std::equal(a.sides.begin(), a.sides.end(), b.sides.begin(), b.sides.end(),
                          [](const PieceSide& x, const PieceSide& y) { return x.corner == y.corner; });
    }

    /// Surfaces stay as the file has them, but for those that reach through a portal or into the solid: no face lies in
    /// two rooms.
    void cut_surfaces() {
        const Level& surfaces = level_.surfaces;
        std::vector<JoinPiece> pieces;
        std::vector<InputPoint> corners;
        for (std::uint32_t k = 0; k < surfaces.faces.size(); ++k) {
            const LevelFace& face = surfaces.faces[k];
            LooseFacet facet;
            facet.source = std::uint32_t(level_.sides.size()) + k;
            facet.material = face.material;
            facet.mask = face.mask;
            facet.two_sided = face.two_sided;
            GridBox box;
            corners.clear();
            for (std::uint32_t c = 0; c < face.corner_count; ++c) {
                const GridPoint& corner = surfaces.vertices[surfaces.corners[face.first_corner + c]];
                facet.corners.push_back(corner);
                corners.push_back(to_input(corner));
                box.add(corner);
            }
            pieces_.assign(1, piece_of_corners(tables(), corners));
            const ConvexPiece whole = pieces_[0];
            hide_in_solids(box, kNoBrush);
            pieces.clear();
            for (ConvexPiece& piece : pieces_)
                pieces.push_back({std::move(piece), facet.source, face.material, face.mask});
            cutter_.divide_at_portals(pieces);
            if (pieces.size() == 1 && same_outline(pieces[0].piece, whole)) {
                made_->loose.push_back(std::move(facet));
                continue;
            }
            for (LooseFacet& part : make_loose_facets(tables(), pieces)) {
                part.two_sided = face.two_sided;
                made_->loose.push_back(std::move(part));
            }
        }
    }

    /// Each loose facet is put where it lies.
    void place_loose(const RoomFinder& finder) {
        for (LooseFacet& facet : made_->loose) {
            facet.room = finder.room_of(made_->rooms, facet.corners);
        }
    }

    void find_rooms() {
        JoinedLevel& made = *made_;
        const std::size_t faces = made.faces.size();
        const RoomFinder finder(faces, made.portal_pieces.size(), made.facets);
        made.rooms = finder.find(made.arrangement.seen_together);
        find_portals();
        cut_loose();
        place_loose(finder);
    }

    /// Portal pieces by the rooms on their two sides.
    void find_portals() {
        JoinedLevel& made = *made_;
        const std::size_t faces = made.faces.size();
        std::vector<std::uint32_t> idle, used;
        for (std::uint32_t k = 0; k < made.portal_pieces.size(); ++k) {
            const std::uint32_t front = made.rooms.of_side[faces + 2 * k], back = made.rooms.of_side[faces + 2 * k + 1];
            const std::uint32_t source = made.portal_pieces[k].source;
            (front == back ? idle : used).push_back(source);
            if (front == back) continue;
            const auto same = [&](const JoinPortal& portal) {
                return portal.room[0] == front && portal.room[1] == back && are_one(portal.source, source);
            };
            auto it = std::find_if(made.portals.begin(), made.portals.end(), same);
            if (it == made.portals.end()) it = made.portals.insert(it, {source, {}, {front, back}});
            it->polygons.push_back(k);
        }
        for (const std::uint32_t source : idle)  // of one that divides two rooms, parts elsewhere do not matter
            if (std::find(used.begin(), used.end(), source) == used.end() &&
                (made.idle_portals.empty() || made.idle_portals.back() != source))
                made.idle_portals.push_back(source);
    }

    /// Whether two sides are of one portal: or of brushes of one entity, in one plane.
    bool are_one(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return true;
        const std::uint32_t entity = level_.brushes[brush_of_side_[a]].entity;
        return entity != 0 && entity == level_.brushes[brush_of_side_[b]].entity &&
               mover_.of_side(a) == mover_.of_side(b);
    }

    const BrushLevel& level_;
    std::unique_ptr<JoinedLevel> made_;
    PortalCutter cutter_;
    PlaneMover mover_;
    FaceHider hider_;
    std::vector<BrushShape> shapes_;
    std::vector<bool> used_;
    std::vector<std::uint32_t> brush_of_side_;
    std::vector<std::uint32_t> solids_;  ///< brushes of the solid, ascending
    BoxTree solid_tree_;
    std::vector<ConvexPiece> pieces_;
    std::vector<std::uint32_t> near_;
    std::vector<OpenEdge> open_;
};

}  // namespace

Result<std::unique_ptr<JoinedLevel>> join_brushes(const BrushLevel& level) {
    return BrushJoiner(level).join();
}

}  // namespace firma
