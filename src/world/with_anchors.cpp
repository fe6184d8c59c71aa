// SPDX-License-Identifier: MIT
// What holds pieces of a world, said by the author.
#include <algorithm>

#include "firma/chunk.h"
#include "world/world_data.h"

namespace firma {

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
    if (rules.hanging) anchors->hanging = find_hanging(data->solid.data().faces.root.get());
    data->anchors = std::move(anchors);
    return World(std::move(data));
}

}  // namespace firma
