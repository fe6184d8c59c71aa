// SPDX-License-Identifier: MIT
// A mesh that somebody has in memory, and the level it makes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firma/export.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/vec.h"

namespace firma {

/// Polygons over shared vertices; views of the caller's arrays. Optional arrays are empty, or have one entry a face;
/// `uvs` one a corner.
struct Mesh {
    std::span<const Vec3> vertices;                ///< in units of `ReadOptions::scale` metres
    std::span<const std::uint32_t> corners;        ///< indices into vertices, face after face, counter-clockwise
                                                   ///< seen from the air
    std::span<const std::uint32_t> corner_counts;  ///< of each face, 3..4096; empty: all are triangles
    std::span<const std::uint32_t> materials;      ///< optional: indices into material_names
    std::span<const std::string> material_names;   ///< UTF-8
    std::span<const std::uint32_t> masks;          ///< optional: see LevelFace::mask
    std::span<const std::uint8_t> two_sided;       ///< optional: 0 or 1
    /// Texture coordinates of each of the corners, in repeats. They come out as they are given: v may point up.
    std::span<const TexturePoint> uvs;
};

/// Makes of a mesh what read_obj() makes of a file: vertices are snapped, faces without area dropped, those that are
/// not convex and planar on the grid divided, and those whose texture coordinates no one map gives; the level's notes
/// say which. Faces keep their index as `source`.
/// Materials get new numbers: the level's first is "", and equal names are one.
///
/// @param name  for messages
/// @return the level, or the first error with vertex or face: a position that is not finite or lies outside the world,
///         texture coordinates that are not finite,
///         an index that names no vertex or material, a face with fewer than 3 or more than 4096 corners, counts that
///         do not add up to the corners, arrays of other lengths than said, no face at all, more than 2^31 corners.
FIRMA_EXPORT Result<Level> level_from_mesh(const Mesh& mesh, std::string name, const ReadOptions& options = {});

}  // namespace firma
