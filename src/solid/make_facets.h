// SPDX-License-Identifier: MIT
// Makes the facets that casts meet from a face of the exact solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "geometry/flat_point.h"
#include "geometry/triangulate.h"
#include "solid/check_loops.h"
#include "solid/merge_facets.h"

namespace firma {

/// Keeps its scratch from call to call: once that has grown, nothing is allocated.
class FacetMaker {
public:
    /// Divides a face whose corners were rounded to the surface grid, and are only nearly of one plane, into convex
    /// polygons that are exactly planar, of at most kMaxCorners corners: check_polygon() holds for each.
    ///
    /// @param points     corners of all loops in a row [n >= 3]; the outer loop counter-clockwise seen from the front,
    ///                   holes clockwise
    /// @param loop_ends  end of each loop in `points`; the first loop is the outer one
    /// @param view       of the face's exact plane from the front
    /// @return true: seen along the axis, the facets cover the face once, their sides along its loops are the loops'
    ///         edges, and every other side is shared by two. A corner stays one even where it lies along a side.
    ///         false when loops in the projection touch or cross themselves or each other, a corner repeats another, a
    ///         loop runs the wrong way around or has no area, or a hole does not lie directly inside the outer loop;
    ///         nothing is said about `facets` then.
    bool make(std::span<const GridPoint> points, std::span<const std::uint32_t> loop_ends, FlatView view,
              Facets& facets);

    /// What make() refuses: triangles of the loops as they lie exactly, then rounded. They cover the face, but rounding
    /// may fold some over others, or leave them without area; their sides cancel all the same, but for the loops'.
    ///
    /// @param exact  the corners before rounding, input steps [n]
    void make_folded(std::span<const GridPoint> points, std::span<const Vec3> exact,
                     std::span<const std::uint32_t> loop_ends, FlatView view, Facets& facets);

private:
    bool make_quad(std::span<const GridPoint> points, Facets& facets) const;
    bool convex() const;
    bool planar(std::span<const GridPoint> points) const;

    std::vector<FlatPoint> flat_;
    Triangles triangles_;
    LoopChecker checker_;
    Triangulator triangulator_;
    FacetMerger merger_;
};

}  // namespace firma
