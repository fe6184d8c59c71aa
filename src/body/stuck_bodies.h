// SPDX-License-Identifier: MIT
// Bodies that solid has come to: out of it, the shortest way.
#pragma once

#include <cstddef>

#include "body/step_parts.h"
#include "firma/bodies.h"

namespace firma {

/// Says of each body whether the centre of one of its spheres is in solid. Those that are wake up.
/// @param sound  of slots: others are left out
/// @param all  of all bodies; else of those that are stuck so far, and those where a part has changed
void find_stuck(Bodies& bodies, const World& world, bool all, const StepParts& parts, const std::vector<bool>& sound);

/// Moves a stuck body on its way out of what is nearest to getting rid of, at kWayOutSpeed at most.
/// Out of a part no farther than it stays as clear of the world as it is.
/// @param skin  metres
void move_out(Body& body, const World& world, const StepParts& parts, double seconds, double skin);

}  // namespace firma
