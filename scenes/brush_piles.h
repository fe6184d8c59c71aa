// SPDX-License-Identifier: MIT
// Random levels of brushes, made to be hard to join: shared planes, overlaps, slivers, nested and touching brushes.
#pragma once

#include <cstdint>

#include "firma/brush_level.h"

namespace firma::scenes {

enum class BrushPile : std::uint8_t {
    kBoxes,           ///< on a coarse grid: faces lie in common planes, against each other and on each other
    kNested,          ///< boxes in boxes, some equal, some sharing a corner, an edge or a face
    kInitialOverlap,  ///< boxes and wedges that touch along edges and in vertices, from outside
    kWedges,          ///< prisms and tetrahedra with corners on a coarse grid: many planes through one point
    kCrystals,        ///< tetrahedra with corners anywhere on the input grid
    kSlivers,         ///< boxes of a grid step or a few thickness, and tetrahedra nearly flat
    kHalls,           ///< rooms of boxes for walls, divided by portals in their doorways
};
inline constexpr int kBrushPiles = 7;

/// @param brushes  about how many; of kHalls a few a room
/// @return with nothing but brushes, one material a brush number modulo three; within 16 m of the origin
BrushLevel brush_pile(BrushPile kind, std::uint64_t seed, int brushes);

/// Appends a box.
/// @param low, high  input steps, low < high along each axis
void add_box(BrushLevel& level, const std::int32_t (&low)[3], const std::int32_t (&high)[3],
             BrushKind kind = BrushKind::kSolid);

}  // namespace firma::scenes
