// SPDX-License-Identifier: MIT
// Whether two triangles of a mesh share more than the mesh says, exactly: grid points, integers of 128 bits.
#pragma once

#include <span>

#include "firma/cutter.h"
#include "geometry/grid_orient.h"

namespace firma {

/// Whether two triangles share a point beyond the vertices, or the edge, whose indices they share. Touching is sharing.
/// Both have area.
bool triangles_cross(std::span<const InputPoint> vertices, const CutterTriangle& t, const CutterTriangle& u);

}  // namespace firma
