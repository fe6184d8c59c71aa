// SPDX-License-Identifier: MIT
// A path in whole numbers, where it has any: so that sides of edges are exact at the cost of a few products.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"

namespace firma {

class WholePath {
public:
    /// @param direction  as in a Sweep
    WholePath(const Vec3& start, const Vec3& direction);

    /// Whether start and direction are such numbers. Of floats most are: those of a start where none but 0 is below
    /// 2^-7 m, and of a direction where none but 0 is below 2^-17 of the largest.
    bool known() const { return known_; }

    /// exact_triangle_sides() of the edges that are open. Only where it is known.
    /// @param open  not 0: a bit for each edge, bit k for that from corner k
    unsigned triangle_sides(const GridPoint (&corners)[3], unsigned open) const;

private:
    /// A corner as seen from the start.
    struct Seen {
        std::int64_t at[3];
        bool near;  ///< enough for a moment of 63 bits
    };
    Seen see(const GridPoint& corner) const;
    template <class Number>
    struct Moment;
    template <class Number>
    unsigned sides_by(const GridPoint (&corners)[3], unsigned open, unsigned at, const Seen& seen) const;

    bool known_ = false;
    int grid_bits_ = 0;  ///< a step of the grid is 2^grid_bits_ of those of the start
    std::int64_t start_[3], direction_[3];
    std::int64_t short_ = 0;  ///< corners within so many steps of the start have moments of 63 bits
};

}  // namespace firma
