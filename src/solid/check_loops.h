// SPDX-License-Identifier: MIT
// Whether the loops of a face keep clear of themselves and of each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/flat_point.h"

namespace firma {

/// Keeps its scratch from call to call.
class LoopChecker {
public:
    /// Judges exactly; sorts edges along u and compares those that overlap there.
    ///
    /// @param points     corners of all loops in a row
    /// @param loop_ends  end of each loop in `points`; each has three corners or more
    /// @return true when no two edges share a point, but for neighbours along a loop, which share just one. (A loop of
    ///         three corners without area counts as simple: all its edges are neighbours.)
    bool simple(std::span<const FlatPoint> points, std::span<const std::uint32_t> loop_ends);

private:
    struct Edge {
        std::int64_t low_u, high_u, low_v, high_v;
        std::uint32_t from, to;
    };

    std::vector<Edge> edges_;
};

}  // namespace firma
