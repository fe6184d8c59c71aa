// SPDX-License-Identifier: MIT
// From a level to its cells, their narrows, the portals among these.
#include "firma/brush_world.h"

#include "brush/choose_portals.h"
#include "brush/judge_brush_level.h"
#include "firma/brush_level.h"

namespace firma {
namespace {

constexpr std::size_t kMostNarrows = 20000;  ///< of more, the narrowest

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

bool is_usable(double number) {
    return is_finite(number) && number >= 0;
}

}  // namespace

Result<BrushLevel> divide_rooms(const BrushLevel& level, const DivideOptions& options, DivideReport* report) {
    if (!is_usable(options.narrow) || !is_usable(options.min_room_volume))
        return Error{ErrorCode::kInvalid, level.name, "rooms are divided by numbers that are finite and not negative"};
    if (auto error = judge_brush_level(level)) return *std::move(error);
    DivideReport found;
    BrushLevel divided = level;
    const std::optional<AirGrid> grid = AirGrid::make(level, options.max_cells);
    if (grid) {
        found.cells = grid->cells();
        std::vector<Narrow> narrows = find_narrows(*grid, inside_of_hull(level, *grid));
        found.narrows = narrows.size();
        if (narrows.size() > kMostNarrows) narrows.resize(kMostNarrows);
        found.untried = found.narrows - narrows.size();
        const Result<PortalChoice> choice = choose_portals(level, *grid, narrows, options);
        if (!choice.ok()) return choice.error();
        for (const std::uint32_t k : choice.value().narrows) add_portal(divided, *grid, narrows[k]);
        found.idle = choice.value().idle;
    }
    found.portals = divided.brushes.size() - level.brushes.size();
    if (report) *report = found;
    return divided;
}

}  // namespace firma
