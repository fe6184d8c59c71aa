// SPDX-License-Identifier: MIT
// Which bodies come to rest together, and what wakes them.
#pragma once

#include <cstdint>
#include <span>

#include "body/mover.h"
#include "body/step_parts.h"
#include "firma/bodies.h"

namespace firma {

/// Puts islands to sleep: bodies that press on each other, all of them still for long enough, none on a part that
/// moves.
/// @param movers           as the step left them
/// @param movers_of_slots  kFixed of those that did not move in this step
void rest(Bodies& bodies, std::span<const Mover> movers, std::span<const std::uint32_t> movers_of_slots, double seconds,
          const StepParts& parts, const StepOptions& options);

/// Wakes what sleeps on a face that this world does not have any more, or on a part that has changed.
/// @return how many woke up
std::size_t wake_unsupported(Bodies& bodies, const World& world, bool other_world, const StepParts& parts);
/// Wakes what sleeps where a part comes.
std::size_t wake_in_the_way(Bodies& bodies, const StepParts& parts, double skin);

/// Wakes a sleeper, and all that fell asleep with it.
std::size_t wake_island(Bodies& bodies, std::uint32_t slot);

}  // namespace firma
