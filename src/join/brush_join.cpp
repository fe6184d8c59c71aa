// SPDX-License-Identifier: MIT
// A level's brushes, joined and kept.
//
// Every step is a function of what it is given and of an order that does not change (by brush, then by face, then by
// piece): so what is not touched is what joining again would make of it.
#include "join/brush_join.h"

#include <algorithm>
#include <utility>

#include "join/cut_loose.h"

namespace firma {
namespace {

constexpr std::size_t kMostPlanes = std::size_t(1) << 21;
constexpr std::uint32_t kNoPolygon = ~0u;
constexpr int kMostMoves = 16;  ///< rounds that move planes; the others leave out what keeps the rest from being joined

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

/// Pieces of faces are merged in this order.
std::uint64_t order_of(std::uint32_t brush, std::size_t face, std::size_t piece = 0) {
    static_assert(kMostBrushPlanes <= 1024);
    return std::uint64_t(brush) << 32 | std::uint64_t(face) << 22 | piece;
}

bool meets(const BoxTree& tree, const GridBox& box) {
    return tree.for_each_meeting(box, [](std::uint32_t) { return true; });
}

}  // namespace

BrushJoin::BrushJoin(const BrushLevel& level)
    : level_(level),
      made_(std::make_unique<JoinedLevel>()),
      mover_(level, made_->tables),
      bodies_(level, made_->tables),
      cutter_(made_->tables),
      lines_(made_->tables),
      face_merger_(made_->tables, lines_),
      portal_merger_(made_->tables, lines_),
      arranger_(made_->tables, lines_),
      faceter_(made_->tables) {
    grow();
    for (std::uint32_t b = 0; b < level.brushes.size(); ++b) use(b, true);
}

bool BrushJoin::fits(const BrushLevel& level) {
    return level.sides.size() < kMostPlanes / 2;
}

void BrushJoin::grow() {
    const std::size_t known = changed_.size(), count = level_.brushes.size();
    mover_.grow();
    brush_of_side_.resize(level_.sides.size());
    for (std::size_t b = known; b < count; ++b) {
        const Brush& brush = level_.brushes[b];
        for (std::uint32_t k = 0; k < brush.side_count; ++k) brush_of_side_[brush.first_side + k] = std::uint32_t(b);
        if (brush.kind == BrushKind::kPortal) portal_brushes_.push_back(std::uint32_t(b));
    }
    bodies_.shapes.resize(count);
    bodies_.used.resize(count);
    changed_.resize(count);
    listed_.resize(count);
    faces_.resize(count);
    open_portals_.resize(count);
    portals_.resize(count);
}

void BrushJoin::use(std::uint32_t brush, bool used) {
    if (bodies_.used[brush] == used) return;
    bodies_.used[brush] = used;
    change(brush);
}

void BrushJoin::take_back() {
    for (const LeftOut& left : made_->left_out) use(left.brush, true);
    made_->left_out.clear();
}

void BrushJoin::change(std::uint32_t brush) {
    if (changed_[brush]) return;
    changed_[brush] = true;
    changes_.push_back(brush);
}

void BrushJoin::update() {
    for (int round = 0;; ++round) {
        redo();
        if (mend(round < kMostMoves)) break;
        if (round >= 2 * kMostMoves && changes_.empty()) break;  // from here each round leaves a brush out, so it ends
    }
}

void BrushJoin::redo() {
    round_ = {};
    const std::size_t merged = face_merger_.work() + portal_merger_.work(), arranged = arranger_.work();
    make_shapes();
    cut_portals();
    cut_faces();
    merge(portal_merger_, polygon_of_portal_, false);
    merge(face_merger_, polygon_of_face_, true);
    arrange();
    for (const std::uint32_t b : changes_) changed_[b] = false;
    changes_.clear();
    round_.pieces = face_merger_.work() + portal_merger_.work() - merged;
    round_.lines = arranger_.work() - arranged;
    round_.whole = round_.brushes > 0 && round_.brushes == bodies_.solids().size();
    made_->rounds.push_back(round_);
}

void BrushJoin::make_shapes() {
    std::sort(changes_.begin(), changes_.end());
    touched_.clear();
    portal_planes_.clear();
    bool solids_changed = false;
    for (const std::uint32_t b : changes_) {
        const auto note = [&](bool in_solid) {
            if (in_solid) touched_.push_back(bodies_.shapes[b].box);
            solids_changed |= in_solid;
            if (level_.brushes[b].kind != BrushKind::kPortal) return;
            for (const BrushShape::Face& face : bodies_.shapes[b].faces)
                portal_planes_.push_back(face.piece.plane & ~1u);
        };
        note(listed_[b]);
        make_shape(b);
        listed_[b] = bodies_.in_solid(b);
        note(listed_[b]);
    }
    const bool all = changes_.size() == level_.brushes.size();  // then nobody asks what else is touched
    touched_tree_ = all ? BoxTree() : BoxTree(touched_);
    if (solids_changed) bodies_.list_solids();
}

void BrushJoin::make_shape(std::uint32_t b) {
    const Brush& brush = level_.brushes[b];
    if (brush.kind == BrushKind::kData || !bodies_.used[b]) return;
    std::vector<PlaneId> planes;
    for (std::uint32_t k = 0; k < brush.side_count; ++k) planes.push_back(mover_.of_side(brush.first_side + k));
    const BrushFault fault = make_brush_shape(tables(), planes, bodies_.shapes[b]);
    if (fault == BrushFault::kNone) return;
    bodies_.shapes[b] = {};
    leave_out(b, reason_of(fault));
}

void BrushJoin::leave_out(std::uint32_t brush, const char* reason) {
    bodies_.used[brush] = false;
    made_->left_out.push_back({brush, reason, bodies_.shapes[brush].faces.empty()});
}

/// The parts of portals that lie in the air, and where none before them is; then they are divided where they cross.
void BrushJoin::cut_portals() {
    std::sort(portal_planes_.begin(), portal_planes_.end());
    portal_boxes_.clear();
    std::vector<std::uint32_t> redone;
    for (const std::uint32_t b : portal_brushes_) {
        const BrushShape& shape = bodies_.shapes[b];
        bool again = changed_[b] || (bodies_.used[b] && meets(touched_tree_, shape.box));
        for (std::size_t k = 0; k < shape.faces.size() && !again; ++k)
            again = std::binary_search(portal_planes_.begin(), portal_planes_.end(), shape.faces[k].piece.plane & ~1u);
        if (!again) continue;
        std::vector<JoinPiece> pieces = cut_portal(b);
        std::vector<JoinPiece>& before = open_portals_[b];
        if (std::equal(before.begin(), before.end(), pieces.begin(), pieces.end(), same_piece)) continue;
        for (const auto* list : {&before, &pieces})
            for (const JoinPiece& piece : *list) portal_boxes_.push_back(piece.piece.box(tables().points));
        before = std::move(pieces);
        redone.push_back(b);
    }
    portal_tree_ = BoxTree(portal_boxes_);
    if (redone.empty()) return;
    std::vector<JoinPiece> all;
    for (const std::uint32_t b : portal_brushes_)
        all.insert(all.end(), open_portals_[b].begin(), open_portals_[b].end());
    cutter_.set_portals(all);
    for (const std::uint32_t b : portal_brushes_) {
        const bool again = std::binary_search(redone.begin(), redone.end(), b);
        const auto crossed = [&](const JoinPiece& piece) {
            return meets(portal_tree_, piece.piece.box(tables().points));
        };
        std::vector<JoinPiece> pieces = open_portals_[b];
        if (!again && std::none_of(pieces.begin(), pieces.end(), crossed)) continue;
        cutter_.divide_at_portals(pieces);
        put(portal_merger_, portals_[b], order_of(b, 0), pieces, true);
    }
}

std::vector<JoinPiece> BrushJoin::cut_portal(std::uint32_t b) {
    std::vector<JoinPiece> made;
    if (!bodies_.used[b]) return made;
    for (const BrushShape::Face& face : bodies_.shapes[b].faces) {
        const std::uint32_t source = level_.brushes[b].first_side + face.side;
        const BrushSide& side = level_.sides[source];
        if (!side.portal) continue;
        pieces_.assign(1, face.piece);
        const GridBox box = face.piece.box(tables().points);
        bodies_.hide_in_solids(box, kNoBrush, pieces_);
        for (const std::uint32_t other : portal_brushes_) {
            if (other >= b || pieces_.empty()) break;
            if (!bodies_.used[other] || !boxes_meet(bodies_.shapes[other].box, box)) continue;
            for (const BrushShape::Face& earlier : bodies_.shapes[other].faces)
                if (level_.sides[level_.brushes[other].first_side + earlier.side].portal &&
                    same_plane(earlier.piece.plane, face.piece.plane))
                    bodies_.hider().hide(bodies_.shapes[other], {.same_way = true, .against = true}, pieces_);
        }
        // The source in place of the material: so that portals do not merge with others.
        for (ConvexPiece& piece : pieces_) made.push_back({std::move(piece), source, source, side.mask});
    }
    return made;
}

/// Of each face what no brush hides, divided where it meets a portal.
void BrushJoin::cut_faces() {
    std::vector<std::uint32_t> near;
    std::vector<bool> listed(level_.brushes.size());
    std::size_t solids = 0;
    const auto list = [&](std::uint32_t b) {
        if (listed[b]) return;
        listed[b] = true;
        near.push_back(b);
        solids += bodies_.in_solid(b);
    };
    for (const std::uint32_t b : changes_)
        if (bodies_.in_solid(b) || !faces_[b].empty()) list(b);
    for (const auto* boxes : {&touched_, &portal_boxes_})
        for (std::size_t k = 0; k < boxes->size() && solids < bodies_.solids().size(); ++k)
            bodies_.for_each_solid((*boxes)[k], list);
    std::sort(near.begin(), near.end());
    for (const std::uint32_t b : near) cut_brush(b);
}

void BrushJoin::cut_brush(std::uint32_t b) {
    std::vector<Cut>& cut = faces_[b];
    const BrushShape& shape = bodies_.shapes[b];
    const bool solid = bodies_.in_solid(b);
    std::vector<JoinPiece> pieces;
    while (cut.size() > (solid ? shape.faces.size() : 0)) {
        put(face_merger_, cut.back(), 0, pieces, true);
        cut.pop_back();
    }
    if (!solid) return;
    cut.resize(shape.faces.size());
    const std::size_t before = round_.faces;
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const ConvexPiece& face = shape.faces[f].piece;
        const GridBox box = face.box(tables().points);
        const bool near_portal = meets(portal_tree_, box);
        if (!changed_[b] && !near_portal && !meets(touched_tree_, box)) continue;
        ++round_.faces;
        pieces_.assign(1, face);
        bodies_.hide_in_solids(box, b, pieces_);
        const std::uint32_t source = level_.brushes[b].first_side + shape.faces[f].side;
        const BrushSide& side = level_.sides[source];
        pieces.clear();
        for (ConvexPiece& piece : pieces_)
            pieces.push_back({std::move(piece), source, side.material, side.mask, side.texture});
        cutter_.divide_at_portals(pieces);
        put(face_merger_, cut[f], order_of(b, f), pieces, near_portal);
    }
    round_.brushes += round_.faces > before;
}

