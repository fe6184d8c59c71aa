// SPDX-License-Identifier: MIT
// Reads glTF 2.0 into a level. In a library of its own, firma_gltf, as it leans on tinygltf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firma/export.h"
#include "firma/grid.h"
#include "firma/level.h"
#include "firma/mesh.h"
#include "firma/result.h"
#include "firma/rooms.h"
#include "firma/turn.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

struct GltfOptions {
    double scale = 1;  ///< metres a unit of the file, > 0
    /// Axis of the level that glTF's y, which points up, becomes: 0 .. 2. What write_glb() turned to y comes back.
    int up = 2;
    /// Of all triangles of all instances; meshes may be placed many times by a small file.
    std::uint64_t max_triangles = std::uint64_t(1) << 26;
    /// Names of nodes that are parts which move (GltfLevel::parts), besides those with `extras.part` or `firma_part`
    /// true.
    std::vector<std::string> parts{};
};

/// A node of the scene, in the order of the file's tree: parents before children.
struct GltfNode {
    std::uint32_t index = 0;  ///< in the file
    std::string name;         ///< UTF-8, may be empty
    Vec3 origin;              ///< where it stands, metres, in the level's axes
    /// Members of `extras`: texts as they are, anything else as JSON.
    std::vector<std::pair<std::string, std::string>> extras;

    /// The text of an extra, or "". Goes through the extras, up to that one.
    std::string_view value(std::string_view key) const {
        for (const auto& [name_of, text] : extras)
            if (name_of == key) return text;
        return {};
    }
};

/// What a node says is a portal: convex, exactly planar polygons of 3 to 64 corners, counter-clockwise seen from the
/// front of the file's triangles. They are not faces of the level.
struct GltfPortal {
    std::string name;        ///< the node's
    std::uint32_t node = 0;  ///< index in the file
    std::vector<std::vector<GridPoint>> polygons;
};

/// A node that moves, with the meshes of all nodes below that are no parts themselves: a level of its own, in the
/// node's frame. For moving_parts.h: MovingPart(make_world(part.level).value(), {part.position, part.rotation}).
struct GltfPart {
    std::string name;                 ///< the node's, or of the nearest above it that has one; "": none
    std::uint32_t node = 0;           ///< index in the file
    Vec3 position;                    ///< of the frame, metres, in the level
    Quaternion rotation{0, 0, 0, 1};  ///< of the frame; scales and mirrors are in the level
    Level level;                      ///< sources numbered from 0, as GltfLevel::level
};

struct GltfLevel {
    /// Sources are triangles, numbered from 0 in order of node, primitive and triangle, those of portals left out; a
    /// face of several has the number of the first. Groups are names of nodes. Textures are those of TEXCOORD_0.
    Level level;
    std::vector<GltfPortal> portals;
    std::vector<GltfPart> parts;     ///< in order of node; their faces are none of `level`
    std::vector<GltfNode> nodes;     ///< all of the scene, with meshes or without
    std::vector<std::string> notes;  ///< what was left out or not understood: a sentence for each kind of thing
    std::vector<Vec3> note_places;   ///< for each of Level::notes the first corner of the triangles in question, metres
};

/// Reads a .gltf or .glb: the triangles of all meshes that stand in the default scene. docs/formats.md says what is
/// kept, dropped, refused.
///
/// @param bytes   the whole file, either form
/// @param name    for messages
/// @param folder  where files that it names lie, links followed; one that lies elsewhere is refused (kUnsupported).
///                Empty: a file that names any is refused
/// @return the level, or the first error with its place: what breaks glTF or its JSON, an index, offset or size beyond
///         what it is an index of, a vertex that is not finite or outside the world, a required extension that changes
///         what is read, nodes in a loop, too many triangles, no triangle at all; kInvalid for a scale or an axis that
///         is none
/// Time and memory grow with the bytes, and with the triangles of all instances (GltfOptions::max_triangles); files
/// that it names are read whole.
FIRMA_EXPORT Result<GltfLevel> read_gltf(std::span<const std::byte> bytes, std::string name,
                                         const GltfOptions& options = {}, const std::string& folder = {});

/// The same of a file, read into memory first; buffers may lie in files beside it or below.
/// @return kCannotRead with the system's reason, else as above
/// Costs reading the file, held in memory until it returns, and the same.
FIRMA_EXPORT Result<GltfLevel> read_gltf(const std::string& path, const GltfOptions& options = {});

/// Checks the level as it was snapped, not the file's own floats: nodes place a vertex by products that are rounded, so
/// that corners that were meant to meet differ in their last bits. Faults and positions are exact on the grid, sources
/// as the level has them; notes are those of the level: dropped and divided. Costs as check_obj(), with the level's
/// vertices and corners.
/// @return kInvalid or kTooLarge, as make_world(), for a level that no reader makes: a face that is not convex and
///         planar, or whose corners, material, group or texture are not there; kInvalid for other than one of
///         GltfLevel::note_places for each note
[[nodiscard]] FIRMA_EXPORT Result<MeshCheck> check_gltf(const GltfLevel& gltf);

/// Indices are into GltfLevel::portals.
using GltfRooms = PortalReport;

/// make_divided_world() of the level and its portals, at its cost.
/// @param report  replaced, when given
FIRMA_EXPORT Result<World> make_world(const GltfLevel& gltf, const WorldOptions& options = {},
                                      GltfRooms* report = nullptr);

}  // namespace firma
