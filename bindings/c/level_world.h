// SPDX-License-Identifier: MIT
// From a level to a world that holds something.
#pragma once

#include <span>
#include <string>

#include "firma/brush_world.h"
#include "firma/level.h"

namespace firma::c {

/// Why a level came to nothing.
Error nothing_left(const std::string& name, std::span<const Omission> left_out);

inline Error nothing_left(const Level& level) {
    return nothing_left(level.name, level.omissions);
}
Error nothing_left(const BrushLevel& level);

/// As make_world(); but a level without a face is an error that says what its reader left out: such a world would
/// answer every cast with a miss.
template <class AnyLevel>
Result<World> make_level_world(const Result<AnyLevel>& level, const WorldOptions& options) {
    if (!level) return level.error();
    Result<World> world = make_world(level.value(), options);
    if (world && world.value().face_count() == 0) return nothing_left(level.value());
    return world;
}

}  // namespace firma::c
