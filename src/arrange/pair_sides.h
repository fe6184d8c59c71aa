// SPDX-License-Identifier: MIT
// Which two sides of faces meet in each edge of the result.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/kept_cells.h"

namespace firma {

class SidePairer {
public:
    explicit SidePairer(KeptCells& in);

    /// Each wedge of air between two faces is an edge. A face that became one across the piece has no edge there: air
    /// that ends at it goes on from its other side.
    bool pair_around(std::uint32_t piece);
    /// Where one solid is alone, its edges are what they were, but for what vanishes between two of them.
    void pair_by_edge(std::uint32_t piece);

private:
    std::size_t spoke_of(std::uint32_t use) const;

    KeptCells& in_;
    std::vector<CellSpoke> spokes_;
};

}  // namespace firma
