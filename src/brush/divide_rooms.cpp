// SPDX-License-Identifier: MIT
// Narrows of the sampled air become portals, and the exact model says which of them are any.
#include "firma/divide_rooms.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>

#include "brush/air_grid.h"
#include "brush/choose_narrows.h"
#include "brush/entity_origin.h"
#include "brush/find_narrows.h"
#include "brush/judge_brush_level.h"
#include "join/join_brushes.h"

namespace firma {
namespace {

constexpr double kThick = 0.015625;          ///< metres: a portal's brush; any will do
constexpr std::size_t kMostNarrows = 20000;  ///< of more, the narrowest
constexpr int kMostRounds = 8;               ///< of choosing others in place of idle ones

/// The cells that the outside of a closed hull does not lead to; empty where the level may be meant to be open.
std::vector<bool> inside_of_hull(const BrushLevel& level, const AirGrid& grid) {
    std::vector<bool> inside(grid.cells(), true);
    std::vector<std::uint32_t> waiting;
    const auto reach = [&](std::size_t cell) {
        if (!inside[cell]) return;
        inside[cell] = false;
        waiting.push_back(std::uint32_t(cell));
    };
    reach(0);
    while (!waiting.empty()) {
        const std::size_t cell = waiting.back();
        waiting.pop_back();
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t stride = grid.stride(axis);
            if (grid.is_free(cell, axis)) reach(cell + stride);
            if (cell >= stride && grid.is_free(cell - stride, axis)) reach(cell - stride);
        }
    }
    for (const Entity& entity : level.entities) {
        if (!entity.value("classname").starts_with("info_player")) continue;
        const std::optional<Vec3> place = entity_origin(level, entity);
        const std::optional<std::size_t> cell = place ? grid.cell_at(*place) : std::nullopt;
        if (cell && grid.is_air(*cell) && inside[*cell]) return inside;
    }
    return {};
}

/// A box as a brush; its portal is the side that looks along `axis`.
void add_portal(BrushLevel& level, int axis, const Vec3& low, const Vec3& high) {
    Brush brush;
    brush.kind = BrushKind::kPortal;
    brush.first_side = std::uint32_t(level.sides.size());
    brush.side_count = 6;
    for (int k = 0; k < 3; ++k)
        for (const bool positive : {true, false}) {
            const int along = (axis + k) % 3, u = (along + 1) % 3, v = (along + 2) % 3;
            Vec3 corners[3] = {low, low, low};
            corners[1][u] = corners[2][u] = high[u];
            corners[2][v] = high[v];
            BrushSide side;
            for (int c = 0; c < 3; ++c) {
                corners[c][along] = positive ? high[along] : low[along];
                side.points[positive ? c : 2 - c] = snap(corners[c]).value();
            }
            side.portal = positive && along == axis;
            level.sides.push_back(side);
        }
    level.brushes.push_back(brush);
}

void add_portal(BrushLevel& level, const AirGrid& grid, const Narrow& narrow) {
    constexpr double kRim = kWorldRim - 1;
    Vec3 low, high;
    high[narrow.axis] = std::clamp(grid.centre(narrow.axis, narrow.layer), -kRim, kRim);
    low[narrow.axis] = high[narrow.axis] - kThick;
    for (int k = 0; k < 2; ++k) {
        const int across = (narrow.axis + 1 + k) % 3;
        low[across] = std::clamp(narrow.low[k], -kRim, kRim);
        high[across] = std::clamp(narrow.high[k], -kRim, kRim);
    }
    add_portal(level, narrow.axis, low, high);
}

BrushLevel with_portals(const BrushLevel& level, const AirGrid& grid, std::span<const Narrow> narrows,
                        std::span<const std::uint32_t> chosen) {
    BrushLevel divided = level;
    for (const std::uint32_t k : chosen) add_portal(divided, grid, narrows[k]);
    return divided;
}

/// Which of the portals from brush `first` on divide two rooms in the exact model.
Result<std::vector<bool>> used_portals(const BrushLevel& level, std::size_t first) {
    const Result<std::unique_ptr<JoinedLevel>> joined = join_brushes(level);
    if (!joined.ok()) return joined.error();
    std::vector<bool> used_side(level.sides.size()), used;
    for (const JoinPortal& portal : joined.value()->portals) used_side[portal.source] = true;
    for (std::size_t b = first; b < level.brushes.size(); ++b) used.push_back(used_side[level.brushes[b].first_side]);
    return used;
}

/// Chooses narrows, leaves out those that divide nothing in the exact model, and looks whether others may take their
/// places. Leaving out an idle portal joins no rooms: what is left of a choice needs no second test.
///
/// @return of all choices that which divides the level by the most portals
Result<std::vector<std::uint32_t>> choose_exactly(const BrushLevel& level, const AirGrid& grid,
                                                  std::span<const Narrow> narrows, const DivideOptions& options,
                                                  DivideReport& report) {
    std::vector<bool> idle(narrows.size());
    std::vector<std::uint32_t> best;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<std::uint32_t> chosen = choose_narrows(grid, narrows, idle, options);
        if (chosen.size() <= best.size()) break;
        const Result<std::vector<bool>> used =
            used_portals(with_portals(level, grid, narrows, chosen), level.brushes.size());
        if (!used.ok()) return used.error();
        std::vector<std::uint32_t> good;
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            if (used.value()[k])
                good.push_back(chosen[k]);
            else
                idle[chosen[k]] = true;
        }
        report.idle += chosen.size() - good.size();
        if (good.size() > best.size()) best = good;
        if (good.size() == chosen.size()) break;
    }
    return best;
}

bool is_usable(double number) {
    return std::isfinite(number) && number >= 0;
}

}  // namespace

Result<BrushLevel> divide_rooms(const BrushLevel& level, const DivideOptions& options, DivideReport* report) {
    if (!is_usable(options.narrow) || !is_usable(options.smallest_room))
        return Error{ErrorCode::kInvalid, level.name, "rooms are divided by numbers that are finite and not negative"};
    if (auto error = judge_brush_level(level)) return *std::move(error);
    DivideReport found;
    BrushLevel divided = level;
    const std::optional<AirGrid> grid = AirGrid::make(level, options.most_cells);
    if (grid) {
        found.cells = grid->cells();
        std::vector<Narrow> narrows = find_narrows(*grid, inside_of_hull(level, *grid));
        found.narrows = narrows.size();
        if (narrows.size() > kMostNarrows) narrows.resize(kMostNarrows);
        const Result<std::vector<std::uint32_t>> chosen = choose_exactly(level, *grid, narrows, options, found);
        if (!chosen.ok()) return chosen.error();
        divided = with_portals(level, *grid, narrows, chosen.value());
    }
    found.portals = divided.brushes.size() - level.brushes.size();
    if (report) *report = found;
    return divided;
}

}  // namespace firma
