// SPDX-License-Identifier: MIT
// A convex body as a Solid: the common part of half spaces, exactly.
#pragma once

#include <optional>
#include <span>

#include "firma/solid.h"
#include "geometry/grid_box.h"
#include "solid/solid_face.h"

namespace firma {

/// @param planes  their fronts look out; repeated ones, and ones that bound nothing, do not matter
/// @return nothing where they have no volume in common, do not close it, or reach out of the world. Faces' sources are
///         the numbers of their planes.
std::optional<Solid> solid_of_planes(std::span<const Ref<const SolidPlane>> planes);

/// The box around a body, rounded; nothing likewise.
std::optional<GridBox> box_of_planes(std::span<const Ref<const SolidPlane>> planes);

}  // namespace firma