/// Replaces pieces by others; those that are equal stay.
/// @param all  replaces these as well: what may keep them from merging has changed
void BrushJoin::put(PieceMerger& merger, Cut& cut, std::uint64_t order, std::vector<JoinPiece>& pieces, bool all) {
    for (std::size_t k = 0; k < std::max(cut.size(), pieces.size()); ++k) {
        const bool was = k < cut.size(), is = k < pieces.size();
        if (was && is && !all && same_piece(merger.piece(cut[k]), pieces[k])) continue;
        if (was) merger.remove(cut[k]);
        if (!is) continue;
        const std::uint32_t added = merger.add(std::move(pieces[k]), order + k);
        if (was)
            cut[k] = added;
        else
            cut.push_back(added);
    }
    cut.resize(pieces.size());
    pieces.clear();
}

void BrushJoin::merge(PieceMerger& merger, std::vector<std::uint32_t>& polygon_of, bool face) {
    const KeepSide keep = [&](std::uint32_t from, std::uint32_t to, PlaneId plane) {
        return cutter_.ends_at_portal(from, to, plane);
    };
    for (const std::uint32_t piece : merger.merge(keep)) {
        if (piece >= polygon_of.size()) polygon_of.resize(piece + 1, kNoPolygon);
        std::uint32_t& polygon = polygon_of[piece];
        if (polygon != kNoPolygon) {
            arranger_.remove(polygon);
            polygons_[polygon].facets = {};
            polygon = kNoPolygon;
        }
        const JoinPiece& merged = merger.merged(piece);
        if (merged.piece.sides.empty()) continue;
        polygon = arranger_.add(merged.piece, face);
        polygons_.push_back({face, piece, {}});
    }
}

