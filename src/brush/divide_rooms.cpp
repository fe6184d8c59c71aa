// SPDX-License-Identifier: MIT
// Portals where the air is narrow: basins of clearance, the openings between them, and a portal across each.
#include "firma/divide_rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/disjoint_sets.h"
#include "brush/cell_grid.h"
#include "firma/brush_world.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;

/// The basins of a grid's air.
class Basins {
public:
    Basins(const CellGrid& grid, const DivideOptions& options) : grid_(grid), label_(grid.size(), kNone) {
        flood(options.narrow);
        absorb_small(options.smallest_room / (grid.cell * grid.cell * grid.cell));
    }

    /// The basin of a cell; kNone outside the air.
    std::uint32_t of(std::size_t cell) { return label_[cell] == kNone ? kNone : find(label_[cell]); }

private:
    struct Basin {
        std::uint16_t peak = 0;
        std::size_t cells = 0;
    };
    struct Saddle {
        std::uint16_t clearance;
        std::uint32_t a, b;
    };

    std::uint32_t find(std::uint32_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return;
        if (basins_[a].peak < basins_[b].peak || (basins_[a].peak == basins_[b].peak && b < a)) std::swap(a, b);
        parent_[b] = a;
        basins_[a].cells += basins_[b].cells;
    }

    /// From the widest places down: a cell belongs to the basin beside it, begins one where there is none, and where
    /// two meet, and the place is not narrow for either, they are one.
    void flood(double narrow) {
        std::vector<std::size_t> cells;
        for (std::size_t k = 0; k < grid_.size(); ++k)
            if (grid_.air[k]) cells.push_back(k);
        std::sort(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
            return grid_.clearance[a] != grid_.clearance[b] ? grid_.clearance[a] > grid_.clearance[b] : a < b;
        });
        for (const std::size_t at : cells) {
            const std::uint16_t here = grid_.clearance[at];
            std::uint32_t mine = kNone;
            for (int axis = 0; axis < 3; ++axis)
                for (const bool up : {false, true}) {
                    const std::size_t beside = up ? at + grid_.stride(axis) : at - grid_.stride(axis);
                    if (label_[beside] == kNone) continue;
                    const std::uint32_t other = find(label_[beside]);
                    if (mine == kNone) {
                        mine = other;
                        continue;
                    }
                    if (mine == other) continue;
                    saddles_.push_back({here, mine, other});
                    if (double(here) >= narrow * std::min(basins_[mine].peak, basins_[other].peak)) {
                        join(mine, other);
                        mine = find(mine);
                    } else if (basins_[other].peak > basins_[mine].peak) {
                        mine = other;
                    }
                }
            if (mine == kNone) {
                mine = std::uint32_t(basins_.size());
                basins_.push_back({here, 0});
                parent_.push_back(mine);
            }
            label_[at] = mine;
            ++basins_[mine].cells;
        }
    }

    /// What is too small for a room goes to the neighbour with the widest way to it. Saddles stand widest first.
    void absorb_small(double smallest) {
        for (bool any = true; any;) {
            any = false;
            for (const Saddle& saddle : saddles_) {
                const std::uint32_t a = find(saddle.a), b = find(saddle.b);
                if (a == b || double(std::min(basins_[a].cells, basins_[b].cells)) >= smallest) continue;
                join(a, b);
                any = true;
            }
        }
    }

    const CellGrid& grid_;
    std::vector<std::uint32_t> label_, parent_;
    std::vector<Basin> basins_;
    std::vector<Saddle> saddles_;
};

/// A side of a cell between two basins.
struct Gate {
    std::size_t cell;
    std::uint8_t axis;        ///< toward the next cell along it
    std::uint32_t low, high;  ///< basins
};

