// SPDX-License-Identifier: MIT
// Whether a placed cutter crosses or touches itself, exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "carve/pair_budget.h"
#include "carve/place_cutter.h"
#include "geometry/polygons_cross.h"
#include "index/box_tree.h"
#include "index/split_bin.h"

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

inline MeshPolygon polygon_of(const PlacedCutter& placed, std::uint32_t triangle) {
    const CutterTriangle& corners = placed.triangles[triangle];
    return {corners, polygon_normal(placed.vertices, corners)};
}

/// Around each triangle, in surface steps.
std::vector<GridBox> triangle_boxes(const PlacedCutter& placed);

/// The parts of find_crossing(). Whether the surface is seen whole from the middle of its vertices: then it cannot
/// cross itself.
bool is_star_shaped(const PlacedCutter& placed);
/// Pair by pair, for any mesh, closed or not.
/// @param budget  may be null; once spent(), nothing is known
std::optional<Crossing> find_crossing_pair(const PlacedCutter& placed, PairBudget* budget = nullptr);

}  // namespace firma
