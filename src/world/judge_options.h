// SPDX-License-Identifier: MIT
// How a world is to be made: does it make sense?
#pragma once

#include <optional>
#include <string>

#include "firma/result.h"
#include "firma/world.h"

namespace firma {

/// kInvalid for a contact offset that is not a finite length, and as judge_rules() and check_matters(). Options of
/// trees have no such: those out of range count as the nearest.
/// @param name  for messages
std::optional<Error> judge_options(const WorldOptions& options, const std::string& name);

}  // namespace firma
