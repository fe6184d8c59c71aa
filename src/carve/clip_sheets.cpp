// SPDX-License-Identifier: MIT
// What a fill does to polygons that stand in the air and divide it.
#include "carve/clip_sheets.h"

#include <algorithm>

#include "base/flat_map.h"
#include "base/sort.h"
#include "carve/sheet_labels.h"
#include "carve/sheet_overlay.h"

namespace firma {
namespace {

/// Writes cells of the arrangement as loops of the fill and outlines of what is left of sheets.
class SheetWriter {
public:
    SheetWriter(SheetOverlay& arranged, const SheetLabels& labels, const Crossings& crossings)
        : of_(arranged), labels_(labels) {
        made_.crossings = crossings;
        made_.loops = arranged.loops;
        made_.loops.faces.clear();
        made_.loops.all_uses.clear();
        made_.loops.loop_ends.clear();
        made_.changed.assign(arranged.sheets.size(), 0);
    }

    std::optional<ClippedSheets> write() {
        divide_edges();
        write_faces();
        write_sheets();
        if (failed_) return {};
        return std::move(made_);
    }

private:
    static constexpr std::uint32_t kNoNumber = SheetOverlay::kNoNumber;

    std::uint32_t vertex_of(std::uint32_t at) {
        if (of_.vertex_of_point.size() <= at) of_.vertex_of_point.resize(at + 1, kNoNumber);
        std::uint32_t& known = of_.vertex_of_point[at];
        if (known != kNoNumber) return known;
        known = of_.view.first_real() + std::uint32_t(made_.crossings.real.size());
        CutPoint made;
        made.point = of_.overlay.point(at);
        if (!made.point.on_grid())
            for (int k = 0; k < 3; ++k)
                made.planes[k] = of_.overlay.tables.planes.stored(of_.overlay.tables.points.plane(at, k)).get();
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
        const std::uint32_t number = use.edge == FacePiece::kNoEdge ? kNoNumber : of_.origin[use.edge].number;
        if (number != kNoNumber && of_.is_whole(use)) return number;
        return of_sheet && number == kNoNumber ? number_of_sheet(use.piece) : number_of_part(use.piece, number);
    }

    /// A new edge: part of one by number, or between two faces of the fill across a face.
    std::uint32_t number_of_part(std::uint32_t piece, std::uint32_t number) {
        std::uint32_t& known = number_of_part_.at(std::uint64_t(piece) << 32 | number);
        if (known != FlatMap::kNone) return known;
        bool doubled = number != kNoNumber && of_.overlay.edges[of_.overlay_edge[number]].doubled;
        for (const std::uint32_t use : of_.users.at(piece)) {
            const std::uint32_t other = of_.number_of_use(use);
            doubled |= other != kNoNumber && other != number;
        }
        return known = add_edge(piece, doubled);
    }

    /// Of a sheet, where it has no number: that of a face, if there is one.
    std::uint32_t number_of_sheet(std::uint32_t piece) {
        bool as_it_was = false, face = false;
        std::uint32_t part = kNoNumber;
        for (const std::uint32_t use : of_.users.at(piece)) {
            const PieceUse& it = of_.cells().all_uses[use];
            const std::uint32_t number = of_.number_of_use(use);
            if (of_.is_whole(it) && number != kNoNumber) return number;
            as_it_was |= of_.is_whole(it);
            if (number == kNoNumber && of_.is_sheet(of_.cells().cells[of_.users.cell_of(use)].face)) continue;
            face = true;
            part = std::min(part, number);
        }
        return as_it_was && !face ? kNoNumber : number_of_part(piece, part);
    }

    std::uint32_t add_edge(std::uint32_t piece, bool doubled) {
        const Piece& it = of_.lines.piece(piece);
        NewEdge made{vertex_of(it.from), vertex_of(it.to), {nullptr, nullptr}, doubled};
        const PieceUse& first = of_.cells().all_uses[of_.users.at(piece)[0]];
        for (int k = 0; k < 2; ++k) {
            const PlaneId plane = it.line == Piece::kNoLine ? of_.overlay.edges[first.edge].plane[k]
                                                            : of_.overlay.lines.plane(it.line, k);
            made_.planes.emplace_back(of_.overlay.tables.planes.stored(plane).get());
            made.plane[k] = made_.planes.back().get();
        }
        made_.loops.edges.push_back(made);
        new_from_.push_back(it.from);
        return of_.view.first_new_edge() + std::uint32_t(made_.loops.edges.size()) - 1;
    }

