// SPDX-License-Identifier: MIT
// A fill's faces and the polygons near it as one arrangement.
#include "carve/sheet_overlay.h"

#include "carve/gather.h"

namespace firma {

SheetOverlay::SheetOverlay(const CutInput& cut_in, const Crossings& crossings, const NewLoops& cut_loops,
                           const std::vector<CutSheet>& cut_sheets)
    : in(cut_in), view(cut_in, crossings, cut_loops), loops(cut_loops), sheets(cut_sheets) {}

void SheetOverlay::know_divisions() {
    division_of_.assign(in.patch.edges.size(), kNoNumber);
    for (std::uint32_t k = 0; k < loops.divisions.size(); ++k) division_of_[loops.divisions[k].edge] = k;
}

std::uint32_t SheetOverlay::point(const ExactPoint& exact) {
    if (exact.on_grid()) return overlay.tables.points.add(exact.grid());
    PlaneId planes[3];
    for (int k = 0; k < 3; ++k) planes[k] = overlay.tables.planes.add(*exact.plane(k));
    return overlay.tables.points.add(planes[0], planes[1], planes[2]);
}

std::uint32_t SheetOverlay::numbered_edge(std::uint32_t number) {
    if (overlay_edge.empty()) overlay_edge.assign(view.edge_count(), kNoNumber);
    std::uint32_t& known = overlay_edge[number];
    if (known != kNoNumber) return known;
    const PatchUse forward{number, false};
    OverlayEdge made{vertex_point(view.from(forward)), vertex_point(view.to(forward))};
    const SolidPlane* const* planes =
        number < view.first_new_edge() ? in.patch.edges[number].plane : view.new_edge(number).plane;
    for (int k = 0; k < 2; ++k) made.plane[k] = overlay.tables.planes.add(planes[k]->plane);
    made.doubled = number < view.first_new_edge() ? in.patch.edges[number].doubled : view.new_edge(number).doubled;
    known = overlay.add_edge(made);
    origin.push_back({number, {}});
    return known;
}

std::uint32_t SheetOverlay::vertex_point(std::uint32_t vertex) {
    const std::uint32_t at = point(view.point(vertex));
    if (vertex_of_point.size() <= at) vertex_of_point.resize(at + 1, kNoNumber);
    if (vertex_of_point[at] == kNoNumber) vertex_of_point[at] = vertex;
    return at;
}

std::uint32_t SheetOverlay::own_edge(const SolidUse& use) {
    const SolidEdge& edge = use.edge();
    std::uint32_t& known = own_edge_.at(reinterpret_cast<std::uintptr_t>(&edge));
    if (known != FlatMap::kNone) return known;
    OverlayEdge made{point(edge.vertex[0]->point), point(edge.vertex[1]->point)};
    for (std::size_t k = 0; k < 2; ++k) made.plane[k] = overlay.tables.planes.add(edge.plane[k]->plane);
    made.doubled = edge.doubled;
    origin.push_back({kNoNumber, SolidUse(Ref<const SolidEdge>(&edge), false)});
    return known = overlay.add_edge(made);
}

void SheetOverlay::add_faces() {
    for (std::uint32_t k = 0; k < loops.faces.size(); ++k) {
        const NewFace& face = loops.faces[k];
        if (face.triangle == ~0u) continue;
        sides_.clear();
        for (const PatchUse& use : loops.uses(face)) sides_.push_back({numbered_edge(use.edge), use.reversed});
        overlay.add_face(overlay.tables.planes.add(face.plane->plane), 0, sides_, loops.ends(face));
        face_of.push_back(k);
    }
}

void SheetOverlay::add_sheets() {
    for (const CutSheet& it : sheets) {
        sides_.clear();
        std::vector<std::uint32_t> ends;
        std::size_t k = 0;
        for (const std::uint32_t end : it.ends) {
            for (; k < end; ++k) {
                const std::optional<PatchUse> found = in.patch.find(it.uses[k]);
                if (found)
                    add_numbered_sides(*found);
                else
                    sides_.push_back({own_edge(it.uses[k]), it.uses[k].reversed()});
            }
            ends.push_back(std::uint32_t(sides_.size()));
        }
        overlay.add_face(overlay.tables.planes.add(it.plane->plane), 1, sides_, ends);
    }
}

void SheetOverlay::add_numbered_sides(const PatchUse& use) {
    const PatchEdge& edge = in.patch.edges[use.edge];
    if (edge.split()) {
        for (const bool last : {false, true}) add_numbered_sides({edge.half[use.reversed != last], use.reversed});
        return;
    }
    if (division_of_[use.edge] == kNoNumber) {
        sides_.push_back({numbered_edge(use.edge), use.reversed});
        return;
    }
    const EdgeDivision& division = loops.divisions[division_of_[use.edge]];
    for (std::uint32_t k = 0; k < division.count; ++k) {
        PatchUse part = loops.parts[division.first_part + (use.reversed ? division.count - 1 - k : k)];
        sides_.push_back({numbered_edge(part.edge), part.reversed != use.reversed});
    }
}

bool SheetOverlay::arrange() {
    know_divisions();
    add_faces();
    add_sheets();
    bool broken = false;
    spans.start();
    std::vector<GridBox> boxes;
    for (std::size_t k = 0; k < face_of.size(); ++k) boxes.push_back(grown(overlay.faces[k].box, 1));
    const BoxTree tree(boxes);
    for (auto face = std::uint32_t(face_of.size()); face < overlay.faces.size(); ++face)
        tree.for_each_meeting(overlay.faces[face].box, [&](std::uint32_t other) {
            spans.meet(other, face);
            return false;
        });
    // Sheets side by side are divided alike. They do not divide each other: where the rim of one touches the inside
    // of another, that stays whole.
    for (auto face = std::uint32_t(face_of.size()); face < overlay.faces.size(); ++face) spans.know_edges(face);
    const auto finish = [](const auto& step) {
        for (;;) {
            WorkSlice slice(1u << 20);
            if (step(slice)) return;
        }
    };
    finish([&](WorkSlice& slice) { return spans.finish(slice); });
    finish([&](WorkSlice& slice) { return lines.divide(slice); });
    finish([&](WorkSlice& slice) {
        const PhaseEnd end = cell_finder_.step(slice);
        broken |= end == PhaseEnd::kBroken;
        return end != PhaseEnd::kGoesOn;
    });
    if (!broken) users.gather(overlay, lines, cells());
    return !broken;
}

std::uint32_t SheetOverlay::start_of(const PieceUse& use) const {
    const Piece& piece = lines.piece(use.piece);
    return use.forward ? piece.from : piece.to;
}

std::uint32_t SheetOverlay::number_of_use(std::uint32_t use) const {
    const std::uint32_t edge = cells().all_uses[use].edge;
    return edge == FacePiece::kNoEdge ? kNoNumber : origin[edge].number;
}

bool SheetOverlay::is_whole(const PieceUse& use) const {
    if (use.edge == FacePiece::kNoEdge) return false;
    const OverlayEdge& edge = overlay.edges[use.edge];
    const Piece& piece = lines.piece(use.piece);
    return (edge.from == piece.from && edge.to == piece.to) || (edge.from == piece.to && edge.to == piece.from);
}

}  // namespace firma
