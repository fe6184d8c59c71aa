// SPDX-License-Identifier: MIT
// What each of two versions of a world holds that the other does not.
#pragma once

#include <cstddef>

#include "firma/world.h"

namespace firma {

/// Bytes, counted as memory_used() counts them.
struct BytesApart {
    std::size_t gone = 0;  ///< of `before` only
    std::size_t come = 0;  ///< of `after` only
};

/// For versions of one world memory_used of both is that of `after` plus `gone`, or that of `before` plus `come`. Opens
/// only blocks that differ, so the cost follows the edit; a world of nothing in common is walked whole.
BytesApart bytes_apart(const World& before, const World& after);

}  // namespace firma
