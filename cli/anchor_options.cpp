// SPDX-License-Identifier: MIT
// Names of materials become anchors.
#include "cli/anchor_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/failure.h"
#include "cli/numbers.h"
#include "firma/chunk.h"
#include "world/world_data.h"

namespace firma::cli {

namespace {

std::vector<std::string> names_in(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        names.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

}  // namespace

void add_anchor_options(Command& command, AnchorArguments& arguments) {
    command.add_option("--anchors", arguments.materials, "NAME,...",
                       "materials whose faces hold the pieces that they belong to; for loose chunks");
    command.add_flag(
        "--no-hanging", arguments.no_hanging,
        "what hangs free in LEVEL is not held for that: of a level without rock around it, name what holds "
        "it up by --anchors");
}

World anchored(const World& world, const AnchorArguments& arguments) {
    if (!arguments.given()) return world;
    AnchorRules rules;
    rules.hanging = !arguments.no_hanging;
    if (!arguments.materials.empty()) rules.materials = names_in(arguments.materials);
    const std::vector<std::string>& known = *world.data().materials;
    for (const std::string& name : rules.materials)
        if (name.empty() || std::find(known.begin(), known.end(), name) == known.end())
            throw Failure("--anchors", fmt::format("the level has no material '{}'", name));
    return with_anchors(world, rules);
}

Json anchors_json(const World& world) {
    const Anchors* anchors = world.data().anchors.get();
    if (!anchors) return {};
    return {{"materials", anchors->materials.size()},
            {"sources", anchors->sources.size()},
            {"edits", anchors->edits.size()},
            {"hanging", anchors->hanging.size()}};
}

std::string anchors_text(const World& world) {
    const Anchors* anchors = world.data().anchors.get();
    if (!anchors) return "";
    const auto sum = anchors->materials.size() + anchors->sources.size() + anchors->edits.size();
    return fmt::format("{} and {} that hung free", counted(sum, "anchor"), counted(anchors->hanging.size(), "face"));
}

}  // namespace firma::cli
