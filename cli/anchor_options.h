// SPDX-License-Identifier: MIT
// What holds loose pieces, as options of the verbs that look for them.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/json.h"
#include "firma/world.h"

namespace firma::cli {

struct AnchorArguments {
    std::string materials;  ///< as typed: names with commas between
    bool no_hanging = false;

    bool given() const { return no_hanging || !materials.empty(); }
};

/// Adds --anchors and --no-hanging.
void add_anchor_options(Command& command, AnchorArguments& arguments);

/// The same world with what the options say of its pieces; itself where none is given.
/// @throws Failure for a material that the world does not have
World anchored(const World& world, const AnchorArguments& arguments);

/// How many of each kind hold: {materials, sources, edits, hanging}; null where nothing was said.
Json anchors_json(const World& world);
/// The same for people, "" where nothing was said.
std::string anchors_text(const World& world);

}  // namespace firma::cli
