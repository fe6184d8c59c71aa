// SPDX-License-Identifier: MIT
// Faces as triangles: for a renderer, or for the collider of another engine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/export.h"
#include "firma/texture.h"
#include "firma/world.h"

namespace firma {

/// How far from the world's origin TriangleOptions::origin may lie along an axis, metres: beyond, floats would end.
inline constexpr double kMaxTriangleOrigin = 1e30;

/// Triangles of some faces. Vertices are not shared between faces, as normals differ; of one face they are.
struct TriangleMesh {
    // One for each vertex.
    std::vector<std::array<float, 3>> positions;  ///< metres from TriangleOptions::origin, rounded to float
    std::vector<std::array<float, 3>> normals;    ///< unit, of the exact plane that the face was cut from
    /// Texture coordinates (u, v), in the unit that the face's Source says; none unless TriangleOptions::uvs.
    std::vector<std::array<float, 2>> uvs;

    // One for each triangle, in order of material, then face.
    std::vector<std::array<std::uint32_t, 3>> corners;  ///< vertices, counter-clockwise seen from the face's front
    std::vector<FaceId> faces;

    /// Triangles of one material, one behind the other: a draw call.
    struct Run {
        std::uint32_t material = 0;        ///< index into World::material_name
        std::uint32_t first_triangle = 0;  ///< into `corners`
        std::uint32_t triangle_count = 0;
        std::uint32_t first_vertex = 0;  ///< its triangles name vertices from here on ...
        std::uint32_t vertex_count = 0;  ///< ... so many, and no other run's do
    };
    std::vector<Run> runs;  ///< in order of material

    /// The faces, in order of material, then id: where they came from.
    struct Source {
        FaceId face;
        RoomId room;
        std::uint32_t source = 0, source_edit = 0;  ///< as in FaceInfo
        std::uint32_t material = 0, mask = 0;
        bool two_sided = false, solid = false;
        std::uint32_t first_triangle = 0, triangle_count = 0;
        std::uint32_t first_vertex = 0, vertex_count = 0;
        /// What its uvs count. kMetres: by box_projection() of its normal, as an edit made the face, or the file says
        /// nothing of it.
        TextureUnit uv_unit = TextureUnit::kMetres;
    };
    std::vector<Source> sources;
};

struct TriangleOptions {
    Vec3 origin{};              ///< metres: what positions are told from. Near the faces, floats lose least
    std::uint32_t mask = ~0u;   ///< faces that share a bit
    bool castable_only = true;  ///< also the faces that bound no solid
    /// Texture coordinates too, by texture_of(), rounded to float; without, they cost nothing.
    bool uvs = false;
    /// Texels across and down of the pictures of materials, by index as World::material_name: where both are above
    /// zero, texels become repeats. May be shorter than the list of materials.
    std::span<const std::array<double, 2>> texture_sizes{};
};

/// The triangles of all faces of a world, of a room, or of a region. None is without area on the surface grid. The same
/// worlds give the same triangles in the same order, however their faces are kept.
/// @return an empty mesh, and no error, for a room that is not there, a region that holds nothing, an origin that is
/// not
///         finite or beyond kMaxTriangleOrigin
/// Costs some hundred nanoseconds a face, and sorting them; with texture coordinates a search a face besides, and,
/// where a face of the file had no one projection and was divided, a look at all of its pieces for each. Of a room it
/// costs that room's faces, of a region the walk through the index down to it and the faces there. Takes memory for the
/// triangles and, until it returns, for the faces.
[[nodiscard]] FIRMA_EXPORT TriangleMesh triangles_of(const World& world, const TriangleOptions& options = {});
[[nodiscard]] FIRMA_EXPORT TriangleMesh triangles_of(const World& world, RoomId room,
                                                     const TriangleOptions& options = {});
[[nodiscard]] FIRMA_EXPORT TriangleMesh triangles_of(const World& world, const Region& region,
                                                     const TriangleOptions& options = {});

}  // namespace firma