void BrushJoin::arrange() {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t polygon : arranger_.update()) {
        arranger_.outline(polygon, corners);
        ++round_.polygons;
        if (!faceter_.make(piece_of(polygon).piece.plane, corners, polygons_[polygon].facets))
            unsound_.push_back(polygon);
    }
    std::sort(unsound_.begin(), unsound_.end());
    unsound_.erase(std::unique(unsound_.begin(), unsound_.end()), unsound_.end());
    std::erase_if(unsound_,
                  [&](std::uint32_t polygon) { return !arranger_.has(polygon) || !polygons_[polygon].facets.empty(); });
}

const JoinPiece& BrushJoin::piece_of(std::uint32_t polygon) const {
    const Polygon& it = polygons_[polygon];
    return (it.face ? face_merger_ : portal_merger_).merged(it.piece);
}

/// Faces before portals; by brush.
void BrushJoin::sort_polygons(std::vector<std::uint32_t>& polygons) const {
    const auto order = [&](std::uint32_t polygon) {
        const Polygon& it = polygons_[polygon];
        return std::pair(!it.face, (it.face ? face_merger_ : portal_merger_).order(it.piece));
    };
    std::sort(polygons.begin(), polygons.end(), [&](std::uint32_t a, std::uint32_t b) { return order(a) < order(b); });
}

