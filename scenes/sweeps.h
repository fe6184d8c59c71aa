// SPDX-License-Identifier: MIT
// Sweeps: many overlapping capsules, cylinders and boxes along a path through a block, at any scale.
//
// The first third goes along straight lines on the block's top by whole lengths of a tool: ends lie flush on ends,
// sides on sides. The rest follows a curve into the block and out of it. Sums, products, quotients and square roots
// alone: bench/node/sweeps.mjs makes the same numbers.
#pragma once

#include <string_view>
#include <vector>

#include "firma/cutter.h"
#include "firma/level.h"

namespace firma::scenes {

enum class SweepTool { kCapsule, kCylinder, kBox };
inline constexpr SweepTool kSweepTools[] = {SweepTool::kCapsule, SweepTool::kCylinder, SweepTool::kBox};
std::string_view name_of(SweepTool tool);

/// The largest exponent: what it needs lies within the world, and within the whole numbers that float32 holds.
inline constexpr int kLargestSweep = 13;
inline constexpr std::size_t kSweepCuts = 120;

struct Sweep {
    Level block;              ///< a cube of 2^exponent metres around the origin
    Cutter tool;              ///< 1/16 of that in radius, along z
    std::vector<Pose> poses;  ///< as many as kSweepCuts
};

/// @param exponent  0 to kLargestSweep
Sweep make_sweep(SweepTool tool, int exponent);

}  // namespace firma::scenes
