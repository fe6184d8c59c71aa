// SPDX-License-Identifier: MIT
// Seeded casts that begin in the air of a level: particles and spheres, short and long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cli/read_queries.h"
#include "firma/world.h"

namespace firma::cli {

/// Half of them particles, half spheres of up to half a metre that overlap nothing at their start; paths from a
/// thousandth of the level's diagonal to all of it.
///
/// How starts stay in the air: each lies on the way of a cast from the one before; the first is a point from which all
/// that is seen is the front of faces.
std::vector<Query> make_demo_casts(const World& world, std::size_t count, std::uint64_t seed);

}  // namespace firma::cli
