// SPDX-License-Identifier: MIT
// Rules for carving that a program gives: do they make sense?
#pragma once

#include <optional>
#include <string>

#include "firma/result.h"
#include "firma/solid.h"

namespace firma {

/// kInvalid for a hardness that is not within 0..1, a zone whose box is empty or not of numbers, a bound on the
/// cutter's size that is no length above zero.
/// @param name  for messages: of the level, or of the call; may be empty
std::optional<Error> judge_rules(const CarveRules& rules, const std::string& name);

/// Whether CarveRules::merge_share is one.
bool is_merge_share(double share);

/// Also for boxes that reach to infinity; false for boxes not of numbers.
bool holds_points(const Box& box);

}  // namespace firma
