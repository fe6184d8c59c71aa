// SPDX-License-Identifier: MIT
// A world's bounds, rooms, solid and tree, for `firma info` of whatever file.
#pragma once

#include <string>

#include "cli/json.h"
#include "firma/world.h"

namespace firma::cli {

/// Adds bounds, rooms, tree and solid.
void add_world(Json& json, const World& world);

/// A line of `firma info`.
std::string info_row(const char* what, const std::string& value);

/// The same for people, a row each.
std::string world_text(const World& world);

}  // namespace firma::cli
