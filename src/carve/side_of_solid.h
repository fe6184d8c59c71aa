// SPDX-License-Identifier: MIT
// Whether a point lies in a solid: by its facets, and where these are too near to tell, by its exact faces.
#pragma once

#include <vector>

#include "carve/exact_ray.h"
#include "firma/solid.h"
#include "geometry/exact_point.h"
#include "solid/solid_patch.h"

namespace firma {

/// Facets lie within so many surface steps of their exact faces.
inline constexpr int kFacetReach = 16;

/// 1 inside, -1 outside; 0 for a point on the surface, or where every line tried meets an edge. Exact.
int side_of_solid(const Solid& solid, const ExactPoint& point);

/// The edges of a face of a patch, to be met by a ray; their planes must be settled.
void append_edges(const SolidPatch& patch, const PatchFace& face, std::vector<ExactRay::Edge>& edges);

}  // namespace firma
