// SPDX-License-Identifier: MIT
// The grids that points lie on, and the distances that are accepted.
#pragma once

#include <cstdint>
#include <optional>

#include "firma/export.h"
#include "firma/vec.h"

namespace firma {

/// Steps of the surface grid in a metre (2^18). Every corner that a cast meets is a whole number of them.
inline constexpr double kSurfaceSteps = 262144;
/// Steps of the input grid in a metre (2^12). A vertex from a file is snapped to it, once.
inline constexpr double kInputSteps = 4096;
/// Surface steps in one input step.
inline constexpr std::int32_t kSurfacePerInput = 64;
/// Geometry lies within -8192 m <= x < 8192 m.
inline constexpr double kWorldRim = 8192;

/// A point of the surface grid, in steps of 1/262144 m: the full range of 32 bits is the world's range.
struct GridPoint {
    std::int32_t x = 0, y = 0, z = 0;

    std::int32_t& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    std::int32_t operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// Metres, exactly. Three products.
FIRMA_INLINE Vec3 to_metres(const GridPoint& p) {
    constexpr double kStep = 1 / kSurfaceSteps;
    return {p.x * kStep, p.y * kStep, p.z * kStep};
}

/// Snaps a point to the input grid: nearest multiple of 1/4096 m, halves to even.
///
/// @param point  metres
/// @return the point in surface steps (a multiple of 64 in each coordinate); nothing when a coordinate is not finite,
///         or lies outside the world once rounded.
/// Costs the same for every point; never allocates.
[[nodiscard]] FIRMA_EXPORT std::optional<GridPoint> snap(const Vec3& point);

/// Distances in metres. Nothing in a cast depends on them but `safe_fraction`.
struct Tolerance {
    /// How far from a surface a mover stops, measured along the contact normal.
    double contact_offset = 0.001;
};

}  // namespace firma
