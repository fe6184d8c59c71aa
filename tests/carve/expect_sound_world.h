// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "firma/carve.h"

namespace firma::test {

/// What must hold of a world after any edit.
inline void expect_sound_world(const World& world) {
    const std::optional<WorldFault> fault = check_world(world);
    EXPECT_FALSE(fault) << fault->what << ", face " << fault->face.value;
    const auto solid = check_solid(world);
    EXPECT_FALSE(solid) << solid->what;
}

}  // namespace firma::test
