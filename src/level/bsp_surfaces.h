// SPDX-License-Identifier: MIT
// The drawn surfaces of a .bsp's first model, every index and number checked: what read_bsp() and check_bsp() share.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firma/grid.h"
#include "firma/level.h"
#include "firma/texture.h"
#include "firma/vec.h"
#include "level/bsp_file.h"

namespace firma {

/// A surface to cast against. Its corners are BspSurfaces::corners[first_corner .. + corner_count):
/// three a triangle, counter-clockwise seen from the front; or a patch's control points, row by row, the front being
/// along x to y (a row's direction to a column's).
struct BspSurface {
    std::uint32_t face = 0;  ///< entry of the faces lump
    FaceKind kind = FaceKind::kPolygon;
    std::uint32_t shader = 0;
    std::uint32_t first_corner = 0;
    std::uint32_t corner_count = 0;
    bool flat = false;        ///< planar, and the file gives a normal that its corners bear out; terrain has none
    std::uint32_t width = 0;  ///< control points in a row of a patch
    std::uint32_t height = 0;
};

struct BspSurfaces {
    double scale = 0;                    ///< metres a unit
    std::vector<Vec3> positions;         ///< of the vertices lump, in the file's units, as its floats say
    std::vector<GridPoint> snapped;      ///< the same in metres on the grid
    std::vector<TexturePoint> uvs;       ///< in repeats; may not be finite
    std::vector<std::uint32_t> corners;  ///< indices into these
    std::vector<BspSurface> surfaces;    ///< in the file's order
    std::vector<std::string> shaders;    ///< names
    std::uint32_t face_count = 0;        ///< of the whole lump
    std::uint64_t ignored = 0;           ///< flares, surfaces without a triangle, surfaces of other models
    std::uint64_t of_other_models = 0;   ///< of those

    std::span<const std::uint32_t> corners_of(const BspSurface& surface) const {
        return std::span(corners).subspan(surface.first_corner, surface.corner_count);
    }
};

/// @return kInvalid for options that make no sense; kMalformed for what breaks the format, kOutOfRange for a vertex
/// that is
///         not finite or outside the world, kTooLarge beyond 2^22 corners: each with lump and entry.
/// Every vertex of the file is judged, and every surface of the first model; surfaces of other models are not looked
/// at.
Result<BspSurfaces> read_surfaces(const BspFile& file, const ReadOptions& options);

}  // namespace firma
