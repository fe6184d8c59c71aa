// SPDX-License-Identifier: MIT
// The loops of one plane by the outline that they belong to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace firma {

class LoopsByOutline {
public:
    /// @param outline_of  of each loop, the outline's number; an outline's is its own
    void set(std::span<const std::uint32_t> outline_of);

    /// In order.
    std::span<const std::uint32_t> outlines() const { return outlines_; }
    /// An outline, then the holes in it, in order.
    /// @param k  the outline's place in outlines()
    std::span<const std::uint32_t> loops(std::size_t k) const {
        return {loops_.data() + first_[k], first_[k + 1] - first_[k]};
    }

private:
    std::vector<std::uint32_t> outlines_, first_, loops_, place_;
};

/// Appends loops.
/// @param uses   of all loops in a row, `ends` where each ends
/// @param loops  which ones
/// @param first  in `uses_made`, where ends are counted from
template <class Use>
void append_loops(std::span<const Use> uses, std::span<const std::uint32_t> ends, std::span<const std::uint32_t> loops,
                  std::size_t first, std::vector<Use>& uses_made, std::vector<std::uint32_t>& ends_made) {
    for (const std::uint32_t loop : loops) {
        const std::uint32_t begin = loop == 0 ? 0 : ends[loop - 1];
        uses_made.insert(uses_made.end(), uses.begin() + begin, uses.begin() + ends[loop]);
        ends_made.push_back(std::uint32_t(uses_made.size() - first));
    }
}

}  // namespace firma
