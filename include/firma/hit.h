// SPDX-License-Identifier: MIT
// What a cast answers. docs/casting.md holds the contract as a table.
#pragma once

#include <array>
#include <cstdint>

#include "firma/vec.h"

namespace firma {

enum class Status : std::uint8_t {
    kMiss,      ///< nothing met; also for a zero path, and for a start in overlap that does not get deeper
    kHit,       ///< first touch at a fraction in (0, 1]
    kTouching,  ///< starts in touch or overlap and the distance is decreasing: fraction 0
    kInvalid,   ///< a number is not finite or too large, or the radius negative: not a miss, nothing was asked of the
                ///< world
};

enum class Feature : std::uint8_t { kFace, kEdge, kVertex };

/// Which sides of a face a cast can meet.
enum class Sides : std::uint8_t {
    kFront,  ///< only while moving against the normal (path . normal < 0)
    kBoth,   ///< always; the contact normal faces the mover
};

/// The first touch of a moving sphere with one polygon, by itself.
struct PolygonHit {
    Status status = Status::kMiss;
    Feature feature = Feature::kFace;
    /// Corner index of the vertex, or of the edge's first corner; 0 for a face.
    std::uint32_t feature_index = 0;
    double fraction = 0;  ///< of the path, 0..1
    Vec3 centre;          ///< of the sphere at `fraction`, metres
    Vec3 point;           ///< of the polygon, metres
    Vec3 normal;          ///< unit, from `point` toward the centre; for a particle the face's, on the side it came from
    Vec3 face_normal;  ///< unit, of the polygon as wound, whichever side was met; through a World, of the exact plane
                       ///< that the face met was cut from

    bool touched() const { return status == Status::kHit || status == Status::kTouching; }
};

/// Names a face for as long as it is untouched. Ids are never used again within a line of edits.
struct FaceId {
    std::uint32_t value = ~0u;
    bool valid() const { return value != ~0u; }
    friend bool operator==(FaceId, FaceId) = default;
    friend auto operator<=>(FaceId, FaceId) = default;
};

/// Names a portal between two rooms, in all versions of a world.
struct PortalId {
    std::uint32_t value = ~0u;
    bool valid() const { return value != ~0u; }
    friend bool operator==(PortalId, PortalId) = default;
    friend auto operator<=>(PortalId, PortalId) = default;
};

/// Finds a face quickly, in the version of a World that it came from, or any other in which the face has not moved.
struct FaceRef {
    const void* block = nullptr;  ///< where the face was kept: compared, never followed
    std::uint32_t slot = 0;
    FaceId id;
    std::array<std::int32_t, 3> at{};  ///< a corner of it, surface steps: where to look
    bool valid() const { return block != nullptr; }
    friend bool operator==(const FaceRef&, const FaceRef&) = default;
};

/// Names a room, in all versions of a world.
struct RoomId {
    std::uint32_t value = 0;
    friend bool operator==(RoomId, RoomId) = default;
    friend auto operator<=>(RoomId, RoomId) = default;
};

/// In place of a room: all of them.
inline constexpr RoomId kAnyRoom{~0u};
/// In place of a room: the one that the start lies in, which the cast finds out.
inline constexpr RoomId kLocateRoom{~0u - 1};
/// So many of the rooms that a cast goes through are listed in its Hit.
inline constexpr std::uint32_t kRoomsInHit = 8;

/// What a cast through a World met first.
struct Hit : PolygonHit {
    double safe_fraction = 0;       ///< how far to go so that the skin is kept along `normal`: within 0..fraction
    FaceId face;                    ///< the face met; of several at the same fraction the lowest id; invalid when a
                                    ///< closed portal was met, which is when no face is met at that fraction
    PortalId portal;                ///< the closed portal met, the lowest id of several; else invalid
    FaceId other_face;              ///< the neighbour across the edge met; invalid otherwise, and on an open edge
    FaceRef ref;                    ///< for World::face, in the World that was asked
    std::uint32_t source = 0;       ///< index of the face in the level's file, dropped ones counted, or see source_edit
    std::uint32_t source_edit = 0;  ///< 0: of the level's file; else the number of the edit whose cutter `source` is of
    std::uint32_t material = 0;     ///< index into World::material_name
    RoomId room;                    ///< of the contact
    std::uint32_t rooms_passed = 1;  ///< how many rooms the sweep reaches through open portals, the first included; 0
                                     ///< when the cast asked all rooms of a world of several, by CastOptions::room or
                                     ///< as its start is in none
    std::array<RoomId, kRoomsInHit> passed{};  ///< the first of them, in the order in which the sweep reaches them
    std::uint64_t version = 0;                 ///< of the World that was asked
};

/// What casts looked at. Add up over casts; a cast only ever adds.
struct CastCounts {
    std::uint64_t bins = 0;     ///< boxes of bins tested
    std::uint64_t boxes = 0;    ///< boxes of faces and of portals' polygons tested
    std::uint64_t faces = 0;    ///< faces whose geometry was looked at
    std::uint64_t precise = 0;  ///< questions that double left open and more digits decided
};

}  // namespace firma
