// SPDX-License-Identifier: MIT
// Faces of a block as users see them.
#pragma once

#include "firma/world.h"
#include "solid/face_shape.h"

namespace firma {

/// What a face is, but for its outline.
FaceInfo face_info(RoomId room, const Block& block, const FaceRecord& face, const PolygonShape& polygon);
/// Of the exact plane that a face was cut from; (0, 0, 0) of one that is its own and has no area.
Vec3 unit_normal_of(const Block& block, const FaceRecord& face);
Face describe_face(RoomId room, const Block& block, const FaceRecord& face);

/// What finds it again.
inline FaceRef ref_to(const Block& block, std::uint32_t slot) {
    const FaceRecord& face = block.faces[slot];
    return {face.id, block.corner(face, 0)};
}

}  // namespace firma
