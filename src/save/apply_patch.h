// SPDX-License-Identifier: MIT
// apply_patch() with its checks chosen: tests compare one with the other.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "firma/result.h"
#include "firma/world.h"

namespace firma {

struct PatchChecks {
    bool whole = false;  ///< judges all of the world that is made, not what was exchanged and its border
    bool hash = true;    ///< compares its hash with what the patch says
};

Result<World> apply_patch(const World& world, std::span<const std::byte> patch, std::string name,
                          const PatchChecks& checks);

}  // namespace firma
