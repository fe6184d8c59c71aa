// SPDX-License-Identifier: MIT
// The air of a level in cells.
// Source: for the distances, G. Borgefors, Distance Transformations in Digital Images, 1986 (3-4-5 chamfer).
#include "brush/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "firma/masks.h"

namespace firma {
namespace {

/// Off whatever round numbers authors use, so that no cell's rim lies in a wall's face.
constexpr double kOff = 480.0 / 4096;

/// Along one row of cells.
class RowReader {
public:
    RowReader(const World& world, CellGrid& grid) : world_(world), grid_(grid) {
        options_.mask = kStopsSight;  // glass and clips are in the air
        options_.sides = Sides::kBoth;
    }

    /// @param first  cell of the row, whose others are `stride` apart along `axis`
    void read(int axis, std::array<std::int32_t, 3> cell) {
        const std::int32_t count = grid_.count[std::size_t(axis)];
        const std::size_t first = grid_.index(cell[0], cell[1], cell[2]), stride = grid_.stride(axis);
        Vec3 start, path{0, 0, 0};
        for (int k = 0; k < 3; ++k) start[k] = grid_.low[k] + (cell[std::size_t(k)] + 0.5) * grid_.cell;
        start[axis] = grid_.low[axis];
        path[axis] = count * grid_.cell;
        cast_all(world_, {start, 0}, path, hits_, options_);
        std::size_t next = 0;
        bool solid = false, way = false;
        for (std::int32_t k = 0; k < count; ++k) {
            const double middle = (k + 0.5) / count;
            for (; next < hits_.size() && hits_[next].fraction < middle; ++next) {
                solid = hits_[next].face_normal[axis] < 0;
                way = false;
            }
            const std::size_t at = first + std::size_t(k) * stride;
            if (axis == 0)
                grid_.air[at] = !solid;
            else if (solid)
                grid_.air[at] = 0;  // a middle that lies on a face, or nearly
            if (way && !solid) grid_.ways[at] |= std::uint8_t(1 << axis);
            way = !solid;
        }
    }

private:
    const World& world_;
    CellGrid& grid_;
    CastOptions options_;
    std::vector<Hit> hits_;
};

void read_rows(const World& world, CellGrid& grid) {
    RowReader reader(world, grid);
    for (int axis = 0; axis < 3; ++axis) {
        const auto u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
        std::array<std::int32_t, 3> cell{0, 0, 0};
        for (cell[v] = 0; cell[v] < grid.count[v]; ++cell[v])
            for (cell[u] = 0; cell[u] < grid.count[u]; ++cell[u]) reader.read(axis, cell);
    }
    for (std::size_t at = 0; at < grid.size(); ++at)
        for (int axis = 0; axis < 3; ++axis)
            if (grid.passes(at, axis) && !(grid.air[at] && grid.air[at - grid.stride(axis)]))
                grid.ways[at] &= std::uint8_t(~(1 << axis));
}

/// Takes off the air that reaches the rim.
void drop_exterior(CellGrid& grid) {
    std::vector<std::size_t> waiting;
    const auto take = [&](std::size_t at) {
        if (!grid.air[at]) return;
        grid.air[at] = 0;
        waiting.push_back(at);
    };
    const auto [nx, ny, nz] = grid.count;
    for (std::int32_t z = 0; z < nz; ++z)
        for (std::int32_t y = 0; y < ny; ++y)
            for (std::int32_t x = 0; x < nx; ++x) {
                const bool rim = x == 0 || y == 0 || z == 0 || x == nx - 1 || y == ny - 1 || z == nz - 1;
                if (rim) take(grid.index(x, y, z));
            }
    while (!waiting.empty()) {
        const std::size_t at = waiting.back();
        waiting.pop_back();
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t up = at + grid.stride(axis);
            if (grid.passes(at, axis)) take(at - grid.stride(axis));
            if (up < grid.size() && grid.passes(up, axis)) take(up);
        }
    }
    for (std::size_t at = 0; at < grid.size(); ++at)
        if (!grid.air[at]) grid.ways[at] = 0;
}

/// Two passes, each from the neighbours that come before.
void measure_clearance(CellGrid& grid) {
    grid.clearance.assign(grid.size(), 0);
    constexpr std::uint16_t kFar = 60000;
    const auto [nx, ny, nz] = grid.count;
    for (std::size_t k = 0; k < grid.size(); ++k) grid.clearance[k] = grid.air[k] ? kFar : 0;
    constexpr std::uint16_t kBesideThinWall = 2;
    for (std::size_t k = 0; k < grid.size(); ++k)
        for (int axis = 0; axis < 3; ++axis) {
            if (!grid.air[k] || !grid.air[k - grid.stride(axis)] || grid.passes(k, axis)) continue;
            grid.clearance[k] = grid.clearance[k - grid.stride(axis)] = kBesideThinWall;
        }
    for (const bool back : {false, true})
        for (std::int32_t k = 1; k + 1 < nz; ++k)
            for (std::int32_t j = 1; j + 1 < ny; ++j)
                for (std::int32_t i = 1; i + 1 < nx; ++i) {
                    const std::size_t at = back ? grid.index(nx - 1 - i, ny - 1 - j, nz - 1 - k) : grid.index(i, j, k);
                    if (grid.clearance[at] == 0) continue;
                    std::uint16_t best = grid.clearance[at];
                    for (int dz = -1; dz <= 0; ++dz)
                        for (int dy = -1; dy <= (dz < 0 ? 1 : 0); ++dy)
                            for (int dx = -1; dx <= (dz < 0 || dy < 0 ? 1 : -1); ++dx) {
                                const std::int64_t step = std::int64_t(dz) * std::int64_t(grid.stride(2)) +
                                                          std::int64_t(dy) * std::int64_t(grid.stride(1)) + dx;
                                const std::size_t other = std::size_t(std::int64_t(at) + (back ? -step : step));
                                const auto cost = std::uint16_t(2 + (dx != 0) + (dy != 0) + (dz != 0));
                                best = std::min<std::uint16_t>(best, std::uint16_t(grid.clearance[other] + cost));
                            }
                    grid.clearance[at] = best;
                }
}

}  // namespace

CellGrid make_cell_grid(const World& world, double cell, std::size_t most_cells) {
    CellGrid grid;
    const Box bounds = world.bounds();
    if (bounds.empty()) return grid;
    const Vec3 size = bounds.high - bounds.low;
    const double volume = (size.x + 4 * cell) * (size.y + 4 * cell) * (size.z + 4 * cell);
    grid.cell = cell;
    while (volume / (grid.cell * grid.cell * grid.cell) > double(most_cells)) grid.cell *= 1.25;
    for (int axis = 0; axis < 3; ++axis) {
        grid.low[axis] = bounds.low[axis] - 2 * grid.cell + kOff * grid.cell;
        grid.count[std::size_t(axis)] = std::int32_t(std::ceil(size[axis] / grid.cell)) + 4;
    }
    grid.air.assign(std::size_t(grid.count[0]) * std::size_t(grid.count[1]) * std::size_t(grid.count[2]), 0);
    grid.ways.assign(grid.size(), 0);
    read_rows(world, grid);
    drop_exterior(grid);
    measure_clearance(grid);
    return grid;
}

}  // namespace firma
