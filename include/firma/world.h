// SPDX-License-Identifier: MIT
// The World: one handle to rooms of immutable blocks, and the questions it answers.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/carve_rules.h"
#include "firma/export.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "firma/polygon.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/tolerance.h"
#include "firma/tree_options.h"

namespace firma {

struct Level;
struct WorldData;

/// A face as the world holds it.
struct Face {
    FaceId id;
    std::uint32_t source = 0;  ///< index of the face in the level's file, or see source_edit
    std::uint32_t source_edit =
        0;  ///< 0: of the level's file; else the number of the edit whose cutter `source` is a triangle of
    std::uint32_t material = 0;
    std::uint32_t mask = ~0u;
    bool two_sided = false;
    bool solid = false;              ///< bounds a closed solid, which can be carved
    std::vector<Vec3> corners;       ///< metres, exact
    std::vector<FaceId> neighbours;  ///< in the same room, across the edge from corner k to k + 1;
                                     ///< invalid where that edge is not shared by exactly two faces, wound alike
    Vec3 normal;                     ///< unit, of the exact plane that the face was cut from
};

/// A value: copies are cheap, share everything, and never change. Any number of threads may ask the same World.
/// Hold one copy for a job and pass references.
class World {
public:
    FIRMA_EXPORT World();
    FIRMA_EXPORT explicit World(std::shared_ptr<const WorldData> data);

    FIRMA_EXPORT std::uint64_t version() const;
    FIRMA_EXPORT std::size_t face_count() const;
    FIRMA_EXPORT std::size_t room_count() const;
    /// Of all faces; empty for a world without any.
    FIRMA_EXPORT Box bounds() const;
    FIRMA_EXPORT const Tolerance& tolerance() const;
    /// What can be carved: a value of its own.
    FIRMA_EXPORT const Solid& solid() const;
    /// "" when there is no such material.
    FIRMA_EXPORT const std::string& material_name(std::uint32_t material) const;
    /// Of all rooms together.
    FIRMA_EXPORT TreeStatistics statistics() const;

    /// The face that a hit of this World names. Its id is not valid() when this world has no such face where the ref
    /// says: it is of another version in which the face was moved or cut, of another world, or of a closed portal.
    /// Costs a walk to the face and one for each of its edges.
    FIRMA_EXPORT Face face(const FaceRef& ref) const;
    /// The same by lasting id, through a search of all faces; nothing when this world has no such face.
    FIRMA_EXPORT std::optional<Face> find_face(FaceId id) const;
    /// Every face, in order of id.
    FIRMA_EXPORT std::vector<Face> faces() const;

    /// How many handles there are to this version, at this instant. What is 1 stays so while nobody copies the one.
    long handles() const { return data_.use_count(); }

