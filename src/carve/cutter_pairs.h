// SPDX-License-Identifier: MIT
// Pairs of an overlay's first faces with those of a cutter that follow, where their boxes meet.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/find_spans.h"
#include "carve/cutter_solid.h"
#include "carve/pair_budget.h"

namespace firma {

class CutterPairs {
public:
    /// @param cutter, overlay  live as long as this is asked
    /// @param face_of          the overlay's, of the cutter's triangles or facets
    /// @param first            the cutter's first: as many faces of the overlay are tried with those from here on
    void start(const CutterSolid& cutter, const Overlay& overlay, std::vector<std::uint32_t> face_of,
               std::uint32_t first);
    /// Notes spans of the next pairs, until kPairsACutStep were looked at, or the budget is spent.
    /// @return whether any are left
    bool step(SpanFinder& spans, PairBudget& budget);

private:
    const CutterSolid* cutter_ = nullptr;
    const Overlay* overlay_ = nullptr;
    std::vector<std::uint32_t> face_of_;
    std::vector<std::uint32_t> met_;  ///< of the overlay's faces: the last one it was tried with
    std::uint32_t next_ = 0, first_ = 0;
};

}  // namespace firma
