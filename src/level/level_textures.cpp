// SPDX-License-Identifier: MIT
// The texture projections of a level's faces.
#include "level/level_textures.h"

#include <vector>

namespace firma {

std::shared_ptr<const FaceTextures> textures_of(const Level& level) {
    FaceTextureBuilder builder;
    builder.add_projections(level.textures);
    std::vector<GridPoint> outline;
    for (const LevelFace& face : level.faces) {
        if (face.texture == kNoTexture) continue;
        outline.clear();
        for (std::uint32_t c = 0; c < face.corner_count; ++c)
            outline.push_back(level.vertices[level.corners[face.first_corner + c]]);
        builder.add(face.source, face.texture, outline);
    }
    return builder.take();
}

}  // namespace firma
