// SPDX-License-Identifier: MIT
// The float planes of a .bsp made exact: once per plane and its negative together, for all brushes that use them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brush/fit_plane.h"
#include "level/bsp_file.h"

namespace firma {

/// A brush's side, as the lumps say.
struct BspSide {
    std::uint32_t plane = 0;   ///< entry of the planes lump
    std::uint32_t shader = 0;  ///< entry of the shaders lump
    bool bounds = true;        ///< false: nothing of the brush lies on it, or next to nothing: left out
    double area = 0;           ///< of its face, square units
    std::uint32_t first_corner = 0, corner_count = 0;  ///< of its face, in BspBrushes::corners
};

struct BspSolid {
    std::uint32_t first_side = 0, side_count = 0;  ///< in BspBrushes::sides
    std::uint32_t shader = 0;
};

/// Every index and number checked; entry k of `brushes` is that of the lump.
struct BspBrushes {
    std::vector<FloatPlane> planes;  ///< of the lump, in the file's units, normals 1 long; unused ones as they come
    std::vector<BspSolid> brushes;
    std::vector<BspSide> sides;
    std::vector<Vec3> corners;
    double growth = 0;  ///< units: the most that a brush grew by a side left out
};

/// The lumps of planes, brushes and brush sides, and each side's face in double.
///
/// Compilers add planes around each brush that touch it in an edge or a vertex, for boxes to be cast against it. On the
/// grid such a plane could cut off a sliver; and in the file it does. So a side whose face is missing, or narrower than
/// half a unit, is left out where the brush then grows by no more than 1/64 unit.
///
/// @return kMalformed, kOutOfRange or kTooLarge with lump and entry
Result<BspBrushes> gather_bsp_brushes(const BspFile& file, double scale);

/// What became of the planes.
struct ExactPlanes {
    std::vector<std::optional<FittedPlane>> of_plane;  ///< by entry of the planes lump; nothing for unused ones
    std::uint64_t counts[4] = {};                      ///< plane pairs by FittedPlane::Points
};

/// @return kOutOfRange when a side's plane cannot be placed in the world
Result<ExactPlanes> make_exact_planes(const BspFile& file, const BspBrushes& brushes, double scale);

}  // namespace firma
