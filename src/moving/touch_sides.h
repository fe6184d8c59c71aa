// SPDX-License-Identifier: MIT
// Which faces of a world lie at the flat sides of a thing, and by how much: what holds it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/support.h"

namespace firma {

/// The six sides of a box, each with half of the box behind it.
std::vector<SupportSide> sides_of_box(const Box& box);

/// A part of a face that lies at a side.
struct TouchedPart {
    std::uint64_t hash = 0;  ///< of the whole face
    FaceRef face;
    std::vector<Vec3> corners;  ///< metres
    double area = 0;            ///< square metres
    double lowest = 0;          ///< metres in front of the side, of the corner that is least so
};

/// What of the world's faces lies at sides, side by side, of each by id.
/// @param reach   metres in front of a side
/// @param behind  metres behind it, at least its depth
std::vector<TouchedPart> touched_parts(const World& world, std::span<const SupportSide> sides, double reach,
                                       double behind, std::uint32_t mask);

/// A box around all that touched_parts() may find.
Box box_of_sides(std::span<const SupportSide> sides, double reach, double behind);

}  // namespace firma
