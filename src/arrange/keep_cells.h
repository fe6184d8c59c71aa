// SPDX-License-Identifier: MIT
// From labels to the faces of the result: which cells stay, what becomes one again, which edges there are.
#pragma once

#include <memory>
#include <span>

#include "arrange/arranged.h"

namespace firma {

class CellKeeper {
public:
    CellKeeper(Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users,
               std::span<const CellLabel> labels, Selection selection);
    ~CellKeeper();

    /// Broken when the cells kept do not close, or do not group.
    PhaseEnd step(WorkSlice& slice);

    /// Once it is done.
    const Arranged& made() const { return made_; }

private:
    class Work;

    Arranged made_;
    const Selection selection_;
    std::unique_ptr<Work> work_;
};

}  // namespace firma
