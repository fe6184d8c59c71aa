// SPDX-License-Identifier: MIT
// Where the air of a level narrows: doorways, hatches, the ends of corridors.
#pragma once

#include <cstdint>
#include <vector>

#include "brush/air_grid.h"

namespace firma {

/// A section of the air, square to an axis, that solid encloses all round and beyond which the air is wider.
struct Narrow {
    int axis = 0, layer = 0;  ///< it passes through the centres of this layer
    double area = 0;          ///< square metres
    /// A rectangle around it across the two axes after its own, that reaches into the solid on all four sides; metres.
    double low[2] = {0, 0}, high[2] = {0, 0};
    std::vector<std::uint32_t> ways;  ///< cells from which the way along the axis leads out of it, to the wider side
};

/// @param inside  by cell: sections elsewhere do not count; empty: all do
/// @return by area, the narrowest first; of those of one area by axis and place
std::vector<Narrow> find_narrows(const AirGrid& grid, const std::vector<bool>& inside);

}  // namespace firma
