// SPDX-License-Identifier: MIT
// Portals where the air is narrow: basins of clearance, the openings between them, and a portal across each.
#include "firma/divide_rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/flat_map.h"
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
        absorb_small(options.smallest_room / (grid.cell * grid.cell * grid.cell),
                     3 * options.smallest_clearance / grid.cell);
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
                    if (label_[beside] == kNone || !grid_.passes(up ? beside : at, axis)) continue;
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
    void absorb_small(double cells, double clearance) {
        const auto small = [&](std::uint32_t k) {
            return double(basins_[k].cells) < cells || double(basins_[k].peak) < clearance;
        };
        for (bool any = true; any;) {
            any = false;
            for (const Saddle& saddle : saddles_) {
                const std::uint32_t a = find(saddle.a), b = find(saddle.b);
                if (a == b || !(small(a) || small(b))) continue;
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
            if (!grid.passes(cell + grid.stride(axis), axis)) continue;
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

/// A piece of a plane between two layers of cells, all air on both sides, with walls around.
struct Section {
    int axis = 0;
    std::int32_t layer = 0;                          ///< the plane lies before it
    std::vector<std::array<std::int32_t, 2>> cells;  ///< along the next axis and the one after
};

/// Where air passes from one layer to the next, as far as it hangs together with a cell. Given up when it grows larger
/// than wanted.
class SectionFinder {
public:
    explicit SectionFinder(const CellGrid& grid) : grid_(grid) {}

    bool find(int axis, std::array<std::int32_t, 3> start, std::size_t most, Section& section) {
        section = {axis, start[std::size_t(axis)], {}};
        if (!passes(axis, start)) return false;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        seen_.clear();
        add(section, start, u, v);
        for (std::size_t k = 0; k < section.cells.size(); ++k) {
            if (section.cells.size() > most) return false;
            for (const auto& [du, dv] : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
                std::array<std::int32_t, 3> next = start;
                next[std::size_t(u)] = section.cells[k][0] + du;
                next[std::size_t(v)] = section.cells[k][1] + dv;
                if (passes(axis, next)) add(section, next, u, v);
            }
        }
        return true;
    }

private:
    bool passes(int axis, const std::array<std::int32_t, 3>& cell) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (cell[k] < 1 || cell[k] + 1 >= grid_.count[k]) return false;
        return grid_.passes(grid_.index(cell[0], cell[1], cell[2]), axis);
    }
    void add(Section& section, const std::array<std::int32_t, 3>& cell, int u, int v) {
        std::uint32_t& known = seen_.at(grid_.index(cell[0], cell[1], cell[2]));
        if (known != FlatMap::kNone) return;
        known = 0;
        section.cells.push_back({cell[std::size_t(u)], cell[std::size_t(v)]});
    }

    const CellGrid& grid_;
    FlatMap seen_;
};

/// The smallest section near an opening: along each axis, a few layers to either side of where most of it lies.
bool smallest_section(const CellGrid& grid, const std::vector<Gate>& opening, Section& best) {
    constexpr std::int32_t kAside = 3;  // layers
    constexpr double kLargest = 60;     // square metres: no doorway is larger
    std::size_t most = std::size_t(kLargest / (grid.cell * grid.cell));
    SectionFinder finder(grid);
    Section section;
    bool any = false;
    const Gate& gate = opening[opening.size() / 2];
    const std::array<std::int32_t, 3> place{std::int32_t(gate.cell % std::size_t(grid.count[0])),
                                            std::int32_t(gate.cell / grid.stride(1) % std::size_t(grid.count[1])),
                                            std::int32_t(gate.cell / grid.stride(2))};
    for (int axis = 0; axis < 3; ++axis)
        for (std::int32_t aside = -kAside; aside <= kAside; ++aside) {
            std::array<std::int32_t, 3> start = place;
            start[std::size_t(axis)] += aside;
            if (!finder.find(axis, start, most, section)) continue;
            if (any && section.cells.size() >= best.cells.size()) continue;
            best = section;
            most = section.cells.size();
            any = true;
        }
    return any;
}

/// Leaves of sections those that, together, divide the air into parts of some size.
class SectionChooser {
public:
    SectionChooser(const CellGrid& grid, std::vector<Section>& sections, double smallest)
        : grid_(grid), sections_(sections), smallest_(smallest) {}

    void choose() {
        while (drop_some()) std::erase_if(sections_, [](const Section& section) { return section.cells.empty(); });
    }

private:
    std::size_t cell_of(const Section& section, const std::array<std::int32_t, 2>& cell) const {
        std::int32_t at[3];
        at[section.axis] = section.layer;
        at[(section.axis + 1) % 3] = cell[0];
        at[(section.axis + 2) % 3] = cell[1];
        return grid_.index(at[0], at[1], at[2]);
    }

    /// Numbers the parts that the sections leave.
    void flood() {
        cut_.assign(grid_.size(), 0);
        for (const Section& section : sections_)
            for (const auto& cell : section.cells) cut_[cell_of(section, cell)] |= std::uint8_t(1 << section.axis);
        part_.assign(grid_.size(), kNone);
        cells_.clear();
        std::vector<std::size_t> waiting;
        for (std::size_t start = 0; start < grid_.size(); ++start) {
            if (!grid_.air[start] || part_[start] != kNone) continue;
            const auto part = std::uint32_t(cells_.size());
            cells_.push_back(0);
            const auto take = [&](std::size_t cell) {
                if (!grid_.air[cell] || part_[cell] != kNone) return;
                part_[cell] = part;
                ++cells_[part];
                waiting.push_back(cell);
            };
            take(start);
            while (!waiting.empty()) {
                const std::size_t at = waiting.back();
                waiting.pop_back();
                for (int axis = 0; axis < 3; ++axis) {
                    const std::size_t up = at + grid_.stride(axis);
                    if (grid_.passes(at, axis) && !(cut_[at] >> axis & 1)) take(at - grid_.stride(axis));
                    if (grid_.passes(up, axis) && !(cut_[up] >> axis & 1)) take(up);
                }
            }
        }
    }

    /// @return whether any was dropped: then its cells are gone
    bool drop_some() {
        flood();
        bool any = false;
        std::vector<std::uint32_t> largest_of_small(cells_.size(), kNone);
        for (std::uint32_t k = 0; k < sections_.size(); ++k) {
            Section& section = sections_[k];
            bool divides = false;
            for (const auto& cell : section.cells) {
                const std::size_t at = cell_of(section, cell);
                const std::uint32_t above = part_[at], below = part_[at - grid_.stride(section.axis)];
                divides = divides || above != below;
                for (const std::uint32_t part : {above, below}) {
                    if (above == below || double(cells_[part]) >= smallest_) continue;
                    std::uint32_t& largest = largest_of_small[part];
                    if (largest == kNone || sections_[largest].cells.size() < section.cells.size()) largest = k;
                }
            }
            if (divides) continue;
            section.cells.clear();
            any = true;
        }
        if (any) return true;
        for (std::size_t part = 0; part < cells_.size(); ++part) {
            if (largest_of_small[part] == kNone) continue;
            sections_[largest_of_small[part]].cells.clear();
            return true;
        }
        return false;
    }

    const CellGrid& grid_;
    std::vector<Section>& sections_;
    const double smallest_;
    std::vector<std::uint8_t> cut_;
    std::vector<std::uint32_t> part_;
    std::vector<std::size_t> cells_;  ///< of each part
};

std::int32_t snapped(double metres) {
    const double steps = std::floor(metres * kInputSteps + 0.5);
    return std::int32_t(std::max(-33554432.0, std::min(33554431.0, steps)));
}

/// A thin brush, whose one side is a portal.
void add_portal_brush(int across, const std::int32_t (&from)[3], const std::int32_t (&to)[3], std::uint32_t material,
                      std::uint32_t entity, BrushLevel& level) {
    Brush brush;
    brush.kind = BrushKind::kPortal;
    brush.entity = entity;
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
            const BrushSide side{{points[0], points[1], points[2]}, material, 0, axis == across && !upper};
            level.sides.push_back(side);
        }
    level.brushes.push_back(brush);
}

/// Covers a section by rectangles of cells, each a little larger than its cells, so that it reaches into the walls
/// around; all of one entity, so that they are one portal.
void add_portal(const CellGrid& grid, Section& section, std::uint32_t material, BrushLevel& level) {
    const int axis = section.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    constexpr double kReach = 1.25;  // cells
    std::sort(section.cells.begin(), section.cells.end());
    std::vector<bool> covered(section.cells.size());
    const auto number = [&](std::int32_t a, std::int32_t b) {
        const std::array<std::int32_t, 2> cell{a, b};
        const auto at = std::lower_bound(section.cells.begin(), section.cells.end(), cell);
        return at != section.cells.end() && *at == cell ? std::size_t(at - section.cells.begin())
                                                        : section.cells.size();
    };
    const auto free_column = [&](std::int32_t a, std::int32_t low, std::int32_t high) {
        for (std::int32_t b = low; b <= high; ++b)
            if (const std::size_t k = number(a, b); k == section.cells.size() || covered[k]) return false;
        return true;
    };
    const auto entity = std::uint32_t(level.entities.size());
    level.entities.push_back({{{"classname", "func_areaportal"}}, 0});
    for (std::size_t k = 0; k < section.cells.size(); ++k) {
        if (covered[k]) continue;
        const auto [a, low] = section.cells[k];
        std::int32_t high = low, last = a;
        while (free_column(a, high + 1, high + 1)) ++high;
        while (free_column(last + 1, low, high)) ++last;
        for (std::int32_t i = a; i <= last; ++i)
            for (std::int32_t b = low; b <= high; ++b) covered[number(i, b)] = true;
        std::int32_t from[3], to[3];
        from[axis] = snapped(grid.low[axis] + section.layer * grid.cell);
        to[axis] = from[axis] + 16;
        from[u] = snapped(grid.low[u] + (a - kReach) * grid.cell);
        to[u] = snapped(grid.low[u] + (last + 1 + kReach) * grid.cell);
        from[v] = snapped(grid.low[v] + (low - kReach) * grid.cell);
        to[v] = snapped(grid.low[v] + (high + 1 + kReach) * grid.cell);
        add_portal_brush(axis, from, to, material, entity, level);
    }
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
    const auto sides = std::uint32_t(level.sides.size());
    std::vector<Section> sections;
    for (const std::vector<Gate>& opening : openings) {
        Section section;
        if (!smallest_section(grid, opening, section)) continue;
        std::sort(section.cells.begin(), section.cells.end());
        const auto same = [&](const Section& other) {
            return other.axis == section.axis && other.layer == section.layer && other.cells == section.cells;
        };
        if (std::none_of(sections.begin(), sections.end(), same)) sections.push_back(std::move(section));
    }
    SectionChooser(grid, sections, options.smallest_room / (grid.cell * grid.cell * grid.cell)).choose();
    for (Section& section : sections) add_portal(grid, section, material, level);
    // Sources of surfaces count on from the sides.
    for (LevelFace& face : level.surfaces.faces) face.source += std::uint32_t(level.sides.size()) - sides;
    return sections.size();
}

}  // namespace firma
