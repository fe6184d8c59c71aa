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

void fill_row(const World& world, const Vec3& start, double length, std::vector<Hit>& hits, CellGrid& grid,
              std::size_t first) {
    CastOptions options;
    options.mask = kStopsSight;  // glass and clips are in the air
    options.sides = Sides::kBoth;
    cast_all(world, {start, 0}, {length, 0, 0}, hits, options);
    bool solid = false;
    double from = 0;
    const auto fill = [&](double to) {
        if (solid) return;
        const auto begin = std::int64_t(std::ceil(from / grid.cell - 0.5)),
                   end = std::int64_t(std::floor(to / grid.cell + 0.5));
        for (std::int64_t k = std::max<std::int64_t>(begin, 0); k < std::min<std::int64_t>(end, grid.count[0]); ++k)
            grid.air[first + std::size_t(k)] = 1;
    };
    for (const Hit& hit : hits) {
        const bool enters = hit.face_normal.x < 0;
        if (enters == solid) continue;  // a face of something that is no solid, or an edge met twice
        fill(hit.fraction * length);
        from = hit.fraction * length;
        solid = enters;
    }
    fill(length + grid.cell);
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
    while (!waiting.empty()) {  // nothing at the rim is left, so neighbours are there
        const std::size_t at = waiting.back();
        waiting.pop_back();
        const std::int64_t x = std::int64_t(at % std::size_t(nx));
        const std::int64_t y = std::int64_t(at / std::size_t(nx) % std::size_t(ny));
        const std::int64_t z = std::int64_t(at / (std::size_t(nx) * std::size_t(ny)));
        if (x > 0) take(at - 1);
        if (x + 1 < nx) take(at + 1);
        if (y > 0) take(at - grid.stride(1));
        if (y + 1 < ny) take(at + grid.stride(1));
        if (z > 0) take(at - grid.stride(2));
        if (z + 1 < nz) take(at + grid.stride(2));
    }
}

/// Two passes, each from the neighbours that come before.
void measure_clearance(CellGrid& grid) {
    grid.clearance.assign(grid.size(), 0);
    constexpr std::uint16_t kFar = 60000;
    const auto [nx, ny, nz] = grid.count;
    for (std::size_t k = 0; k < grid.size(); ++k) grid.clearance[k] = grid.air[k] ? kFar : 0;
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
    std::vector<Hit> hits;
    for (std::int32_t z = 0; z < grid.count[2]; ++z)
        for (std::int32_t y = 0; y < grid.count[1]; ++y) {
            const Vec3 start{grid.low.x, grid.low.y + (y + 0.5) * grid.cell, grid.low.z + (z + 0.5) * grid.cell};
            fill_row(world, start, grid.count[0] * grid.cell, hits, grid, grid.index(0, y, z));
        }
    drop_exterior(grid);
    measure_clearance(grid);
    return grid;
}

}  // namespace firma
