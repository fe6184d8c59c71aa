// SPDX-License-Identifier: MIT
// What holds loose pieces, by the options of the verbs that look for them, and by the level's firma_anchor brushes.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "firma/edit_log.h"
#include "firma/world.h"

namespace firma::cli {

struct AnchorArguments {
    std::string materials;  ///< as typed: names with commas between
    bool no_hanging = false;

    bool given() const { return no_hanging || !materials.empty(); }
};

/// Adds --anchors and --no-hanging.
void add_anchor_options(Command& command, AnchorArguments& arguments);

/// The level's world with what the options and its firma_anchor brushes say of its pieces; as it is where neither says
/// anything.
/// @throws Failure for a material that the world does not have
World anchored(const LoadedLevel& loaded, const AnchorArguments& arguments);

/// The same world; where nothing is said of it, what hangs free holds: as the first cut that looks for pieces finds
/// out.
World with_usual_anchors(const World& world);

/// The world that a log begins from: with the brushes, or without, as whoever wrote it had it.
World anchored_for(const EditLog& log, const LoadedLevel& loaded, const AnchorArguments& arguments);

/// How many of each kind hold: {materials, sources, edits, hanging, volumes}; null where nothing was said.
Json anchors_json(const World& world);
/// The same for people, "" where nothing was said.
std::string anchors_text(const World& world);

}  // namespace firma::cli