    /// Of an edge by number, used from a point on.
    PatchUse use_of(std::uint32_t number, std::uint32_t from) const {
        const std::uint32_t first_new = of_.view.edge_count();
        const std::uint32_t start =
            number < first_new ? of_.overlay.edges[of_.overlay_edge[number]].from : new_from_[number - first_new];
        return {number, start != from};
    }

    /// Edges by number that what is kept has parts of: whatever else has them is divided likewise.
    void divide_edges() {
        std::vector<std::uint8_t> partly(of_.overlay.edges.size(), 0);
        bool any = false;
        for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) {
            if (!labels_.is_kept(cell)) continue;
            for (const PieceUse& use : of_.cells().uses(of_.cells().cells[cell])) {
                if (use.edge == FacePiece::kNoEdge || of_.origin[use.edge].number == kNoNumber || of_.is_whole(use))
                    continue;
                partly[use.edge] = 1;
                any = true;
            }
        }
        if (!any) return;
        std::vector<std::vector<std::uint32_t>> pieces(of_.overlay.edges.size());
        std::vector<std::uint8_t> against(of_.overlay.edges.size(), 0);  // whether an edge runs against its line
        for (std::uint32_t face = 0; face < of_.overlay.faces.size(); ++face)
            for (const FacePiece& piece : of_.lines.of_face(face)) {
                if (piece.edge == FacePiece::kNoEdge || !partly[piece.edge]) continue;
                pieces[piece.edge].push_back(piece.piece);
                against[piece.edge] = piece.reversed;
            }
        parts_of_.assign(of_.view.edge_count(), {});
        for (std::uint32_t edge = 0; edge < pieces.size(); ++edge) {
            sort_once(pieces[edge]);
            if (against[edge]) std::reverse(pieces[edge].begin(), pieces[edge].end());
            const std::uint32_t number = of_.origin[edge].number;
            for (const std::uint32_t piece : pieces[edge]) {
                const std::uint32_t from = against[edge] ? of_.lines.piece(piece).to : of_.lines.piece(piece).from;
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
        std::vector<bool> gone(of_.in.patch.faces.size(), false);
        for (const std::uint32_t face : of_.loops.gone) gone[face] = true;
        for (std::uint32_t face = 0; face < of_.in.patch.faces.size(); ++face) {
            const PatchFace& it = of_.in.patch.faces[face];
            if (gone[face] || it.replaced) continue;
            const auto uses = of_.in.patch.uses(it);
            if (std::none_of(uses.begin(), uses.end(), [&](const PatchUse& use) { return is_divided(use.edge); }))
                continue;
            made_.loops.gone.push_back(face);
            add_copy({Ref<const SolidPlane>(it.plane), 0, 0, 0, 0, face, ~0u}, uses, of_.in.patch.ends(it));
        }
        sort_once(made_.loops.gone);
        std::vector<EdgeDivision> divisions;
        std::vector<PatchUse> parts;
        std::size_t next = 0;  // of the fill's divisions
        for (std::uint32_t edge = 0; edge < of_.in.patch.edges.size(); ++edge) {
            const auto first = std::uint32_t(parts.size());
            if (next < of_.loops.divisions.size() && of_.loops.divisions[next].edge == edge) {
                const EdgeDivision& division = of_.loops.divisions[next++];
                for (std::uint32_t k = 0; k < division.count; ++k)
                    append_parts(of_.loops.parts[division.first_part + k], parts);
            } else if (is_divided(edge)) {
                append_parts({edge, false}, parts);
            }
            if (parts.size() > first) divisions.push_back({edge, first, std::uint32_t(parts.size()) - first});
        }
        made_.loops.divisions = std::move(divisions);
        made_.loops.parts = std::move(parts);
    }

    void write_faces() {
        std::size_t next = 0;  // of of_.face_of
        for (std::uint32_t k = 0; k < of_.loops.faces.size(); ++k) {
            const NewFace& face = of_.loops.faces[k];
            if (next == of_.face_of.size() || of_.face_of[next] != k) {
                copy_face(face);
                continue;
            }
            for (std::uint32_t cell = of_.cells().first_of_face[next]; cell < of_.cells().first_of_face[next + 1];
                 ++cell)
                write_face(cell, face);
            ++next;
        }
    }

    void copy_face(const NewFace& face) { add_copy(face, of_.loops.uses(face), of_.loops.ends(face)); }

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
        const Cell& cell = of_.cells().cells[index];
        NewFace made = like;
        made.first_use = std::uint32_t(made_.loops.all_uses.size());
        made.first_loop = std::uint32_t(made_.loops.loop_ends.size());
        for (const PieceUse& use : of_.cells().uses(cell)) {
            const std::uint32_t number = number_at(use, false);
            failed_ |= number == kNoNumber;
            if (failed_) return;
            made_.loops.all_uses.push_back(use_of(number, of_.start_of(use)));
        }
        for (const std::uint32_t end : of_.cells().ends(cell)) made_.loops.loop_ends.push_back(end);
        made.use_count = cell.use_count;
        made.loop_count = cell.loop_count;
        made_.loops.faces.push_back(std::move(made));
        made_.air.push_back(labels_.air(index));
    }

