// SPDX-License-Identifier: MIT
// The edges of a closed mesh of triangles, each with the two triangles beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/cutter.h"
#include "firma/result.h"

namespace firma {

/// a < b. The way a -> b runs counter-clockwise around triangle `left`, b -> a around `right`.
struct CutterEdge {
    std::uint32_t a = 0, b = 0;
    std::uint32_t left = 0, right = 0;
};

struct CutterTopology {
    std::vector<CutterEdge> edges;  ///< in order of (a, b)
    /// Edge k of a triangle runs from its corner k to the next.
    std::vector<std::array<std::uint32_t, 3>> triangle_edges;
};

/// Time and memory in proportion to triangles and vertices.
///
/// @param triangles     corners below vertex_count (FIRMA_ASSERT), three different ones in each
/// @param vertex_count  the arrays made have one entry a vertex: no more than a few times the triangles
/// @return the edges, or kMalformed for the first edge in their order that not exactly two triangles use, one each way
Result<CutterTopology> cutter_topology(std::span<const CutterTriangle> triangles, std::size_t vertex_count);

}  // namespace firma
