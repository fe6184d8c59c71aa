// SPDX-License-Identifier: MIT
// How a texture lies on a side of a .map, as a projection.
#pragma once

#include <optional>

#include "brush/parse_map.h"
#include "firma/texture.h"

namespace firma {

/// Standard and Valve 220 give texels, brush primitives repeats. A scale of 0 is 1, as in the games.
/// @return nothing where the side has no plane, or its numbers are too large to be used
std::optional<TextureProjection> texture_of_side(const MapSide& side, double metres_a_unit);

}  // namespace firma
