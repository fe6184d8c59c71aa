// SPDX-License-Identifier: MIT
// The map from points to texture coordinates that a polygon's corners say.
#pragma once

#include <optional>
#include <span>

#include "firma/grid.h"
#include "firma/texture.h"

namespace firma {

/// Corners are moved by so much when they are snapped, and a little over; metres.
inline constexpr double kTextureSlack = 2 / kInputSteps;

/// Through three corners exactly, those that span the largest triangle or nearly so; the map changes in their plane
/// alone. It is that of all corners when at each other one it is off by no more than 1/1024 of a repeat, or than it
/// changes over the slack.
///
/// @param corners  metres [count >= 3]
/// @param uvs      of each, in repeats
/// @param slack    metres by which the file's own corners may be off
/// @return nothing where the corners lie on a line, no one map is that of all, or its numbers are too large to be used
std::optional<TextureProjection> fit_texture(std::span<const Vec3> corners, std::span<const TexturePoint> uvs,
                                             double slack = kTextureSlack);

}  // namespace firma
