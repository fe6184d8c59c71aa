// SPDX-License-Identifier: MIT
// Directed edges.
#include "tests/reference/directed_edges.h"
#include "tests/reference/facet_corners.h"

#include <algorithm>
#include <cstdio>

namespace firma::reference {
namespace {

GridPoint on_grid(const Vec3& p) {
    GridPoint made;
    for (int axis = 0; axis < 3; ++axis) made[axis] = std::int32_t(p[axis] * kSurfaceSteps);
    return made;
}

std::string text_of(const GridPoint& p) {
    const Vec3 metres = to_metres(p);
    char text[100];
    std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", metres.x, metres.y, metres.z);
    return text;
}

}  // namespace

void DirectedEdges::add(const GridPoint& from, const GridPoint& to) {
    if (from == to) return;  // of a facet that rounding left no length: it cancels itself
    edges_.push_back(from < to ? Edge{from, to, 1} : Edge{to, from, -1});
}

void DirectedEdges::add(const FacetPlace& facet) {
    const auto corners = grid_corners_of(facet);
    for (std::size_t k = 0; k < corners.size(); ++k) add(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
}

void DirectedEdges::add(std::span<const Vec3> polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k)
        add(on_grid(polygon[k]), on_grid(polygon[k + 1 < polygon.size() ? k + 1 : 0]));
}

void DirectedEdges::add(std::span<const GridPoint> polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) add(polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0]);
}

std::string DirectedEdges::first_open(std::uint64_t* shared) {
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    for (std::size_t k = 0, end = 0; k < edges_.size(); k = end) {
        int sum = 0;
        for (end = k; end < edges_.size() && edges_[end].low == edges_[k].low && edges_[end].high == edges_[k].high;
             ++end)
            sum += edges_[end].way;
        if (sum != 0 || (end - k) % 2 != 0)
            return "open edge from " + text_of(edges_[k].low) + " to " + text_of(edges_[k].high);
        if (shared && end - k > 2) ++*shared;
    }
    return "";
}

}  // namespace firma::reference
