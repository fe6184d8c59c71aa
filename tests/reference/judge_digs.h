// SPDX-License-Identifier: MIT
// Long rows of cuts and fills that touch, in blocks so large that their faces are divided for them and become one
// again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firma::reference {

struct DigVerdict {
    std::uint64_t edits = 0, done = 0, nothing = 0, unplaceable = 0;
    std::vector<std::string> failures;  ///< the dig ends with the first
};

/// A block of 16 cells along each axis, 1/2 to 32 m each; up to 60 boxes of 1 to 6 cells, anywhere, along the top, or
/// on every fourth plane; a third of them fill. After each edit: whether it was done or met nothing, its volume, the
/// boundary, where some cells' middles lie. At the end all is carved, and nothing is left.
DigVerdict judge_lattice_dig(std::uint64_t seed);

/// A block of 64 x 64 x 16 units of 1/4 to 8 m; 80 blocks, wedges, gears and bent pieces on the lattice of units, and
/// craters that are not; two in five fill. After each edit: not refused, the boundary, the measured volume beside the
/// one reported, the same again meets nothing.
DigVerdict judge_mixed_dig(std::uint64_t seed);

}  // namespace firma::reference
