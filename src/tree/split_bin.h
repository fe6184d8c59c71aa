// SPDX-License-Identifier: MIT
// How a bin is divided: the article's halves across the longest axis, or by surface area.
#pragma once

#include <cstdint>
#include <span>

#include "firma/grid.h"
#include "firma/tree_options.h"

namespace firma {

/// A box in whole surface steps, closed.
struct GridBox {
    GridPoint low{INT32_MAX, INT32_MAX, INT32_MAX};
    GridPoint high{INT32_MIN, INT32_MIN, INT32_MIN};

    void add(const GridPoint& p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    void add(const GridBox& b) {
        add(b.low);
        add(b.high);
    }
    double extent(int axis) const { return (double(high[axis]) - double(low[axis])) / kSurfaceSteps; }
    double volume() const { return extent(0) * extent(1) * extent(2); }
    /// Half the surface, square metres.
    double half_area() const { return extent(0) * extent(1) + extent(1) * extent(2) + extent(2) * extent(0); }
};

/// A face on its way into a bin.
struct BuildItem {
    GridBox box;
    std::uint32_t face = 0;

    /// Twice the centre of the face's box.
    std::int64_t centre(int axis) const { return std::int64_t(box.low[axis]) + box.high[axis]; }
};

/// Reorders the items so that those of the left child come first.
///
/// @param items  two or more
/// @param box    around them all
/// @return how many go left: at least 1, fewer than all. When no plane separates the centres (they may all coincide)
/// the items
///         are divided in the middle of their order by face.
std::size_t split_bin(std::span<BuildItem> items, const GridBox& box, Split split);

/// The middle of the order by face, for bins that are done but too large for a block.
std::size_t split_by_count(std::span<BuildItem> items);

}  // namespace firma
