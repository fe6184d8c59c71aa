// SPDX-License-Identifier: MIT
// Seeded polygons on the surface grid: always convex, exactly planar, with area.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "firma/grid.h"
#include "firma/level.h"
#include "firma/vec.h"
#include "scenes/rng.h"

namespace firma::scenes {

using GridPolygon = std::vector<GridPoint>;

/// A position or direction in whole steps of the surface grid, with room to spare.
struct Steps {
    std::int64_t x = 0, y = 0, z = 0;

    friend bool operator==(const Steps&, const Steps&) = default;
};
inline Steps operator+(const Steps& a, const Steps& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Steps operator-(const Steps& a, const Steps& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Steps operator*(const Steps& a, std::int64_t s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Steps steps(const GridPoint& p) {
    return {p.x, p.y, p.z};
}
/// Exact below 2^53 steps.
inline Vec3 to_metres(const Steps& s) {
    return {double(s.x) / kSurfaceSteps, double(s.y) / kSurfaceSteps, double(s.z) / kSurfaceSteps};
}

inline constexpr std::int64_t kMetre = 262144;  ///< in surface steps
inline constexpr std::int64_t kInput = kSurfacePerInput;

/// Each coordinate within -reach..reach.
Steps random_steps(Rng& rng, std::int64_t reach);

/// The nearest point of the world's range, on multiples of `step`.
GridPoint in_world(const Steps& s, std::int64_t step = 1);

/// Whether a x b = 0, computed modulo 2^64: never false when it is, and true by accident all but never.
bool along_one_line(const Steps& a, const Steps& b);

bool all_in_world(std::span<const Steps> corners);

/// Three mutually perpendicular whole vectors of the same whole length: a turned frame in which lengths are exact.
/// Source: L. Euler's and O. Rodrigues' parametrisation of rotations by whole quaternions.
struct WholeFrame {
    Steps x, y, z;
    std::int64_t length = 1;

    Steps at(std::int64_t i, std::int64_t j, std::int64_t k) const { return x * i + y * j + z * k; }
};
/// @param most  of a quaternion's entries: the length is at most 4 * most^2
WholeFrame random_frame(Rng& rng, int most);

/// Corners of a convex polygon of the whole plane, counter-clockwise, within -radius..radius, not all on one line.
/// @param points     thrown to take the hull of, >= 3
/// @param collinear  also keep some points along the sides
std::vector<std::pair<std::int64_t, std::int64_t>> lattice_polygon(Rng& rng, std::int64_t radius, int points,
                                                                   bool collinear);

/// A triangle with corners within `reach` of the centre, on multiples of `step`.
GridPolygon random_triangle(Rng& rng, const Steps& centre, std::int64_t reach, std::int64_t step);

/// A polygon of a random whole plane, about `reach` from the centre to its corners, on multiples of `step`, at most 64
/// corners.
GridPolygon random_polygon(Rng& rng, const Steps& centre, std::int64_t reach, std::int64_t step, int points,
                           bool collinear = false);

/// The corners `origin + i u + j v`; nothing when one lies outside the world.
GridPolygon on_plane(const Steps& origin, const Steps& u, const Steps& v,
                     std::span<const std::pair<std::int64_t, std::int64_t>> corners);

/// The other way round.
GridPolygon turned_over(const GridPolygon& polygon);

std::vector<Vec3> to_metres(const GridPolygon& polygon);

/// Not along any corner in particular; in double, for aiming.
Vec3 unit_normal(const GridPolygon& polygon);

/// A level of these faces, vertices shared where they coincide; `source` is the index.
Level level_of(std::span<const GridPolygon> polygons, const std::vector<bool>& two_sided = {});

}  // namespace firma::scenes
