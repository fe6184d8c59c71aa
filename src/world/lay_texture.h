// SPDX-License-Identifier: MIT
// How the texture lies on a face that is to be drawn: as its file says, or by box_projection().
#pragma once

#include <array>
#include <span>

#include "firma/texture.h"
#include "firma/world.h"

namespace firma {

struct LaidTexture {
    TextureProjection lies;
    double width = 1, height = 1;  ///< what its coordinates are divided by

    std::array<float, 2> at(const Vec3& point) const {
        const auto [u, v] = lies.at(point);
        return {float(u / width), float(v / height)};
    }
};

/// @param face     its source, source_edit, material and normal are looked at
/// @param corners  the face's, metres
/// @param sizes    texels across and down, by material: where both are above zero, texels become repeats
LaidTexture lay_texture(const World& world, const FaceInfo& face, std::span<const Vec3> corners,
                        std::span<const std::array<double, 2>> sizes);

/// The direction along a face in which u grows and v stays, unit, and 1, or -1 where the picture lies mirrored. Of a
/// projection that maps the face to a line: that of box_projection().
/// @param normal  the face's, unit
std::array<float, 4> tangent_of(const TextureProjection& lies, const Vec3& normal);

}  // namespace firma
