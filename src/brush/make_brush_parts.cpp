// SPDX-License-Identifier: MIT
// Entities of a level that move, as parts.
#include <optional>
#include <utility>

#include "brush/judge_brush_level.h"
#include "brush/part_level.h"
#include "brush/part_paths.h"
#include "firma/brush_parts.h"
#include "world/judge_options.h"

namespace firma {
namespace {

/// Which entities have brushes that something would meet.
std::vector<bool> entities_that_move(const BrushLevel& level) {
    std::vector<bool> move(level.entities.size());
    for (const Brush& brush : level.brushes)
        if (brush.entity < move.size() && brush.part_kind != BrushKind::kData) move[brush.entity] = true;
    return move;
}

}  // namespace

Result<BrushParts> make_brush_parts(const BrushLevel& level, const WorldOptions& options) {
    if (auto error = judge_brush_level(level)) return *std::move(error);
    if (auto error = judge_options(options, level.name)) return *std::move(error);
    WorldOptions each = options;
    each.work = {};
    BrushParts made;
    const std::vector<bool> move = entities_that_move(level);
    for (std::uint32_t k = 0; k < move.size(); ++k) {
        if (!move[k]) continue;
        const auto note = [&](std::string reason) {
            if (!reason.empty()) made.notes.push_back({k, std::move(reason)});
        };
        PartLevel solid = part_level(level, k);
        if (!solid.fault.empty()) {
            note(std::move(solid.fault));
            continue;
        }
        BrushWorldReport report;
        Result<World> world = make_world(solid.level, each, &report);
        if (!world.ok()) {
            note("no world comes of its brushes: " + world.error().reason);
            continue;
        }
        BrushPart part;
        part.entity = k;
        part.world = std::move(world).value();
        const Box box = part.world.bounds();
        note(put_path(level, {solid.position, box.high - box.low, box.low.z, solid.has_origin}, part));
        for (const BrushNote& left : report.notes) note("of its brushes one is left out: " + left.reason);
        made.parts.push_back(std::move(part));
    }
    return made;
}

}  // namespace firma
