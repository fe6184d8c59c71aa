// SPDX-License-Identifier: MIT
// A cut whose cutter touches what it cuts.
#include "carve/arrange_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/sort.h"
#include "carve/tile_faces.h"

namespace firma {
namespace {

constexpr std::uint32_t kNotYet = ~0u;
constexpr std::size_t kUnitsAStep = 32;
constexpr std::size_t kMostPlanes = 1u << 21;  // see arrange/point_table.cpp

/// A point of a piece between its ends: where its line meets a plane across an axis, at the roundest place there.
bool point_within(const Overlay& overlay, const Plane& p, const Plane& q, std::uint32_t from, std::uint32_t to,
                  Plane& middle) {
    const Vec3 &a = overlay.point(from).approximate(), &b = overlay.point(to).approximate();
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(b[k] - a[k]) > std::fabs(b[axis] - a[axis])) axis = k;
    const double low = std::fmin(a[axis], b[axis]), high = std::fmax(a[axis], b[axis]);
    constexpr int kFinest = 24;
    for (int bits = 0; bits <= kFinest; ++bits) {
        const double scale = double(1 << bits), at = std::floor((low + high) / 2 * scale + 0.5);
        if (!(at / scale > low + 4 * kApproximation && at / scale < high - 4 * kApproximation)) continue;
        middle = axis_plane(axis, 0);
        middle.normal[axis] = std::int64_t(scale);
        middle.set_offset(-Int128(std::int64_t(at)));
        middle.d = -at;
        middle.size = scale;
        return exact_turn(p, q, middle) != 0;
    }
    return false;
}

}  // namespace

CutArranger::CutArranger(const CutInput& in, PairBudget& budget, std::uint32_t material)
    : in_(in),
      budget_(budget),
      material_(material),
      world_(std::make_unique<PatchAdder>(in.patch, 0, overlay_)),
      spans_(overlay_),
      lines_(overlay_, spans_),
      cell_finder_(overlay_, spans_, lines_) {
    if (in.cutter.turned)
        solid_ = std::make_unique<PatchAdder>(in.cutter.turned->boundary, 1, overlay_);
    else
        mesh_ = std::make_unique<MeshAdder>(in.cutter, 1, overlay_);
}

CutArranger::~CutArranger() = default;

CutArranger::End CutArranger::go_to(Phase next) {
    phase_ = next;
    return End::kGoesOn;
}

CutArranger::End CutArranger::move_on(PhaseEnd end, Phase next) {
    switch (end) {
        case PhaseEnd::kGoesOn:
            return End::kGoesOn;
        case PhaseEnd::kDone:
            return go_to(next);
        case PhaseEnd::kUnlocated:
            return End::kUnlocated;
        case PhaseEnd::kBroken:
            break;
    }
    return End::kBroken;
}

CutArranger::End CutArranger::step(const LocatePoint& locate) {
    WorkSlice slice(kUnitsAStep);
    switch (phase_) {
        case Phase::kWorld:
            if (!world_->add(slice)) return End::kGoesOn;
            take_world();
            return go_to(Phase::kCutter);
        case Phase::kCutter:
            return add_cutter(slice);
        case Phase::kPairs:
            return meet_next();
        case Phase::kSpans:
            return spans_.finish(slice) ? go_to(Phase::kLines) : End::kGoesOn;
        case Phase::kLines:
            return lines_.divide(slice) ? go_to(Phase::kCells) : End::kGoesOn;
        case Phase::kCells: {
            const End end = move_on(cell_finder_.step(slice), Phase::kLabels);
            return phase_ == Phase::kLabels ? start_labels() : end;
        }
        case Phase::kLabels: {
            const auto locate_it = [&](std::uint32_t cell) { return locate_cell(cell, locate); };
            const End end = move_on(labeller_->step(locate_it, slice), Phase::kKeep);
            return phase_ == Phase::kKeep ? start_keeping() : end;
        }
        case Phase::kKeep: {
            const End end = move_on(keeper_->step(slice), Phase::kEdges);
            if (phase_ != Phase::kEdges) return end;
            if (!keeper_->made().changes) return End::kFine;
            start_writing();
            return End::kGoesOn;
        }
        case Phase::kEdges:
            return go_on(next_, number_.size(), slice, [&](std::uint32_t edge) { write_edge(edge); })
                       ? go_to(Phase::kFaces)
                       : End::kGoesOn;
        case Phase::kFaces: {
            const std::vector<ArrangedFace>& faces = keeper_->made().faces;
            if (!go_on(next_, faces.size(), slice, [&](std::uint32_t face) { write_face(faces[face]); }))
                return End::kGoesOn;
            write_gone();
            if (!in_.divides) return End::kFine;
            number_of_piece_.assign(lines_.size(), kNotYet);
            return go_to(Phase::kTaken);
        }
        case Phase::kTaken:
            if (!go_on(next_, cell_finder_.cells().cells.size(), slice, [&](std::uint32_t cell) {
                    if (is_taken(cell)) write_taken(cell);
                }))
                return End::kGoesOn;
            gather_divisions();
            return go_to(Phase::kDivisions);
        case Phase::kDivisions:
            break;
    }
    return go_on(next_, divided_.size(), slice, [&](std::uint32_t edge) { write_division(edge); }) ? End::kFine
                                                                                                   : End::kGoesOn;
}

