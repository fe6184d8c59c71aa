// SPDX-License-Identifier: MIT
// What holds pieces of a world, said by the author.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "firma/chunk.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// In surface steps, from outside to within the world; nothing for one that holds no point of it.
std::optional<GridBox> grid_box_of(const Box& box) {
    GridBox made;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.low[axis] * kSurfaceSteps, high = box.high[axis] * kSurfaceSteps;
        if (!(low <= high) || !(low <= double(INT32_MAX)) || !(high >= double(INT32_MIN))) return std::nullopt;
        made.low[axis] = std::int32_t(std::max(std::floor(low), double(INT32_MIN)));
        made.high[axis] = std::int32_t(std::min(std::ceil(high), double(INT32_MAX)));
    }
    return made;
}

}  // namespace

World with_anchors(const World& world, const AnchorRules& rules) {
    auto data = std::make_shared<WorldData>(world.data());
    auto anchors = std::make_shared<Anchors>();
    const std::vector<std::string>& names = *data->materials;
    for (std::uint32_t material = 0; material < names.size(); ++material)
        if (std::find(rules.materials.begin(), rules.materials.end(), names[material]) != rules.materials.end())
            anchors->materials.push_back(material);
    anchors->sources = rules.sources;
    std::sort(anchors->sources.begin(), anchors->sources.end());
    anchors->sources.erase(std::unique(anchors->sources.begin(), anchors->sources.end()), anchors->sources.end());
    for (const Box& volume : rules.volumes)
        if (const std::optional<GridBox> box = grid_box_of(volume)) anchors->volumes.push_back(*box);
    const auto corners = [](const GridBox& box) { return std::pair(box.low, box.high); };
    std::sort(anchors->volumes.begin(), anchors->volumes.end(),
              [&](const GridBox& a, const GridBox& b) { return corners(a) < corners(b); });
    anchors->volumes.erase(std::unique(anchors->volumes.begin(), anchors->volumes.end()), anchors->volumes.end());
    if (rules.hanging) anchors->hanging = find_hanging(data->solid.data().faces.root.get());
    data->anchors = std::move(anchors);
    return World(std::move(data));
}

}  // namespace firma
