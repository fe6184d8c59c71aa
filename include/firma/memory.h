// SPDX-License-Identifier: MIT
// How much memory worlds hold.
#pragma once

#include <cstddef>
#include <span>

#include "firma/world.h"

namespace firma {

/// Bytes that some versions of a world, or several worlds, hold together: what they share counts once, so one more
/// version costs what it does not share. Visits every block; for budgets and diagnosis, not for each frame.
///
/// Blocks and rooms are counted as they are. Of the exact faces that edits made, the edges, vertices and planes that
/// neighbours share are counted by estimate: half an edge and a third of a vertex for each edge of a face's loops, and
/// a plane a face.
std::size_t memory_used(std::span<const World> worlds);
inline std::size_t memory_used(const World& world) {
    return memory_used({&world, 1});
}

}  // namespace firma