void CutArranger::take_world() {
    world_face_ = world_->faces();
    patch_edge_ = world_->edges();
    // One vertex stands for each point.
    vertex_of_point_.assign(overlay_.tables.points.size(), kNotYet);
    for (std::uint32_t vertex = 0; vertex < in_.patch.vertices.size(); ++vertex)
        if (const std::uint32_t point = world_->points()[vertex];
            point != kNotYet && vertex_of_point_[point] == kNotYet)
            vertex_of_point_[point] = vertex;
    world_.reset();
}

CutArranger::End CutArranger::add_cutter(WorkSlice& slice) {
    const auto first = std::uint32_t(world_face_.size());
    std::vector<std::uint32_t> face_of;
    if (solid_) {
        if (!solid_->add(slice)) return End::kGoesOn;
        triangle_of_ = solid_->faces();
        for (const std::uint32_t face : in_.cutter.turned->face_of) face_of.push_back(first + face);
        solid_.reset();
    } else {
        if (!mesh_->add(slice)) return End::kGoesOn;
        triangle_of_ = mesh_->triangles();
        face_of = mesh_->face_of();
        vertex_of_point_.resize(overlay_.tables.points.size(), kNotYet);
        for (std::uint32_t v = 0; v < mesh_->points().size(); ++v)
            if (std::uint32_t& known = vertex_of_point_[mesh_->points()[v]]; known == kNotYet)
                known = std::uint32_t(in_.patch.vertices.size()) + v;
        mesh_.reset();
    }
    patch_edge_.resize(overlay_.edges.size(), kNotYet);
    if (overlay_.tables.planes.size() >= kMostPlanes) return End::kTooLarge;
    spans_.start();
    std::vector<std::uint32_t> faces(first);
    std::iota(faces.begin(), faces.end(), 0u);
    pairs_.start(in_.cutter, overlay_, std::move(face_of), std::move(faces));
    return go_to(Phase::kPairs);
}

CutArranger::End CutArranger::meet_next() {
    const bool more = pairs_.step(spans_, budget_);
    if (budget_.spent()) return End::kPairs;
    return more ? End::kGoesOn : go_to(Phase::kSpans);
}

/// By a point of it that the other solid's boundary does not hold: a corner, or one within an edge.
CellLabel CutArranger::locate_cell(std::uint32_t cell, const LocatePoint& locate) const {
    const CellSet& cells = cell_finder_.cells();
    const Cell& it = cells.cells[cell];
    const bool world = of_world(it.face);
    const auto label_at = [&](const ExactPoint& point) {
        if (!world) {
            const CutSide side = locate(point);
            return side == CutSide::kUnknown  ? CellLabel::kUnknown
                   : side == CutSide::kInside ? CellLabel::kIn
                                              : CellLabel::kOut;
        }
        const int side = side_of_cutter(in_.cutter, point);
        return side == 0 ? CellLabel::kUnknown : side > 0 ? CellLabel::kIn : CellLabel::kOut;
    };
    for (const PieceUse& use : cells.uses(it)) {
        const CellLabel label = label_at(overlay_.point(lines_.piece(use.piece).from));
        if (label != CellLabel::kUnknown) return label;
    }
    for (const PieceUse& use : cells.uses(it)) {
        const Piece& piece = lines_.piece(use.piece);
        const Plane &p = overlay_.plane(piece.line == Piece::kNoLine ? overlay_.edges[use.edge].plane[0]
                                                                     : overlay_.lines.plane(piece.line, 0)),
                    &q = overlay_.plane(piece.line == Piece::kNoLine ? overlay_.edges[use.edge].plane[1]
                                                                     : overlay_.lines.plane(piece.line, 1));
        Plane middle;
        if (!point_within(overlay_, p, q, piece.from, piece.to, middle)) continue;
        const CellLabel label = label_at(ExactPoint(p, q, middle));
        if (label != CellLabel::kUnknown) return label;
    }
    return CellLabel::kUnknown;
}

