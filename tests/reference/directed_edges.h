// SPDX-License-Identifier: MIT
// Directed edges of facets and other polygons: does each go as often the other way?
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firma/grid.h"
#include "firma/vec.h"
#include "solid/solid_patch.h"

namespace firma::reference {

class DirectedEdges {
public:
    void add(const FacetPlace& facet);
    /// @param polygon  metres, on the surface grid
    void add(std::span<const Vec3> polygon);
    void add(std::span<const GridPoint> polygon);

    /// "open edge from ... to ..." for the first edge that does not go as often each way; empty when all do.
    /// @param shared  added to: edges that more than two polygons have
    std::string first_open(std::uint64_t* shared = nullptr);

private:
    struct Edge {
        GridPoint low, high;
        int way;
    };
    void add(const GridPoint& from, const GridPoint& to);

    std::vector<Edge> edges_;
};

}  // namespace firma::reference
