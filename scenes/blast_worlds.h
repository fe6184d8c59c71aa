// SPDX-License-Identifier: MIT
// Small worlds of rooms for blasts, each from a seed: buildings in rock and in the open, on a lattice and crooked,
// halls with closets.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "firma/world.h"

namespace firma::scenes {

enum class BlastWorld : std::uint8_t {
    kInRock,    ///< two to four rooms a side and their doorways, walls crooked
    kLattice,   ///< the same with all walls on multiples of a metre
    kOutdoors,  ///< in the open, with doors outside
    kHub,       ///< a hall with 4 to 32 closets
    kMany,      ///< 25 rooms and their doorways
};
inline constexpr std::array<std::string_view, 5> kBlastWorldNames{"in_rock", "lattice", "outdoors", "hub", "many"};

World blast_world(BlastWorld kind, std::uint64_t seed);

}  // namespace firma::scenes
