// SPDX-License-Identifier: MIT
// A hash of rules for carving: edits depend on them, and a world's hash does not see them.
#pragma once

#include <cstdint>

#include "firma/solid.h"

namespace firma {

/// Of everything that they say. A new rule gets its term here.
std::uint64_t hash_rules(const CarveRules& rules);

}  // namespace firma
