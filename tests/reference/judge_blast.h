// SPDX-License-Identifier: MIT
// Judges blasts in a world with rooms and doors: after every one rooms are closed, and each point lies in one of them
// or in the solid, whichever way that is asked; volumes add up; rooms, portals and doors are what they were.
//
// What the solid itself must be after a cut is judged by judge_cut.h.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scenes/blasts.h"
#include "tests/reference/judge_cut.h"

namespace firma::reference {

/// What judging came to, beside what it came to of cuts.
struct BlastTally : CutTally {
    std::uint64_t filled = 0, shot_from = 0;
    std::uint64_t cut_short = 0;  ///< by what may not be carved
    std::uint64_t rooms_made = 0, rooms_swallowed = 0, rooms_filled = 0;
    std::uint64_t choices = 0;  ///< carvings without `from` that took walls of several rooms, and went to one
    std::uint64_t portals_made = 0, portals_grown = 0, portals_divided = 0, portals_clipped = 0, portals_filled = 0;
    std::uint64_t portal_sides = 0;  ///< points of new portals, of which both sides were looked at
    std::uint64_t door_casts = 0;    ///< aimed through closed portals ...
    std::uint64_t open_casts = 0;    ///< ... and through open ones
    std::uint64_t chunk_searches = 0, chunks = 0;
    double judge_seconds = 0;

    void add(const BlastTally& other);
};

struct BlastJudgeOptions {
    int points = 12, casts = 6, doors = 4, open = 4;
    /// Every so many blasts, and after the last, all of the world is checked by the library too (check_world(),
    /// check_solid()).
    int whole_every = 1;
    int volume_every = 4;  ///< the volume that leaves the solid is also that of the cutter within it
    /// In the same world without loose pieces, all that are made: as a flood over all faces finds them. 0: no such
    /// world.
    int chunks_every = 4;
};

/// Blasts one after another, each judged.
/// @param name  for failures: what it takes to see the blasts again
BlastTally judge_blasts(World world, std::span<const scenes::RoomBlast> blasts, const std::string& name,
                        std::uint64_t seed, const BlastJudgeOptions& options = {});

}  // namespace firma::reference
