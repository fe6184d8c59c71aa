// SPDX-License-Identifier: MIT
// How many faces reach into a placed cutter: of those that it leaves as they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "carve/cutter_solid.h"
#include "carve/pair_budget.h"
#include "solid/block.h"

namespace firma {

/// Counts faces of which some part lies inside the cutter. Judged in double: one that just touches the cutter, or
/// reaches less than 1/4096 m into it, may count or not. Works in pieces of some ten microseconds.
class ReachCount {
public:
    /// @param near       faces, that may reach into it
    /// @param max_pairs  of a face and a triangle of the cutter: once they are used up, faces count that reach into
    ///                    the bevelled box
    ReachCount(std::vector<FacetPlace> near, const CutterSolid& cutter, std::uint64_t max_pairs);

    /// Does one piece of work; false once there is none left.
    bool step();

    /// Once step() said false.
    std::size_t count() const { return count_; }

private:
    bool reaches(const FacetPlace& facet);
    bool crosses_cutter(const GridBox& box);

    const CutterSolid& cutter_;
    PairBudget budget_;
    std::vector<FacetPlace> near_;
    std::size_t next_ = 0, count_ = 0;
    std::vector<Vec3> corners_, loop_;  ///< of the face at hand, input steps
};

}  // namespace firma
