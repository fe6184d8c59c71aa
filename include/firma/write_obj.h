// SPDX-License-Identifier: MIT
// A world as a Wavefront .obj, exact to the last digit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "firma/export.h"
#include "firma/result.h"
#include "firma/world.h"

namespace firma {

/// What was written.
struct ObjWritten {
    std::size_t faces = 0;
    std::size_t vertices = 0;
    std::uint64_t bytes = 0;
};

/// Which faces are written.
enum class ObjFaces : std::uint8_t {
    kAll,    ///< all that casts meet
    kSolid,  ///< those that bound closed solids: what they bound is closed in the file, too
};

/// Takes the next piece of a file; false when it cannot.
using TextSink = std::function<bool(std::string_view)>;

/// Writes faces, in order of id: convex polygons, wound as they are, after a `usemtl` wherever the
/// material changes. Vertices stand before them, each once, in metres on the surface grid (1/262144 m) with all their
/// digits. The same world gives the same bytes on every machine.
///
/// The file says exactly what the world holds of them, with two exceptions: masks and two-sidedness have no place in an
/// .obj, and characters of a material's name that an .obj cannot hold become '_'. Reading it with read_obj() snaps
/// vertices to the input grid (1/4096 m), as any file's: where carving made vertices between its points, the world read
/// is not the world written, and faces bent by the snap are divided. A world without faces makes a file that no reader
/// takes.
///
/// @param put  gets some 64 KiB at a time
/// @return nothing once `put` failed
FIRMA_EXPORT std::optional<ObjWritten> write_obj(const World& world, const TextSink& put,
                                                 ObjFaces which = ObjFaces::kAll);

/// The same into a file, which appears whole or not at all: it is written beside its place, under a name that ends in
/// ".part", then renamed.
/// @return kCannotWrite with the system's reason
FIRMA_EXPORT Result<ObjWritten> write_obj(const World& world, const std::string& path, ObjFaces which = ObjFaces::kAll);

}  // namespace firma
