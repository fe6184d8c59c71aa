// SPDX-License-Identifier: MIT
// Edges from triangles.
#include "carve/cutter_topology.h"

#include <string>

#include "base/assert.h"
#include "base/edge_sides.h"

namespace firma {
namespace {

/// Their owners are numbered 3 * triangle + corner.
std::vector<EdgeSide> sorted_sides(std::span<const CutterTriangle> triangles, std::size_t vertex_count) {
    std::vector<EdgeSide> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangles[t][k], to = triangles[t][k == 2 ? 0 : k + 1];
            FIRMA_ASSERT(from < vertex_count && from != to, "check indices before asking for edges");
            sides.emplace_back(from, to, 3 * t + k);
        }
    sort_sides(sides, vertex_count);
    return sides;
}

Error edge_error(const EdgeSide& side, std::size_t uses, bool opposed) {
    const std::string edge =
        "the edge between vertices " + std::to_string(side.low) + " and " + std::to_string(side.high);
    const std::string triangle = std::to_string(side.owner / 3);
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
    const std::vector<EdgeSide> sides = sorted_sides(triangles, vertex_count);
    CutterTopology topology;
    topology.edges.reserve(sides.size() / 2);
    topology.triangle_edges.resize(triangles.size());
    for (std::size_t k = 0; k < sides.size(); k += 2) {
        const std::span<const EdgeSide> uses = edge_at(sides, k);
        const bool opposed = uses.size() == 2 && uses[0].upward != uses[1].upward;
        if (!opposed) return edge_error(uses[0], uses.size(), opposed);

        const bool first_left = uses[0].upward;
        topology.edges.push_back({uses[0].low, uses[0].high, uses[!first_left].owner / 3, uses[first_left].owner / 3});
        for (const EdgeSide& use : uses)
            topology.triangle_edges[use.owner / 3][use.owner % 3] = std::uint32_t(topology.edges.size() - 1);
    }
    return topology;
}

}  // namespace firma
