// SPDX-License-Identifier: MIT
// Where pieces of polygons lie against what fills the air, and the air of each face of the fill.
#include "carve/sheet_labels.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"

namespace firma {

bool SheetLabels::find() {
    know_walls();
    if (!label_sheets()) return false;
    air_.assign(of_.cells().cells.size(), {});
    return label_faces() && !failed_;
}

bool SheetLabels::label_sheets() {
    place_.assign(of_.cells().cells.size(), SheetPlace::kOut);
    std::vector<std::uint32_t> thin;
    for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) {
        if (!of_.is_sheet(of_.cells().cells[cell].face)) continue;
        place_[cell] = place_of(of_.cells().cells[cell]);
        if (place_[cell] == SheetPlace::kUnknown) thin.push_back(cell);
    }
    // One may be told by another.
    for (std::size_t left = thin.size() + 1; !thin.empty() && thin.size() < left;) {
        left = thin.size();
        std::erase_if(
            thin, [&](std::uint32_t cell) { return (place_[cell] = place_by_edges(cell)) != SheetPlace::kUnknown; });
    }
    return thin.empty();
}

SheetPlace SheetLabels::place_of(const Cell& cell) {
    corners_.clear();
    for (const PieceUse& use : of_.cells().uses(cell)) corners_.push_back(of_.overlay.point(of_.start_of(use)));
    const std::optional<ExactPoint> within =
        within_.find(of_.sheet(cell.face).plane->plane, corners_, of_.cells().ends(cell));
    if (!within) return SheetPlace::kUnknown;
    const int side = side_of_cutter(of_.in.cutter, *within);
    return side > 0 ? SheetPlace::kIn : side < 0 ? SheetPlace::kOut : SheetPlace::kOn;
}

SheetPlace SheetLabels::place_by_edges(std::uint32_t cell) {
    for (const PieceUse& use : of_.cells().uses(of_.cells().cells[cell]))
        if (const SheetPlace place = place_around(use.piece, cell); place != SheetPlace::kUnknown) return place;
    return SheetPlace::kUnknown;
}

SheetPlace SheetLabels::place_around(std::uint32_t piece, std::uint32_t cell) {
    SheetPlace beside = SheetPlace::kUnknown;
    bool any_face = false;
    spokes_.clear();
    CellSpoke own;
    for (const std::uint32_t use : of_.users.at(piece)) {
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
    if (of_.lines.piece(piece).line == Piece::kNoLine) return SheetPlace::kUnknown;
    add_wall_spokes(piece);
    sort_around(of_.overlay.lines, of_.lines.piece(piece).line, spokes_);
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

CellSpoke SheetLabels::spoke_of(std::uint32_t use) const {
    const std::uint32_t cell = of_.users.cell_of(use);
    const OverlayFace& face = of_.overlay.faces[of_.cells().cells[cell].face];
    const bool forward = of_.cells().all_uses[use].forward;
    return {use, cell, forward ? face.plane : from_behind(face.plane), forward, face.operand, 0};
}

bool SheetLabels::is_kept(std::uint32_t cell) const {
    return !of_.is_sheet(of_.cells().cells[cell].face) || place_[cell] == SheetPlace::kOut;
}

bool SheetLabels::label_faces() {
    DisjointSets sets(of_.cells().cells.size());
    std::vector<std::uint32_t> air(of_.cells().cells.size(), ClippedSheets::kNoAir);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> told;  // cell, air
    for (std::uint32_t piece = 0; piece < of_.lines.size(); ++piece) look_around(piece, sets, told);
    tell_by_walls(told);
    for (const auto& [cell, which] : told) {
        std::uint32_t& known = air[sets.find(cell)];
        if (known == ClippedSheets::kNoAir) known = which;
        if (known != which) return false;
    }
    for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) air_[cell].air = air[sets.find(cell)];
    find_places(sets);
    return true;
}

void SheetLabels::find_places(DisjointSets& sets) {
    std::vector<double> farthest(of_.cells().cells.size(), -1);
    std::vector<GridPoint> at(of_.cells().cells.size());
    for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) {
        if (of_.is_sheet(of_.cells().cells[cell].face) || air_[cell].air != ClippedSheets::kNoAir) continue;
        const std::uint32_t set = sets.find(cell);
        for (const PieceUse& use : of_.cells().uses(of_.cells().cells[cell])) {
            const ExactPoint& corner = of_.overlay.point(of_.start_of(use));
            double nearest = INFINITY;
            for (const CutSheet& sheet : of_.sheets) nearest = std::min(nearest, distance(*sheet.plane, corner));
            if (nearest <= farthest[set]) continue;
            farthest[set] = nearest;
            at[set] = corner.rounded();
        }
    }
    for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) air_[cell].place = at[sets.find(cell)];
}

double SheetLabels::distance(const SolidPlane& sheet, const ExactPoint& corner) {
    const Plane& plane = sheet.plane;
    return std::fabs(dot(plane.direction(), corner.approximate()) + plane.d) / length(plane.direction());
}

