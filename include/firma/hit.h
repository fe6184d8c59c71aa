// SPDX-License-Identifier: MIT
// What a cast answers: plain values, whose functions cost a comparison or two. docs/casting.md holds the contract as a
// table.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"

namespace firma {

enum class Status : std::uint8_t {
    kMiss,            ///< nothing met; also for a zero path, and for a start in overlap that does not get deeper
    kHit,             ///< first touch at a fraction in (0, 1]
    kInitialOverlap,  ///< starts in touch or overlap and the distance is decreasing: fraction 0
    kInvalid,  ///< a number is not finite or too large, or the radius negative: not a miss, nothing was asked of the
               ///< world; the fraction is 0
};

enum class Feature : std::uint8_t { kFace, kEdge, kVertex };

/// Which sides of a face a cast can meet.
enum class Sides : std::uint8_t {
    kFront,  ///< only while moving against the normal (path . normal < 0)
    kBoth,   ///< always; the contact normal faces the mover
};

/// The first touch of a moving sphere with one polygon, by itself. As it stands here it is a miss of an unknown path.
struct PolygonHit {
    Status status = Status::kMiss;
    Feature feature = Feature::kFace;
    /// Corner index of the vertex, or of the edge's first corner; 0 for a face.
    std::uint32_t feature_index = 0;
    double fraction = 1;  ///< of the path, 0..1; of a miss 1, where nothing could be asked (kInvalid) 0
    Vec3 centre;          ///< of the sphere at `fraction`, metres
    Vec3 point;           ///< of the polygon, metres
    Vec3 normal;          ///< unit, from `point` toward the centre; for a particle the face's, on the side it came from
    Vec3 face_normal;  ///< unit, of the polygon as wound, whichever side was met; through a World, of the exact plane
                       ///< that the face met was cut from

    [[nodiscard]] bool touched() const { return status == Status::kHit || status == Status::kInitialOverlap; }
    /// Whether anything was met: false of a miss, and of what could not be asked.
    [[nodiscard]] explicit operator bool() const { return touched(); }
};

/// Names a face for as long as it is untouched. Ids are never used again within a line of edits.
struct FaceId {
    std::uint32_t value = ~0u;
    [[nodiscard]] bool valid() const { return value != ~0u; }
    friend bool operator==(FaceId, FaceId) = default;
    friend auto operator<=>(FaceId, FaceId) = default;
};

/// Names a portal between two rooms, in all versions of a world.
struct PortalId {
    std::uint32_t value = ~0u;
    [[nodiscard]] bool valid() const { return value != ~0u; }
    friend bool operator==(PortalId, PortalId) = default;
    friend auto operator<=>(PortalId, PortalId) = default;
};

/// Names a face, and says where to look for it: plain numbers, to be kept, saved or sent. World::face() finds it in any
/// world that has a face of this id with this corner, and says so where there is none.
struct FaceRef {
    FaceId id;
    GridPoint corner;  ///< its first
    [[nodiscard]] bool valid() const { return id.valid(); }
    friend bool operator==(const FaceRef&, const FaceRef&) = default;
};

/// Names a room, in all versions of a world.
struct RoomId {
    std::uint32_t value = ~0u;
    [[nodiscard]] bool valid() const { return value != ~0u; }
    friend bool operator==(RoomId, RoomId) = default;
    friend auto operator<=>(RoomId, RoomId) = default;
};

/// In place of a room that a question is limited to: all of them.
inline constexpr RoomId kAnyRoom{};
/// In place of a room: the one that the start lies in, which the cast finds out.
inline constexpr RoomId kLocateRoom{~0u - 1};

/// What a cast through a World met first. Where a face came from, its room and neighbours are a second question:
/// World::face_info(), other_face(), room_of().
struct Hit : PolygonHit {
    double safe_fraction = 1;  ///< how far to go so that the contact offset is kept along `normal`: within 0..fraction
    FaceRef face;              ///< the face met; of several at the same fraction the one with the lowest id; invalid
                               ///< when a closed portal was met, which is when no face is met at that fraction
    PortalId portal;           ///< the closed portal met, the lowest id of several; else invalid
    std::uint32_t material = 0;  ///< index into World::material_name; of a closed portal, the portal's
};

/// What casts tested. Add up over casts; a cast only ever adds.
struct CastCounts {
    std::uint64_t nodes = 0;  ///< boxes of the tree's nodes tested, eight at a time
    std::uint64_t boxes = 0;  ///< triangles of faces tested eight at a time; boxes of portals' polygons. Built without
                              ///< SIMD (FIRMA_SIMD), boxes are tested one by one, and of faces boxes as well
    std::uint64_t faces = 0;  ///< candidate faces: those whose geometry was tested exactly
    std::uint64_t precise = 0;  ///< questions that double left open and more digits decided
};

}  // namespace firma
