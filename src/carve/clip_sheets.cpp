// SPDX-License-Identifier: MIT
// What a fill does to polygons that stand in the air and divide it.
#include "carve/clip_sheets.h"

#include <algorithm>
#include <cmath>

#include "arrange/label_cells.h"
#include "base/disjoint_sets.h"
#include "base/flat_map.h"
#include "base/sort.h"
#include "carve/gather.h"
#include "carve/point_within.h"

namespace firma {
namespace {

constexpr std::uint32_t kNoNumber = ~0u;
/// Where a piece of a sheet lies against the cutter.
enum class SheetPlace : std::uint8_t { kOut, kIn, kOn, kUnknown };

class SheetClipper {
public:
    SheetClipper(const CutInput& in, const Crossings& crossings, const NewLoops& loops,
                 const std::vector<CutSheet>& sheets, const std::function<std::uint32_t(std::uint32_t)>& air_of)
        : in_(in), view_(in, crossings, loops), loops_(loops), sheets_(sheets), air_of_(air_of) {
        made_.crossings = crossings;
        made_.loops = loops;
        made_.loops.faces.clear();
        made_.loops.all_uses.clear();
        made_.loops.loop_ends.clear();
        made_.changed.assign(sheets.size(), 0);
    }

    std::optional<ClippedSheets> clip() {
        know_divisions();
        add_faces();
        add_sheets();
        arrange();
        know_walls();
        if (!label_sheets()) return {};
        cell_air_.assign(cells().cells.size(), {});
        if (!label_faces()) return {};
        divide_edges();
        write_faces();
        write_sheets();
        if (failed_) return {};
        return std::move(made_);
    }

private:
    const CellSet& cells() const { return cell_finder_.cells(); }
    bool is_sheet(std::uint32_t face) const { return face >= face_of_.size(); }
    const CutSheet& sheet(std::uint32_t face) const { return sheets_[face - face_of_.size()]; }

    void know_divisions() {
        division_of_.assign(in_.patch.edges.size(), kNoNumber);
        for (std::uint32_t k = 0; k < loops_.divisions.size(); ++k) division_of_[loops_.divisions[k].edge] = k;
    }

    std::uint32_t point(const ExactPoint& exact) {
        if (exact.on_grid()) return overlay_.tables.points.add(exact.grid());
        PlaneId planes[3];
        for (int k = 0; k < 3; ++k) planes[k] = overlay_.tables.planes.add(*exact.plane(k));
        return overlay_.tables.points.add(planes[0], planes[1], planes[2]);
    }

    /// The overlay's edge of one by number.
    std::uint32_t numbered_edge(std::uint32_t number) {
        if (overlay_edge_.empty()) overlay_edge_.assign(view_.edge_count(), kNoNumber);
        std::uint32_t& known = overlay_edge_[number];
        if (known != kNoNumber) return known;
        const PatchUse forward{number, false};
        OverlayEdge made{vertex_point(view_.from(forward)), vertex_point(view_.to(forward))};
        const SolidPlane* const* planes =
            number < view_.first_new_edge() ? in_.patch.edges[number].plane : view_.new_edge(number).plane;
        for (int k = 0; k < 2; ++k) made.plane[k] = overlay_.tables.planes.add(planes[k]->plane);
        made.doubled =
            number < view_.first_new_edge() ? in_.patch.edges[number].doubled : view_.new_edge(number).doubled;
        known = overlay_.add_edge(made);
        origin_.push_back({number, {}});
        return known;
    }
    std::uint32_t vertex_point(std::uint32_t vertex) {
        const std::uint32_t at = point(view_.point(vertex));
        if (vertex_of_point_.size() <= at) vertex_of_point_.resize(at + 1, kNoNumber);
        if (vertex_of_point_[at] == kNoNumber) vertex_of_point_[at] = vertex;
        return at;
    }

    std::uint32_t own_edge(const SolidUse& use) {
        const SolidEdge& edge = use.edge();
        std::uint32_t& known = own_edge_.at(reinterpret_cast<std::uintptr_t>(&edge));
        if (known != FlatMap::kNone) return known;
        OverlayEdge made{point(edge.vertex[0]->point), point(edge.vertex[1]->point)};
        for (std::size_t k = 0; k < 2; ++k) made.plane[k] = overlay_.tables.planes.add(edge.plane[k]->plane);
        made.doubled = edge.doubled;
        origin_.push_back({kNoNumber, SolidUse(Ref<const SolidEdge>(&edge), false)});
        return known = overlay_.add_edge(made);
    }