void SheetLabels::know_walls() {
    std::vector<bool> gone(of_.in.patch.faces.size(), false);
    for (const std::uint32_t face : of_.loops.gone) gone[face] = true;
    first_wall_.assign(of_.view.edge_count(), kNoNumber);
    const auto know = [&](std::span<const PatchUse> uses, const PatchFace& face) {
        for (const PatchUse& use : uses) {
            std::uint32_t& first = first_wall_[use.edge];
            walls_.push_back({face.plane, use.reversed, air_of_(face.facet.block->part), first});
            first = std::uint32_t(walls_.size()) - 1;
        }
    };
    for (std::uint32_t face = 0; face < of_.in.patch.faces.size(); ++face) {
        const PatchFace& it = of_.in.patch.faces[face];
        if (!gone[face] && !it.replaced) know(of_.in.patch.uses(it), it);
    }
    for (const NewFace& face : of_.loops.faces)
        if (face.face != ~0u) know(of_.loops.uses(face), of_.in.patch.faces[face.face]);
}

void SheetLabels::look_around(std::uint32_t piece, DisjointSets& sets,
                              std::vector<std::pair<std::uint32_t, std::uint32_t>>& told) {
    faces_at_.clear();
    spokes_.clear();
    bool any_sheet = false;
    bool at_wall = false;  // where the rim of a sheet that goes lies on a wall: the fill touches that along a line
    for (const std::uint32_t use : of_.users.at(piece)) {
        const std::uint32_t cell = of_.users.cell_of(use);
        if (!is_kept(cell)) {
            at_wall |= of_.number_of_use(use) != kNoNumber;
            continue;
        }
        spokes_.push_back(spoke_of(use));
        any_sheet |= spokes_.back().operand == 1;
        if (spokes_.back().operand == 0) faces_at_.push_back(use);
    }
    const auto meet = [&](std::uint32_t a, std::uint32_t b) {
        if (at_wall && of_.number_of_use(a) == kNoNumber) return;
        if (of_.number_of_use(a) == of_.number_of_use(b)) sets.join(of_.users.cell_of(a), of_.users.cell_of(b));
    };
    if (!any_sheet) {
        for (std::size_t k = 1; k < faces_at_.size(); ++k)
            for (std::size_t other = 0; other < k; ++other) meet(faces_at_[other], faces_at_[k]);
        return;
    }
    if (faces_at_.empty()) return;
    if (of_.lines.piece(piece).line == Piece::kNoLine) {
        failed_ = true;
        return;
    }
    add_wall_spokes(piece);
    sort_around(of_.overlay.lines, of_.lines.piece(piece).line, spokes_);
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
        told.emplace_back(here.cell, of_.sheet(of_.cells().cells[next.cell].face).air[front ? 0 : 1]);
    }
    for (const std::uint32_t use : faces_at_)
        if (const std::uint32_t number = of_.number_of_use(use); number != kNoNumber) at_sheet_.push_back(number);
}

void SheetLabels::add_wall_spokes(std::uint32_t piece) {
    numbers_.clear();
    for (const std::uint32_t use : of_.users.at(piece))
        if (const std::uint32_t number = of_.number_of_use(use); number != kNoNumber) numbers_.push_back(number);
    sort_once(numbers_);
    for (const std::uint32_t number : numbers_) {
        const OverlayEdge& edge = of_.overlay.edges[of_.overlay_edge[number]];
        const bool along = of_.overlay.lines.before(of_.lines.piece(piece).line, edge.from, edge.to);
        for (std::uint32_t wall = first_wall_[number]; wall != kNoNumber; wall = walls_[wall].next) {
            const WallSide& it = walls_[wall];
            const bool forward = along != it.reversed;
            const PlaneId plane = of_.overlay.tables.planes.add(it.plane->plane);
            spokes_.push_back({wall, wall, forward ? plane : from_behind(plane), forward, kWall, 0});
        }
    }
}

void SheetLabels::tell_by_walls(std::vector<std::pair<std::uint32_t, std::uint32_t>>& told) {
    std::vector<std::uint32_t> air(of_.view.edge_count(), ClippedSheets::kNoAir);
    for (std::uint32_t edge = 0; edge < of_.view.edge_count(); ++edge)
        if (first_wall_[edge] != kNoNumber) air[edge] = walls_[first_wall_[edge]].air;
    for (const std::uint32_t edge : at_sheet_) air[edge] = ClippedSheets::kNoAir;
    for (std::uint32_t cell = 0; cell < of_.cells().cells.size(); ++cell) {
        const Cell& it = of_.cells().cells[cell];
        if (of_.is_sheet(it.face)) continue;
        for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
            const std::uint32_t number = of_.number_of_use(use);
            if (number != kNoNumber && air[number] != ClippedSheets::kNoAir) told.emplace_back(cell, air[number]);
        }
    }
}

}  // namespace firma