CutArranger::End CutArranger::start_labels() {
    users_.gather(overlay_, lines_, cell_finder_.cells());
    labeller_ = std::make_unique<CellLabeller>(overlay_, lines_, cell_finder_.cells(), users_);
    return End::kGoesOn;
}

CutArranger::End CutArranger::start_keeping() {
    joins_air_ = in_.fill || takes_walls();
    keeper_ =
        std::make_unique<CellKeeper>(overlay_, lines_, cell_finder_.cells(), users_, labeller_->labels(), selection());
    return End::kGoesOn;
}

/// Faces that cuts made of one material are one source; what a level's face was divided into stays divided.
bool CutArranger::alike(std::uint32_t face, std::uint32_t other) const {
    if (in_.divides) return false;  // which air the cutter's faces will bound is not known yet
    const auto record = [&](std::uint32_t at) -> const FaceRecord& {
        return in_.patch.faces[world_face_[at]].facet.record();
    };
    if (!of_world(face)) std::swap(face, other);
    if (!of_world(face)) return true;
    const FaceRecord& a = record(face);
    if (a.edit == 0) return false;
    if (!of_world(other)) return joins_air_ && a.material == material_ && a.mask == ~0u && !a.two_sided;
    const FaceRecord& b = record(other);
    return b.edit != 0 && a.material == b.material && a.mask == b.mask && a.two_sided == b.two_sided &&
           in_.patch.faces[world_face_[face]].facet.block->part ==
               in_.patch.faces[world_face_[other]].facet.block->part;
}

Selection CutArranger::selection() const {
    Selection selection;
    const bool fill = in_.fill;
    selection.keep = [fill](std::uint8_t operand, CellLabel label) {
        switch (label) {
            case CellLabel::kOut:
                return operand == 0 || fill ? Kept::kAsItIs : Kept::kNot;
            case CellLabel::kIn:
                return fill || operand == 0 ? Kept::kNot : Kept::kTurned;
            case CellLabel::kSame:
                return operand == 0 && fill ? Kept::kAsItIs : Kept::kNot;
            case CellLabel::kOpposite:
                return operand == 0 && !fill ? Kept::kAsItIs : Kept::kNot;
            case CellLabel::kUnknown:
                break;
        }
        return Kept::kNot;
    };
    selection.longest = largest_face(in_.cutter);
    selection.alike = [this](std::uint32_t face, std::uint32_t other) { return alike(face, other); };
    selection.reusable = [this](std::uint32_t edge) { return patch_edge_[edge] != kNotYet; };
    selection.keeps_ends = in_.divides;
    selection.keeps_corners = in_.divides && in_.opens;
    return selection;
}

std::uint32_t CutArranger::vertex_of(std::uint32_t point) {
    if (vertex_of_point_.size() <= point) vertex_of_point_.resize(overlay_.tables.points.size(), kNotYet);
    std::uint32_t& known = vertex_of_point_[point];
    if (known != kNotYet) return known;
    known = std::uint32_t(in_.patch.vertices.size() + in_.cutter.points.size() + crossings_.points.size());
    CutPoint made;
    made.point = overlay_.point(point);
    if (!made.point.on_grid())
        for (int k = 0; k < 3; ++k)
            made.planes[k] = overlay_.tables.planes.stored(overlay_.tables.points.plane(point, k)).get();
    made.vertex = known;
    crossings_.real.push_back(std::uint32_t(crossings_.points.size()));
    crossings_.points.push_back(made);
    return known;
}

/// Edges that no face uses are passed over.
void CutArranger::start_writing() {
    const Arranged& arranged = keeper_->made();
    number_.assign(arranged.edges.size(), kNotYet);
    for (const OverlaySide& use : arranged.all_uses) number_[use.edge] = 0;
    if (!in_.divides) return;
    const CellSet& cells = cell_finder_.cells();
    for (std::uint32_t cell = 0; cell < cells.cells.size(); ++cell) {
        if (!is_taken(cell)) continue;
        for (const PieceUse& use : cells.uses(cells.cells[cell]))
            if (const std::uint32_t edge = kept_edge_at(use.piece, cells.cells[cell].face); edge != kNotYet)
                number_[edge] = 0;
    }
}

