// SPDX-License-Identifier: MIT
// The brushes of one entity that moves, as a level of their own in the frame of the part.
#pragma once

#include <cstdint>
#include <string>

#include "firma/brush_level.h"

namespace firma {

struct PartLevel {
    BrushLevel level;
    Vec3 position;  ///< of the frame in the level, metres
    bool has_origin = false;
    std::string fault;  ///< why there is none: a clause; empty where there is
};

PartLevel part_level(const BrushLevel& level, std::uint32_t entity);

}  // namespace firma
