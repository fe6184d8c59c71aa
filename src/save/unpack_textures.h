// SPDX-License-Identifier: MIT
// How textures lie, of a saved world.
#pragma once

#include <memory>

#include "save/entries.h"
#include "world/face_textures.h"

namespace firma {

/// Null where the file says nothing of it.
std::shared_ptr<const FaceTextures> unpack_textures(Sections& sections, Damage& damage);

}  // namespace firma
