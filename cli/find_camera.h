// SPDX-License-Identifier: MIT
// A place from which what blasts did is seen well.
#pragma once

#include <optional>

#include "draw/draw_view.h"
#include "firma/world.h"

namespace firma::cli {

/// Of some hundred seeded views from the air of `before` toward new faces of `after`, the one that shows them
/// best: on a third of the picture, or as near to that as there is. Nothing where an edit made none.
///
/// @param size  its width, height, zoom and up are kept
std::optional<draw::Camera> find_camera(const World& before, const World& after, const draw::Camera& size);

}  // namespace firma::cli
