// SPDX-License-Identifier: MIT
// A cut whose cutter touches what it cuts.
#include "carve/arrange_cut.h"

#include <cmath>

#include "base/disjoint_sets.h"
#include "carve/gather.h"
#include "carve/side_of_solid.h"
#include "carve/tile_faces.h"
#include "geometry/flat_loop.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;
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

CutArranger::End CutArranger::step(const LocatePoint& locate) {
    switch (phase_) {
        case Phase::kStart:
            return start();
        case Phase::kPairs:
            return meet_next();
        case Phase::kLines:
            return divide();
        case Phase::kCells:
            phase_ = Phase::kLabels;
            if (!find_cells(overlay_, spans_, lines_, cells_)) return End::kBroken;
            return End::kGoesOn;
        case Phase::kLabels:
            return label(locate);
        case Phase::kKeep:
            break;
    }
    return keep();
}

/// Puts faces of a patch into an overlay.
class CutArranger::PatchAdder {
public:
    PatchAdder(const SolidPatch& patch, std::uint8_t operand, Overlay& overlay)
        : patch_(patch),
          operand_(operand),
          overlay_(overlay),
          point_of_(patch.vertices.size(), kNone),
          edge_of_(patch.edges.size(), kNone) {}

    std::uint32_t add(const PatchFace& face) {
        sides_.clear();
        for (const PatchUse& use : patch_.uses(face)) sides_.push_back({edge(use.edge), use.reversed});
        return overlay_.add_face(overlay_.tables.planes.add(face.plane->plane), operand_, sides_, patch_.ends(face));
    }
    /// Of its vertices; ~0: one of no face added.
    const std::vector<std::uint32_t>& points() const { return point_of_; }
    /// The patch's, of the overlay's edges added.
    const std::vector<std::uint32_t>& edges() const { return edges_; }

private:
    std::uint32_t point(std::uint32_t vertex) {
        std::uint32_t& known = point_of_[vertex];
        if (known != kNone) return known;
        const ExactPoint& point = patch_.vertices[vertex].point;
        if (point.on_grid()) return known = overlay_.tables.points.add(point.grid());
        PlaneId planes[3];
        for (int k = 0; k < 3; ++k) planes[k] = overlay_.tables.planes.add(*point.plane(k));
        return known = overlay_.tables.points.add(planes[0], planes[1], planes[2]);
    }

    std::uint32_t edge(std::uint32_t index) {
        std::uint32_t& known = edge_of_[index];
        if (known != kNone) return known;
        const PatchEdge& edge = patch_.edges[index];
        OverlayEdge made;
        made.from = point(edge.vertex[0]);
        made.to = point(edge.vertex[1]);
        for (int k = 0; k < 2; ++k) made.plane[k] = overlay_.tables.planes.add(edge.plane[k]->plane);
        made.doubled = edge.doubled;
        edges_.push_back(index);
        return known = overlay_.add_edge(made);
    }

    const SolidPatch& patch_;
    const std::uint8_t operand_;
    Overlay& overlay_;
    std::vector<std::uint32_t> point_of_, edge_of_, edges_;
    std::vector<OverlaySide> sides_;
};

void CutArranger::add_world() {
    const SolidPatch& patch = in_.patch;
    PatchAdder adder(patch, 0, overlay_);
    for (std::uint32_t index = 0; index < patch.faces.size(); ++index) {
        if (patch.faces[index].replaced) continue;
        adder.add(patch.faces[index]);
        world_face_.push_back(index);
    }
    patch_edge_ = adder.edges();
    // One vertex stands for each point.
    vertex_of_point_.assign(overlay_.tables.points.size(), kNone);
    for (std::uint32_t vertex = 0; vertex < patch.vertices.size(); ++vertex)
        if (const std::uint32_t point = adder.points()[vertex]; point != kNone && vertex_of_point_[point] == kNone)
            vertex_of_point_[point] = vertex;
}

void CutArranger::add_solid() {
    const TurnedSolid& turned = *in_.cutter.turned;
    PatchAdder adder(turned.boundary, 1, overlay_);
    const std::uint32_t first = std::uint32_t(overlay_.faces.size());
    for (std::uint32_t index = 0; index < turned.boundary.faces.size(); ++index) {
        adder.add(turned.boundary.faces[index]);
        triangle_of_.push_back(index);
    }
    patch_edge_.resize(overlay_.edges.size(), kNone);
    for (const std::uint32_t face : turned.face_of) group_face_.push_back(first + face);
}

