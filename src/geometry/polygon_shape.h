// SPDX-License-Identifier: MIT
// A polygon made ready for casts: corners in metres and the normal, each component rounded at most once.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firma/grid.h"
#include "firma/polygon.h"
#include "firma/vec.h"

namespace firma {

/// Polygons of more corners are divided by whoever makes them.
inline constexpr int kMaxCorners = 64;

/// A view: whoever makes it keeps the corners.
struct PolygonShape {
    std::span<const Vec3> corners;
    Vec3 normal;  ///< twice the area long, square metres; components rounded once from their exact values
    double normal_length = 0;

    /// Not so of a facet that rounding flattened: all of it lies on its neighbours.
    bool has_area() const { return normal_length > 0; }
    std::size_t next(std::size_t k) const { return k + 1 < corners.size() ? k + 1 : 0; }
    Vec3 unit_normal() const { return normal * (1 / normal_length); }
};

/// Whether corners can be worked with at all: three or more, none outside the world (or no number).
bool usable_corners(std::span<const Vec3> corners);

/// A normal as exact sums of two doubles a component.
struct ExactNormal {
    std::array<std::array<double, 2>, 3> axis;
};

/// The normal's exact components, in square metres.
ExactNormal exact_normal(std::span<const Vec3> corners);

/// @param corners  a polygon as firma/polygon.h says; usable_corners() must hold
/// Exact at once when every corner lies on the input grid (double holds each term and sum), by wide integers otherwise.
PolygonShape make_shape(std::span<const Vec3> corners);

}  // namespace firma
