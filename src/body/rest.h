// SPDX-License-Identifier: MIT
// Which bodies come to rest together, and what wakes them.
#pragma once

#include <cstdint>
#include <span>

#include "firma/bodies.h"

namespace firma {

/// Puts islands to sleep: bodies that press on each other, all of them still for long enough.
/// @param movers  of each slot; kFixed of those that did not move in this step
void rest(Bodies& bodies, std::span<const std::uint32_t> movers, double seconds, const StepOptions& options);

/// Wakes what sleeps on a face that this world does not have any more.
/// @return how many woke up
std::size_t wake_unsupported(Bodies& bodies, const World& world);

/// Wakes a sleeper, and all that fell asleep with it.
std::size_t wake_island(Bodies& bodies, std::uint32_t slot);

}  // namespace firma
