// SPDX-License-Identifier: MIT
// A level as read from a file: snapped vertices, convex planar faces, what they stop, and an account of what was
// dropped or divided.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firma/export.h"
#include "firma/grid.h"
#include "firma/result.h"
#include "firma/texture.h"

namespace firma {

inline constexpr std::uint32_t kStopsWalk = 1;    ///< bodies that walk: walls, glass, clip brushes
inline constexpr std::uint32_t kStopsShots = 2;   ///< walls, glass
inline constexpr std::uint32_t kStopsSight = 4;   ///< walls, but no glass
inline constexpr std::uint32_t kStopsLiquid = 8;  ///< the surface of water, slime, lava
inline constexpr std::uint32_t kIsSky = 16;       ///< in addition to what a wall stops: the sky is painted on it

/// What a wall stops. Faces of formats that know no contents stop everything.
inline constexpr std::uint32_t kStopsSolid = kStopsWalk | kStopsShots | kStopsSight;

/// What a face was in its file.
enum class FaceKind : std::uint8_t { kPolygon, kTriangleSoup, kPatch };

/// A convex, exactly planar polygon with area: corners are Level::corners[first_corner .. + corner_count), at most 64.
struct LevelFace {
    std::uint32_t first_corner = 0;
    std::uint32_t corner_count = 0;
    std::uint32_t source = 0;    ///< index of the face in the file, from 0, dropped ones counted
    std::uint32_t material = 0;  ///< index into Level::materials
    std::uint32_t group = 0;     ///< index into Level::groups
    FaceKind kind = FaceKind::kPolygon;
    bool two_sided = false;
    std::uint32_t mask = ~0u;            ///< casts with a mask that shares a bit meet it
    std::uint32_t texture = kNoTexture;  ///< index into Level::textures
};

/// Why a face of the file is not as it was.
enum class FaceNote : std::uint8_t {
    kNoArea,    ///< dropped: no area, in the file or after the snap
    kSplit,     ///< not convex, not exactly planar on the grid, or of more than 64 corners: divided on its own outline
    kCrossing,  ///< divided as well, though its outline crosses itself: pieces may overlap
    kTexture,   ///< convex and planar, and yet divided into triangles: no one map gives its texture coordinates
};

struct LevelNote {
    FaceNote what = FaceNote::kNoArea;
    std::uint32_t source = 0;  ///< index of the face in the file
    std::uint32_t line = 0;    ///< line of the file, from 1; 0 where the format has none
};

/// Things of one kind that a file holds and a reader leaves out: no cast meets them, though in their game one would, or
/// a reader does not understand them.
struct Omission {
    std::string what;         ///< in the plural: "primitives 'brushDef9'", "faces without area"
    std::uint64_t count = 0;  ///< how many
    std::string first;        ///< the place of the first; "" where the format has none
};

/// A level: what every reader makes and make_world() takes. make_world() checks it: a face whose corners, material or
/// group are not there, or that is no convex polygon, is an Error that names it.
struct Level {
    std::string name;                    ///< the file's, for messages
    std::vector<GridPoint> vertices;     ///< snapped; one entry a `v` of the file
    std::vector<std::uint32_t> corners;  ///< indices into vertices
    std::vector<LevelFace> faces;
    std::vector<std::string> materials;       ///< at least one: "" is the name of none
    std::vector<std::string> groups;          ///< at least one, likewise
    std::vector<TextureProjection> textures;  ///< how textures lie, where the file says it
    /// By material, where the file says it: the name of its matter, or a name that patterns of textures fit; "" and
    /// missing ones go by the material's own name.
    std::vector<std::string> matters;
    std::vector<LevelNote> notes;    ///< in order of `source`
    std::uint32_t source_faces = 0;  ///< faces in the file, dropped ones counted
    std::uint64_t ignored_entries =
        0;  ///< things in the file that are not geometry for casts (points, lines, flares ...)
    std::vector<Omission> omissions;  ///< what the file holds and this does not

    /// How many notes say this. Goes through all notes.
    std::size_t count(FaceNote what) const {
        std::size_t n = 0;
        for (const LevelNote& note : notes) n += note.what == what;
        return n;
    }
};

/// Options for reading. Defaults suit the format.
struct ReadOptions {
    double scale = 0;  ///< metres a unit; 0 takes the format's own: 1 for .obj, 1/32 for .bsp and .map
    /// Patches are divided until the surface is within this of the chords, metres.
    double patch_tolerance = 0.01;
};

/// Reads a Wavefront .obj: v, vt, f (n-gons, all index forms, negative too), g, o, usemtl; continued lines. Other
/// entries are counted and ignored. A face's group is the last g or o before it, by the rest of that line. Texture
/// coordinates become projections in repeats, v turned to point down; a face of which a corner has none has none.
///
/// @param text  the whole file
/// @param name  for messages
/// @return the level, or the first error with file and line: bad or non-finite number, vertex outside the world, index
///         that names no vertex before the face, face with fewer than 3 or more than 4096 corners, no face at all,
///         bytes that are no text, more than 4 GiB of it, more than 2^31 corners.
/// Time and memory grow with the text. Dividing a face that is not convex and planar takes time that may grow with the
/// square of its corners.
[[nodiscard]] FIRMA_EXPORT Result<Level> read_obj(std::string_view text, std::string name,
                                                  const ReadOptions& options = {});

/// Reads the drawn surfaces of a Quake 3 .bsp (version 46) of the first model: planar faces as the polygons that their
/// triangles make up, triangle soups as they are, patches tessellated. Shader names become materials. Quake's units are
/// scaled by 1/32 m, unless told otherwise by the options. Texture coordinates become projections in repeats.
///
/// @param bytes  the whole file
/// @return the level, or the first error with file, lump and entry.
/// Time and memory grow with the file, and with the triangles that patches become (ReadOptions::patch_tolerance).
[[nodiscard]] FIRMA_EXPORT Result<Level> read_bsp(std::span<const std::byte> bytes, std::string name,
                                                  const ReadOptions& options = {});

/// Reads a file by its ending (.obj, .bsp), all of it into memory first.
/// @return kCannotRead with the system's reason; kTooLarge beyond 4 GiB; kUnsupported for other endings; the errors of
///         the readers
/// Costs what these cost.
[[nodiscard]] FIRMA_EXPORT Result<Level> read_level(const std::string& path, const ReadOptions& options = {});

}  // namespace firma
