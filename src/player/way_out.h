// SPDX-License-Identifier: MIT
// Out of what came where a player is.
#pragma once

#include <optional>

#include "player/player_shape.h"

namespace firma {

/// Whether it overlaps nothing there, its middle in air.
bool is_free(const PostureIn& posture, const Vec3& feet);

/// A free place near: out of what it overlaps the shortest ways, one after another; else the nearest of rings of places
/// around, and from there back as far as nothing is met. Never in an exterior room of several, but from there.
/// @param room      where its middle was last in air; invalid: not known
/// @param reach     metres
/// @param thorough  look on dense rings too: 2,630 places, and the ways of what is overlapped there
/// @return the feet there; nothing where none was found
std::optional<Vec3> way_out(const World& world, const PostureIn& posture, const PlayerShapeData& shape,
                            const Vec3& feet, RoomId room, double reach, double offset, bool thorough);

}  // namespace firma
