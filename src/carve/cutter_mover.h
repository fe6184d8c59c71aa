// SPDX-License-Identifier: MIT
// Moves a cutter out of degenerate position, try by try: all of it, or of a large one what touches.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/cutter_solid.h"
#include "carve/pair_budget.h"
#include "carve/place_cutter.h"

namespace firma {

class CutterMover {
public:
    enum class Outcome : std::uint8_t {
        kMoved,
        kUnsound,  ///< moved like that, it is no cutter: try again
        kTooManyPairs,
    };

    /// @param placed  as place_cutter() gave it
    void start(PlacedCutter placed) { placed_ = std::move(placed); }
    /// Before it was moved aside.
    const PlacedCutter& placed() const { return placed_; }
    /// Whether only what touches is moved.
    bool is_large() const { return placed_.vertices.size() > kMostMovedWhole; }

    /// Tells which vertices are to be moved of a large cutter: those that a phase found, some more than once; all,
    /// where it could name none.
    void touched(std::vector<std::uint32_t>& vertices);

    /// One try. A cutter that was moved must pass what it passed before.
    /// @param tries   1, 2, ...
    /// @param cutter  as the last try left it; of a small one unchanged unless kMoved
    Outcome move(int tries, CutterSolid& cutter, PairBudget& budget) const {
        return is_large() ? move_what_touches(tries, cutter, budget) : move_all(tries, cutter, budget);
    }

private:
    Outcome move_all(int tries, CutterSolid& cutter, PairBudget& budget) const;
    Outcome move_what_touches(int tries, CutterSolid& cutter, PairBudget& budget) const;

    PlacedCutter placed_;
    std::vector<std::uint32_t> touching_;  ///< each once, in order
};

}  // namespace firma
