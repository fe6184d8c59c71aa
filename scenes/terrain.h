// SPDX-License-Identifier: MIT
// Bumpy open ground of any size: a height field of squares of a metre, two triangles each.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/level.h"
#include "scenes/cast_families.h"

namespace firma::scenes {

struct Terrain {
    int squares = 100;  ///< along x and along y
    std::uint64_t seed = 3;
};

/// Seven octaves of value noise, 40 m and 128 m the widest. Faces look up; open at the rim.
Level terrain(const Terrain& ground);

/// Casts that start in the air, at least their radius and at most 6 m more above the ground around them; half of them
/// within 0.3 m of it.
/// @param level  what terrain() made of `ground`
std::vector<CastQuery> casts_over_terrain(const Terrain& ground, const Level& level, const CastRange& range,
                                          std::size_t count, std::uint64_t seed);

}  // namespace firma::scenes
