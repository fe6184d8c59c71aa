// SPDX-License-Identifier: MIT
// The exact form of a polygon that is its own exact face: all corners on the input grid.
#pragma once

#include <span>

#include "solid/solid_face.h"

namespace firma {

/// Where its corners lie; not valid() where they lie on a line.
/// @param corners  on the input grid
Ref<const SolidPlane> plane_of_corners(std::span<const GridPoint> corners);

/// A side of a face in a plane.
SolidUse side_between(const InputPoint& from, const InputPoint& to, const Ref<const SolidPlane>& plane);

/// The polygon with edges and a plane.
Ref<const SolidFace> face_of_corners(std::span<const GridPoint> corners);

}  // namespace firma