    /// Whether a face of the fill ends along the rim of a sheet, where that had an edge alone: from now on both have
    /// one, so that what divides it divides it in both.
    bool meets_a_face(const Cell& cell) const {
        for (const PieceUse& use : of_.cells().uses(cell)) {
            if (use.edge != FacePiece::kNoEdge && of_.origin[use.edge].number != kNoNumber) continue;
            for (const std::uint32_t user : of_.users.at(use.piece))
                if (!of_.is_sheet(of_.cells().cells[of_.users.cell_of(user)].face)) return true;
        }
        return false;
    }

    void write_sheets() {
        for (std::uint32_t k = 0; k < of_.sheets.size(); ++k) {
            const auto face = std::uint32_t(of_.face_of.size() + k);
            const std::uint32_t first = of_.cells().first_of_face[face], end = of_.cells().first_of_face[face + 1];
            made_.changed[k] = end != first + 1 || labels_.place(first) != SheetPlace::kOut ||
                               of_.overlay.faces[face].side_count != of_.sheets[k].uses.size() ||
                               of_.cells().cells[first].use_count != of_.sheets[k].uses.size() ||
                               meets_a_face(of_.cells().cells[first]);
            if (!made_.changed[k]) continue;
            for (std::uint32_t cell = first; cell < end; ++cell)
                if (labels_.place(cell) == SheetPlace::kOut) write_rest(k, of_.cells().cells[cell]);
        }
    }

    void write_rest(std::uint32_t sheet, const Cell& cell) {
        SheetRest rest;
        rest.sheet = sheet;
        for (const PieceUse& use : of_.cells().uses(cell)) {
            SheetSide& side = rest.sides.emplace_back();
            const std::uint32_t number = number_at(use, true);
            if (number == kNoNumber) {
                if (!of_.is_whole(use)) {  // a sheet beside it has the edge, as it was
                    failed_ = true;
                    return;
                }
                const SolidEdge& edge = of_.origin[use.edge].use.edge();
                const bool reversed = of_.overlay.edges[use.edge].from != of_.start_of(use);
                side.use = SolidUse(Ref<const SolidEdge>(&edge), reversed);
                continue;
            }
            const PatchUse found = use_of(number, of_.start_of(use));
            side.edge = found.edge;
            side.reversed = found.reversed;
        }
        for (const std::uint32_t end : of_.cells().ends(cell)) rest.ends.push_back(end);
        made_.rest.push_back(std::move(rest));
    }

    SheetOverlay& of_;
    const SheetLabels& labels_;
    ClippedSheets made_;
    bool failed_ = false;
    std::vector<std::vector<PatchUse>> parts_of_;  ///< of edges by number: what takes their place. Empty: of none
    std::vector<std::uint32_t> new_from_;          ///< the point that each new edge starts at
    FlatMap number_of_part_;  ///< of new edges: by piece, and by the number of the edge divided there
};

}  // namespace

std::optional<ClippedSheets> clip_sheets(const CutInput& in, const Crossings& crossings, const NewLoops& loops,
                                         const std::vector<CutSheet>& sheets,
                                         const std::function<std::uint32_t(std::uint32_t part)>& air_of) {
    SheetOverlay arranged(in, crossings, loops, sheets);
    if (!arranged.arrange()) return {};
    SheetLabels labels(arranged, air_of);
    if (!labels.find()) return {};
    return SheetWriter(arranged, labels, crossings).write();
}

}  // namespace firma
