// SPDX-License-Identifier: MIT
// Levels of brushes of several matters, for tests of matter.
#pragma once

#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/matter.h"
#include "tests/brush/map_text.h"

namespace firma::test {

/// Units of the map are metres.
inline World brush_world(const std::string& content, const WorldOptions& options = {}) {
    const Result<BrushLevel> level = read_map(map_text::world(content), "test.map", {.scale = 1});
    return make_world(level.value(), options).value();
}

/// A wall of three brushes side by side along x, 4 m deep: brick from 0, wood from 4, steel from 8 to 12.
inline std::string three_matters() {
    return map_text::box({0, 0, 0}, {4, 4, 4}, "old_brick") + map_text::box({4, 0, 0}, {8, 4, 4}, "wood_panel") +
           map_text::box({8, 0, 0}, {12, 4, 4}, "steel");
}

inline std::string name_at(const World& world, const Vec3& point) {
    return matter(world, matter_at(world, point)).name;
}

}  // namespace firma::test
