// SPDX-License-Identifier: MIT
// Where faces of the result become one across a piece, which then is an edge of neither.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/kept_cells.h"

namespace firma {

class SeamFinder {
public:
    explicit SeamFinder(KeptCells& in);

    /// Points that lie on pieces where both solids are, and the faces there.
    void find_contacts(std::uint32_t piece);
    /// What lies in one plane on both sides of the piece, and is alike, is one.
    void merge_across(std::uint32_t piece);
    /// What lies between two pieces of one face goes.
    void dissolve_within(std::uint32_t piece);

private:
    /// Calls `becomes_one` for two uses of the piece, one each way, with cells in one plane: whether the piece vanishes
    /// between them.
    template <class BecomesOne>
    void for_each_seam(std::uint32_t piece, const BecomesOne& becomes_one);
    /// Across what both solids share, or across an edge of a face that changes anyhow.
    bool may_merge(std::uint32_t use, std::uint32_t other) const;
    bool meets_other(std::uint32_t use) const;
    bool of_one_face(std::uint32_t a, std::uint32_t b) const;
    bool are_alike(std::uint32_t a, std::uint32_t b) const;
    GridBox box_of_both(std::uint32_t a, std::uint32_t b);
    /// Whether all faces at the piece are here. Near what both solids share they are.
    bool is_complete(std::uint32_t piece) const;

    KeptCells& in_;
    std::vector<std::uint8_t> met_;  ///< of the overlay's faces: whether they have a piece that both solids share
};

}  // namespace firma
