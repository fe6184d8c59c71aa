// SPDX-License-Identifier: MIT
// Pairs of an overlay's faces with those of a cutter, where their boxes meet.
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
    /// @param faces            of the overlay, that are tried with those
    void start(const CutterSolid& cutter, const Overlay& overlay, std::vector<std::uint32_t> face_of,
               std::vector<std::uint32_t> faces);
    /// Notes spans of the next pairs, until kPairsACutStep were looked at, or the budget is spent.
    /// @return whether any are left
    bool step(SpanFinder& spans, PairBudget& budget);

private:
    const CutterSolid* cutter_ = nullptr;
    const Overlay* overlay_ = nullptr;
    std::vector<std::uint32_t> face_of_;
    std::vector<std::uint32_t> faces_;
    std::vector<std::uint32_t> met_;  ///< of the overlay's faces: the last of faces_ it was tried with, by number
    std::uint32_t next_ = 0;
};

}  // namespace firma
