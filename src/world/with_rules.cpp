// SPDX-License-Identifier: MIT
// The same world under other rules for carving.
#include "carve/judge_rules.h"
#include "world/world_data.h"

namespace firma {

Result<World> with_rules(const World& world, CarveRules rules) {
    if (auto error = judge_rules(rules, "")) return *std::move(error);
    auto data = std::make_shared<WorldData>(world.data());
    data->rules = std::make_shared<const CarveRules>(std::move(rules));
    return World(std::move(data));
}

}  // namespace firma
