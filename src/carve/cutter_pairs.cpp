// SPDX-License-Identifier: MIT
// Pairs of an overlay's faces with a cutter's.
#include "carve/cutter_pairs.h"

#include <utility>

#include "carve/gather.h"
#include "carve/side_of_solid.h"

namespace firma {

void CutterPairs::start(const CutterSolid& cutter, const Overlay& overlay, std::vector<std::uint32_t> face_of,
                        std::uint32_t first) {
    cutter_ = &cutter;
    overlay_ = &overlay;
    face_of_ = std::move(face_of);
    met_.assign(overlay.faces.size(), ~0u);
    next_ = 0;
    first_ = first;
}

bool CutterPairs::step(SpanFinder& spans, PairBudget& budget) {
    // A mesh's triangles hold its faces; a Solid's facets lie near its faces.
    const std::int32_t steps = cutter_->turned ? 1 + kFacetReach : 1;
    const std::uint64_t before = budget.taken();
    for (; next_ < first_ && budget.taken() - before < kPairsACutStep; ++next_) {
        cutter_->tree.for_each_meeting(grown(overlay_->faces[next_].box, steps), [&](std::uint32_t triangle) {
            const std::uint32_t face = face_of_[triangle];
            if (met_[face] == next_) return false;
            met_[face] = next_;
            if (!budget.take()) return true;
            spans.meet(next_, face);
            return false;
        });
        if (budget.spent()) return false;
    }
    return next_ < first_;
}

}  // namespace firma
