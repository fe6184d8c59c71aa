// SPDX-License-Identifier: MIT
// How an entity moves, by its class and keys.
#pragma once

#include <string>

#include "firma/brush_parts.h"

namespace firma {

/// What path_of_entity() has to know of the part besides.
struct PartPlace {
    Vec3 position;      ///< of the frame, metres
    Vec3 size;          ///< of the box around the solid, metres
    double lowest = 0;  ///< of that box, in the frame
    bool has_origin = false;
};

/// Fills path, when_blocked, waits_for_trigger, breaks, and what goes with it.
/// @param part  its entity is set
/// @return a note, or "": what is odd about it
std::string put_path(const BrushLevel& level, const PartPlace& place, BrushPart& part);

}  // namespace firma