/// Gates that hang together are one opening.
std::vector<std::vector<Gate>> find_openings(const CellGrid& grid, Basins& basins) {
    std::vector<Gate> gates;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const std::uint32_t mine = basins.of(cell);
        if (mine == kNone) continue;
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t other = basins.of(cell + grid.stride(axis));
            if (other == kNone || other == mine) continue;
            gates.push_back({cell, std::uint8_t(axis), std::min(mine, other), std::max(mine, other)});
        }
    }
    // Gates of the same two basins that are a cell apart at most.
    DisjointSets together(gates.size());
    std::vector<std::uint32_t> order(gates.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto cell_less = [&](std::uint32_t a, std::size_t cell) { return gates[a].cell < cell; };
    for (std::uint32_t k = 0; k < gates.size(); ++k)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const auto cell = std::size_t(std::int64_t(gates[k].cell) + dz * std::int64_t(grid.stride(2)) +
                                                  dy * std::int64_t(grid.stride(1)) + dx);
                    for (auto at = std::lower_bound(order.begin(), order.end(), cell, cell_less);
                         at != order.end() && gates[*at].cell == cell; ++at)
                        if (gates[*at].low == gates[k].low && gates[*at].high == gates[k].high) together.join(k, *at);
                }
    std::vector<std::vector<Gate>> openings;
    std::vector<std::uint32_t> number(gates.size(), kNone);
    for (std::uint32_t k = 0; k < gates.size(); ++k) {
        std::uint32_t& opening = number[together.find(k)];
        if (opening == kNone) {
            opening = std::uint32_t(openings.size());
            openings.emplace_back();
        }
        openings[opening].push_back(gates[k]);
    }
    return openings;
}

std::int32_t snapped(double metres) {
    const double steps = std::floor(metres * kInputSteps + 0.5);
    return std::int32_t(std::max(-33554432.0, std::min(33554431.0, steps)));
}

/// A thin brush across an opening, whose one side is the portal.
void add_portal(const CellGrid& grid, const std::vector<Gate>& opening, std::uint32_t material, BrushLevel& level) {
    std::array<std::size_t, 3> votes{0, 0, 0};
    for (const Gate& gate : opening) ++votes[gate.axis];
    const int across = int(std::max_element(votes.begin(), votes.end()) - votes.begin());
    std::vector<std::int32_t> at;
    std::array<std::int32_t, 3> low{INT32_MAX, INT32_MAX, INT32_MAX}, high{INT32_MIN, INT32_MIN, INT32_MIN};
    for (const Gate& gate : opening) {
        const std::array<std::int32_t, 3> place{std::int32_t(gate.cell % std::size_t(grid.count[0])),
                                                std::int32_t(gate.cell / grid.stride(1) % std::size_t(grid.count[1])),
                                                std::int32_t(gate.cell / grid.stride(2))};
        if (gate.axis == across) at.push_back(place[std::size_t(across)] + 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], place[axis]);
            high[axis] = std::max(high[axis], place[axis] + 1 + (gate.axis == axis));
        }
    }
    std::nth_element(at.begin(), at.begin() + std::ptrdiff_t(at.size() / 2), at.end());
    constexpr double kReach = 1.5;  // cells: into the walls around
    std::int32_t from[3], to[3];
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = std::size_t(axis);
        from[axis] = snapped(grid.low[axis] + (low[k] - kReach) * grid.cell);
        to[axis] = snapped(grid.low[axis] + (high[k] + kReach) * grid.cell);
    }
    from[across] = snapped(grid.low[across] + at[at.size() / 2] * grid.cell);
    to[across] = from[across] + 16;

    Brush brush;
    brush.kind = BrushKind::kPortal;
    brush.first_side = std::uint32_t(level.sides.size());
    brush.side_count = 6;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            GridPoint points[3];
            for (GridPoint& point : points) {
                point[axis] = (upper ? to[axis] : from[axis]) * kSurfacePerInput;
                point[u] = from[u] * kSurfacePerInput;
                point[v] = from[v] * kSurfacePerInput;
            }
            points[1][u] = to[u] * kSurfacePerInput;
            points[2][v] = to[v] * kSurfacePerInput;
            if (!upper) std::swap(points[1], points[2]);
            BrushSide side{{points[0], points[1], points[2]}, material, 0, axis == across && !upper};
            level.sides.push_back(side);
        }
    level.brushes.push_back(brush);
}

}  // namespace

Result<std::size_t> divide_rooms(BrushLevel& level, const DivideOptions& options) {
    const Result<World> whole = make_world(level);
    if (!whole.ok()) return whole.error();
    const CellGrid grid = make_cell_grid(whole.value(), options.cell, options.most_cells);
    Basins basins(grid, options);
    const std::vector<std::vector<Gate>> openings = find_openings(grid, basins);
    if (openings.empty()) return std::size_t(0);
    const auto material = std::uint32_t(level.materials.size());
    level.materials.push_back("portal");
    const auto surfaces = std::uint32_t(level.sides.size());
    for (const std::vector<Gate>& opening : openings) add_portal(grid, opening, material, level);
    // Sources of surfaces count on from the sides.
    for (LevelFace& face : level.surfaces.faces) face.source += std::uint32_t(level.sides.size()) - surfaces;
    return openings.size();
}

}  // namespace firma