void CutArranger::write_edge(std::uint32_t index) {
    if (number_[index] != kNotYet) number_[index] = number_of_edge(index);
}

/// The patch's, or a new one.
std::uint32_t CutArranger::number_of_edge(std::uint32_t index) {
    const ArrangedEdge& edge = keeper_->made().edges[index];
    if (edge.edge != ArrangedEdge::kNoEdge) return patch_edge_[edge.edge];
    const auto number = std::uint32_t(in_.patch.edges.size() + loops_.edges.size());
    loops_.edges.push_back(
        {vertex_of(edge.from),
         vertex_of(edge.to),
         {overlay_.tables.planes.stored(edge.plane[0]).get(), overlay_.tables.planes.stored(edge.plane[1]).get()},
         edge.doubled});
    return number;
}

void CutArranger::write_face(const ArrangedFace& face) {
    const Arranged& arranged = keeper_->made();
    NewFace made;
    made.first_use = std::uint32_t(loops_.all_uses.size());
    made.use_count = face.use_count;
    made.first_loop = std::uint32_t(loops_.loop_ends.size());
    made.loop_count = face.loop_count;
    for (const OverlaySide& use : arranged.uses(face)) loops_.all_uses.push_back({number_[use.edge], use.reversed});
    for (const std::uint32_t end : arranged.ends(face)) loops_.loop_ends.push_back(end);
    if (of_world(face.face)) {
        made.face = world_face_[face.face];
        made.plane = Ref<const SolidPlane>(in_.patch.faces[made.face].plane);
    } else {
        made.triangle = triangle_of_[face.face - world_face_.size()];
        made.plane = overlay_.tables.planes.stored(face.plane);
    }
    loops_.faces.push_back(std::move(made));
}

void CutArranger::write_gone() {
    const std::vector<std::uint8_t>& stays = keeper_->made().stays;
    crossings_.face_cut.assign(in_.patch.faces.size(), 0);
    for (std::uint32_t face = 0; face < world_face_.size(); ++face) {
        if (stays[face]) continue;
        loops_.gone.push_back(world_face_[face]);
        crossings_.face_cut[world_face_[face]] = spans_.touched(face);
    }
}

/// Whether it is a piece of the solid's boundary, and goes.
bool CutArranger::goes(std::uint32_t cell) const {
    if (!of_world(cell_finder_.cells().cells[cell].face)) return false;
    const CellLabel label = labeller_->labels()[cell];
    return label == CellLabel::kIn || label == CellLabel::kSame;
}

bool CutArranger::is_taken(std::uint32_t cell) const {
    return in_.opens && goes(cell);
}

bool CutArranger::takes_walls() const {
    for (std::uint32_t cell = 0; cell < cell_finder_.cells().cells.size(); ++cell)
        if (goes(cell)) return true;
    return false;
}

/// The arranged edge that a piece is a part of in the result: of several the one of the same face.
std::uint32_t CutArranger::kept_edge_at(std::uint32_t piece, std::uint32_t face) const {
    const std::vector<std::uint32_t>& edges = keeper_->made().edge_of_use;
    std::uint32_t found = kNotYet;
    for (const std::uint32_t use : users_.at(piece)) {
        if (edges[use] == ArrangedEdge::kNoEdge) continue;
        if (cell_finder_.cells().cells[users_.cell_of(use)].face == face) return edges[use];
        if (found == kNotYet) found = edges[use];
    }
    return found;
}

/// The number of the edge that a side of a face that goes is a part of, see cut_view.h: that of the faces that stay
/// where there are any, else one that is the patch's whole edge, or the piece alone.
std::uint32_t CutArranger::edge_at(const PieceUse& use, std::uint32_t face) {
    if (const std::uint32_t kept = kept_edge_at(use.piece, face); kept != kNotYet) {
        if (number_[kept] == kNotYet) number_[kept] = number_of_edge(kept);
        return number_[kept];
    }
    const Piece& piece = lines_.piece(use.piece);
    if (use.edge != FacePiece::kNoEdge && patch_edge_[use.edge] != kNotYet) {
        const OverlayEdge& edge = overlay_.edges[use.edge];
        if ((edge.from == piece.from && edge.to == piece.to) || (edge.from == piece.to && edge.to == piece.from))
            return patch_edge_[use.edge];
    }
    std::uint32_t& known = number_of_piece_[use.piece];
    if (known != kNotYet) return known;
    NewEdge made{vertex_of(piece.from), vertex_of(piece.to), {nullptr, nullptr}, users_.at(use.piece).size() > 2};
    for (int k = 0; k < 2; ++k) {
        const PlaneId plane =
            piece.line == Piece::kNoLine ? overlay_.edges[use.edge].plane[k] : overlay_.lines.plane(piece.line, k);
        made.plane[k] = overlay_.tables.planes.stored(plane).get();
    }
    known = std::uint32_t(in_.patch.edges.size() + loops_.edges.size());
    loops_.edges.push_back(made);
    return known;
}

