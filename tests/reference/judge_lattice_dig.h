// SPDX-License-Identifier: MIT
// Boxes on a lattice dug out of a block and filled in again, beside a list of its cells: large faces are divided and
// become one again, flush walls come and go.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firma::reference {

struct LatticeDigVerdict {
    std::uint64_t edits = 0, nothing = 0;
    std::vector<std::string> failures;  ///< the dig ends with the first
};

/// A block of 16 cells along each axis, 1/2 to 32 m each; up to 60 boxes of 1 to 6 cells, anywhere, along the top, or
/// on every fourth plane; a third of them fill. After each edit: whether it was done or met nothing, its volume, the
/// boundary, where some cells' middles lie. At the end all is carved, and nothing is left.
LatticeDigVerdict judge_lattice_dig(std::uint64_t seed);

}  // namespace firma::reference