/// Neighbouring triangles in one plane are one face.
void CutArranger::add_mesh() {
    const CutterSolid& cutter = in_.cutter;
    const std::size_t count = cutter.planes.size();
    std::vector<PlaneId> planes;
    planes.reserve(count);
    for (const auto& plane : cutter.planes) planes.push_back(overlay_.tables.planes.add(plane->plane));
    DisjointSets groups(count);
    for (const CutterSolid::Edge& edge : cutter.edges)
        if (planes[edge.left] == planes[edge.right]) groups.join(edge.left, edge.right);

    std::vector<std::uint32_t> point_of(cutter.points.size());
    for (std::size_t v = 0; v < point_of.size(); ++v)
        point_of[v] = overlay_.tables.points.add(cutter.placed.vertices[v]);
    vertex_of_point_.resize(overlay_.tables.points.size(), kNone);
    for (std::uint32_t v = 0; v < point_of.size(); ++v)
        if (vertex_of_point_[point_of[v]] == kNone)
            vertex_of_point_[point_of[v]] = std::uint32_t(in_.patch.vertices.size()) + v;

    std::vector<std::uint32_t> edge_of(cutter.edges.size(), kNone);
    const auto is_rim = [&](std::uint32_t edge) {
        return groups.find(cutter.edges[edge].left) != groups.find(cutter.edges[edge].right);
    };
    for (std::uint32_t edge = 0; edge < cutter.edges.size(); ++edge) {
        if (!is_rim(edge)) continue;
        const CutterSolid::Edge& it = cutter.edges[edge];
        OverlayEdge made{point_of[it.a], point_of[it.b], {planes[it.left], planes[it.right]}};
        if (exact_parallel(it.plane[0]->plane, cutter.planes[it.right]->plane))
            made.plane[1] = overlay_.tables.planes.add(it.plane[1]->plane);
        edge_of[edge] = overlay_.add_edge(made);
        patch_edge_.push_back(kNone);
    }

    group_face_.assign(count, kNone);
    std::vector<std::vector<std::uint32_t>> members(count);
    for (std::uint32_t t = 0; t < count; ++t) members[groups.find(t)].push_back(t);
    std::vector<std::uint8_t> seen(3 * count, 0);
    std::vector<OverlaySide> sides, loop, holes;
    std::vector<std::uint32_t> hole_ends, ends;
    std::vector<FlatPoint> corners;
    for (std::uint32_t group = 0; group < count; ++group) {
        if (members[group].empty()) continue;
        sides.clear();
        holes.clear();
        hole_ends.clear();
        const FlatView view = cutter.planes[group]->plane.front_view();
        for (const std::uint32_t first : members[group])
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (seen[3 * first + k] || !is_rim(cutter.edge_of(first, int(k)))) continue;
                loop.clear();
                corners.clear();
                for (std::uint32_t t = first, at = k; !seen[3 * t + at];) {
                    seen[3 * t + at] = 1;
                    const std::uint32_t edge = cutter.edge_of(t, int(at));
                    loop.push_back({edge_of[edge], cutter.edges[edge].left != t});
                    corners.push_back(project(cutter.points[cutter.triangle(t)[at]].rounded(), view));
                    // Around the corner at its end, through triangles of the same face.
                    at = (at + 1) % 3;
                    for (std::uint32_t next = cutter.edge_of(t, int(at)); !is_rim(next);
                         next = cutter.edge_of(t, int(at))) {
                        t = cutter.edges[next].left == t ? cutter.edges[next].right : cutter.edges[next].left;
                        at = 0;
                        while (cutter.edge_of(t, int(at)) != next) ++at;
                        at = (at + 1) % 3;
                    }
                }
                if (sides.empty() && twice_area(corners) > 0) {
                    sides = loop;
                } else {
                    holes.insert(holes.end(), loop.begin(), loop.end());
                    hole_ends.push_back(std::uint32_t(holes.size()));
                }
            }
        ends.assign(1, std::uint32_t(sides.size()));
        for (const std::uint32_t end : hole_ends) ends.push_back(std::uint32_t(sides.size()) + end);
        sides.insert(sides.end(), holes.begin(), holes.end());
        const std::uint32_t face = overlay_.add_face(planes[group], 1, sides, ends);
        triangle_of_.push_back(group);
        for (const std::uint32_t t : members[group]) group_face_[t] = face;
    }
}

CutArranger::End CutArranger::start() {
    add_world();
    if (in_.cutter.turned)
        add_solid();
    else
        add_mesh();
    if (overlay_.tables.planes.size() >= kMostPlanes) return End::kTooLarge;
    spans_.start();
    met_.assign(overlay_.faces.size(), kNone);
    phase_ = Phase::kPairs;
    return End::kGoesOn;
}

CutArranger::End CutArranger::meet_next() {
    // A mesh's triangles hold its faces; a Solid's facets lie near its faces.
    const std::int32_t steps = in_.cutter.turned ? 1 + kFacetReach : 1;
    const std::uint64_t before = budget_.taken();
    for (; next_ < world_face_.size() && budget_.taken() - before < kPairsACutStep; ++next_) {
        in_.cutter.tree.for_each_meeting(grown(overlay_.faces[next_].box, steps), [&](std::uint32_t triangle) {
            const std::uint32_t face = group_face_[triangle];
            if (met_[face] == next_) return false;
            met_[face] = next_;
            if (!budget_.take()) return true;
            spans_.meet(next_, face);
            return false;
        });
        if (budget_.spent()) return End::kPairs;
    }
    if (next_ == world_face_.size()) phase_ = Phase::kLines;
    return End::kGoesOn;
}

