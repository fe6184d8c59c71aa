// SPDX-License-Identifier: MIT
// Faces of a block as users see them.
#pragma once

#include "firma/world.h"
#include "solid/face_shape.h"

namespace firma {

/// What a face is, but for its outline.
FaceInfo face_info(RoomId room, const Block& block, const FaceRecord& face, const PolygonShape& polygon);
Face describe_face(RoomId room, const Block& block, const FaceRecord& face);

/// What finds it again.
inline FaceRef ref_to(const Block& block, std::uint32_t slot) {
    const FaceRecord& face = block.faces[slot];
    return {face.id, block.corner(face, 0)};
}

}  // namespace firma
