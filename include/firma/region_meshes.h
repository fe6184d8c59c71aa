// SPDX-License-Identifier: MIT
// A renderer's meshes, one for each cube of space: all of them once, and after each edit those that it changed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/export.h"
#include "firma/result.h"
#include "firma/texture.h"
#include "firma/vec.h"
#include "firma/versions.h"
#include "firma/world.h"

namespace firma {

/// Edges of the cubes, metres: from the smallest to the largest, and in whole multiples of kMinTileSize.
inline constexpr double kMinRegionSize = 1, kMaxRegionSize = 1024;

struct RegionMeshOptions {
    double size = 16;           ///< metres: the edge of each cube, see kMinRegionSize
    std::uint32_t mask = ~0u;   ///< faces that share a bit
    bool castable_only = true;  ///< also the faces that bound no solid
    bool textures = true;       ///< uvs, tangents and blends; without, they cost nothing
    /// As TriangleOptions::texture_sizes, each finite and not negative.
    std::span<const std::array<double, 2>> texture_sizes{};
};

/// The triangles of the faces whose lowest corner (by x, then y, then z) lies in one cube; other corners may lie
/// outside of it. Vertices are not shared between faces, as normals differ; of one face they are. Corners of faces of
/// the solid meet each other exactly, and the triangles add none: there is no T-joint that the faces do not have.
struct RegionMesh {
    Tile place{};  ///< the cube is from place * size to (place + 1) * size along each axis
    Vec3 origin;   ///< metres: place * size; a float holds it exactly
    Box bounds;    ///< metres: of its corners; empty without any

    // One for each vertex.
    /// Metres from `origin`: exact up to 64 m along each axis, beyond that rounded to float.
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;  ///< unit, of the exact plane that the face was cut from
    /// x, y, z: unit, along the face, where u grows and v stays. w: 1, or -1 where the picture lies mirrored. The way
    /// up in the picture, against v, is w * cross(normal, tangent).
    std::vector<std::array<float, 4>> tangents;
    std::vector<std::array<float, 2>> uvs;  ///< in the unit that the face's run says
    /// How much of four pictures is mixed, as parts of 255 that sum to 255: those that lie along the x, y and z axis,
    /// and the one by `uvs`. Faces of the level's file have (0, 0, 0, 255). Faces of edits have no part by `uvs`: at a
    /// corner all those that meet there at less than a sharp edge have the same parts, so that no seam shows between
    /// them. A point p of the world has in these pictures the coordinates (p.y, -p.z), (p.x, -p.z), (p.x, -p.y).
    std::vector<std::array<std::uint8_t, 4>> blends;

    // One for each triangle, in the order of `runs`, in those of faces.
    std::vector<std::array<std::uint32_t, 3>> corners;  ///< vertices, counter-clockwise seen from the face's front
    std::vector<FaceId> faces;

    /// Triangles that are drawn alike, one behind the other: a draw call.
    struct Run {
        std::uint32_t material = 0;  ///< index into World::material_name
        bool cut = false;            ///< faces that edits made
        bool two_sided = false;
        TextureUnit uv_unit = TextureUnit::kMetres;  ///< what `uvs` count
        std::uint32_t first_triangle = 0, triangle_count = 0;
        std::uint32_t first_vertex = 0, vertex_count = 0;  ///< its triangles name these vertices, and no other run's do
        friend bool operator==(const Run&, const Run&) = default;
    };
    std::vector<Run> runs;  ///< in order of material, then the three below it

    /// The faces: where they came from, and where their triangles are.
    struct FacePart {
        FaceRef face;                               ///< World::face() has its room and outline
        std::uint32_t source = 0, source_edit = 0;  ///< as in FaceInfo
        std::uint32_t mask = 0;
        bool two_sided = false, solid = false;
        std::uint32_t first_triangle = 0, triangle_count = 0;
        std::uint32_t first_vertex = 0, vertex_count = 0;
        friend bool operator==(const FacePart&, const FacePart&) = default;
    };
    std::vector<FacePart> parts;  ///< in the order of `runs`, in each of face

    bool empty() const { return corners.empty(); }
    friend bool operator==(const RegionMesh&, const RegionMesh&) = default;
};

/// The cubes with faces in them, in order.
/// @return kInvalid for a size that is none
/// Costs all faces.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<Tile>> regions_of(const World& world, double size);

/// The cubes whose meshes an edit changed, in order: that a face left or came to, and those of faces of edits that
/// share a corner with such a face of an edit, as their blends may differ. Other cubes have the same meshes in both
/// worlds, to the bit. Compares as diff_worlds() does: for versions a few edits apart the cost follows the edits.
/// @param before, after  versions of one level, in any order
/// @return kInvalid for a size that is none
[[nodiscard]] FIRMA_EXPORT Result<std::vector<Tile>> changed_regions(const World& before, const World& after,
                                                                     double size);

/// One cube's mesh. The same worlds give the same mesh, to the bit, however they were made and their faces are kept.
/// @return an empty mesh for a cube without a face; kInvalid for options that are none, naming which
/// Costs a walk through the index down to the faces there, and some microseconds for each: of those of the file a
/// search for its texture (see texture_of()), of those of edits the faces around its corners. Takes memory for the mesh
/// and, until it returns, for the faces. Any number of threads may make meshes of the same World.
[[nodiscard]] FIRMA_EXPORT Result<RegionMesh> region_mesh(const World& world, const Tile& place,
                                                          const RegionMeshOptions& options = {});

/// The meshes of all cubes with triangles to draw, in order of place.
/// @return errors as region_mesh()
/// Costs all faces.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<RegionMesh>> region_meshes(const World& world,
                                                                         const RegionMeshOptions& options = {});

/// The meshes of changed_regions() in `after`, in order of place: they replace those of before. A cube that has nothing
/// to draw any more, or had nothing, is there with an empty mesh.
/// @return errors as region_mesh()
/// Costs what changed_regions() costs, and all faces of those cubes.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<RegionMesh>> changed_region_meshes(const World& before,
                                                                                 const World& after,
                                                                                 const RegionMeshOptions& options = {});

}  // namespace firma
