// SPDX-License-Identifier: MIT
// A hash of rules for carving, and of what holds loose pieces: edits depend on them, and a world's hash does not see
// them.
#pragma once

#include <cstdint>

#include "firma/solid.h"
#include "solid/anchors.h"

namespace firma {

/// Of everything that they say. A new rule gets its term here.
/// @param anchors  null: nothing was said
std::uint64_t hash_rules(const CarveRules& rules, const Anchors* anchors);

}  // namespace firma
