// SPDX-License-Identifier: MIT
// Where each cell lies against the other solid.
//
// Around a piece all faces stand like spokes. The cells of a face there lie in what the other solid's faces enclose
// between them, or on one of them; along pieces without the other solid a label spreads.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "arrange/find_cells.h"
#include "arrange/phase_end.h"
#include "base/disjoint_sets.h"

namespace firma {

enum class CellLabel : std::uint8_t {
    kUnknown,
    kOut,
    kIn,
    kSame,      ///< on the other solid's boundary, both look the same way
    kOpposite,  ///< on it, and they look at each other
};

/// A cell's side at a piece.
struct CellSpoke {
    std::uint32_t use = 0;  ///< in CellSet::all_uses
    std::uint32_t cell = 0;
    PlaneId half = kNoPlane;  ///< the plane, turned so that the cell lies left of the piece
    bool air_after = false;   ///< turning from it about the piece, counter-clockwise: else its solid
    std::uint8_t operand = 0;
    std::uint8_t part = 0;  ///< of the circle
};

/// The sides at each piece.
class PieceUsers {
public:
    void gather(const Overlay& overlay, const DividedLines& lines, const CellSet& cells);
    /// In order of cells.
    std::span<const std::uint32_t> at(std::uint32_t piece) const {
        return {uses_.data() + first_[piece], first_[piece + 1] - first_[piece]};
    }
    std::uint32_t cell_of(std::uint32_t use) const { return cell_of_[use]; }
    /// Whether faces of more than one solid stand there.
    bool shared(std::uint32_t piece) const { return shared_[piece] != 0; }

private:
    std::vector<std::uint32_t> first_, uses_, cell_of_;
    std::vector<std::uint8_t> shared_;
};

/// Sorts by angle about a line, counter-clockwise, from the first on; those at one angle stay in order of uses.
void sort_around(const LineTable& lines, std::uint32_t line, std::span<CellSpoke> spokes);

/// Where a cell lies that no piece tells about.
using LocateCell = std::function<CellLabel(std::uint32_t cell)>;

class CellLabeller {
public:
    CellLabeller(const Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users);

    /// Broken when labels contradict each other, unlocated when `locate` could not tell.
    PhaseEnd step(const LocateCell& locate, WorkSlice& slice);

    /// One a cell, once it is done.
    std::span<const CellLabel> labels() const { return labels_; }

private:
    enum class Stage : std::uint8_t { kSpread, kLookAround, kLocate };

    void spread(std::uint32_t piece);
    bool look_around(std::uint32_t piece);
    bool set(std::uint32_t cell, CellLabel label);

    const Overlay& overlay_;
    const DividedLines& lines_;
    const CellSet& cells_;
    const PieceUsers& users_;
    Stage stage_ = Stage::kSpread;
    std::uint32_t next_ = 0;  ///< in the loop of the stage
    DisjointSets sets_;
    std::vector<CellLabel> label_;  ///< of a set, by the cell that stands for it
    std::vector<CellLabel> labels_;
    std::vector<CellSpoke> spokes_;
};

}  // namespace firma