    /// What the fill makes of the cutter.
    void add_faces() {
        for (std::uint32_t k = 0; k < loops_.faces.size(); ++k) {
            const NewFace& face = loops_.faces[k];
            if (face.triangle == ~0u) continue;
            sides_.clear();
            for (const PatchUse& use : loops_.uses(face)) sides_.push_back({numbered_edge(use.edge), use.reversed});
            overlay_.add_face(overlay_.tables.planes.add(face.plane->plane), 0, sides_, loops_.ends(face));
            face_of_.push_back(k);
        }
    }

    /// Edges that faces have, too, as these have them now.
    void add_sheets() {
        for (const CutSheet& it : sheets_) {
            sides_.clear();
            std::vector<std::uint32_t> ends;
            std::size_t k = 0;
            for (const std::uint32_t end : it.ends) {
                for (; k < end; ++k) {
                    const std::optional<PatchUse> found = in_.patch.find(it.uses[k]);
                    if (found)
                        add_numbered_sides(*found);
                    else
                        sides_.push_back({own_edge(it.uses[k]), it.uses[k].reversed()});
                }
                ends.push_back(std::uint32_t(sides_.size()));
            }
            overlay_.add_face(overlay_.tables.planes.add(it.plane->plane), 1, sides_, ends);
        }
    }

    void add_numbered_sides(const PatchUse& use) {
        const PatchEdge& edge = in_.patch.edges[use.edge];
        if (edge.split()) {
            for (const bool last : {false, true}) add_numbered_sides({edge.half[use.reversed != last], use.reversed});
            return;
        }
        if (division_of_[use.edge] == kNoNumber) {
            sides_.push_back({numbered_edge(use.edge), use.reversed});
            return;
        }
        const EdgeDivision& division = loops_.divisions[division_of_[use.edge]];
        for (std::uint32_t k = 0; k < division.count; ++k) {
            PatchUse part = loops_.parts[division.first_part + (use.reversed ? division.count - 1 - k : k)];
            sides_.push_back({numbered_edge(part.edge), part.reversed != use.reversed});
        }
    }

    void arrange() {
        spans_.start();
        std::vector<GridBox> boxes;
        for (std::size_t k = 0; k < face_of_.size(); ++k) boxes.push_back(grown(overlay_.faces[k].box, 1));
        const BoxTree tree(boxes);
        for (auto face = std::uint32_t(face_of_.size()); face < overlay_.faces.size(); ++face)
            tree.for_each_meeting(overlay_.faces[face].box, [&](std::uint32_t other) {
                spans_.meet(other, face);
                return false;
            });
        // Sheets side by side are divided alike. They do not divide each other: where the rim of one touches the inside
        // of another, that stays whole.
        for (auto face = std::uint32_t(face_of_.size()); face < overlay_.faces.size(); ++face) spans_.know_edges(face);
        const auto finish = [](const auto& step) {
            for (;;) {
                WorkSlice slice(1u << 20);
                if (step(slice)) return;
            }
        };
        finish([&](WorkSlice& slice) { return spans_.finish(slice); });
        finish([&](WorkSlice& slice) { return lines_.divide(slice); });
        finish([&](WorkSlice& slice) {
            const PhaseEnd end = cell_finder_.step(slice);
            failed_ |= end == PhaseEnd::kBroken;
            return end != PhaseEnd::kGoesOn;
        });
        if (!failed_) users_.gather(overlay_, lines_, cells());
    }

    bool label_sheets() {
        if (failed_) return false;
        place_.assign(cells().cells.size(), SheetPlace::kOut);
        std::vector<std::uint32_t> thin;
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) {
            if (!is_sheet(cells().cells[cell].face)) continue;
            place_[cell] = place_of(cells().cells[cell]);
            if (place_[cell] == SheetPlace::kUnknown) thin.push_back(cell);
        }
        // One may be told by another.
        for (std::size_t left = thin.size() + 1; !thin.empty() && thin.size() < left;) {
            left = thin.size();
            std::erase_if(thin, [&](std::uint32_t cell) {
                return (place_[cell] = place_by_edges(cell)) != SheetPlace::kUnknown;
            });
        }
        return thin.empty();
    }

    std::uint32_t start_of(const PieceUse& use) const {
        const Piece& piece = lines_.piece(use.piece);
        return use.forward ? piece.from : piece.to;
    }

