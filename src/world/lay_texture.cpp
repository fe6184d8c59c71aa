// SPDX-License-Identifier: MIT
// How the texture lies on a face that is to be drawn.
#include "world/lay_texture.h"

#include <cmath>

namespace firma {
namespace {

/// Of the parallelogram that the projection's axes span along the face, to the product of their lengths: below it the
/// directions are lost to rounding.
constexpr double kLeastArea = 0x1p-30;

}  // namespace

LaidTexture lay_texture(const World& world, const FaceInfo& face, std::span<const Vec3> corners,
                        std::span<const std::array<double, 2>> sizes) {
    LaidTexture laid{texture_of(world, face, corners).value_or(box_projection(face.normal))};
    if (laid.lies.unit != TextureUnit::kTexels || face.material >= sizes.size()) return laid;
    const auto [across, down] = sizes[face.material];
    if (!(across > 0 && down > 0)) return laid;
    laid.width = across;
    laid.height = down;
    laid.lies.unit = TextureUnit::kRepeats;
    return laid;
}

std::array<float, 4> tangent_of(const TextureProjection& lies, const Vec3& normal) {
    const Vec3 &u = lies.u_axis, &v = lies.v_axis;
    // With v' the part of v along the face, v' does not change along n x v', and u grows there by dot(u, n x v').
    const Vec3 across = cross(normal, v - normal * dot(normal, v));
    const double grows = dot(u, across);
    if (!(std::fabs(grows) > kLeastArea * (length(u) * length(v)))) return tangent_of(box_projection(normal), normal);
    const double side = grows < 0 ? -1 : 1;
    const Vec3 tangent = across * (side / length(across));
    return {float(tangent.x), float(tangent.y), float(tangent.z), float(side)};
}

}  // namespace firma
