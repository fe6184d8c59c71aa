// SPDX-License-Identifier: MIT
// Where each cell lies against the other solid.
#include "arrange/label_cells.h"

#include "base/sort.h"

namespace firma {

void PieceUsers::gather(const Overlay& overlay, const DividedLines& lines, const CellSet& cells) {
    first_.assign(lines.size() + 1, 0);
    cell_of_.resize(cells.all_uses.size());
    for (const PieceUse& use : cells.all_uses) ++first_[use.piece + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    std::vector<std::uint8_t> operands(lines.size(), 0);
    uses_.resize(cells.all_uses.size());
    for (std::uint32_t cell = 0; cell < cells.cells.size(); ++cell) {
        const Cell& it = cells.cells[cell];
        const std::uint8_t operand = overlay.faces[it.face].operand;
        for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
            const std::uint32_t piece = cells.all_uses[use].piece;
            cell_of_[use] = cell;
            uses_[next[piece]++] = use;
            operands[piece] |= std::uint8_t(1u << operand);
        }
    }
    shared_.resize(lines.size());
    for (std::size_t piece = 0; piece < lines.size(); ++piece)
        shared_[piece] = (operands[piece] & (operands[piece] - 1)) != 0;
}

void sort_around(const LineTable& lines, std::uint32_t line, std::span<CellSpoke> spokes) {
    const PlaneId zero = spokes[0].half;
    for (CellSpoke& spoke : spokes) {
        if (spoke.half == zero) {
            spoke.part = 0;
            continue;
        }
        const int turn = lines.turn(line, zero, spoke.half);
        spoke.part = turn > 0 ? 1 : turn == 0 ? 2 : 3;
    }
    sort_range(spokes, [&](const CellSpoke& a, const CellSpoke& b) {
        if (a.part != b.part) return a.part < b.part;
        if (a.half != b.half) return lines.turn(line, a.half, b.half) > 0;
        return a.use < b.use;
    });
}

CellLabeller::CellLabeller(const Overlay& overlay, const DividedLines& lines, const CellSet& cells,
                           const PieceUsers& users)
    : overlay_(overlay),
      lines_(lines),
      cells_(cells),
      users_(users),
      sets_(cells.cells.size()),
      label_(cells.cells.size(), CellLabel::kUnknown) {}

PhaseEnd CellLabeller::step(const LocateCell& locate, WorkSlice& slice) {
    constexpr std::size_t kToLocate = 16;  // units
    bool fine = true;
    switch (stage_) {
        case Stage::kSpread:
            if (!go_on(next_, lines_.size(), slice, [&](std::uint32_t piece) {
                    if (!users_.shared(piece)) spread(piece);
                }))
                return PhaseEnd::kGoesOn;
            stage_ = Stage::kLookAround;
            [[fallthrough]];
        case Stage::kLookAround:
            if (!go_on(next_, lines_.size(), slice, [&](std::uint32_t piece) {
                    if (!users_.shared(piece)) return;
                    slice.take(users_.at(piece).size());
                    fine = fine && look_around(piece);
                }))
                return fine ? PhaseEnd::kGoesOn : PhaseEnd::kBroken;
            if (!fine) return PhaseEnd::kBroken;
            labels_.resize(cells_.cells.size());
            stage_ = Stage::kLocate;
            [[fallthrough]];
        case Stage::kLocate:
            break;
    }
    const bool all = go_on(next_, cells_.cells.size(), slice, [&](std::uint32_t cell) {
        CellLabel& known = label_[sets_.find(cell)];
        if (known == CellLabel::kUnknown) {
            slice.take(kToLocate);
            known = locate(cell);
        }
        fine = fine && known != CellLabel::kUnknown;
        labels_[cell] = known;
    });
    return !fine ? PhaseEnd::kUnlocated : all ? PhaseEnd::kDone : PhaseEnd::kGoesOn;
}

/// The other solid is not there.
void CellLabeller::spread(std::uint32_t piece) {
    const auto uses = users_.at(piece);
    for (std::size_t k = 1; k < uses.size(); ++k) sets_.join(users_.cell_of(uses[0]), users_.cell_of(uses[k]));
}

bool CellLabeller::set(std::uint32_t cell, CellLabel label) {
    CellLabel& known = label_[sets_.find(cell)];
    if (known == CellLabel::kUnknown) known = label;
    return known == label;
}

bool CellLabeller::look_around(std::uint32_t piece) {
    spokes_.clear();
    for (const std::uint32_t use : users_.at(piece)) {
        const std::uint32_t cell = users_.cell_of(use);
        const OverlayFace& face = overlay_.faces[cells_.cells[cell].face];
        const bool forward = cells_.all_uses[use].forward;
        spokes_.push_back({use, cell, forward ? face.plane : from_behind(face.plane), forward, face.operand, 0});
    }
    sort_around(overlay_.lines, lines_.piece(piece).line, spokes_);
    // What lies before the first spoke is what lies after the last one of each solid.
    bool solid[kOperands] = {false, false};
    for (const CellSpoke& spoke : spokes_) solid[spoke.operand] = !spoke.air_after;
    for (std::size_t first = 0; first < spokes_.size();) {
        std::size_t end = first + 1;
        while (end < spokes_.size() && spokes_[end].half == spokes_[first].half) ++end;
        if (end - first > 2 || (end - first == 2 && spokes_[first].operand == spokes_[first + 1].operand)) return false;
        for (std::size_t k = first; k < end; ++k) {
            const CellSpoke& spoke = spokes_[k];
            if (solid[spoke.operand] != spoke.air_after) return false;  // not so before it as after the one before
        }
        for (std::size_t k = first; k < end; ++k) {
            const CellSpoke& spoke = spokes_[k];
            const CellLabel label =
                end - first == 2
                    ? spokes_[first].air_after == spokes_[first + 1].air_after ? CellLabel::kSame : CellLabel::kOpposite
                : solid[1 - spoke.operand] ? CellLabel::kIn
                                           : CellLabel::kOut;
            if (!set(spoke.cell, label)) return false;
        }
        for (std::size_t k = first; k < end; ++k) solid[spokes_[k].operand] = !spokes_[k].air_after;
        first = end;
    }
    return true;
}

}  // namespace firma
