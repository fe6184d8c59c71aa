// SPDX-License-Identifier: MIT
// The map from points to texture coordinates that a polygon's corners say.
//
// With p0, p1, p2 the three corners, a = p1 - p0, b = p2 - p0 and n = a x b, the vectors b x n / n.n and n x a / n.n
// are 1 along one of a and b and 0 along the other. So u's axis is (u1 - u0) (b x n) / n.n + (u2 - u0) (n x a) / n.n.
#include "level/fit_texture.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace firma {
namespace {

constexpr double kSameRepeats = 1.0 / 1024;  // half a texel of a picture of 512

/// The corner farthest from the first, and the one farthest from the line through both.
std::array<std::size_t, 3> wide_triangle(std::span<const Vec3> corners) {
    std::array<std::size_t, 3> wide{0, 0, 0};
    double most = 0;
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const double away = length(corners[k] - corners[0]);
        if (away > most) most = away, wide[1] = k;
    }
    most = 0;
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const double twice_area = length(cross(corners[wide[1]] - corners[0], corners[k] - corners[0]));
        if (twice_area > most) most = twice_area, wide[2] = k;
    }
    return wide;
}

}  // namespace

std::optional<TextureProjection> fit_texture(std::span<const Vec3> corners, std::span<const TexturePoint> uvs,
                                             double slack) {
    const std::array<std::size_t, 3> wide = wide_triangle(corners);
    const std::size_t first = wide[0], second = wide[1], third = wide[2];
    const Vec3 a = corners[second] - corners[first], b = corners[third] - corners[first], n = cross(a, b);
    const double square = dot(n, n);
    if (!(square > 0)) return std::nullopt;
    const Vec3 along_a = cross(b, n), along_b = cross(n, a);
    const auto axis = [&](std::size_t which) {
        const double by_a = uvs[second][which] - uvs[first][which], by_b = uvs[third][which] - uvs[first][which];
        return along_a * (by_a / square) + along_b * (by_b / square);
    };
    TextureProjection map;
    map.u_axis = axis(0);
    map.v_axis = axis(1);
    map.u_offset = uvs[first][0] - dot(map.u_axis, corners[first]);
    map.v_offset = uvs[first][1] - dot(map.v_axis, corners[first]);
    if (!is_usable(map)) return std::nullopt;
    const double most_u = std::max(kSameRepeats, slack * length(map.u_axis));
    const double most_v = std::max(kSameRepeats, slack * length(map.v_axis));
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const TexturePoint there = map.at(corners[k]);
        if (!(std::fabs(there[0] - uvs[k][0]) <= most_u) || !(std::fabs(there[1] - uvs[k][1]) <= most_v))
            return std::nullopt;
    }
    return map;
}

}  // namespace firma