void BrushJoin::leave_out_of(std::uint32_t polygon, const char* reason) {
    const std::uint32_t brush = brush_of_side_[piece_of(polygon).source];
    if (!bodies_.used[brush]) return;
    leave_out(brush, reason);
    change(brush);
}

/// Moves planes that make outlines too thin for the surface grid; leaves out brushes where that is of no use.
/// @return true when there is nothing to mend
bool BrushJoin::mend(bool may_move) {
    std::vector<std::uint32_t> polygons;
    for (const OpenEdge& edge : arranger_.open())
        polygons.insert(polygons.end(), edge.polygons.begin(), edge.polygons.end());
    sort_polygons(polygons);
    for (const std::uint32_t polygon : polygons)
        leave_out_of(polygon, "air and solid do not alternate around an edge of it");
    const bool sound = polygons.empty() && unsound_.empty();

    polygons = unsound_;
    sort_polygons(polygons);
    std::vector<PlaneMover::Outline> outlines;
    for (const std::uint32_t polygon : polygons) {
        PlaneMover::Outline& outline = outlines.emplace_back();
        outline.plane = piece_of(polygon).piece.plane;
        arranger_.outline(polygon, outline.corners);
    }
    std::vector<bool> moved(outlines.size());
    if (may_move && !outlines.empty()) {
        moved = mover_.move(outlines, bodies_.shapes);
        std::vector<bool> side_moved(level_.sides.size());
        for (const std::uint32_t side : mover_.moved_sides()) side_moved[side] = true;
        for (std::uint32_t b = 0; b < level_.brushes.size(); ++b)
            for (std::uint32_t k = 0; k < level_.brushes[b].side_count; ++k)
                if (side_moved[level_.brushes[b].first_side + k]) change(b);
    }
    for (std::size_t k = 0; k < outlines.size(); ++k)
        if (!moved[k]) leave_out_of(polygons[k], "a face of it is too thin for the grid");
    return sound;
}

