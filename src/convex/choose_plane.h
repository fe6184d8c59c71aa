// SPDX-License-Identifier: MIT
// Which plane divides a solid next.
#pragma once

#include <vector>

#include "convex/sides.h"

namespace firma {

/// How much each side of a reflex edge matters, >= 0; of others 0.
using ReflexWeights = std::vector<double>;

/// Divides by one of the planes of the faces at reflex edges: of those that resolve much and cross little a few are
/// tried, and the one that leaves least to be done is taken. The first of several, in the order of planes.
/// @param solid  with a reflex edge
/// @return false where the halves do not close, or no plane resolves anything
bool divide_best(ConvexSpace& space, const SolidSides& solid, const ReflexWeights& weights,
                 std::vector<FaceSides>& parts);

}  // namespace firma
