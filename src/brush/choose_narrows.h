// SPDX-License-Identifier: MIT
// Which of the narrows of the air divide it into rooms.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brush/find_narrows.h"
#include "firma/divide_rooms.h"

namespace firma {

/// Divides the cells at all narrows, and what is cut already, then joins rooms again whose opening to each other is not
/// narrow, or one of which is too small: the widest first.
///
/// @param narrows  where two cut the same way, only the first one does
/// @return the narrows that still divide rooms, ascending
std::vector<std::uint32_t> choose_narrows(AirGrid& grid, std::span<const Narrow> narrows, const DivideOptions& options);

}  // namespace firma