CutArranger::End CutArranger::divide() {
    spans_.lend();
    spans_.cross();
    lines_.divide(overlay_, spans_);
    phase_ = Phase::kCells;
    return End::kGoesOn;
}

/// By a point of it that the other solid's boundary does not hold: a corner, or one within an edge.
CellLabel CutArranger::locate_cell(std::uint32_t cell, const LocatePoint& locate) const {
    const Cell& it = cells_.cells[cell];
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
    for (const PieceUse& use : cells_.uses(it)) {
        const CellLabel label = label_at(overlay_.point(lines_.piece(use.piece).from));
        if (label != CellLabel::kUnknown) return label;
    }
    for (const PieceUse& use : cells_.uses(it)) {
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

CutArranger::End CutArranger::label(const LocatePoint& locate) {
    users_.gather(overlay_, lines_, cells_);
    phase_ = Phase::kKeep;
    switch (label_cells(
        overlay_, lines_, cells_, users_, [&](std::uint32_t cell) { return locate_cell(cell, locate); }, labels_)) {
        case LabelEnd::kFine:
            break;
        case LabelEnd::kBroken:
            return End::kBroken;
        case LabelEnd::kUnlocated:
            return End::kUnlocated;
    }
    return End::kGoesOn;
}

/// Faces that cuts made of one material are one source; what a level's face was divided into stays divided.
bool CutArranger::alike(std::uint32_t face, std::uint32_t other) const {
    const auto record = [&](std::uint32_t at) -> const FaceRecord& {
        return in_.patch.faces[world_face_[at]].facet.record();
    };
    if (!of_world(face)) std::swap(face, other);
    if (!of_world(face)) return true;
    const FaceRecord& a = record(face);
    if (a.edit == 0) return false;
    if (!of_world(other)) return a.material == material_ && a.mask == ~0u && !a.two_sided;
    const FaceRecord& b = record(other);
    return b.edit != 0 && a.material == b.material && a.mask == b.mask && a.two_sided == b.two_sided &&
           in_.patch.faces[world_face_[face]].facet.block->part ==
               in_.patch.faces[world_face_[other]].facet.block->part;
}

CutArranger::End CutArranger::keep() {
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
    selection.reusable = [this](std::uint32_t edge) { return patch_edge_[edge] != kNone; };
    Arranged arranged;
    if (!keep_cells(overlay_, lines_, cells_, users_, labels_, selection, arranged)) return End::kBroken;
    if (arranged.changes) write(arranged);
    return End::kFine;
}

std::uint32_t CutArranger::vertex_of(std::uint32_t point) {
    if (vertex_of_point_.size() <= point) vertex_of_point_.resize(overlay_.tables.points.size(), kNone);
    std::uint32_t& known = vertex_of_point_[point];
    if (known != kNone) return known;
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

void CutArranger::write(const Arranged& arranged) {
    const std::uint32_t first_new = std::uint32_t(in_.patch.edges.size());
    std::vector<std::uint32_t> number(arranged.edges.size());
    std::vector<bool> needed(arranged.edges.size(), false);
    for (const OverlaySide& use : arranged.all_uses) needed[use.edge] = true;
    for (std::size_t k = 0; k < arranged.edges.size(); ++k) {
        const ArrangedEdge& edge = arranged.edges[k];
        if (!needed[k]) continue;
        if (edge.edge != ArrangedEdge::kNoEdge) {
            number[k] = patch_edge_[edge.edge];
            continue;
        }
        number[k] = first_new + std::uint32_t(loops_.edges.size());
        loops_.edges.push_back(
            {vertex_of(edge.from),
             vertex_of(edge.to),
             {overlay_.tables.planes.stored(edge.plane[0]).get(), overlay_.tables.planes.stored(edge.plane[1]).get()},
             edge.doubled});
    }
    for (const ArrangedFace& face : arranged.faces) {
        NewFace made;
        made.first_use = std::uint32_t(loops_.all_uses.size());
        made.use_count = face.use_count;
        made.first_loop = std::uint32_t(loops_.loop_ends.size());
        made.loop_count = face.loop_count;
        for (const OverlaySide& use : arranged.uses(face)) loops_.all_uses.push_back({number[use.edge], use.reversed});
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
    for (std::uint32_t face = 0; face < world_face_.size(); ++face)
        if (!arranged.stays[face]) loops_.gone.push_back(world_face_[face]);
    crossings_.face_cut.assign(in_.patch.faces.size(), 0);
    for (std::uint32_t face = 0; face < world_face_.size(); ++face)
        crossings_.face_cut[world_face_[face]] = !arranged.stays[face] && spans_.touched(face);
}

}  // namespace firma
