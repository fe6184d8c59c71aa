// SPDX-License-Identifier: MIT
// The turn of a pose.
#include "carve/pose_turn.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/round_half_even.h"

namespace firma {

std::optional<PoseTurn> turn_of(const Quaternion& rotation, double scale) {
    double reach = 0;
    for (const double part : rotation) {
        if (!is_finite(part)) return std::nullopt;
        reach = std::max(reach, std::fabs(part));
    }
    if (reach == 0) return std::nullopt;
    // Divided by the largest part first, so that no square overflows and not all of them vanish.
    double q[4], square = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = rotation[k] / reach;
        square += q[k] * q[k];
    }
    const double size = std::sqrt(square);
    const double x = q[0] / size, y = q[1] / size, z = q[2] / size, w = q[3] / size;
    PoseTurn turn{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                   {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                   {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
    for (Vec3& row : turn.row) row = row * scale;
    return turn;
}

std::optional<GridTurn> grid_turn(const Pose& pose) {
    if (pose.scale != 1) return std::nullopt;
    const std::optional<PoseTurn> turn = turn_of(pose.rotation, 1);
    if (!turn) return std::nullopt;
    constexpr double kOff = 0x1p-40;
    constexpr double kFarthest = 0x1p+26;
    GridTurn found;
    for (int axis = 0; axis < 3; ++axis) {
        int along = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(turn->row[axis][k]) > std::fabs(turn->row[axis][along])) along = k;
        for (int k = 0; k < 3; ++k)
            if (std::fabs(std::fabs(turn->row[axis][k]) - (k == along)) > kOff) return std::nullopt;
        found.from[axis] = along;
        found.sign[axis] = turn->row[axis][along] < 0 ? -1 : 1;
        const double steps = pose.position[axis] * kInputSteps;
        if (!(std::fabs(steps) < kFarthest)) return std::nullopt;
        found.move[axis] = std::int32_t(round_half_even(steps));
    }
    return found;
}

Plane GridTurn::operator()(const Plane& plane) const {
    std::int64_t normal[3];
    Int128 offset = plane.offset();
    for (int axis = 0; axis < 3; ++axis) {
        normal[axis] = sign[axis] * plane.normal[from[axis]];
        offset -= Int128(normal[axis]) * move[axis];
    }
    const Plane turned = plane_of_numbers(normal, offset);
    FIRMA_ASSERT(turned.valid(), "a plane that holds a point of the world");
    return turned;
}

std::optional<GridPoint> GridTurn::operator()(const GridPoint& point) const {
    GridPoint turned;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t at =
            sign[axis] * std::int64_t(point[from[axis]]) + std::int64_t(move[axis]) * kSurfacePerInput;
        constexpr std::int64_t kRim = std::int64_t(kRimSteps) * kSurfacePerInput;
        if (at < -kRim || at > kRim - kSurfacePerInput) return std::nullopt;
        turned[axis] = std::int32_t(at);
    }
    return turned;
}

}  // namespace firma
