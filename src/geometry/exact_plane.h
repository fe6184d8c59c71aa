// SPDX-License-Identifier: MIT
// Planes through points of the input grid, as integers.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"
#include "geometry/exact_integer.h"
#include "geometry/flat_point.h"

namespace firma {

/// Coordinates of the input grid lie between minus this and this.
constexpr std::int32_t kRimSteps = std::int32_t(kWorldRim * kInputSteps);

/// A point of the input grid, in steps of 1/4096 m: 26 bits signed each.
struct InputPoint {
    std::int32_t x = 0, y = 0, z = 0;

    std::int32_t& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    std::int32_t operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    friend bool operator==(const InputPoint&, const InputPoint&) = default;
    friend auto operator<=>(const InputPoint&, const InputPoint&) = default;
};

/// Whether a point of the surface grid lies on the input grid.
inline bool on_input_grid(const GridPoint& p) {
    return ((p.x | p.y | p.z) & (kSurfacePerInput - 1)) == 0;
}
inline InputPoint to_input(const GridPoint& p) {
    return {p.x / kSurfacePerInput, p.y / kSurfacePerInput, p.z / kSurfacePerInput};
}
inline GridPoint to_surface(const InputPoint& p) {
    return {p.x * kSurfacePerInput, p.y * kSurfacePerInput, p.z * kSurfacePerInput};
}

/// normal . p + offset = 0, in input steps; in front where that is positive. Divided by the greatest common divisor of
/// all four, so coplanar faces that look the same way have equal planes. Components of the normal have up to 53 bits
/// with sign, the offset up to 78 (three grid points). A plane holds a point of the world, be it turned by quarter
/// turns and moved by whole steps since (a Solid that cuts): |offset| <= size * 2^25. With its count of users a stored
/// one fills one line of a cache: solids are made of millions.
struct Plane {
    std::int64_t normal[3] = {0, 0, 0};
    std::uint64_t offset_low = 0;
    std::int64_t offset_high = 0;
    double d = 0;     ///< offset() as a double, the nearest one
    double size = 0;  ///< |normal[0]| + |normal[1]| + |normal[2]|, rounded up

    Int128 offset() const { return Int128(offset_high) << 64 | offset_low; }
    void set_offset(Int128 offset) {
        offset_low = std::uint64_t(offset);
        offset_high = std::int64_t(offset >> 64);
    }
    /// `normal` as doubles, exactly.
    Vec3 direction() const { return {double(normal[0]), double(normal[1]), double(normal[2])}; }

    Vec3 unit_normal() const { return direction() * (1 / length(direction())); }

    friend bool operator==(const Plane& a, const Plane& b) {
        return a.normal[0] == b.normal[0] && a.normal[1] == b.normal[1] && a.normal[2] == b.normal[2] &&
               a.offset_low == b.offset_low && a.offset_high == b.offset_high;
    }
    bool valid() const { return normal[0] != 0 || normal[1] != 0 || normal[2] != 0; }
    /// The axis of the normal's largest component; the first of several.
    int dominant_axis() const {
        const auto size_of = [this](int axis) { return normal[axis] < 0 ? -normal[axis] : normal[axis]; };
        const int axis = size_of(1) > size_of(0) ? 1 : 0;
        return size_of(2) > size_of(axis) ? 2 : axis;
    }
    /// From the front, along that axis.
    FlatView front_view() const {
        const int axis = dominant_axis();
        return {axis, normal[axis] < 0};
    }
};

/// Counter-clockwise seen from the front. Not valid() when the points lie on a line.
Plane plane_through(const InputPoint& a, const InputPoint& b, const InputPoint& c);

/// The plane of these numbers; not valid() unless they are as such a plane has them: components that fit and have no
/// common divisor, and an offset that lets it pass through the world. For numbers from outside.
Plane plane_of_numbers(const std::int64_t (&normal)[3], Int128 offset);

/// The same plane seen from behind.
Plane flipped(const Plane& plane);

/// An auxiliary plane through the edge a b and one grid step along the dominant axis of `face`, a plane that holds the
/// edge: never parallel to it.
Plane edge_plane(const InputPoint& a, const InputPoint& b, const Plane& face);

/// The plane axis = step, looking toward greater coordinates.
Plane axis_plane(int axis, std::int32_t step);
/// Across an axis at a place in input steps, rounded to 2^-16 of one; looking toward greater coordinates.
Plane fine_plane(int axis, double at);

/// A component of a.normal x b.normal, for (i, j) = (1, 2), (2, 0), (0, 1): at most 2^105.
inline Int128 normal_minor(const Plane& a, const Plane& b, int i, int j) {
    return Int128(a.normal[i]) * b.normal[j] - Int128(a.normal[j]) * b.normal[i];
}

/// Whether two planes are parallel, exactly.
bool exact_parallel(const Plane& a, const Plane& b);

/// Sign of det(a, b, c) of the normals, exactly: 0 where the planes do not meet in one point.
int exact_turn(const Plane& a, const Plane& b, const Plane& c);

}  // namespace firma
