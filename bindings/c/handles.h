// SPDX-License-Identifier: MIT
// The numbers that C programs hold instead of objects: never used twice, and known to be bad when they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace firma::c {

enum class Kind : std::uint8_t {
    kNone,
    kWorld,
    kLevel,
    kCutter,
    kJob,
    kEdit,
    kStore,
    kDiff,
    kFaces,
    kTriangles,
    kRegionMeshes,
    kBytes,
    kChunks,
    kMatters,
    kCommand,
    kLog,
    kReplay,
    kHull,
    kParts,
    kPlayerShape,
    kBodyShape,
    kBodies,
    kBodyIndex,
    kShotEvents,
    kPiercing,
    kDebris,
    kSupports,
    kConvexPieces,
    kGame,
    kRecording
};

/// What a handle may stand for; deleted when it is released.
struct Object {
    virtual ~Object() = default;
};

/// Looking one up takes no lock and writes nothing; making and releasing take one.
/// @return null for a handle that was released, never made, or is of another kind
Object* find_object(std::uint64_t id, Kind kind);
/// @return the handle; 0 when 2^22 are held, or the memory for one more is not there
std::uint64_t add_object(std::unique_ptr<Object> object, Kind kind);
/// The object, no longer to be found; null as find_object().
std::unique_ptr<Object> remove_object(std::uint64_t id, Kind kind);
std::size_t count_objects();

}  // namespace firma::c
