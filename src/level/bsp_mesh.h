// SPDX-License-Identifier: MIT
// The surfaces of a .bsp as polygons, before any snap: what read_bsp() adds to a level and check_bsp() judges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/level.h"
#include "level/bsp_surfaces.h"

namespace firma {

struct BspMesh {
    /// Corners are BspMesh::corners[first_corner .. + corner_count), counter-clockwise seen from the front.
    struct Polygon {
        std::uint32_t first_corner = 0;
        std::uint32_t corner_count = 0;
        std::uint32_t surface = 0;  ///< index into BspSurfaces::surfaces
    };

    std::vector<Vec3> positions;         ///< in the file's units: of its vertices, then points of patches
    std::vector<GridPoint> snapped;      ///< the same in metres on the grid
    std::vector<std::uint32_t> corners;  ///< indices into both
    std::vector<TexturePoint> uvs;       ///< of each corner, in repeats; may not be finite
    std::vector<Polygon> polygons;       ///< in order of surface; any may have no area

    std::span<const std::uint32_t> corners_of(const Polygon& polygon) const {
        return std::span(corners).subspan(polygon.first_corner, polygon.corner_count);
    }
    std::span<const TexturePoint> uvs_of(const Polygon& polygon) const {
        return std::span(uvs).subspan(polygon.first_corner, polygon.corner_count);
    }
};

/// Flat surfaces become the outlines that their triangles were made from, other triangles stay, patches become cells of
/// four corners (some in one place where the patch comes to a point).
///
/// @param patch_tolerance  metres, > 0
/// @return kTooLarge when patches make more than 2^22 cells at this tolerance
Result<BspMesh> make_bsp_mesh(const BspFile& file, const BspSurfaces& surfaces, double patch_tolerance);

}  // namespace firma
