// SPDX-License-Identifier: MIT
// A path in whole numbers, where it has any: so that sides of edges are exact at the cost of a few products.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"
#include "geometry/exact_integer.h"

namespace firma {

/// Signs that occur among some edges, as bits; none where all of them are 0.
enum EdgeSigns : unsigned { kSomePositive = 1, kSomeNegative = 2 };

// With e = b - a and w the corner a or b as seen from the start, direction . ((a - start) x (b - start)) is
// e . (direction x w). A start within 2^14 m has 44 bits in steps of 2^-30 m, w 45, the direction 41, their moment 87;
// e, in steps of the grid, has 33, and the sum of three products 122. Steps are made as long as start and direction
// allow: then moments mostly have 63 bits.
class WholePath {
public:
    /// @param direction  as in a Sweep
    WholePath(const Vec3& start, const Vec3& direction);

    /// Whether start and direction are such numbers. Of floats most are: those of a start where none but 0 is below
    /// 2^-7 m, and of a direction where none but 0 is below 2^-17 of the largest.
    bool known() const { return known_; }

    /// The signs of exact_edge_side() of the edges that are open. Where the line runs through a corner the moment there
    /// is 0, and so are both edges. Only where it is known.
    /// @param corner  a function of 0, 1 or 2: that corner, a GridPoint; asked of no more corners than it takes
    /// @param open    not 0: a bit for each edge, bit k for that from corner k
    /// @return EdgeSigns
    template <class Corner>
    unsigned triangle_sides(const Corner& corner, unsigned open) const {
        // The corner that two open edges share, or that the only one begins at.
        static constexpr std::uint8_t kShared[] = {0, 0, 1, 1, 2, 0, 2, 0};
        const unsigned at = kShared[open];
        const GridPoint first = corner(at);
        const Seen seen = see(first);
        return seen.near ? sides_by<std::int64_t>(corner, open, at, first, seen)
                         : sides_by<Int128>(corner, open, at, first, seen);
    }

private:
    /// A corner as seen from the start.
    struct Seen {
        std::int64_t at[3];
        bool near;  ///< enough for a moment of 63 bits
    };
    Seen see(const GridPoint& corner) const {
        Seen seen;
        std::uint64_t far = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t w = (std::int64_t(corner[axis]) << grid_bits_) - start_[axis];
            far |= std::uint64_t(w ^ (w >> 63));
            seen.at[axis] = w;
        }
        seen.near = far < std::uint64_t(short_);
        return seen;
    }

    /// Of the line about a corner: direction x w.
    template <class Number>
    struct Moment {
        Number x, y, z;

        Moment(const std::int64_t (&d)[3], const std::int64_t (&w)[3])
            : x(Number(d[1]) * w[2] - Number(d[2]) * w[1]),
              y(Number(d[2]) * w[0] - Number(d[0]) * w[2]),
              z(Number(d[0]) * w[1] - Number(d[1]) * w[0]) {}

        bool is_zero() const { return (x | y | z) == 0; }
        /// Of an edge at that corner, as a bit of EdgeSigns.
        unsigned side_of(const GridPoint& from, const GridPoint& to) const {
            const Int128 sum = Int128(x) * (std::int64_t(to.x) - from.x) + Int128(y) * (std::int64_t(to.y) - from.y) +
                               Int128(z) * (std::int64_t(to.z) - from.z);
            return sum > 0 ? unsigned(kSomePositive) : sum < 0 ? unsigned(kSomeNegative) : 0u;
        }
    };

    template <class Number, class Corner>
    unsigned sides_by(const Corner& corner, unsigned open, unsigned at, const GridPoint& first,
                      const Seen& seen) const {
        static constexpr std::uint8_t kNext[] = {1, 2, 0, 1};
        const unsigned after = kNext[at], before = kNext[at + 1];
        const Moment<Number> moment(direction_, seen.at);
        if (moment.is_zero() && open != 7) return 0;  // through the corner
        const GridPoint next = corner(after);
        unsigned signs = moment.side_of(first, next);
        if (!(open >> before & 1)) return signs;
        const GridPoint last = corner(before);
        signs |= moment.side_of(last, first);
        if (open == 7) signs |= Moment<Int128>(direction_, see(next).at).side_of(next, last);
        return signs;
    }

    bool known_ = false;
    int grid_bits_ = 0;  ///< a step of the grid is 2^grid_bits_ of those of the start
    std::int64_t start_[3], direction_[3];
    std::int64_t short_ = 0;  ///< corners within so many steps of the start have moments of 63 bits
};

}  // namespace firma
