// SPDX-License-Identifier: MIT
// Seeded craters where casts met a level, casts between them, and rays that must not get out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cli/read_queries.h"
#include "firma/world.h"

namespace firma::cli {

struct DemoCraters {
    World after;
    std::size_t fired = 0, done = 0, nothing = 0, refused = 0;
    std::size_t nothing_castable_only = 0;        ///< of `nothing`: met only faces that are castable only
    std::map<std::string, std::size_t> refusals;  ///< by reason
    std::vector<double> seconds;                  ///< of those that were done
    double volume = 0;                            ///< cubic metres taken
    std::size_t chunks = 0, crumbs = 0;           ///< pieces that came loose and left
    double chunk_volume = 0;                      ///< cubic metres of chunks
    std::size_t casts = 0;                        ///< between craters
    double cast_seconds = 0;
    std::size_t rays = 0;            ///< through all of the level, from its air
    std::size_t escaped_before = 0;  ///< of these in the level as it was: where any does, it is open
    std::size_t escaped = 0;         ///< between craters
    bool leaks() const { return escaped_before == 0 && escaped > 0; }
};

/// Fires craters of 0.4 to 1.6 m, most of them rocky, at points that casts meet, and after each its share of the
/// queries and a hundred rays. Pieces that come loose leave.
/// @param level   as it was read: where rays escape from it, it is open
/// @param before  the same, or after some edits
DemoCraters fire_demo_craters(const World& level, const World& before, const std::vector<Query>& queries,
                              std::size_t count, std::uint64_t seed);

}  // namespace firma::cli
