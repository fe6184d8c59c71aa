// SPDX-License-Identifier: MIT
// Judges a level of brushes made into a world: closed, of the right volume, points and ways in the right rooms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "firma/brush_level.h"

namespace firma::reference {

struct JoinedVerdict {
    std::string fault;  ///< empty: all holds
    std::size_t rooms = 0, portals = 0, points = 0;
    std::size_t ways = 0, crossings = 0;         ///< clear ways near portals, and how many of them end in another room
    std::size_t planes_moved = 0, left_out = 0;  ///< brushes not joined
    double farthest = 0;                         ///< metres from a corner of a face to its plane as the level has it
    double volume = 0;                           ///< cubic metres; 0 where it is not compared
};

/// The brushes that were joined are those of the level that were not left out, with their planes as they were moved:
/// the exact volume of those is compared, where `volume` says so: many bodies through each other take long. None may be
/// moved by more than a millimetre.
JoinedVerdict judge_joined(const BrushLevel& level, std::uint64_t seed, int points = 40, bool volume = true);

}  // namespace firma::reference
