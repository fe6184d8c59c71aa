// SPDX-License-Identifier: MIT
// From labels to the faces of the result, phase by phase.
#include "arrange/keep_cells.h"

#include "arrange/find_seams.h"
#include "arrange/pair_sides.h"
#include "arrange/write_cells.h"

namespace firma {

class CellKeeper::Work {
public:
    Work(Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users,
         std::span<const CellLabel> labels, const Selection& selection, Arranged& made)
        : labels_(labels),
          made_(made),
          cells_(overlay, lines, cells, users, selection),
          seams_(cells_),
          sides_(cells_),
          writer_(cells_, made) {
        made.stays.assign(overlay.faces.size(), 0);
    }

    PhaseEnd step(WorkSlice& slice) {
        while (stage_ != Stage::kEnd) {
            const bool ended = loop(slice);
            if (broken_) return PhaseEnd::kBroken;
            if (!ended) return PhaseEnd::kGoesOn;
            stage_ = Stage(std::uint8_t(stage_) + 1);
            if (stage_ != Stage::kEdges || !nothing_changes()) continue;
            made_.changes = false;
            stage_ = Stage::kEnd;
        }
        if (made_.changes && made_.edge_of_use.empty()) made_.edge_of_use = writer_.take_edges();
        return PhaseEnd::kDone;
    }

private:
    /// Each goes over all cells, edges, pieces or groups; kMerge over the pieces twice.
    enum class Stage : std::uint8_t {
        kSelect,
        kEdges,
        kContacts,
        kMerge,
        kDissolve,
        kPair,
        kGroup,
        kTrace,
        kWrite,
        kEnd
    };

    /// Goes on with the loop of the stage at hand; true at its end.
    bool loop(WorkSlice& slice) {
        const std::size_t pieces = cells_.lines.size();
        const PieceUsers& users = cells_.users;
        switch (stage_) {
            case Stage::kSelect:
                return go_on(next_, cells_.kept.size(), slice, [&](std::uint32_t cell) {
                    slice.take(cells_.cells.cells[cell].use_count / 8);
                    select(cell);
                });
            case Stage::kEdges:
                return go_on(next_, cells_.overlay.edges.size(), slice,
                             [&](std::uint32_t edge) { writer_.know_edge(edge); });
            case Stage::kContacts:
                return go_on(next_, pieces, slice, [&](std::uint32_t piece) { seams_.find_contacts(piece); });
            case Stage::kMerge:
                // Where faces became one across what both solids share, the rest of what lay between them goes too.
                return go_on(next_, 2 * pieces, slice, [&](std::uint32_t k) {
                    const auto piece = std::uint32_t(k < pieces ? k : k - pieces);
                    if (users.shared(piece) == (k < pieces)) seams_.merge_across(piece);
                });
            case Stage::kDissolve:
                // Faces that became one by way of others have edges between them still.
                return go_on(next_, pieces, slice, [&](std::uint32_t piece) { seams_.dissolve_within(piece); });
            case Stage::kPair:
                return go_on(next_, pieces, slice, [&](std::uint32_t piece) {
                    if (!users.shared(piece))
                        sides_.pair_by_edge(piece);
                    else if (!sides_.pair_around(piece))
                        broken_ = true;
                });
            case Stage::kGroup:
                writer_.gather_groups();
                return true;
            case Stage::kTrace:
                return go_on(next_, writer_.group_count(), slice, [&](std::uint32_t group) {
                    broken_ = broken_ || !writer_.trace(group);
                    slice.take(2 * writer_.uses_traced());
                });
            case Stage::kWrite:
                return go_on(next_, writer_.group_count(), slice, [&](std::uint32_t group) {
                    broken_ = broken_ || !writer_.write(group);
                    slice.take(2 * writer_.uses_written());
                });
            case Stage::kEnd:
                break;
        }
        return true;
    }

    void select(std::uint32_t cell) {
        const Cell& it = cells_.cells.cells[cell];
        cells_.kept[cell] = cells_.selection.keep(cells_.overlay.faces[it.face].operand, labels_[cell]);
        for (std::uint32_t k = it.first_use; k < it.first_use + it.use_count; ++k) {
            PieceUse& use = cells_.uses[k];
            cells_.box[cell].add(cells_.overlay.point(cells_.flat.from(use)).rounded());
            if (cells_.kept[cell] == Kept::kTurned) use = use.turned();
            use.id = k;
        }
    }

    /// Whether all of the first solid stays, and nothing of another comes.
    bool nothing_changes() const {
        for (std::uint32_t cell = 0; cell < cells_.kept.size(); ++cell) {
            const bool of_first = cells_.overlay.faces[cells_.cells.cells[cell].face].operand == 0;
            if (cells_.kept[cell] != (of_first ? Kept::kAsItIs : Kept::kNot)) return false;
        }
        return true;
    }

    const std::span<const CellLabel> labels_;
    Arranged& made_;
    KeptCells cells_;
    SeamFinder seams_;
    SidePairer sides_;
    CellWriter writer_;
    Stage stage_ = Stage::kSelect;
    std::uint32_t next_ = 0;  ///< in the loop of the stage
    bool broken_ = false;
};

CellKeeper::CellKeeper(Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users,
                       std::span<const CellLabel> labels, Selection selection)
    : selection_(std::move(selection)),
      work_(std::make_unique<Work>(overlay, lines, cells, users, labels, selection_, made_)) {}

CellKeeper::~CellKeeper() = default;

PhaseEnd CellKeeper::step(WorkSlice& slice) {
    return work_->step(slice);
}

}  // namespace firma
