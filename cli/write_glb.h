// SPDX-License-Identifier: MIT
// Writes a world as binary glTF 2.0, for viewers and engines. docs/formats.md says what is in it.
#pragma once

#include <functional>
#include <string_view>

#include "cli/glb_parts.h"
#include "firma/world.h"

namespace firma::cli {

/// Takes twice the file in memory while it lasts.
///
/// @param parts  of this world; their file_bytes() judged before
/// @param up     the axis of the world that points up, 0 .. 2; glTF's own is y. Turns the node, not the positions
/// @param put    takes the file piece by piece; what it throws ends the writing and comes back from here
void write_glb(const World& world, const GlbParts& parts, int up, const std::function<void(std::string_view)>& put);

}  // namespace firma::cli
