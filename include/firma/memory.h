// SPDX-License-Identifier: MIT
// How much memory worlds hold.
#pragma once

#include <cstddef>
#include <span>

#include "firma/world.h"

namespace firma {

/// Bytes that some versions of a world, or several worlds, hold together: what they share counts once, so one more
/// version costs what it does not share. Edges, vertices and planes that exact faces share are counted by an estimate
/// for each face. Visits every block; for budgets and diagnosis, not for each frame.
std::size_t memory_used(std::span<const World> worlds);
inline std::size_t memory_used(const World& world) {
    return memory_used({&world, 1});
}

}  // namespace firma
