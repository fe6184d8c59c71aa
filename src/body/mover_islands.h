// SPDX-License-Identifier: MIT
// Movers that hang together by contacts: each lot can be worked on by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "body/mover.h"

namespace firma {

struct MoverIsland {
    std::uint32_t first_mover = 0, movers = 0;
    std::uint32_t first_contact = 0, contacts = 0;
    double mass_ratio = 1;  ///< the largest between two movers that touch
};

/// Puts movers, and contacts, of an island side by side, the islands in order of their lowest slots; within each all
/// keep their order. NearContact::a and b follow.
std::vector<MoverIsland> part_into_islands(std::vector<Mover>& movers, std::vector<NearContact>& contacts);

}  // namespace firma
