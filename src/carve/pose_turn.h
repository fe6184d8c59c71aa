// SPDX-License-Identifier: MIT
// The turn of a pose: as numbers, and as a quarter turn with a move by whole steps, where it is one.
#pragma once

#include <optional>

#include "firma/cutter.h"
#include "geometry/exact_plane.h"

namespace firma {

/// Rows of a rotation times a scale.
struct PoseTurn {
    Vec3 row[3];

    Vec3 turned(const Vec3& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
};

/// Nothing for a rotation that is zero or not finite.
std::optional<PoseTurn> turn_of(const Quaternion& rotation, double scale);

/// One of the 24 turns of the axes, then a move: points of the grids stay points of the grids, planes of three points
/// stay such planes.
struct GridTurn {
    int from[3] = {0, 1, 2};  ///< the axis that comes to lie along each axis
    int sign[3] = {1, 1, 1};  ///< and whether backward
    InputPoint move;

    Plane operator()(const Plane& plane) const;
    /// Where a point of the surface grid comes to lie; nothing outside the world.
    std::optional<GridPoint> operator()(const GridPoint& point) const;
};

/// A pose of scale 1 whose turn is one of the axes, to within 2^-40; its position is snapped to the input grid, halves
/// to even. Nothing for any other, or for a position 2^26 steps from the origin and beyond, from where nothing reaches
/// into the world.
std::optional<GridTurn> grid_turn(const Pose& pose);

}  // namespace firma
