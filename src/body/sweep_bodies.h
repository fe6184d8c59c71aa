// SPDX-License-Identifier: MIT
// The end of a step: bodies that may have gone through something are swept along their way.
#pragma once

#include <cstdint>

#include "body/mover.h"
#include "firma/world.h"

namespace firma {

struct SweepRules {
    double skin = 0;          ///< metres
    double seconds = 0;       ///< of the step
    double bounce_speed = 0;  ///< metres a second along the normal: what meets slower does not bounce
    double friction = 0;      ///< of the world
    int max_bounces = 0;
};

/// Takes a mover from where the step began as far along its way as no sphere, less the skin, meets the world. There it
/// bounces, or goes on along the wall, for what is left of the step.
/// @return how often it met anything
int sweep_body(const World& world, Mover& mover, const Body& body, const SweepRules& rules);

/// Whether it may be left where it is: it moved too little to be deeper than the skin.
bool moved_clearly(const Mover& mover);

}  // namespace firma
