// SPDX-License-Identifier: MIT
// The rule by which rooms become one, as an option of the verbs that make or replay edits.
#pragma once

#include <string>

#include "cli/command.h"
#include "firma/world.h"

namespace firma::cli {

/// Adds --merge-share.
void add_merge_option(Command& command, std::string& share);

/// The world with CarveRules::merge_share as typed, its other rules as they are; as it is where nothing was typed.
/// @throws Failure for what is no share
World with_merge_share(const World& world, const std::string& share);

/// CarveRules::merge_share of a world.
double merge_share_of(const World& world);

}  // namespace firma::cli
