// SPDX-License-Identifier: MIT
// Merges triangles of a face into convex polygons that are exactly planar.
//
// Source: S. Hertel, K. Mehlhorn, Fast Triangulation of Simple Polygons, 1983.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "geometry/clip_ears.h"
#include "geometry/flat_point.h"

namespace firma {

/// Facets of one face: facet k has corners `corners[first[k]] .. corners[first[k + 1]]`, indices into the face's
/// points, counter-clockwise from the front.
struct Facets {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first;  ///< count + 1 entries

    std::size_t count() const { return first.empty() ? 0 : first.size() - 1; }
};

/// Keeps its scratch from call to call.
class FacetMerger {
public:
    /// Removes each diagonal in turn, longest first, where the piece stays convex (corners along sides are allowed),
    /// has at most kMaxCorners corners, and is exactly planar.
    ///
    /// @param points, flat  the face's corners in space and projected; every triangle has area in the projection
    void merge(std::span<const GridPoint> points, std::span<const FlatPoint> flat, const Triangles& triangles,
               Facets& facets);

private:
    struct Side {
        std::uint32_t before = 0, after = 0;
        std::uint32_t corner = 0;  ///< where it begins
        bool gone = false;
    };
    struct Diagonal {
        double length = 0;
        std::uint32_t side = 0;
    };

    void find_diagonals(std::span<const GridPoint> points, const Triangles& triangles);
    bool convex_without(std::uint32_t side, std::uint32_t twin, std::span<const FlatPoint> flat) const;
    void remove(std::uint32_t side, std::uint32_t twin);
    std::uint32_t piece_of(std::uint32_t triangle);
    void write(Facets& facets);

    std::vector<Side> sides_;
    std::vector<Diagonal> diagonals_;    ///< those between triangles of one plane
    std::vector<std::uint32_t> pieces_;  ///< per triangle: itself, or one that it was merged into
    std::vector<std::uint32_t> sizes_;   ///< corners, for each that stands for its piece
};

}  // namespace firma