    const WorldData& data() const { return *data_; }

private:
    std::shared_ptr<const WorldData> data_;
};

struct WorldOptions {
    TreeOptions tree;
    Tolerance tolerance{};
    CarveRules rules{};
};

/// The same world with its index built anew, over all faces. Only how quickly it answers changes: no id, answer, edit
/// or hash depends on an index. Takes about as long as make_world() without reading, and ten times that where faces
/// have many corners.
FIRMA_EXPORT World rebuild_index(const World& world, const TreeOptions& options);

/// The same world under other rules for carving.
FIRMA_EXPORT World with_rules(const World& world, CarveRules rules);

/// A world of one room around a solid. Shares all of it, unless it was a world's of several rooms: then its faces, as
/// many as there are, are put into blocks anew. Materials keep their numbers and have no names.
FIRMA_EXPORT World make_world(const Solid& solid, const WorldOptions& options = {});

/// Makes a world of a level: one room.
/// @return kTooLarge beyond 2^31 faces; kInvalid when the skin is negative or not finite, or when a face of the level
///         is not convex, planar and of 3 to 64 corners, or has a corner, material or group that is not there (readers
///         never make such), naming it; kMalformed for a level without a face, with what its reader left out: such a
///         world would answer every cast with a miss (World() is one).
FIRMA_EXPORT Result<World> make_world(const Level& level, const WorldOptions& options = {});

struct CastOptions {
    std::uint32_t mask = ~0u;      ///< faces that share a bit are met
    Sides sides = Sides::kFront;   ///< kFront leaves the choice to the face; kBoth meets both sides of all
    double skin = -1;              ///< metres for safe_fraction; negative takes the World's
    CastCounts* counts = nullptr;  ///< added to, when given; not shared between threads
    /// The room that the start lies in, and the cast goes on from there through portals; kLocateRoom: the cast finds
    /// out; kAnyRoom: all rooms are asked. For starts in the air, clear of all faces, the answers are the same;
    /// docs/rooms.md says what they are for others.
    RoomId room = kAnyRoom;
    std::span<RoomId> passed{};  ///< filled with the rooms passed, in the order in which the sweep reaches them,
                                 ///< as far as they fit; how many there were is in Hit::rooms_passed
};

/// The first touch of a moving sphere with the world.
///
/// @param sphere  centre at the start and radius; both may lie outside the world
/// @param path    motion (metres)
/// @return as cast_polygon(), over all faces, and over closed portals as two-sided ones; of several at the smallest
/// fraction the one with the lowest id, faces before portals; kInvalid also for a room that is not there.
/// Never allocates, takes no lock and touches no reference count; by room, where there are more than 4,096 rooms or
/// more than 256 wait at a time, a thread's first such casts take memory that it keeps.
FIRMA_EXPORT Hit cast(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options = {});

/// Whether cast() would touch anything, without looking for the first.
/// @return kHit, kTouching, kMiss or kInvalid; kHit also stands for a touch where another face would have said
/// kTouching.
FIRMA_EXPORT Status cast_any(const World& world, const Sphere& sphere, const Vec3& path,
                             const CastOptions& options = {});

/// Every face and every closed portal that the sphere would meet along the whole path, as if alone, by fraction, then
/// id, faces before portals. By room: those of the rooms that the whole path leads to through portals, open or closed.
/// @param hits  replaced; keeps its memory from call to call
/// @return kMiss when there is none, else the first one's status; kInvalid as cast(), with no hits
FIRMA_EXPORT Status cast_all(const World& world, const Sphere& sphere, const Vec3& path, std::vector<Hit>& hits,
                             const CastOptions& options = {});

/// A face near a point, or a closed portal.
struct NearFace : ClosestPoint {
    FaceId face;      ///< invalid of a portal
    PortalId portal;  ///< invalid of a face
    FaceRef ref;
    std::uint32_t source = 0;
    std::uint32_t source_edit = 0;  ///< as in Face
    std::uint32_t material = 0;
};

/// The faces that a closed ball touches, either side, in order of id, then the closed portals. No tolerance.
/// @param found  replaced
/// @param room   only what bounds this room; kAnyRoom: all of them
/// @return kInvalid as for cast(); otherwise kTouching when anything was found, kMiss when not
FIRMA_EXPORT Status overlap(const World& world, const Sphere& sphere, std::vector<NearFace>& found,
                            std::uint32_t mask = ~0u, RoomId room = kAnyRoom);

/// For closest(): a reach, in metres, that leaves nothing out. It is finite, as a program built with -ffast-math has no
/// infinity to give.
inline constexpr double kEverywhere = 0x1p1000;

/// The point of all faces and closed portals nearest to `point`; of several at the same distance the lowest id, faces
/// before portals.
/// @param reach  metres; nothing farther is looked for. kEverywhere, or infinity, looks everywhere
/// @param room   only what bounds this room; kAnyRoom: all of them
/// @return nothing when no face lies within reach, a number is not finite or too large, or there is no such room
FIRMA_EXPORT std::optional<NearFace> closest(const World& world, const Vec3& point, double reach = kEverywhere,
                                             std::uint32_t mask = ~0u, RoomId room = kAnyRoom);

/// in_solid() of the world's solid.
FIRMA_EXPORT std::optional<bool> in_solid(const World& world, const Vec3& point);

/// A hash of what the world holds: faces with ids, exact forms and rooms, portals, doors, counters, version; not of the
/// rules for carving, nor of how faces are kept and found. Worlds made by equal edits in equal order have equal ones on
/// every machine. It is kept as edits go: asking costs a few nanoseconds a material.
FIRMA_EXPORT std::uint64_t hash_world(const World& world);

/// Of one room: its faces, name and number. Costs the same.
/// @param room  below World::room_count(); 0 for others
FIRMA_EXPORT std::uint64_t hash_room(const World& world, RoomId room);

/// Of each cube of 32 m with anything in it, in an order that is the same everywhere: so two machines can find where
/// their worlds differ.
FIRMA_EXPORT std::vector<RegionHash> hash_regions(const World& world);

/// A broken invariant, named.
struct WorldFault {
    std::string what;
    FaceId face;
};

/// The first invariant that does not hold, or nothing: faces planar, convex, with area and in range; boxes of bins
/// around what they hold; every face in exactly one bin of its room; ids unique; hashes those of the faces. In a world
/// of several rooms also: portals join two rooms that are there, by polygons as sound as faces; around each room, the
/// directed edges of the solid's faces and of its portals cancel exactly. Of the exact solid behind the faces see
/// check_solid().
FIRMA_EXPORT std::optional<WorldFault> check_world(const World& world);

}  // namespace firma
