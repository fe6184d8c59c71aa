// SPDX-License-Identifier: MIT
// Faces of a block as users see them.
#pragma once

#include "firma/world.h"
#include "solid/face_shape.h"

namespace firma {

/// A face as users see it; its neighbours are looked for below `root`.
Face describe_face(const Node& root, const Block& block, const FaceRecord& face);
/// The same without its neighbours.
Face describe_face(const Block& block, const FaceRecord& face);

/// What finds it again.
inline FaceRef ref_to(const Block& block, std::uint32_t slot) {
    const FaceRecord& face = block.faces[slot];
    const GridPoint& corner = block.corner(face, 0);
    return {&block, slot, face.id, {corner.x, corner.y, corner.z}};
}

}  // namespace firma
