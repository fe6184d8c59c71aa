// SPDX-License-Identifier: MIT
// The air of a level in cells: which of them are air, and how far each is from the nearest that is not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// Cells in rows along x, rows along y, layers along z.
struct CellGrid {
    Vec3 low{0, 0, 0};  ///< corner of the first cell, metres
    double cell = 0;    ///< metres
    std::array<std::int32_t, 3> count{0, 0, 0};
    std::vector<std::uint8_t> air;  ///< of the air that the hull encloses
    /// Bit `axis`: the cell and the one before it along the axis are air, with nothing but air between.
    std::vector<std::uint8_t> ways;
    std::vector<std::uint16_t>
        clearance;  ///< cells to the nearest cell that is no air, 3 to a cell's width; 0 in those

    std::size_t size() const { return air.size(); }
    std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const {
        return (std::size_t(z) * std::size_t(count[1]) + std::size_t(y)) * std::size_t(count[0]) + std::size_t(x);
    }
    bool passes(std::size_t at, int axis) const { return ways[at] >> axis & 1; }
    /// How far apart neighbours along an axis are.
    std::size_t stride(int axis) const {
        return axis == 0 ? 1 : axis == 1 ? std::size_t(count[0]) : std::size_t(count[0]) * std::size_t(count[1]);
    }
};

/// Looks along the middle of each row, along each axis, at what it passes through. Air that reaches the rim of the grid
/// is the exterior's, and counts as none.
CellGrid make_cell_grid(const World& world, double cell, std::size_t most_cells);

}  // namespace firma
