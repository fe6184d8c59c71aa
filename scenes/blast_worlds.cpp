// SPDX-License-Identifier: MIT
// Small worlds of rooms for blasts.
#include "scenes/blast_worlds.h"

#include "scenes/divided_building.h"
#include "scenes/hub.h"

namespace firma::scenes {

World blast_world(BlastWorld kind, std::uint64_t seed) {
    Rng rng(seed * 0x9E3779B97F4A7C15ull ^ 0xB1A57);
    if (kind == BlastWorld::kHub) {
        const int closets = 4 + 2 * int(rng.below(15));
        const bool hall_last = rng.chance(0.5);
        return assemble_world(hub_parts({.closets = closets, .hall_last = hall_last})).value();
    }
    BuildingPlan plan;
    plan.rooms_x = 2 + int(rng.below(2));
    plan.rooms_y = 1 + int(rng.below(2));
    plan.rooms_z = 1 + int(rng.below(2));
    if (kind == BlastWorld::kMany) plan.rooms_x = plan.rooms_y = 5;
    if (kind == BlastWorld::kMany) plan.rooms_z = 1;
    plan.jitter = kind == BlastWorld::kLattice ? 0 : rng.uniform(0.02, 0.15);
    plan.outdoors = kind == BlastWorld::kOutdoors;
    plan.seed = rng.next();
    return assemble_world(DividedBuilding(plan).parts()).value();
}

}  // namespace firma::scenes
