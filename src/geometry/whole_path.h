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
    /// @param corners  corner k is at origin + steps(k, axis) * 2^bits, in steps of the grid; asked of no more than it
    ///                 takes
    /// @param open     not 0: a bit for each edge, bit k for that from corner k
    /// @return EdgeSigns
    template <class Corners>
    unsigned triangle_sides(const Corners& corners, unsigned open) const {
        // The corner that two open edges share, or that the only one begins at.
        static constexpr std::uint8_t kShared[] = {0, 0, 1, 1, 2, 0, 2, 0};
        const View<Corners> view(*this, corners);
        const unsigned at = kShared[open];
        const Seen seen = view.see(at);
        return seen.far < std::uint64_t(short_) ? sides_by<std::int64_t>(view, open, at, seen)
                                                : sides_by<Int128>(view, open, at, seen);
    }

private:
    /// A corner as seen from the start.
    struct Seen {
        std::int64_t at[3];
        std::uint64_t far;  ///< no coordinate has more bits
    };

    template <class Corners>
    class View {
    public:
        View(const WholePath& path, const Corners& corners) : corners_(corners), bits_(corners.bits + path.grid_bits_) {
            for (int axis = 0; axis < 3; ++axis)
                origin_[axis] = (std::int64_t(corners.origin[axis]) << path.grid_bits_) - path.start_[axis];
        }
        Seen see(unsigned k) const {
            Seen seen{{}, 0};
            for (int axis = 0; axis < 3; ++axis) {
                const std::int64_t w = (corners_.steps(k, axis) << bits_) + origin_[axis];
                seen.far |= std::uint64_t(w ^ (w >> 63));
                seen.at[axis] = w;
            }
            return seen;
        }
        /// From one corner to another, by 2^bits.
        std::int64_t edge(unsigned from, unsigned to, int axis) const {
            return corners_.steps(to, axis) - corners_.steps(from, axis);
        }

    private:
        const Corners& corners_;
        const int bits_;
        std::int64_t origin_[3];  ///< as seen from the start
    };

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
        template <class Corners>
        unsigned side_of(const View<Corners>& view, unsigned from, unsigned to) const {
            const Int128 sum = Int128(x) * view.edge(from, to, 0) + Int128(y) * view.edge(from, to, 1) +
                               Int128(z) * view.edge(from, to, 2);
            return sum > 0 ? unsigned(kSomePositive) : sum < 0 ? unsigned(kSomeNegative) : 0u;
        }
    };

    template <class Number, class Corners>
    unsigned sides_by(const View<Corners>& view, unsigned open, unsigned at, const Seen& seen) const {
        static constexpr std::uint8_t kNext[] = {1, 2, 0, 1};
        const unsigned after = kNext[at], before = kNext[at + 1];
        const Moment<Number> moment(direction_, seen.at);
        if (moment.is_zero() && open != 7) return 0;  // through the corner
        unsigned signs = moment.side_of(view, at, after);
        if (!(open >> before & 1)) return signs;
        signs |= moment.side_of(view, before, at);
        if (open == 7) signs |= Moment<Int128>(direction_, view.see(after).at).side_of(view, after, before);
        return signs;
    }

    bool known_ = false;
    int grid_bits_ = 0;  ///< a step of the grid is 2^grid_bits_ of those of the start
    std::int64_t start_[3], direction_[3];
    std::int64_t short_ = 0;  ///< corners within so many steps of the start have moments of 63 bits
};

}  // namespace firma
