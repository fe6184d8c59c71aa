// SPDX-License-Identifier: MIT
// Closed pieces of a mesh, exactly: which way one is turned, and how often others wind around it.
//
// For points of the grid alone. Where a point of three planes lies, side_of_cutter() says; where any point in metres
// lies, by casts in double, see_first().
#pragma once

#include "geometry/grid_box.h"
#include "geometry/polygons_cross.h"

namespace firma {

/// Six times the volume between a convex polygon and a point: summed over a closed piece it is positive where that is
/// turned outward. A triangle's has 83 bits.
inline Int128 six_times_cone(std::span<const InputPoint> points, std::span<const std::uint32_t> corners,
                             const InputPoint& apex) {
    const InputPoint& first = points[corners[0]];
    Int128 sum = 0;
    for (std::size_t k = 2; k < corners.size(); ++k)
        sum += height(apex, area_vector(first, points[corners[k - 1]], points[corners[k]]), first);
    return sum;
}

/// The same on the surface grid: a triangle's has 99 bits.
Int128 six_times_cone(std::span<const GridPoint> corners, const GridPoint& apex);

/// A ray along x from the middle of an edge: no other piece passes through that, even where pieces share a vertex.
class EdgeRay {
public:
    EdgeRay(const InputPoint& a, const InputPoint& b)
        : x_(std::int64_t(a.x) + b.x), y_(std::int64_t(a.y) + b.y), z_(std::int64_t(a.z) + b.z) {}

    /// Around it, surface steps.
    GridBox box() const;

    /// How it passes through a polygon: 1 outward, -1 inward, 0 not at all. The sum over a closed piece is how often
    /// that winds around the edge.
    int passage(std::span<const InputPoint> points, const MeshPolygon& polygon) const;

private:
    int turn(const InputPoint& a, const InputPoint& b) const;

    std::int64_t x_, y_, z_;  ///< where it starts, half steps
};

}  // namespace firma
