// SPDX-License-Identifier: MIT
// A mover against a part that turns, and a hull against one that stands turned.
#pragma once

#include "moving/part_frame.h"

namespace firma {

/// @param part    its motion is usable
/// @param latest  a touch later than this fraction need not be found
/// @return the first touch, in the world; kInvalid for a mover beyond kMaxPartReach
Hit cast_turning(const PartNow& part, const MoverCore& mover, const Vec3& path, double latest,
                 const CastOptions& options);

}  // namespace firma
