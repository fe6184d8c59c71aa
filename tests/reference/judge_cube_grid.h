// SPDX-License-Identifier: MIT
// A grid of cubes filled one by one and carved again: what touches on all sides must leave nothing behind.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firma::reference {

struct CubeGrid {
    int side = 10;            ///< cubes along each axis
    double edge = 1;          ///< metres
    std::uint64_t order = 0;  ///< 0: row by row; else the seed of a random order
};

struct CubeGridVerdict {
    std::uint64_t edits = 0, refused = 0;
    std::size_t faces_full = 0;         ///< exact ones of the whole cube
    std::vector<std::string> failures;  ///< the first few
};

/// Fills all cubes in an empty world, then carves them all in another order: nothing may be left, none refused;
/// the volume is looked at on the way. Then once more with every other cube carved again, in the pattern of a
/// chess board, and with one half of the grid: both must equal what is filled alone.
CubeGridVerdict judge_cube_grid(const CubeGrid& grid);

}  // namespace firma::reference
