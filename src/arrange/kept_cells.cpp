// SPDX-License-Identifier: MIT
// What is known of an arrangement's cells while faces are made of them.
#include "arrange/kept_cells.h"

namespace firma {

KeptCells::KeptCells(Overlay& overlay_in, const DividedLines& lines_in, const CellSet& cells_in,
                     const PieceUsers& users_in, const Selection& selection_in)
    : overlay(overlay_in),
      lines(lines_in),
      cells(cells_in),
      users(users_in),
      selection(selection_in),
      flat(overlay, lines),
      groups(cells.cells.size()),
      box(cells.cells.size()),
      kept(cells.cells.size(), Kept::kNot),
      uses(cells.all_uses),
      dissolved(uses.size(), 0),
      across(uses.size(), kNone),
      contact(overlay.tables.points.size(), 0),
      partner(uses.size(), kNone),
      crowded(uses.size(), 0) {}

}  // namespace firma