/// What is kept, in a row.
/// @param last  it need not be kept any longer
void BrushJoin::assemble(bool last) {
    JoinedLevel& made = *made_;
    std::vector<std::uint32_t> order;
    for (std::uint32_t polygon = 0; polygon < polygons_.size(); ++polygon)
        if (arranger_.has(polygon)) order.push_back(polygon);
    sort_polygons(order);
    made.faces.clear();
    made.portal_pieces.clear();
    made.facets = {};
    made.facets.first.push_back(0);
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        Polygon& polygon = polygons_[order[k]];
        (polygon.face ? made.faces : made.portal_pieces).push_back(piece_of(order[k]));
        if (polygon.facets.empty()) made.facets.unsound.push_back(k);
        if (last)
            made.facets.add(std::move(polygon.facets));
        else
            made.facets.add(polygon.facets);
    }
    made.arrangement = arranger_.arrangement(order);
    made.planes_moved = mover_.moved();
    made.plane_of_side.clear();
    made.moved_sides.clear();
    for (std::uint32_t side = 0; side < level_.sides.size(); ++side) {
        made.plane_of_side.push_back(mover_.of_side(side));
        if (mover_.is_moved(side)) made.moved_sides.push_back({side, mover_.points_of_side(side)});
    }
    made.hidden_portals.clear();
    for (const std::uint32_t b : portal_brushes_) {
        const auto is_portal = [&](const BrushShape::Face& face) {
            return level_.sides[level_.brushes[b].first_side + face.side].portal;
        };
        const std::vector<BrushShape::Face>& faces = bodies_.shapes[b].faces;
        if (bodies_.used[b] && open_portals_[b].empty() && std::any_of(faces.begin(), faces.end(), is_portal))
            made.hidden_portals.push_back(b);
    }
}

RoomFinder BrushJoin::find_rooms(bool last) {
    assemble(last);
    RoomFinder finder(made_->faces.size(), made_->portal_pieces.size(), made_->facets);
    made_->rooms = finder.find(made_->arrangement.seen_together);
    find_portals();
    return finder;
}

const JoinedLevel& BrushJoin::divide() {
    find_rooms(false);
    return *made_;
}

std::unique_ptr<JoinedLevel> BrushJoin::finish() {
    const RoomFinder finder = find_rooms(true);
    std::vector<std::uint32_t> left_out;
    for (const LeftOut& left : made_->left_out)
        if (!bodies_.shapes[left.brush].faces.empty()) left_out.push_back(left.brush);
    made_->loose = LooseCutter(level_, tables(), bodies_, cutter_).cut(left_out);
    for (LooseFacet& facet : made_->loose) facet.room = finder.room_of(made_->rooms, facet.corners);
    made_->bodies.clear();
    for (const std::uint32_t b : bodies_.solids()) {
        JoinBody& body = made_->bodies.emplace_back(JoinBody{b, bodies_.shapes[b].box, {}});
        for (const BrushShape::Face& face : bodies_.shapes[b].faces) body.planes.push_back(face.piece.plane);
    }
    return std::move(made_);
}

/// Portal pieces by the rooms on their two sides.
void BrushJoin::find_portals() {
    JoinedLevel& made = *made_;
    made.portals.clear();
    made.idle_portals.clear();
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
    std::sort(used.begin(), used.end());
    for (const std::uint32_t source : idle)  // of one that divides two rooms, parts elsewhere do not matter
        if (!std::binary_search(used.begin(), used.end(), source) &&
            (made.idle_portals.empty() || made.idle_portals.back() != source))
            made.idle_portals.push_back(source);
}

/// Whether two sides are of one portal: or of brushes of one entity, in one plane.
bool BrushJoin::are_one(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return true;
    const std::uint32_t entity = level_.brushes[brush_of_side_[a]].entity;
    return entity != 0 && entity == level_.brushes[brush_of_side_[b]].entity && mover_.of_side(a) == mover_.of_side(b);
}

Result<std::unique_ptr<JoinedLevel>> join_brushes(const BrushLevel& level) {
    if (!BrushJoin::fits(level))
        return Error{ErrorCode::kTooLarge, level.name, "a level has fewer than 2^20 brush sides"};
    BrushJoin join(level);
    join.update();
    return join.finish();
}

}  // namespace firma
