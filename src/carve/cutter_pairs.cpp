// SPDX-License-Identifier: MIT
// Pairs of an overlay's faces with a cutter's.
#include "carve/cutter_pairs.h"

#include <utility>

#include "carve/gather.h"
#include "carve/side_of_solid.h"

namespace firma {

void CutterPairs::start(const CutterSolid& cutter, const Overlay& overlay, std::vector<std::uint32_t> face_of,
                        std::vector<std::uint32_t> faces) {
    cutter_ = &cutter;
    overlay_ = &overlay;
    face_of_ = std::move(face_of);
    faces_ = std::move(faces);
    met_.resize(overlay.faces.size());
    for (const std::uint32_t face : face_of_) met_[face] = ~0u;  // of many cutters each has its own
    next_ = 0;
}

bool CutterPairs::step(SpanFinder& spans, PairBudget& budget) {
    // A mesh's triangles hold its faces; a Solid's facets lie near its faces.
    const std::int32_t steps = cutter_->turned ? 1 + kFacetReach : 1;
    const std::uint64_t before = budget.taken();
    for (; next_ < faces_.size() && budget.taken() - before < kPairsACutStep; ++next_) {
        const std::uint32_t tried = faces_[next_];
        cutter_->tree.for_each_meeting(grown(overlay_->faces[tried].box, steps), [&](std::uint32_t triangle) {
            const std::uint32_t face = face_of_[triangle];
            if (met_[face] == next_) return false;
            met_[face] = next_;
            if (!budget.take()) return true;
            spans.meet(tried, face);
            return false;
        });
        if (budget.spent()) return false;
    }
    return next_ < faces_.size();
}

}  // namespace firma
