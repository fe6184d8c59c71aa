// SPDX-License-Identifier: MIT
// The face of a brush's side in double: for choosing and measuring, never for geometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firma/vec.h"

namespace firma {

/// Cutting out all faces of a brush takes time that grows with the square of its sides. The sum of these squares over a
/// file; seventy times the most seen.
inline constexpr std::uint64_t kMostSidePairs = std::uint64_t(1) << 26;

/// In front of it, where normal . p > distance, lies the outside. The normal is about 1 long.
struct FloatPlane {
    Vec3 normal;
    double distance = 0;
};

/// Counter-clockwise seen from the front of normal; nothing when the points lie on a line.
std::optional<FloatPlane> float_plane(const Vec3& a, const Vec3& b, const Vec3& c);

/// The part of plane `which` that lies behind or on all the others, counter-clockwise seen from outside; empty when
/// there is none. Two planes that are the same leave the face to both.
///
/// @param reach  half the side of the square about the origin's foot that is cut down; what has no end is this large
std::vector<Vec3> winding(std::span<const FloatPlane> planes, std::size_t which, double reach);

/// Corners of a winding nearer to each other are one; units.
constexpr double kSameCorner = 1.0 / 128;

/// Corners nearer to the one before than `distance` left out.
void merge_corners(std::vector<Vec3>& corners, double distance);

/// Of a plane polygon.
double area(std::span<const Vec3> corners);

}  // namespace firma
