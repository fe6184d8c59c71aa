// SPDX-License-Identifier: MIT
// A closed mesh that snapping folded, mended where it crosses or touches itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/cutter.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Takes triangles out that have no area, and of those that share more than their common corners and edges the
/// thinnest: by turning the edge that such a one has with its neighbour, where it is nearly flat on that, else by
/// merging the ends of its shortest edge; until none is left, or none can be mended like this. What it moves, it moves
/// by at most kLongestMerged, and each triangle that it turns was thinner than kThin.
/// @param points     on the input grid, each once
/// @param triangles  closed; changed in place, also where that ends too soon
/// @return how many it took out
int mend_mesh(std::span<const InputPoint> points, std::vector<CutterTriangle>& triangles);

inline constexpr std::int64_t kThin = 8;            ///< input steps: 2 mm
inline constexpr std::int64_t kLongestMerged = 64;  ///< input steps: 16 mm

}  // namespace firma
