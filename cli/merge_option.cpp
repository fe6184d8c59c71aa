// SPDX-License-Identifier: MIT
// A share becomes a rule of the world.
#include "cli/merge_option.h"

#include <utility>

#include "cli/failure.h"
#include "cli/numbers.h"
#include "world/world_data.h"

namespace firma::cli {

void add_merge_option(Command& command, std::string& share) {
    command.add_option(
        "--merge-share", share, "X",
        "rooms become one where holes between them are larger than X times the smaller one's walls; 0: never");
}

World with_merge_share(const World& world, const std::string& share) {
    if (share.empty()) return world;
    CarveRules rules = world.data().rules ? *world.data().rules : CarveRules();
    rules.merge_share = number_option("--merge-share", share, 0, 1e12);
    Result<World> made = with_rules(world, std::move(rules));
    if (!made) throw Failure(made.error());
    return std::move(made).value();
}

double merge_share_of(const World& world) {
    return world.data().rules ? world.data().rules->merge_share : 0;
}

}  // namespace firma::cli
