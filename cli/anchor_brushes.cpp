// SPDX-License-Identifier: MIT
// A volume holds what a box cut out of the solid there would take something of.
#include "cli/anchor_brushes.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>

#include "firma/grid.h"
#include "firma/solid.h"

namespace firma::cli {

namespace {

/// The brush alone, as a level of one entity.
BrushLevel alone(const BrushLevel& level, const Brush& brush) {
    BrushLevel one;
    one.entities = {level.entities[brush.entity]};
    const std::span<const BrushSide> sides = std::span(level.sides).subspan(brush.first_side, brush.side_count);
    one.sides.assign(sides.begin(), sides.end());
    one.brushes = {brush};
    one.brushes[0].entity = 0;
    one.brushes[0].first_side = 0;
    return one;
}

/// A step wider all around: a volume holds what it only touches as well.
Result<Cutter> box_around(const Box& box) {
    constexpr double kStep = 1.0 / kInputSteps;
    std::array<Vec3, 8> corners;
    for (unsigned k = 0; k < 8; ++k)
        for (int axis = 0; axis < 3; ++axis)
            corners[k][axis] = k >> axis & 1 ? box.high[axis] + kStep : box.low[axis] - kStep;
    constexpr std::array<CutterTriangle, 12> kTriangles{{{0, 2, 3},
                                                         {0, 3, 1},
                                                         {4, 5, 7},
                                                         {4, 7, 6},
                                                         {0, 1, 5},
                                                         {0, 5, 4},
                                                         {2, 6, 7},
                                                         {2, 7, 3},
                                                         {0, 4, 6},
                                                         {0, 6, 2},
                                                         {1, 3, 7},
                                                         {1, 7, 5}}};
    return make_cutter(corners, kTriangles, "anchor");
}

/// Whether any solid reaches into a volume. True where that cannot be told: beyond the world, say.
bool holds_solid(const World& world, const Box& volume) {
    const Result<Cutter> cutter = box_around(volume);
    return !cutter || subtract(world.solid(), cutter.value(), {}).status != CarveStatus::kNothing;
}

}  // namespace

AnchorBrushes judge_anchors(const BrushLevel& level, const World& world) {
    AnchorBrushes found;
    for (std::uint32_t entity = 0; entity < level.entities.size(); ++entity) {
        if (level.entities[entity].value("classname") != "firma_anchor") continue;
        bool any = false;
        for (std::size_t k = 0; k < level.brushes.size(); ++k) {
            const Brush& brush = level.brushes[k];
            if (brush.entity != entity) continue;
            any = true;
            const std::vector<Box> volumes = anchor_volumes(alone(level, brush));
            found.volumes += volumes.size();
            if (volumes.empty())
                found.notes.push_back({entity, fmt::format("brush {} is open, or has no volume", k)});
            else if (!holds_solid(world, volumes[0]))
                found.notes.push_back({entity, fmt::format("no solid reaches into brush {}", k)});
        }
        if (!any) found.notes.push_back({entity, "it has no brush"});
    }
    return found;
}

}  // namespace firma::cli
