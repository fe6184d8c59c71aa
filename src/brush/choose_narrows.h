// SPDX-License-Identifier: MIT
// Which of the narrows of the air divide it into rooms.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brush/find_narrows.h"
#include "firma/brush_world.h"

namespace firma {

/// Divides the cells at all narrows, and what is cut already, then joins rooms again whose opening to each other is not
/// narrow, or one of which is too small: the widest first. Narrows of which then only a part divides rooms, as others
/// cross them, are left out, and all begins again.
///
/// @param narrows  where two cut the same way, only the first one does
/// @param without  by narrow: not to be thought of
/// @return the narrows that still divide rooms, ascending
std::vector<std::uint32_t> choose_narrows(const AirGrid& grid, std::span<const Narrow> narrows,
                                          std::vector<bool> without, const DivideOptions& options);

}  // namespace firma