    /// By a point within it.
    SheetPlace place_of(const Cell& cell) {
        corners_.clear();
        for (const PieceUse& use : cells().uses(cell)) corners_.push_back(overlay_.point(start_of(use)));
        const std::optional<ExactPoint> within =
            within_.find(sheet(cell.face).plane->plane, corners_, cells().ends(cell));
        if (!within) return SheetPlace::kUnknown;
        const int side = side_of_cutter(in_.cutter, *within);
        return side > 0 ? SheetPlace::kIn : side < 0 ? SheetPlace::kOut : SheetPlace::kOn;
    }

    /// Of a piece that is too thin for a point within it: by what stands around its edges.
    SheetPlace place_by_edges(std::uint32_t cell) {
        for (const PieceUse& use : cells().uses(cells().cells[cell]))
            if (const SheetPlace place = place_around(use.piece, cell); place != SheetPlace::kUnknown) return place;
        return SheetPlace::kUnknown;
    }

    SheetPlace place_around(std::uint32_t piece, std::uint32_t cell) {
        SheetPlace beside = SheetPlace::kUnknown;
        bool any_face = false;
        spokes_.clear();
        CellSpoke own;
        for (const std::uint32_t use : users_.at(piece)) {
            const CellSpoke spoke = spoke_of(use);
            if (spoke.cell == cell)
                own = spoke;
            else if (spoke.operand == 1)
                beside = place_[spoke.cell];
            else
                any_face = true;
            if (spoke.operand == 0 || spoke.cell == cell) spokes_.push_back(spoke);
        }
        if (!any_face) return beside;  // the edge lies off the cutter's faces, so all that have it lie alike
        if (lines_.piece(piece).line == Piece::kNoLine) return SheetPlace::kUnknown;
        add_wall_spokes(piece);
        sort_around(overlay_.lines, lines_.piece(piece).line, spokes_);
        for (const CellSpoke& spoke : spokes_)
            if (spoke.operand == 0 && spoke.half == own.half) return SheetPlace::kOn;
        const auto at = std::size_t(
            std::find_if(spokes_.begin(), spokes_.end(), [&](const CellSpoke& spoke) { return spoke.operand == 1; }) -
            spokes_.begin());
        const CellSpoke& before = spokes_[(at + spokes_.size() - 1) % spokes_.size()];
        if (before.operand == 0) return before.air_after ? SheetPlace::kOut : SheetPlace::kIn;
        const CellSpoke& after = spokes_[(at + 1) % spokes_.size()];
        if (after.operand == 0) return after.air_after ? SheetPlace::kIn : SheetPlace::kOut;
        return SheetPlace::kUnknown;
    }

    CellSpoke spoke_of(std::uint32_t use) const {
        const std::uint32_t cell = users_.cell_of(use);
        const OverlayFace& face = overlay_.faces[cells().cells[cell].face];
        const bool forward = cells().all_uses[use].forward;
        return {use, cell, forward ? face.plane : from_behind(face.plane), forward, face.operand, 0};
    }

    bool is_kept(std::uint32_t cell) const {
        return !is_sheet(cells().cells[cell].face) || place_[cell] == SheetPlace::kOut;
    }

    /// Of a use by a face: the number of the edge that it is part of; kNoNumber within the face.
    std::uint32_t number_of_use(std::uint32_t use) const {
        const std::uint32_t edge = cells().all_uses[use].edge;
        return edge == FacePiece::kNoEdge ? kNoNumber : origin_[edge].number;
    }

    bool label_faces() {
        DisjointSets sets(cells().cells.size());
        std::vector<std::uint32_t> air(cells().cells.size(), ClippedSheets::kNoAir);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> told;  // cell, air
        for (std::uint32_t piece = 0; piece < lines_.size(); ++piece) look_around(piece, sets, told);
        tell_by_walls(told);
        for (const auto& [cell, which] : told) {
            std::uint32_t& known = air[sets.find(cell)];
            if (known == ClippedSheets::kNoAir) known = which;
            if (known != which) return false;
        }
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) cell_air_[cell].air = air[sets.find(cell)];
        find_places(sets);
        return true;
    }

