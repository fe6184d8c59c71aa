// SPDX-License-Identifier: MIT
// A cut whose cutter touches what it cuts: the patch and the cutter as one arrangement, nothing moved.
//
// In place of cut_faces, order_cuts, label and trace_loops, and with the same outcome: crossings that are vertices, and
// the loops of new faces.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "arrange/keep_cells.h"
#include "carve/crossings.h"
#include "carve/cutter_pairs.h"
#include "carve/label.h"
#include "carve/new_loops.h"
#include "carve/overlay_operands.h"
#include "carve/pair_budget.h"

namespace firma {

/// Whether a point that lies off the solid's boundary lies in the solid; kUnknown when that cannot be told.
using LocatePoint = std::function<CutSide(const ExactPoint& point)>;

class CutArranger {
public:
    enum class End : std::uint8_t {
        kFine,
        kGoesOn,     ///< call step() again
        kTooLarge,   ///< more planes than one arrangement holds
        kPairs,      ///< the budget is spent
        kBroken,     ///< the solid or the cutter crosses itself
        kUnlocated,  ///< a part that meets nothing lies too near to the other solid to tell where
    };

    /// @param material  of the faces that the cutter leaves
    CutArranger(const CutInput& in, PairBudget& budget, std::uint32_t material);
    ~CutArranger();

    /// Does one piece of work.
    End step(const LocatePoint& locate);

    /// After kFine. They look at planes of this object.
    const Crossings& crossings() const { return crossings_; }
    const NewLoops& loops() const { return loops_; }
    /// Whether anything of a wall goes: a cutter may touch walls along edges alone.
    bool takes_walls() const;

private:
    enum class Phase : std::uint8_t {
        kWorld,
        kCutter,
        kPairs,
        kSpans,
        kLines,
        kCells,
        kLabels,
        kKeep,
        kEdges,
        kFaces,
        kTaken,
        kDivisions
    };

    void take_world();
    End add_cutter(WorkSlice& slice);
    End meet_next();
    End start_labels();
    End start_keeping();
    End move_on(PhaseEnd end, Phase next);
    End go_to(Phase next);
    CellLabel locate_cell(std::uint32_t cell, const LocatePoint& locate) const;
    bool alike(std::uint32_t face, std::uint32_t other) const;
    Selection selection() const;
    void start_writing();
    void write_edge(std::uint32_t index);
    std::uint32_t number_of_edge(std::uint32_t index);
    void write_face(const ArrangedFace& face);
    void write_gone();
    bool goes(std::uint32_t cell) const;
    bool is_taken(std::uint32_t cell) const;
    std::uint32_t kept_edge_at(std::uint32_t piece, std::uint32_t face) const;
    std::uint32_t edge_at(const PieceUse& use, std::uint32_t face);
    std::uint32_t piece_start(const PieceUse& use);
    void append_side(const PieceUse& use, std::uint32_t face, std::vector<PatchUse>& sides);
    void write_taken(std::uint32_t cell);
    void gather_divisions();
    void write_division(std::uint32_t edge);
    std::uint32_t vertex_of(std::uint32_t point);
    bool of_world(std::uint32_t face) const { return face < world_face_.size(); }

    const CutInput& in_;
    PairBudget& budget_;
    const std::uint32_t material_;
    Phase phase_ = Phase::kWorld;
    std::uint32_t next_ = 0;  ///< in the loop of the phase

    Overlay overlay_;
    std::vector<std::uint32_t> patch_edge_;       ///< of an overlay's edge; ~0: one of the cutter
    std::vector<std::uint32_t> world_face_;       ///< the patch's, of the overlay's first faces
    std::vector<std::uint32_t> triangle_of_;      ///< the lowest, of the overlay's faces after those; a Solid's face
    std::vector<std::uint32_t> vertex_of_point_;  ///< see cut_view.h; ~0: none yet
    CutterPairs pairs_;
    std::vector<std::uint32_t> number_;           ///< see cut_view.h, of the arranged edges
    std::vector<std::uint32_t> number_of_piece_;  ///< likewise, of pieces that only taken cells have; ~0: none yet
    std::vector<std::vector<PieceUse>> divided_;  ///< of the overlay's edges that are the patch's: their pieces
    std::vector<PatchUse> sides_;                 ///< scratch
    bool side_forward_ = false;                   ///< which way the last of these goes
    bool joins_air_ = false;  ///< what the cutter leaves bounds air that was there, not a room of its own

    // What the phases make, in their order.
    std::unique_ptr<PatchAdder> world_, solid_;
    std::unique_ptr<MeshAdder> mesh_;
    SpanFinder spans_;
    DividedLines lines_;
    CellFinder cell_finder_;
    PieceUsers users_;
    std::unique_ptr<CellLabeller> labeller_;
    std::unique_ptr<CellKeeper> keeper_;
    Crossings crossings_;
    NewLoops loops_;
};

}  // namespace firma
