// SPDX-License-Identifier: MIT
// Whether the loops of a face keep clear of themselves and of each other.
#include "solid/check_loops.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {

/// Neighbours need not be compared: where one folds back over the other, the far end of the shorter lies on the longer,
/// and so does the edge that follows there. Likewise the edges before and after one without length meet.
bool LoopChecker::simple(std::span<const FlatPoint> points, std::span<const std::uint32_t> loop_ends) {
    edges_.clear();
    std::uint32_t begin = 0;
    for (const std::uint32_t end : loop_ends) {
        for (std::uint32_t k = begin; k < end; ++k) {
            const std::uint32_t next = k + 1 < end ? k + 1 : begin;
            const FlatPoint &a = points[k], &b = points[next];
            const auto [low_u, high_u] = std::minmax(a.u, b.u);
            const auto [low_v, high_v] = std::minmax(a.v, b.v);
            edges_.push_back({low_u, high_u, low_v, high_v, k, next});
        }
        begin = end;
    }
    sort_range(edges_,
               [](const Edge& a, const Edge& b) { return a.low_u != b.low_u ? a.low_u < b.low_u : a.from < b.from; });
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const Edge& e = edges_[i];
        for (std::size_t j = i + 1; j < edges_.size() && edges_[j].low_u <= e.high_u; ++j) {
            const Edge& f = edges_[j];
            if (f.low_v > e.high_v || f.high_v < e.low_v) continue;
            const bool neighbours = e.to == f.from || f.to == e.from;
            if (!neighbours && segments_meet(points[e.from], points[e.to], points[f.from], points[f.to])) return false;
        }
    }
    return true;
}

}  // namespace firma
