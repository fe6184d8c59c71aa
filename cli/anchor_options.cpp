// SPDX-License-Identifier: MIT
// Names of materials and brushes become anchors.
#include "cli/anchor_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/failure.h"
#include "cli/numbers.h"
#include "firma/brush_world.h"
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

/// @param volumes  that hold; none: by the options alone
World anchored_by(const World& world, const AnchorArguments& arguments, std::vector<Box> volumes) {
    if (!arguments.given() && volumes.empty()) return world;
    AnchorRules rules;
    rules.hanging = !arguments.no_hanging;
    rules.volumes = std::move(volumes);
    if (!arguments.materials.empty()) rules.materials = names_in(arguments.materials);
    const std::vector<std::string>& known = *world.data().materials;
    for (const std::string& name : rules.materials)
        if (name.empty() || std::find(known.begin(), known.end(), name) == known.end())
            throw Failure("--anchors", fmt::format("the level has no material '{}'", name));
    return with_anchors(world, rules);
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

World anchored(const LoadedLevel& loaded, const AnchorArguments& arguments) {
    return anchored_by(loaded.world, arguments,
                       loaded.brushes ? anchor_volumes(loaded.brushes->level) : std::vector<Box>());
}

World with_usual_anchors(const World& world) {
    return world.data().anchors ? world : with_anchors(world);
}

World anchored_for(const EditLog& log, const LoadedLevel& loaded, const AnchorArguments& arguments) {
    const auto is_its_own = [&](const World& world) { return EditLog(world).rules_hash() == log.rules_hash(); };
    const World with_brushes = anchored(loaded, arguments);
    if (is_its_own(with_brushes)) return with_brushes;
    // Commands that look for no pieces need none; a game may do without.
    const World without = anchored_by(loaded.world, arguments, {});
    return is_its_own(without) ? without : with_brushes;
}

Json anchors_json(const World& world) {
    const Anchors* anchors = world.data().anchors.get();
    if (!anchors) return {};
    return {{"materials", anchors->materials.size()},
            {"sources", anchors->sources.size()},
            {"edits", anchors->edits.size()},
            {"hanging", anchors->hanging.size()},
            {"volumes", anchors->volumes.size()}};
}

std::string anchors_text(const World& world) {
    const Anchors* anchors = world.data().anchors.get();
    if (!anchors) return "";
    const auto sum = anchors->materials.size() + anchors->sources.size() + anchors->edits.size();
    const std::size_t volumes = anchors->volumes.size();
    return fmt::format("{}{} and {} that hung free", counted(sum, "anchor"),
                       volumes > 0 ? ", " + counted(volumes, "volume") : "", counted(anchors->hanging.size(), "face"));
}

}  // namespace firma::cli
