// SPDX-License-Identifier: MIT
// The texture projections of a level's faces, by source, as a world keeps them.
#pragma once

#include <memory>

#include "firma/level.h"
#include "world/face_textures.h"

namespace firma {

/// @param level  judged
/// @return null where no face has one
std::shared_ptr<const FaceTextures> textures_of(const Level& level);

}  // namespace firma