/// The vertex that a side begins at.
std::uint32_t CutArranger::piece_start(const PieceUse& use) {
    const Piece& piece = lines_.piece(use.piece);
    return vertex_of(use.forward ? piece.from : piece.to);
}

/// Pieces in a row of one edge are one side, as long as they go one way: along a slit a face has an edge there and
/// back.
void CutArranger::append_side(const PieceUse& use, std::uint32_t face, std::vector<PatchUse>& sides) {
    const std::uint32_t edge = edge_at(use, face);
    const bool goes_on = !sides.empty() && sides.back().edge == edge && side_forward_ == use.forward;
    side_forward_ = use.forward;
    if (goes_on) return;
    const std::uint32_t first = std::uint32_t(in_.patch.edges.size());
    const std::uint32_t from = edge < first ? in_.patch.edges[edge].vertex[0] : loops_.edges[edge - first].from;
    sides.push_back({edge, from != piece_start(use)});
}

void CutArranger::write_taken(std::uint32_t index) {
    const CellSet& cells = cell_finder_.cells();
    const Cell& cell = cells.cells[index];
    NewFace made;
    made.first_use = std::uint32_t(loops_.all_uses.size());
    made.first_loop = std::uint32_t(loops_.loop_ends.size());
    made.face = world_face_[cell.face];
    made.plane = Ref<const SolidPlane>(in_.patch.faces[made.face].plane);
    const auto uses = cells.uses(cell);
    std::uint32_t first = 0;
    for (const std::uint32_t end : cells.ends(cell)) {
        // From where an edge begins.
        std::uint32_t start = first;
        const PieceUse& last = uses[end - 1];
        while (start + 1 < end && uses[start].forward == last.forward &&
               edge_at(uses[start], cell.face) == edge_at(last, cell.face))
            ++start;
        sides_.clear();
        for (std::uint32_t k = 0; k < end - first; ++k)
            append_side(uses[first + (start - first + k) % (end - first)], cell.face, sides_);
        loops_.all_uses.insert(loops_.all_uses.end(), sides_.begin(), sides_.end());
        loops_.loop_ends.push_back(std::uint32_t(loops_.all_uses.size()) - made.first_use);
        ++made.loop_count;
        first = end;
    }
    made.use_count = std::uint32_t(loops_.all_uses.size()) - made.first_use;
    loops_.taken.push_back(std::move(made));
}

/// The pieces of each edge of the patch, along it: those of a line are numbered as they stand on it.
void CutArranger::gather_divisions() {
    divided_.assign(overlay_.edges.size(), {});
    for (std::uint32_t face = 0; face < world_face_.size(); ++face)
        for (const FacePiece& piece : lines_.of_face(face)) {
            if (piece.edge == FacePiece::kNoEdge || patch_edge_[piece.edge] == kNotYet) continue;
            std::vector<PieceUse>& pieces = divided_[piece.edge];
            const bool known = std::any_of(pieces.begin(), pieces.end(),
                                           [&](const PieceUse& use) { return use.piece == piece.piece; });
            if (!known) pieces.push_back({piece.piece, !piece.reversed, piece.reversed, piece.edge, face});
        }
}

void CutArranger::write_division(std::uint32_t edge) {
    std::vector<PieceUse>& pieces = divided_[edge];
    if (pieces.empty()) return;
    sort_range(pieces, [](const PieceUse& a, const PieceUse& b) { return a.piece < b.piece; });
    if (pieces[0].reversed) std::reverse(pieces.begin(), pieces.end());
    sides_.clear();
    for (const PieceUse& piece : pieces) append_side(piece, piece.id, sides_);
    if (sides_.size() == 1 && sides_[0].edge == patch_edge_[edge]) return;
    loops_.divisions.push_back({patch_edge_[edge], std::uint32_t(loops_.parts.size()), std::uint32_t(sides_.size())});
    loops_.parts.insert(loops_.parts.end(), sides_.begin(), sides_.end());
}

}  // namespace firma
