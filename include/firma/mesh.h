// SPDX-License-Identifier: MIT
// Meshes that a program gives, and what is wrong with the mesh of a file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
/// say which. Faces keep their index as `source`. Materials keep their numbers, whatever their names; without names
/// there is one, "".
///
/// @param name  for messages
/// @return the level, or the first error with vertex or face: a position that is not finite or lies outside the world,
///         texture coordinates that are not finite,
///         an index that names no vertex or material, a face with fewer than 3 or more than 4096 corners, counts that
///         do not add up to the corners, arrays of other lengths than said, no face at all, more than 2^31 corners.
/// Time and memory grow with vertices and corners; a face that is divided costs as in read_obj().
[[nodiscard]] FIRMA_EXPORT Result<Level> level_from_mesh(const Mesh& mesh, std::string name,
                                                         const ReadOptions& options = {});

enum class MeshFault : std::uint8_t {
    kOpenEdge,      ///< an edge that fewer faces use one way than the other
    kReversedFace,  ///< a face wound against its neighbours; its edges are then judged as if it were turned over
};

enum class MeshNote : std::uint8_t {
    kNoArea,   ///< the face has no area in the file itself; it is dropped, unless the snap gives it one
    kDropped,  ///< the snap takes its area; it is dropped
    kBent,     ///< flat in the file, not on the grid; it is divided
    kTurned,   ///< the snap turns it over: its normals before and after point apart
    kDivided,  ///< not flat or not convex in the file itself, or of more than 64 corners; it is divided
};

/// A place in the mesh where something is wrong. Points as the file has them, nearest doubles.
struct MeshFaultPlace {
    MeshFault what = MeshFault::kOpenEdge;
    std::uint32_t source = 0;  ///< face index in the file
    std::uint32_t line = 0;    ///< of the face, from 1; 0 where the format has none
    Vec3 from, to;             ///< ends of the edge; for a reversed face, of the first edge that tells
    bool t_joint = false;      ///< an open edge that another vertex of the mesh lies on, exactly
};

struct MeshNotePlace {
    MeshNote what = MeshNote::kNoArea;
    std::uint32_t source = 0;
    std::uint32_t line = 0;
    Vec3 at;  ///< its first corner
};

struct MeshCheck {
    std::vector<MeshFaultPlace> faults;  ///< in order of face
    std::vector<MeshNotePlace> notes;    ///< in order of face
    std::uint32_t faces = 0;             ///< in the file
    std::uint64_t vertices = 0;          ///< different positions used by faces
    /// Whether no fault was found.
    bool closed() const { return faults.empty(); }
};

/// Checks an .obj by the decimals it holds: vertices are the same where their decimals are equal as numbers, whatever
/// their indices. `options.scale` only says what the notes compare with.
/// @return kMalformed and others as read_obj(); kOutOfRange also for a number of more than 400 digits or an exponent
///         beyond 400
/// Time and memory grow with the text, time a little faster than in proportion, as positions and edges are sorted.
/// Numbers of more digits than a whole number of 64 bits holds cost more.
[[nodiscard]] FIRMA_EXPORT Result<MeshCheck> check_obj(std::string_view text, std::string name,
                                                       const ReadOptions& options = {});

/// Checks the drawn surfaces of a .bsp by its floats (drawn surfaces are seldom closed).
/// @return errors as read_bsp()
/// Costs as check_obj(), with the file's surfaces.
[[nodiscard]] FIRMA_EXPORT Result<MeshCheck> check_bsp(std::span<const std::byte> bytes, std::string name,
                                                       const ReadOptions& options = {});

/// Checks a file by its ending (.obj, .bsp), all of it read into memory first.
/// @return kCannotRead with the system's reason; kTooLarge beyond 4 GiB; kUnsupported for other endings; the errors of
///         the checks
/// Costs what these cost.
[[nodiscard]] FIRMA_EXPORT Result<MeshCheck> check_mesh(const std::string& path, const ReadOptions& options = {});

}  // namespace firma
