// SPDX-License-Identifier: MIT
// Several edits as one: the last world, as if it were the version after the first.
#pragma once

#include <memory>

#include "world/world_data.h"

namespace firma {

/// @param after  made of `before` by any number of edits
inline World as_one_version(const World& before, const World& after) {
    if (after.version() - before.version() <= 1) return after;  // never below: there is no edit after the last version
    auto data = std::make_shared<WorldData>(after.data());
    data->version = before.version() + 1;
    return World(std::move(data));
}

}  // namespace firma
