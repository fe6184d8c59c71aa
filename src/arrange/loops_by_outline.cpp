// SPDX-License-Identifier: MIT
// The loops of one plane by the outline that they belong to.
#include "arrange/loops_by_outline.h"

namespace firma {

void LoopsByOutline::set(std::span<const std::uint32_t> outline_of) {
    outlines_.clear();
    place_.resize(outline_of.size());
    for (std::uint32_t loop = 0; loop < outline_of.size(); ++loop) {
        if (outline_of[loop] != loop) continue;
        place_[loop] = std::uint32_t(outlines_.size());
        outlines_.push_back(loop);
    }
    first_.assign(outlines_.size() + 1, 0);
    for (const std::uint32_t outline : outline_of) ++first_[place_[outline] + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    // Outlines first: so many loops of each are placed.
    std::vector<std::uint32_t> placed(outlines_.size(), 1);
    loops_.resize(outline_of.size());
    for (std::uint32_t loop = 0; loop < outline_of.size(); ++loop) {
        const std::uint32_t place = place_[outline_of[loop]];
        loops_[first_[place] + (outline_of[loop] == loop ? 0 : placed[place]++)] = loop;
    }
}

}  // namespace firma
