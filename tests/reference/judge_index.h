// SPDX-License-Identifier: MIT
// Judges that an index is free: the same cuts under different trees, some built anew in between, end in the same world.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "firma/world.h"
#include "scenes/cut_families.h"

namespace firma::reference {

struct IndexTally {
    std::uint64_t cuts = 0, done = 0, nothing = 0, refused = 0;
    std::uint64_t rebuilds = 0;         ///< of indices
    std::uint64_t packed = 0;           ///< files compared, byte for byte
    std::uint64_t failed = 0;           ///< cuts after which something differed
    std::vector<std::string> failures;  ///< the first few
};

/// Makes the same cuts in a world for each of three kinds of tree (longest axis with 4 faces a bin, surface area, no
/// division at all), in the first of them once more with its index built anew after every cut, each time in another of
/// those ways. After every cut all must agree in how it ended, hash_world(), hash_solid(), hash_regions() and the ids
/// of all faces; after every 16th and the last, in each byte of pack_world() without an index.
///
/// @param make  the world to begin with, its trees made so
IndexTally judge_index(const std::function<World(const TreeOptions&)>& make, std::span<const scenes::CutOrder> cuts);

/// So many cuts for our level, spread, in one corner, and on round coordinates; every eighth is filled in instead.
std::vector<scenes::CutOrder> cuts_of_our_level(const Level& ours, std::uint64_t seed, std::size_t count);

}  // namespace firma::reference
