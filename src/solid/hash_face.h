// SPDX-License-Identifier: MIT
// What a face adds to the hash of a solid's points.
#pragma once

#include "solid/hash_points.h"
#include "solid/solid_face.h"

namespace firma {

/// @param sign  1: it comes; -1: it goes
void add_face(const SolidFace& face, int sign, PointHash& hash);
/// The exact face of a facet.
void add_face(const Block& block, const FaceRecord& face, int sign, PointHash& hash);

}  // namespace firma
