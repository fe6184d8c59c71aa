// SPDX-License-Identifier: MIT
// A plane given in floating point, replaced by one through three points of the input grid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "brush/winding.h"
#include "firma/grid.h"

namespace firma {

struct FittedPlane {
    /// What the three points are, in the file's units.
    enum class Points : std::uint8_t { kWhole, kEighths, kGrid, kAxial };

    GridPoint points[3];  ///< counter-clockwise seen from the front
    Points kind = Points::kGrid;
    double shift = 0;  ///< metres by which the plane was moved, at the corner where it is most
};

/// Whether the plane is exactly perpendicular to an axis; then that axis.
std::optional<int> axis_of(const FloatPlane& plane);

/// An axial plane at the nearest distance on the grid; nothing when that is outside the world.
///
/// @param plane  in the file's units
/// @param scale  metres a unit
std::optional<FittedPlane> fit_axial_plane(const FloatPlane& plane, int axis, double scale);

/// The plane through three of the corners, moved to points of a lattice, that lies nearest to all corners.
///
/// People and editors place vertices at whole units: when three corners are within a hundredth of such points and the
/// plane through those fits, it is the plane that was meant, and planes that met in one vertex meet there again.
/// Eighths of a unit come next, then any points of the grid.
///
/// @param corners  of the faces that lie on the plane, in the file's units
/// @return nothing when no three corners in the world span a plane
std::optional<FittedPlane> fit_plane(const FloatPlane& plane, std::span<const Vec3> corners, double scale);

/// For a plane without faces: through points near its foot.
std::optional<FittedPlane> fit_bare_plane(const FloatPlane& plane, double scale);

}  // namespace firma
