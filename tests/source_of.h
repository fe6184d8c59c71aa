// SPDX-License-Identifier: MIT
// Where the face that a cast met came from: its index in the file.
#pragma once

#include "firma/world.h"

namespace firma {

inline std::uint32_t source_of(const World& world, const Hit& hit) {
    const std::optional<FaceInfo> face = world.face_info(hit.face);
    return face ? face->source : ~0u;
}

}  // namespace firma
