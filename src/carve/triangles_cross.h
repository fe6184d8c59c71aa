// SPDX-License-Identifier: MIT
// Whether two triangles of a mesh share more than the mesh says, exactly: grid points, integers of 128 bits.
#pragma once

#include <span>

#include "firma/cutter.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Twice the area vector of a triangle, counter-clockwise; components have 55 bits.
struct AreaVector {
    std::int64_t x = 0, y = 0, z = 0;
};

AreaVector area_vector(const InputPoint& a, const InputPoint& b, const InputPoint& c);

/// Whether two triangles share a point beyond the vertices, or the edge, whose indices they share. Touching is sharing.
/// Both have area.
bool triangles_cross(std::span<const InputPoint> vertices, const CutterTriangle& t, const CutterTriangle& u);

}  // namespace firma
