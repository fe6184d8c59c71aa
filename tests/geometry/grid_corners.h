// SPDX-License-Identifier: MIT
// A triangle's corners as a WholePath asks for them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "firma/grid.h"

namespace firma {

/// Counted from the first corner, in the longest steps.
struct GridCorners {
    const GridPoint (&corners)[3];
    const GridPoint origin = corners[0];
    const int bits = common_bits();

    std::int64_t steps(unsigned k, int axis) const { return from_origin(k, axis) >> bits; }

private:
    std::int64_t from_origin(unsigned k, int axis) const { return std::int64_t(corners[k][axis]) - origin[axis]; }
    /// As lanes have them, 16 at most.
    int common_bits() const {
        std::uint64_t all = std::uint64_t(1) << 16;
        for (unsigned k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis) all |= std::uint64_t(from_origin(k, axis));
        return std::countr_zero(all);
    }
};

}  // namespace firma
