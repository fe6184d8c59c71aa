// SPDX-License-Identifier: MIT
// A body where it came to rest, ready to become ground.
#include "carve/place_solid.h"
#include "carve/pose_turn.h"
#include "firma/chunk.h"
#include "firma/grid.h"

namespace firma {
namespace {

constexpr int kTries = 16;

}  // namespace

Result<RestingSolid> resting_solid(const Solid& solid, const Pose& pose, std::string name) {
    Result<Cutter> cutter = cutter_from_solid(solid, name);
    if (!cutter) return cutter.error();
    RestingSolid resting;
    if (grid_turn(pose)) {
        resting.cutter = std::move(cutter).value();
        resting.pose = pose;
        return resting;
    }
    Result<Solid> snapped = snap_solid(cutter.value(), pose, &resting.mended);
    for (int k = 1; k < kTries && !snapped && snapped.error().code == ErrorCode::kInvalid; ++k) {
        // Less than half a step along each axis: corners snap otherwise then.
        constexpr double kStep = 1 / kInputSteps;
        Pose moved = pose;
        for (int axis = 0; axis < 3; ++axis) {
            const int part = k * (3 + 2 * axis) % kTries;
            moved.position[axis] += (double(part) / kTries - 0.5) * kStep;
        }
        if (Result<Solid> other = snap_solid(cutter.value(), moved, &resting.mended)) snapped = std::move(other);
    }
    if (!snapped) return snapped.error();
    resting.cutter = cutter_from_solid(snapped.value(), std::move(name)).value();
    const double scale = pose.scale * pose.scale * pose.scale;
    resting.volume_change = mass_properties(snapped.value(), 0).volume - mass_properties(solid, 0).volume * scale;
    return resting;
}

}  // namespace firma
