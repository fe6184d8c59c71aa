// SPDX-License-Identifier: MIT
// Whether two convex polygons of a mesh share more than the mesh says, exactly: grid points, integers of 128 bits.
//
// For the faces of a level and the triangles of a cutter. A cutter against a solid, whose corners may be points of
// three planes, is FaceCutter's.
#pragma once

#include <span>

#include "geometry/grid_orient.h"

namespace firma {

/// Corners as numbers of points [n >= 3], convex and planar, with area; corners may lie along sides. A view.
struct MeshPolygon {
    std::span<const std::uint32_t> corners;
    AreaVector normal;  ///< of three of the corners: counter-clockwise
};

/// The normal of a convex planar polygon, from the first three corners that have area.
AreaVector polygon_normal(std::span<const InputPoint> points, std::span<const std::uint32_t> corners);

/// Whether two polygons share a point beyond the corners, or whole edges, whose numbers they share. Touching is
/// sharing.
bool polygons_cross(std::span<const InputPoint> points, const MeshPolygon& p, const MeshPolygon& q);

}  // namespace firma
