// SPDX-License-Identifier: MIT
// Edges from triangles: their sides are sorted by both ends, so that the two uses of an edge meet.
#include "carve/cutter_topology.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/assert.h"

namespace firma {
namespace {

/// A side of a triangle on its way around it.
struct Side {
    std::uint32_t low = 0, high = 0;  ///< its ends in order of number
    std::uint32_t index = 0;          ///< 3 * triangle + corner
    bool falling = false;             ///< from `high` to `low`
};

/// Counting sort by one end: keeps the order of equal ones, and takes no longer for a fan of a million triangles.
void sort_by(std::vector<Side>& sides, std::vector<Side>& scratch, std::vector<std::uint32_t>& first,
             std::uint32_t Side::* end) {
    std::fill(first.begin(), first.end(), 0u);
    for (const Side& side : sides) ++first[side.*end + 1];
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    for (const Side& side : sides) scratch[first[side.*end]++] = side;
    sides.swap(scratch);
}

std::vector<Side> sorted_sides(std::span<const CutterTriangle> triangles, std::size_t vertex_count) {
    std::vector<Side> sides(3 * triangles.size()), scratch(sides.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const CutterTriangle& corners = triangles[t];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k], to = corners[k == 2 ? 0 : k + 1];
            FIRMA_ASSERT(from < vertex_count && from != to, "check indices before asking for edges");
            sides[3 * t + k] = {std::min(from, to), std::max(from, to), 3 * t + k, from > to};
        }
    }
    std::vector<std::uint32_t> first(vertex_count + 1);
    sort_by(sides, scratch, first, &Side::high);
    sort_by(sides, scratch, first, &Side::low);
    return sides;
}

Error edge_error(const Side& side, std::size_t uses, bool opposed) {
    const std::string edge =
        "the edge between vertices " + std::to_string(side.low) + " and " + std::to_string(side.high);
    const std::string triangle = std::to_string(side.index / 3);
    if (uses == 1)
        return {ErrorCode::kMalformed, "triangle " + triangle, edge + " belongs to no other: the mesh is open"};
    if (uses == 2 && !opposed)
        return {ErrorCode::kMalformed, "triangle " + triangle,
                edge + " runs the same way in its neighbour: they are wound against each other"};
    return {ErrorCode::kMalformed, "triangle " + triangle,
            edge + " belongs to " + std::to_string(uses) + " triangles, not to two"};
}

}  // namespace

Result<CutterTopology> cutter_topology(std::span<const CutterTriangle> triangles, std::size_t vertex_count) {
    const std::vector<Side> sides = sorted_sides(triangles, vertex_count);
    CutterTopology topology;
    topology.edges.reserve(sides.size() / 2);
    topology.triangle_edges.resize(triangles.size());
    for (std::size_t k = 0; k < sides.size();) {
        const Side& side = sides[k];
        std::size_t uses = 1;
        while (k + uses < sides.size() && sides[k + uses].low == side.low && sides[k + uses].high == side.high) ++uses;
        const bool opposed = uses == 2 && sides[k + 1].falling != side.falling;
        if (!opposed) return edge_error(side, uses, opposed);

        const Side& other = sides[k + 1];
        const auto edge = std::uint32_t(topology.edges.size());
        topology.edges.push_back(
            {side.low, side.high, (side.falling ? other : side).index / 3, (side.falling ? side : other).index / 3});
        for (const Side* use : {&side, &other}) topology.triangle_edges[use->index / 3][use->index % 3] = edge;
        k += 2;
    }
    return topology;
}

}  // namespace firma
