// SPDX-License-Identifier: MIT
// The same world under other rules for carving.
#include "world/world_data.h"

namespace firma {

World with_rules(const World& world, CarveRules rules) {
    auto data = std::make_shared<WorldData>(world.data());
    data->rules = std::make_shared<const CarveRules>(std::move(rules));
    return World(std::move(data));
}

}  // namespace firma
