// SPDX-License-Identifier: MIT
// Two counting sorts, by one end and by the other: each keeps the order of equal ones.
#include "base/edge_sides.h"

#include <algorithm>
#include <vector>

namespace firma {
namespace {

void sort_by(std::uint32_t EdgeSide::* end, std::span<const EdgeSide> sides, std::span<EdgeSide> sorted,
             std::vector<std::uint32_t>& first) {
    std::fill(first.begin(), first.end(), 0u);
    for (const EdgeSide& side : sides) ++first[side.*end + 1];
    for (std::size_t point = 1; point < first.size(); ++point) first[point] += first[point - 1];
    for (const EdgeSide& side : sides) sorted[first[side.*end]++] = side;
}

}  // namespace

void sort_sides(std::span<EdgeSide> sides, std::size_t point_count) {
    std::vector<EdgeSide> scratch(sides.size());
    std::vector<std::uint32_t> first(point_count + 1);
    sort_by(&EdgeSide::high, sides, scratch, first);
    sort_by(&EdgeSide::low, scratch, sides, first);
}

std::span<const EdgeSide> edge_at(std::span<const EdgeSide> sorted, std::size_t first) {
    std::size_t end = first;
    while (end < sorted.size() && sorted[end].low == sorted[first].low && sorted[end].high == sorted[first].high) ++end;
    return sorted.subspan(first, end - first);
}

}  // namespace firma
