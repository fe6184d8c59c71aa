// SPDX-License-Identifier: MIT
// A solid in two along a plane, exactly: both halves have that plane, bit for bit.
#pragma once

#include <cstdint>
#include <optional>

#include "firma/solid.h"
#include "firma/vec.h"

namespace firma {

/// A plane through three points of the input grid, and a point of the grid on either side, metres. The pyramids on the
/// triangle are the halves of space, as far as they matter.
struct CrackPlane {
    Vec3 corners[3];
    Vec3 front, back;  ///< tips: counter-clockwise seen from `front`
};

/// A plane near a point, nearly across a direction: three points far around a ball, snapped to the grid. Off from what
/// was asked for by less than a step of the input grid within the ball.
/// @param normal  unit
/// @return nothing where the pyramids would leave the world
std::optional<CrackPlane> crack_plane(const Vec3& point, const Vec3& normal, const Vec3& centre, double radius);

struct SolidHalves {
    enum class Outcome : std::uint8_t {
        kSplit,
        kMissed,   ///< all of it is on one side
        kRefused,  ///< `error` says why
    };
    Outcome outcome = Outcome::kRefused;
    Solid front, back;
    Error error;
};

/// @param solid     within the ball that the plane was made for, without rock outside
/// @param material  of the two faces along the plane
/// Costs two subtract() of a cutter of four triangles: all faces.
SolidHalves split_solid(const Solid& solid, const CrackPlane& plane, std::uint32_t material);

}  // namespace firma
