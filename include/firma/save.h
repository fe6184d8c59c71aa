// SPDX-License-Identifier: MIT
// Worlds as files. .firma: whole, to the bit, and written so that nothing saved before is ever lost. .obj: their faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firma/export.h"
#include "firma/result.h"
#include "firma/world.h"

namespace firma {

struct SaveOptions {
    /// Whether the exact solid behind the facets is kept. Without, the file is smaller, and the world read back can be
    /// cast against, not carved: no face of it is `solid`, locate() finds no solid, and a hit's `face_normal` is the
    /// facet's own.
    bool exact = true;
    /// Whether the TreeOptions are kept, by which reading builds the index anew; how faces are kept and found is in no
    /// file. Without, the bytes follow from the level, the edits, rules and contact offset alone, and the world read
    /// back has the default TreeOptions.
    bool index = true;
};

/// What pack_world() writes and unpack_world() reads; files of older versions stay readable.
inline constexpr std::uint32_t kFirmaFileVersion = 3;

/// A world as the bytes of a .firma file: everything that hash_world() covers, the tolerance, the options for trees,
/// the rules for carving and how textures lie. The same world, made the same way, gives the same bytes on every
/// machine. docs/formats.md has the layout.
/// Costs all faces, in time and memory, and sorting them; also rooms, portals and the table of textures.
[[nodiscard]] FIRMA_EXPORT std::vector<std::byte> pack_world(const World& world, const SaveOptions& options = {});

/// The world of such bytes, which it copies what it needs of. hash_world() of it is that of the world packed (with its
/// exact part), and edits of both end in the same bits.
///
/// Bytes are taken as hostile: checksums, every number that anything later relies on, and then the world as by
/// check_world() and check_solid() are checked first. Memory taken is in proportion to the bytes given.
///
/// @param name  for messages
/// @return kMalformed with the section and the entry in it for damage; kUnsupported for another version, and for a part
///         that is marked as required and unknown; kTooLarge where a size does not fit
/// Time grows with the bytes, a little faster than in proportion: the checks of the whole world, which cost all its
/// faces, and building the index.
FIRMA_EXPORT Result<World> unpack_world(std::span<const std::byte> bytes, std::string name);

/// Whether bytes begin as those of a .firma file do, of whatever version. Reads the first few bytes only.
[[nodiscard]] FIRMA_EXPORT bool is_firma_file(std::span<const std::byte> bytes);

/// What save_world() wrote.
struct FirmaWritten {
    std::uint64_t bytes = 0;
};

/// Saves a world: the file appears whole or not at all. Bytes go beside it, into a file of its name with ".part"
/// behind, which is flushed and renamed; then the folder is flushed. Killed at any moment it leaves what was there
/// before, and at most the ".part", which the next save of that name takes over. Several saves of one name at once, by
/// threads or processes, wait for each other. A link is followed, and an error where it leads nowhere; the mode of a
/// file that was there is kept.
/// @return how much was written; kCannotWrite with the system's reason; kInvalid for an empty path
/// Costs pack_world(), all of whose bytes are held in memory, writing them, and two flushes that wait for the disk.
[[nodiscard]] FIRMA_EXPORT Result<FirmaWritten> save_world(const World& world, const std::string& path,
                                                           const SaveOptions& options = {});

/// Reads a file into memory, and from there as unpack_world() does. A file that something else changes or cuts short
/// meanwhile is an error at most.
/// @return kCannotRead with the system's reason: missing, a folder, not allowed, no memory for it, cut short meanwhile;
///         else as unpack_world()
/// Costs reading all of it and unpack_world(); of a file that is no .firma file no more than a mebibyte is read.
FIRMA_EXPORT Result<World> load_world(const std::string& path);

/// What write_obj() wrote.
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
/// @return kCannotWrite once `put` failed, which is not called again
/// Costs all faces, and sorting them and their corners; takes memory for both, not for the text.
[[nodiscard]] FIRMA_EXPORT Result<ObjWritten> write_obj(const World& world, const TextSink& put,
                                                        ObjFaces which = ObjFaces::kAll);

/// The same into a file, which appears whole or not at all: it is written beside its place, under a name that ends in
/// ".part", then renamed.
/// @return kCannotWrite with the system's reason
/// Costs the same, writing the text, and flushes as of save_world().
[[nodiscard]] FIRMA_EXPORT Result<ObjWritten> write_obj(const World& world, const std::string& path,
                                                        ObjFaces which = ObjFaces::kAll);

}  // namespace firma
