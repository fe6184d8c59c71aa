// SPDX-License-Identifier: MIT
// Texture projections by themselves.
#include "firma/texture.h"

namespace firma {
namespace {

bool is_small(double number) {
    return number >= -kMaxTextureNumber && number <= kMaxTextureNumber;  // NaN is not
}
bool is_small(const Vec3& axis) {
    return is_small(axis.x) && is_small(axis.y) && is_small(axis.z);
}

}  // namespace

bool is_usable(const TextureProjection& projection) {
    return is_small(projection.u_axis) && is_small(projection.v_axis) && is_small(projection.u_offset) &&
           is_small(projection.v_offset) && projection.unit <= TextureUnit::kMetres;
}

TextureProjection box_projection(const Vec3& normal) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    TextureProjection box;
    box.unit = TextureUnit::kMetres;
    if (z >= x && z >= y) {
        box.u_axis = {normal.z < 0 ? -1.0 : 1.0, 0, 0};
        box.v_axis = {0, -1, 0};
    } else if (x >= y) {
        box.u_axis = {0, normal.x < 0 ? -1.0 : 1.0, 0};
        box.v_axis = {0, 0, -1};
    } else {
        box.u_axis = {normal.y < 0 ? 1.0 : -1.0, 0, 0};
        box.v_axis = {0, 0, -1};
    }
    return box;
}

}  // namespace firma
