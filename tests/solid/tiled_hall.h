// SPDX-License-Identifier: MIT
#pragma once

#include "tests/solid/solid_levels.h"

namespace firma::test {

/// A room whose walls are tiled, some slanted so that pieces have several facets.
inline Level tiled_hall() {
    Level level = empty_level();
    const Vec3 base[4] = {{0, 0, 0}, {61, 3, 0.5}, {58, 47, 0}, {-2, 44, 1}};
    Vec3 top[4];
    for (int k = 0; k < 4; ++k) top[k] = base[k] + Vec3{k * 0.7, 1.1 * k, 12.0 + k};
    const auto triangle = [&](const Vec3& a, const Vec3& b, const Vec3& c) { add_polygon(level, {a, b, c}); };
    triangle(base[0], base[1], base[2]);
    triangle(base[0], base[2], base[3]);
    triangle(top[2], top[1], top[0]);
    triangle(top[3], top[2], top[0]);
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        triangle(base[next], base[k], top[k]);
        triangle(base[next], top[k], top[next]);
    }
    return level;
}

}  // namespace firma::test
