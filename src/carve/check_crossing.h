// SPDX-License-Identifier: MIT
// Whether a placed cutter crosses or touches itself, exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "carve/place_cutter.h"
#include "tree/split_bin.h"

namespace firma {

/// Two triangles, the lower number first.
using Crossing = std::pair<std::uint32_t, std::uint32_t>;

/// A pair of triangles that share a point beyond the vertices, or the edge, whose indices they share; nothing when
/// there is none. Shells may lie within each other.
///
/// @param placed  closed: each edge belongs to two triangles, one each way; each triangle has area
/// The pair is the same on every machine, not the first in any order. Quick for a cutter that is seen whole from the
/// middle of its vertices; else it takes a tree and n log n.
std::optional<Crossing> find_crossing(const PlacedCutter& placed);

/// Around each triangle, in surface steps.
std::vector<GridBox> triangle_boxes(const PlacedCutter& placed);

/// The parts of find_crossing(). Whether the surface is seen whole from the middle of its vertices: then it cannot
/// cross itself.
bool is_star_shaped(const PlacedCutter& placed);
/// How many more pairs of triangles may be looked at: some meshes (a fan of long triangles) have boxes that all meet.
struct PairBudget {
    std::uint64_t left = ~std::uint64_t(0);

    bool spent() const { return left == 0; }
    bool take() {
        if (left > 0) --left;
        return left > 0;
    }
};

/// Pair by pair, for any mesh, closed or not.
/// @param budget  may be null; once spent(), nothing is known
std::optional<Crossing> find_crossing_pair(const PlacedCutter& placed, PairBudget* budget = nullptr);

}  // namespace firma
