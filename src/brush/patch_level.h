// SPDX-License-Identifier: MIT
// Patches as castable faces: what a brush level has beside its brushes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firma/level.h"
#include "level/patch.h"

namespace firma {

struct PatchSurface {
    Patch patch;          ///< in the file's units; the front is along a row's direction to a column's
    Patch uvs;            ///< of its control points: x and y are u and v, in repeats; empty where there are none
    std::string place;    ///< for errors
    std::string texture;  ///< material
    std::uint32_t source = 0;
    std::uint32_t line = 0;
    std::uint32_t mask = 0;
};

/// All patches divided together, so that those that share a rim meet.
///
/// @param patches  in order of source, each below source_end
/// @param name     of the level, and of the file in errors
/// @return kOutOfRange for a point outside the world, with the patch's place; kTooLarge when they make more than 2^22
///         cells at the options' tolerance
Result<Level> make_patch_level(std::span<const PatchSurface> patches, std::string name, std::uint32_t source_end,
                               double scale, double patch_tolerance);

}  // namespace firma