    /// Of cells whose air is not told: they meet sheets in points at most, such as a corner that lies on one.
    void find_places(DisjointSets& sets) {
        std::vector<double> farthest(cells().cells.size(), -1);
        std::vector<GridPoint> at(cells().cells.size());
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) {
            if (is_sheet(cells().cells[cell].face) || cell_air_[cell].air != ClippedSheets::kNoAir) continue;
            const std::uint32_t set = sets.find(cell);
            for (const PieceUse& use : cells().uses(cells().cells[cell])) {
                const ExactPoint& corner = overlay_.point(start_of(use));
                double nearest = INFINITY;
                for (const CutSheet& sheet : sheets_) nearest = std::min(nearest, distance(*sheet.plane, corner));
                if (nearest <= farthest[set]) continue;
                farthest[set] = nearest;
                at[set] = corner.rounded();
            }
        }
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) cell_air_[cell].place = at[sets.find(cell)];
    }
    static double distance(const SolidPlane& sheet, const ExactPoint& corner) {
        const Plane& plane = sheet.plane;
        return std::fabs(dot(plane.direction(), corner.approximate()) + plane.d) / length(plane.direction());
    }

    /// Faces that the fill left, and pieces of those that it cut, by the edges that they use.
    void know_walls() {
        std::vector<bool> gone(in_.patch.faces.size(), false);
        for (const std::uint32_t face : loops_.gone) gone[face] = true;
        first_wall_.assign(view_.edge_count(), kNoNumber);
        const auto know = [&](std::span<const PatchUse> uses, const PatchFace& face) {
            for (const PatchUse& use : uses) {
                std::uint32_t& first = first_wall_[use.edge];
                walls_.push_back({face.plane, use.reversed, air_of_(face.facet.block->part), first});
                first = std::uint32_t(walls_.size()) - 1;
            }
        };
        for (std::uint32_t face = 0; face < in_.patch.faces.size(); ++face) {
            const PatchFace& it = in_.patch.faces[face];
            if (!gone[face] && !it.replaced) know(in_.patch.uses(it), it);
        }
        for (const NewFace& face : loops_.faces)
            if (face.face != ~0u) know(loops_.uses(face), in_.patch.faces[face.face]);
    }

    void look_around(std::uint32_t piece, DisjointSets& sets,
                     std::vector<std::pair<std::uint32_t, std::uint32_t>>& told) {
        faces_at_.clear();
        spokes_.clear();
        bool any_sheet = false;
        bool at_wall = false;  // where the rim of a sheet that goes lies on a wall: the fill touches that along a line
        for (const std::uint32_t use : users_.at(piece)) {
            const std::uint32_t cell = users_.cell_of(use);
            if (!is_kept(cell)) {
                at_wall |= number_of_use(use) != kNoNumber;
                continue;
            }
            spokes_.push_back(spoke_of(use));
            any_sheet |= spokes_.back().operand == 1;
            if (spokes_.back().operand == 0) faces_at_.push_back(use);
        }
        const auto meet = [&](std::uint32_t a, std::uint32_t b) {
            if (at_wall && number_of_use(a) == kNoNumber) return;
            if (number_of_use(a) == number_of_use(b)) sets.join(users_.cell_of(a), users_.cell_of(b));
        };
        if (!any_sheet) {
            for (std::size_t k = 1; k < faces_at_.size(); ++k)
                for (std::size_t other = 0; other < k; ++other) meet(faces_at_[other], faces_at_[k]);
            return;
        }
        if (faces_at_.empty()) return;
        if (lines_.piece(piece).line == Piece::kNoLine) {
            failed_ = true;
            return;
        }
        add_wall_spokes(piece);
        sort_around(overlay_.lines, lines_.piece(piece).line, spokes_);
        for (std::size_t k = 0; k < spokes_.size(); ++k) {
            const CellSpoke& here = spokes_[k];
            if (here.operand != 0) continue;
            const CellSpoke& next = spokes_[(k + (here.air_after ? 1 : spokes_.size() - 1)) % spokes_.size()];
            if (next.operand == 0) {
                meet(here.use, next.use);
                continue;
            }
            if (next.operand == kWall) {
                told.emplace_back(here.cell, walls_[next.cell].air);
                continue;
            }
            // What comes after it, turning counter-clockwise, lies in front of a sheet that runs forward.
            const bool front = next.air_after != here.air_after;
            told.emplace_back(here.cell, sheet(cells().cells[next.cell].face).air[front ? 0 : 1]);
        }
        for (const std::uint32_t use : faces_at_)
            if (const std::uint32_t number = number_of_use(use); number != kNoNumber) at_sheet_.push_back(number);
    }

    /// Where faces meet along a line two and two, walls may stand between a face of the fill and a sheet.
    void add_wall_spokes(std::uint32_t piece) {
        numbers_.clear();
        for (const std::uint32_t use : users_.at(piece))
            if (const std::uint32_t number = number_of_use(use); number != kNoNumber) numbers_.push_back(number);
        sort_once(numbers_);
        for (const std::uint32_t number : numbers_) {
            const OverlayEdge& edge = overlay_.edges[overlay_edge_[number]];
            const bool along = overlay_.lines.before(lines_.piece(piece).line, edge.from, edge.to);
            for (std::uint32_t wall = first_wall_[number]; wall != kNoNumber; wall = walls_[wall].next) {
                const WallSide& it = walls_[wall];
                const bool forward = along != it.reversed;
                const PlaneId plane = overlay_.tables.planes.add(it.plane->plane);
                spokes_.push_back({wall, wall, forward ? plane : from_behind(plane), forward, kWall, 0});
            }
        }
    }

    /// Faces that share an edge, without a sheet between them, bound the same air.
    void tell_by_walls(std::vector<std::pair<std::uint32_t, std::uint32_t>>& told) {
        std::vector<std::uint32_t> air(view_.edge_count(), ClippedSheets::kNoAir);
        for (std::uint32_t edge = 0; edge < view_.edge_count(); ++edge)
            if (first_wall_[edge] != kNoNumber) air[edge] = walls_[first_wall_[edge]].air;
        for (const std::uint32_t edge : at_sheet_) air[edge] = ClippedSheets::kNoAir;
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) {
            const Cell& it = cells().cells[cell];
            if (is_sheet(it.face)) continue;
            for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
                const std::uint32_t number = number_of_use(use);
                if (number != kNoNumber && air[number] != ClippedSheets::kNoAir) told.emplace_back(cell, air[number]);
            }
        }
    }

    bool is_whole(const PieceUse& use) const {
        if (use.edge == FacePiece::kNoEdge) return false;
        const OverlayEdge& edge = overlay_.edges[use.edge];
        const Piece& piece = lines_.piece(use.piece);
        return (edge.from == piece.from && edge.to == piece.to) || (edge.from == piece.to && edge.to == piece.from);
    }

    std::uint32_t vertex_of(std::uint32_t at) {
        if (vertex_of_point_.size() <= at) vertex_of_point_.resize(at + 1, kNoNumber);
        std::uint32_t& known = vertex_of_point_[at];
        if (known != kNoNumber) return known;
        known = view_.first_real() + std::uint32_t(made_.crossings.real.size());
        CutPoint made;
        made.point = overlay_.point(at);
        if (!made.point.on_grid())
            for (int k = 0; k < 3; ++k)
                made.planes[k] = overlay_.tables.planes.stored(overlay_.tables.points.plane(at, k)).get();
        made.vertex = known;
        for (const SolidPlane* plane : made.planes)
            if (plane) made_.planes.emplace_back(plane);
        made_.crossings.real.push_back(std::uint32_t(made_.crossings.points.size()));
        made_.crossings.points.push_back(made);
        return known;
    }

    /// The edge that a use is part of, by number; kNoNumber where it is a sheet's alone, as it was. Where faces meet
    /// along a line two and two, each two have an edge of their own.
    std::uint32_t number_at(const PieceUse& use, bool of_sheet) {
        const std::uint32_t number = use.edge == FacePiece::kNoEdge ? kNoNumber : origin_[use.edge].number;
        if (number != kNoNumber && is_whole(use)) return number;
        return of_sheet && number == kNoNumber ? number_of_sheet(use.piece) : number_of_part(use.piece, number);
    }

    /// A new edge: part of one by number, or between two faces of the fill across a face.
    std::uint32_t number_of_part(std::uint32_t piece, std::uint32_t number) {
        std::uint32_t& known = number_of_part_.at(std::uint64_t(piece) << 32 | number);
        if (known != FlatMap::kNone) return known;
        bool doubled = number != kNoNumber && overlay_.edges[overlay_edge_[number]].doubled;
        for (const std::uint32_t use : users_.at(piece)) {
            const std::uint32_t other = number_of_use(use);
            doubled |= other != kNoNumber && other != number;
        }
        return known = add_edge(piece, doubled);
    }

    /// Of a sheet, where it has no number: that of a face, if there is one.
    std::uint32_t number_of_sheet(std::uint32_t piece) {
        bool as_it_was = false, face = false;
        std::uint32_t part = kNoNumber;
        for (const std::uint32_t use : users_.at(piece)) {
            const PieceUse& it = cells().all_uses[use];
            const std::uint32_t number = number_of_use(use);
            if (is_whole(it) && number != kNoNumber) return number;
            as_it_was |= is_whole(it);
            if (number == kNoNumber && is_sheet(cells().cells[users_.cell_of(use)].face)) continue;
            face = true;
            part = std::min(part, number);
        }
        return as_it_was && !face ? kNoNumber : number_of_part(piece, part);
    }

    std::uint32_t add_edge(std::uint32_t piece, bool doubled) {
        const Piece& it = lines_.piece(piece);
        NewEdge made{vertex_of(it.from), vertex_of(it.to), {nullptr, nullptr}, doubled};
        const PieceUse& first = cells().all_uses[users_.at(piece)[0]];
        for (int k = 0; k < 2; ++k) {
            const PlaneId plane =
                it.line == Piece::kNoLine ? overlay_.edges[first.edge].plane[k] : overlay_.lines.plane(it.line, k);
            made_.planes.emplace_back(overlay_.tables.planes.stored(plane).get());
            made.plane[k] = made_.planes.back().get();
        }
        made_.loops.edges.push_back(made);
        new_from_.push_back(it.from);
        return view_.first_new_edge() + std::uint32_t(made_.loops.edges.size()) - 1;
    }

    /// Of an edge by number, used from a point on.
    PatchUse use_of(std::uint32_t number, std::uint32_t from) const {
        const std::uint32_t first_new = view_.edge_count();
        const std::uint32_t start =
            number < first_new ? overlay_.edges[overlay_edge_[number]].from : new_from_[number - first_new];
        return {number, start != from};
    }

    /// Edges by number that what is kept has parts of: whatever else has them is divided likewise.
    void divide_edges() {
        std::vector<std::uint8_t> partly(overlay_.edges.size(), 0);
        bool any = false;
        for (std::uint32_t cell = 0; cell < cells().cells.size(); ++cell) {
            if (!is_kept(cell)) continue;
            for (const PieceUse& use : cells().uses(cells().cells[cell])) {
                if (use.edge == FacePiece::kNoEdge || origin_[use.edge].number == kNoNumber || is_whole(use)) continue;
                partly[use.edge] = 1;
                any = true;
            }
        }
        if (!any) return;
        std::vector<std::vector<std::uint32_t>> pieces(overlay_.edges.size());
        std::vector<std::uint8_t> against(overlay_.edges.size(), 0);  // whether an edge runs against its line
        for (std::uint32_t face = 0; face < overlay_.faces.size(); ++face)
            for (const FacePiece& piece : lines_.of_face(face)) {
                if (piece.edge == FacePiece::kNoEdge || !partly[piece.edge]) continue;
                pieces[piece.edge].push_back(piece.piece);
                against[piece.edge] = piece.reversed;
            }
        parts_of_.assign(view_.edge_count(), {});
        for (std::uint32_t edge = 0; edge < pieces.size(); ++edge) {
            sort_once(pieces[edge]);
            if (against[edge]) std::reverse(pieces[edge].begin(), pieces[edge].end());
            const std::uint32_t number = origin_[edge].number;
            for (const std::uint32_t piece : pieces[edge]) {
                const std::uint32_t from = against[edge] ? lines_.piece(piece).to : lines_.piece(piece).from;
                parts_of_[number].push_back(use_of(number_of_part(piece, number), from));
            }
        }
        divide_walls();
    }

    bool is_divided(std::uint32_t number) const { return number < parts_of_.size() && !parts_of_[number].empty(); }

    /// Adds what takes the place of an edge by number.
    void append_parts(const PatchUse& use, std::vector<PatchUse>& uses) const {
        if (!is_divided(use.edge)) {
            uses.push_back(use);
            return;
        }
        const std::vector<PatchUse>& parts = parts_of_[use.edge];
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const PatchUse& part = parts[use.reversed ? parts.size() - 1 - k : k];
            uses.push_back({part.edge, part.reversed != use.reversed});
        }
    }

    /// Faces that the fill left alone become pieces of themselves, and what other portals ask for is noted.
    void divide_walls() {
        std::vector<bool> gone(in_.patch.faces.size(), false);
        for (const std::uint32_t face : loops_.gone) gone[face] = true;
        for (std::uint32_t face = 0; face < in_.patch.faces.size(); ++face) {
            const PatchFace& it = in_.patch.faces[face];
            if (gone[face] || it.replaced) continue;
            const auto uses = in_.patch.uses(it);
            if (std::none_of(uses.begin(), uses.end(), [&](const PatchUse& use) { return is_divided(use.edge); }))
                continue;
            made_.loops.gone.push_back(face);
            add_copy({Ref<const SolidPlane>(it.plane), 0, 0, 0, 0, face, ~0u}, uses, in_.patch.ends(it));
        }
        sort_once(made_.loops.gone);
        std::vector<EdgeDivision> divisions;
        std::vector<PatchUse> parts;
        std::size_t next = 0;  // of the fill's divisions
        for (std::uint32_t edge = 0; edge < in_.patch.edges.size(); ++edge) {
            const auto first = std::uint32_t(parts.size());
            if (next < loops_.divisions.size() && loops_.divisions[next].edge == edge) {
                const EdgeDivision& division = loops_.divisions[next++];
                for (std::uint32_t k = 0; k < division.count; ++k)
                    append_parts(loops_.parts[division.first_part + k], parts);
            } else if (is_divided(edge)) {
                append_parts({edge, false}, parts);
            }
            if (parts.size() > first) divisions.push_back({edge, first, std::uint32_t(parts.size()) - first});
        }
        made_.loops.divisions = std::move(divisions);
        made_.loops.parts = std::move(parts);
    }

    void write_faces() {
        std::size_t next = 0;  // of face_of_
        for (std::uint32_t k = 0; k < loops_.faces.size(); ++k) {
            const NewFace& face = loops_.faces[k];
            if (next == face_of_.size() || face_of_[next] != k) {
                copy_face(face);
                continue;
            }
            for (std::uint32_t cell = cells().first_of_face[next]; cell < cells().first_of_face[next + 1]; ++cell)
                write_face(cell, face);
            ++next;
        }
    }

    void copy_face(const NewFace& face) { add_copy(face, loops_.uses(face), loops_.ends(face)); }

    /// A piece of a face that was there, with its edges as they are now.
    void add_copy(NewFace made, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends) {
        std::vector<PatchUse>& all = made_.loops.all_uses;
        made.first_use = std::uint32_t(all.size());
        made.first_loop = std::uint32_t(made_.loops.loop_ends.size());
        std::size_t next = 0;
        for (const std::uint32_t end : ends) {
            for (; next < end; ++next) append_parts(uses[next], all);
            made_.loops.loop_ends.push_back(std::uint32_t(all.size()) - made.first_use);
        }
        made.use_count = std::uint32_t(all.size()) - made.first_use;
        made.loop_count = std::uint32_t(ends.size());
        made_.loops.faces.push_back(std::move(made));
        made_.air.push_back({});
    }

    void write_face(std::uint32_t index, const NewFace& like) {
        const Cell& cell = cells().cells[index];
        NewFace made = like;
        made.first_use = std::uint32_t(made_.loops.all_uses.size());
        made.first_loop = std::uint32_t(made_.loops.loop_ends.size());
        for (const PieceUse& use : cells().uses(cell)) {
            const std::uint32_t number = number_at(use, false);
            failed_ |= number == kNoNumber;
            if (failed_) return;
            made_.loops.all_uses.push_back(use_of(number, start_of(use)));
        }
        for (const std::uint32_t end : cells().ends(cell)) made_.loops.loop_ends.push_back(end);
        made.use_count = cell.use_count;
        made.loop_count = cell.loop_count;
        made_.loops.faces.push_back(std::move(made));
        made_.air.push_back(cell_air_[index]);
    }

    /// Whether a face of the fill ends along the rim of a sheet, where that had an edge alone: from now on both have
    /// one, so that what divides it divides it in both.
    bool meets_a_face(const Cell& cell) const {
        for (const PieceUse& use : cells().uses(cell)) {
            if (use.edge != FacePiece::kNoEdge && origin_[use.edge].number != kNoNumber) continue;
            for (const std::uint32_t user : users_.at(use.piece))
                if (!is_sheet(cells().cells[users_.cell_of(user)].face)) return true;
        }
        return false;
    }

    void write_sheets() {
        for (std::uint32_t k = 0; k < sheets_.size(); ++k) {
            const auto face = std::uint32_t(face_of_.size() + k);
            const std::uint32_t first = cells().first_of_face[face], end = cells().first_of_face[face + 1];
            made_.changed[k] = end != first + 1 || place_[first] != SheetPlace::kOut ||
                               overlay_.faces[face].side_count != sheets_[k].uses.size() ||
                               cells().cells[first].use_count != sheets_[k].uses.size() ||
                               meets_a_face(cells().cells[first]);
            if (!made_.changed[k]) continue;
            for (std::uint32_t cell = first; cell < end; ++cell)
                if (place_[cell] == SheetPlace::kOut) write_rest(k, cells().cells[cell]);
        }
    }

    void write_rest(std::uint32_t sheet, const Cell& cell) {
        SheetRest rest;
        rest.sheet = sheet;
        for (const PieceUse& use : cells().uses(cell)) {
            SheetSide& side = rest.sides.emplace_back();
            const std::uint32_t number = number_at(use, true);
            if (number == kNoNumber) {
                if (!is_whole(use)) {  // a sheet beside it has the edge, as it was
                    failed_ = true;
                    return;
                }
                const SolidEdge& edge = origin_[use.edge].use.edge();
                const bool reversed = overlay_.edges[use.edge].from != start_of(use);
                side.use = SolidUse(Ref<const SolidEdge>(&edge), reversed);
                continue;
            }
            const PatchUse found = use_of(number, start_of(use));
            side.edge = found.edge;
            side.reversed = found.reversed;
        }
        for (const std::uint32_t end : cells().ends(cell)) rest.ends.push_back(end);
        made_.rest.push_back(std::move(rest));
    }

    /// How a face that is not in the overlay uses an edge.
    struct WallSide {
        const SolidPlane* plane = nullptr;
        bool reversed = false;
        std::uint32_t air = 0;
        std::uint32_t next = kNoNumber;  ///< of those that use the edge
    };
    static constexpr std::uint8_t kWall = 2;  ///< a spoke's operand; its cell is in walls_

    /// Where an edge of the overlay comes from.
    struct Origin {
        std::uint32_t number = kNoNumber;
        SolidUse use;
    };

    const CutInput& in_;
    const CutView view_;
    const NewLoops& loops_;
    const std::vector<CutSheet>& sheets_;
    const std::function<std::uint32_t(std::uint32_t)>& air_of_;
    ClippedSheets made_;
    bool failed_ = false;

    Overlay overlay_;
    std::vector<std::uint32_t> division_of_;      ///< of the patch's edges
    std::vector<std::uint32_t> overlay_edge_;     ///< of edges by number
    std::vector<Origin> origin_;                  ///< of the overlay's edges
    std::vector<std::uint32_t> vertex_of_point_;  ///< by number, of the overlay's points
    std::vector<std::uint32_t> face_of_;          ///< NewLoops::faces, of the overlay's first faces; sheets follow
    std::vector<OverlaySide> sides_;
    SpanFinder spans_{overlay_};
    DividedLines lines_{overlay_, spans_};
    CellFinder cell_finder_{overlay_, spans_, lines_};
    PieceUsers users_;
    std::vector<SheetPlace> place_;                ///< of cells
    std::vector<FaceAir> cell_air_;                ///< likewise
    std::vector<std::vector<PatchUse>> parts_of_;  ///< of edges by number: what takes their place. Empty: of none
    std::vector<WallSide> walls_;
    std::vector<std::uint32_t> first_wall_;  ///< in walls_, of edges by number
    std::vector<std::uint32_t> at_sheet_, faces_at_, numbers_;
    std::vector<CellSpoke> spokes_;
    std::vector<std::uint32_t> new_from_;  ///< the point that each new edge starts at
    FlatMap number_of_part_;               ///< of new edges: by piece, and by the number of the edge divided there
    FlatMap own_edge_;                     ///< of the overlay, by address
    std::vector<ExactPoint> corners_;
    WithinFinder within_;
};

}  // namespace

std::optional<ClippedSheets> clip_sheets(const CutInput& in, const Crossings& crossings, const NewLoops& loops,
                                         const std::vector<CutSheet>& sheets,
                                         const std::function<std::uint32_t(std::uint32_t part)>& air_of) {
    return SheetClipper(in, crossings, loops, sheets, air_of).clip();
}

}  // namespace firma
