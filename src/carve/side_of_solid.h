// SPDX-License-Identifier: MIT
// Whether a point lies in a solid, asked of its facets.
#pragma once

#include "firma/solid.h"

namespace firma {

/// Facets lie within so many surface steps of their exact faces.
inline constexpr int kFacetReach = 16;

/// 1 inside, -1 outside; 0 when that cannot be told: a facet lies nearer than that.
/// @param point  metres
int side_of_solid(const Solid& solid, const Vec3& point);

}  // namespace firma
