// SPDX-License-Identifier: MIT
// A brush as a convex body: the polygons on its planes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "join/convex_piece.h"

namespace firma {

struct BrushShape {
    struct Face {
        ConvexPiece piece;       ///< its front looks out of the brush
        std::uint32_t side = 0;  ///< which of the planes given
    };
    std::vector<Face> faces;             ///< of the planes that bound it; others are not needed
    std::vector<std::uint32_t> corners;  ///< each once
    GridBox box;                         ///< around them, rounded
};

enum class BrushFault : std::uint8_t {
    kNone,
    kEmpty,    ///< its half spaces have no volume in common
    kOpen,     ///< its half spaces do not close it, or it reaches out of the world
    kTooMany,  ///< more planes than a brush may have
};

inline constexpr std::size_t kMostBrushPlanes = 1024;

/// @param planes  their fronts look out of the brush; ones that bound nothing do not matter, nor do repeated ones
BrushFault make_brush_shape(ExactTables& tables, std::span<const PlaneId> planes, BrushShape& shape);

}  // namespace firma
