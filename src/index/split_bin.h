// SPDX-License-Identifier: MIT
// How a bin is divided: the article's halves across the longest axis, or by surface area.
#pragma once

#include <cstdint>
#include <span>

#include "firma/tree_options.h"
#include "geometry/grid_box.h"

namespace firma {

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
/// the items are divided in the middle of their order by face.
std::size_t split_bin(std::span<BuildItem> items, const GridBox& box, Split split);

/// By surface area alone.
/// @return 0 when no plane separates the centres
std::size_t split_by_area(std::span<BuildItem> items, const GridBox& box);

/// The most items that split_apart() takes.
inline constexpr std::size_t kFewItems = 12;

/// Few items into two parts that lie apart, along the axis along which the centres do most: the surfaces of the boxes
/// around them are less than `share` of the surface of the box around all.
/// @return 0 when no plane between centres parts them so
std::size_t split_apart(std::span<BuildItem> items, const GridBox& box, double share);

/// @param items  one or more
GridBox box_around(std::span<const BuildItem> items);

/// The middle of the order by face, for bins that are done but too large for a block.
std::size_t split_by_count(std::span<BuildItem> items);

}  // namespace firma
