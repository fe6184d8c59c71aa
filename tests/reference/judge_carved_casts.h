// SPDX-License-Identifier: MIT
// Casts through a carved world against the exact oracle, place by place; and rays that must not get out of it.
#pragma once

#include <cstdint>

#include "firma/world.h"
#include "scenes/cut_families.h"
#include "scenes/rng.h"
#include "tests/reference/judge_scene.h"

namespace firma::reference {

/// Casts in a box of `size` metres somewhere on the surface, judged by an oracle of all faces that reach into that box:
/// every sweep stays within it.
Tally judge_casts_at(const World& world, scenes::Rng& rng, int casts, double size);

struct RayTally {
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;      ///< met nothing, or a face from behind
    std::uint64_t at_edges = 0;  ///< met a back first, most with a front in the same place: looked at again
    std::string first_failure;
};

/// Rays from the air at corners, edges and insides of faces nearby, going on for twice the world's size: in a world
/// whose outside is rock each must meet something, and that from the front, however far behind a crack the next front
/// may be.
void shoot_from_air(const World& world, scenes::Rng& rng, std::uint64_t rays, RayTally& tally);

/// A world after cuts of one family, one after another until so many are done: cases go on in the first one's level.
World carved_world(const scenes::CutFamily& family, std::uint64_t seed, std::uint64_t cuts, const Level& ours);

}  // namespace firma::reference
