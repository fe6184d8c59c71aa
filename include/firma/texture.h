// SPDX-License-Identifier: MIT
// How a texture lies on a face, as the level's file says it: a map from points of the face to texture coordinates.
#pragma once

#include <array>
#include <cstdint>

#include "firma/export.h"
#include "firma/vec.h"

namespace firma {

/// What texture coordinates count. In all of them u goes to the right in the picture, v down, and (0, 0) is the
/// picture's top left corner.
enum class TextureUnit : std::uint8_t {
    kTexels,   ///< pixels of the picture, whose size the file does not say: divided by it they are repeats
    kRepeats,  ///< the whole picture is 1 wide and 1 high
    kMetres,   ///< metres along the face: of no file, see box_projection()
};

/// (u, v).
using TexturePoint = std::array<double, 2>;

/// An affine map from a point p of a face, in metres, to texture coordinates:
/// u = u_axis . p + u_offset, v = v_axis . p + v_offset. What it says of points off the face means nothing.
struct TextureProjection {
    Vec3 u_axis, v_axis;  ///< units a metre
    double u_offset = 0, v_offset = 0;
    TextureUnit unit = TextureUnit::kRepeats;

    FIRMA_INLINE TexturePoint at(const Vec3& point) const {
        return {dot(u_axis, point) + u_offset, dot(v_axis, point) + v_offset};
    }
    FIRMA_INLINE friend bool operator==(const TextureProjection& a, const TextureProjection& b) {
        return a.u_axis == b.u_axis && a.v_axis == b.v_axis && a.u_offset == b.u_offset && a.v_offset == b.v_offset &&
               a.unit == b.unit;
    }
};

/// The largest number in a projection: texture coordinates in the world are then numbers that a float can hold.
inline constexpr double kMaxTextureNumber = 0x1p64;
/// Of faces without a projection.
inline constexpr std::uint32_t kNoTexture = ~0u;

/// Whether it can be used: its numbers are finite and at most kMaxTextureNumber, its unit is one of the three. Costs a
/// few comparisons.
[[nodiscard]] FIRMA_EXPORT bool is_usable(const TextureProjection& projection);

/// For faces whose file says nothing, and for those that edits made: straight along the axis nearest to the normal (of
/// equally near ones z, then x), in metres from the world's origin; seen from the front it is not mirrored. Costs a few
/// comparisons; never allocates.
/// @param normal  of any length
[[nodiscard]] FIRMA_EXPORT TextureProjection box_projection(const Vec3& normal);

}  // namespace firma
