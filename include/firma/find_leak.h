// SPDX-License-Identifier: MIT
// Where a level is open to the void.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/export.h"
#include "firma/masks.h"
#include "firma/world.h"

namespace firma {

/// A way through the air from a point to beyond all faces, for an author to see where a level leaks.
///
/// @param from  metres, in the air
/// @param mask  faces that share a bit stop the way; kStopsSight: walls alone, as glass and clips close nothing
/// @return the points of a line, `from` first, the last one outside the world's bounds; each sees the next. Empty where
///         there is no way, or none wide enough to be found: ways narrower than an eighth of a metre may not be
/// Looks at a lattice of points, ever finer; takes up to some seconds for a large level.
FIRMA_EXPORT std::vector<Vec3> find_leak(const World& world, const Vec3& from, std::uint32_t mask = kStopsSight);

}  // namespace firma
