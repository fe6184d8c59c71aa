// SPDX-License-Identifier: MIT
// The World: one handle to faces, rooms and rules that never change. Questions to it are in queries.h and rooms.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/function_ref.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "firma/matter.h"
#include "firma/polygon.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/tasks.h"
#include "firma/texture.h"
#include "firma/tree_options.h"

namespace firma {

struct Level;
struct WorldData;

/// What a face is besides its outline.
struct FaceInfo {
    FaceId id;
    GridPoint corner;          ///< its first
    RoomId room;               ///< that it looks into
    std::uint32_t source = 0;  ///< index of the face in the level's file, or see source_edit
    std::uint32_t source_edit =
        0;  ///< 0: of the level's file; else the number of the edit whose cutter `source` is a triangle of
    std::uint32_t material = 0;
    std::uint32_t mask = ~0u;
    bool two_sided = false;
    bool solid = false;  ///< bounds a closed solid, which can be carved
    Vec3 normal;         ///< unit, of the exact plane that the face was cut from

    [[nodiscard]] FaceRef ref() const { return {id, corner}; }
};

/// A face with its outline: convex, counter-clockwise seen from its front, exactly planar.
struct Face : FaceInfo {
    std::vector<Vec3> corners;  ///< metres, exact
};

/// The same for a visitor: `corners` is good until the visitor returns.
struct FaceView : FaceInfo {
    std::span<const Vec3> corners;  ///< metres, exact; 3 to 64
};

/// Is given one face at a time, in no particular order; returns whether to go on.
using FaceVisitor = FunctionRef<bool(const FaceView& face)>;

/// A value: copies are cheap, share everything, and never change. Any number of threads may ask the same World.
/// Hold one copy for a job and pass references. A copy costs one count that threads share. Dropping the last copy frees
/// what no other world shares, block by block. What is asked here costs the same for every world and never allocates,
/// where nothing else is said.
class World {
public:
    FIRMA_EXPORT World();
    FIRMA_EXPORT explicit World(std::shared_ptr<const WorldData> data);
    World(const World&) = default;
    World& operator=(const World&) = default;
    /// Leaves an empty world behind.
    FIRMA_EXPORT World(World&& other) noexcept;
    FIRMA_EXPORT World& operator=(World&& other) noexcept;
    ~World() = default;

    /// 0 as read; every edit, and every door opened or closed, adds one.
    FIRMA_EXPORT std::uint64_t version() const;
    FIRMA_EXPORT std::size_t face_count() const;
    /// How many rooms there are, those that edits joined to others counted.
    FIRMA_EXPORT std::size_t room_count() const;
    /// Of all faces, metres; empty for a world without any. Costs a few walks through the index, more where many faces
    /// reach to within a float's rounding of the bounds.
    FIRMA_EXPORT Box bounds() const;
    FIRMA_EXPORT const Tolerance& tolerance() const;
    /// What can be carved: a value of its own.
    FIRMA_EXPORT const Solid& solid() const;
    /// "" when there is no such material.
    FIRMA_EXPORT const std::string& material_name(std::uint32_t material) const;
    /// Of all rooms together. Goes through every node and leaf: grows with all faces.
    FIRMA_EXPORT TreeStatistics statistics() const;

    /// The face that a ref names; nothing when this world has no such face: it was moved or cut, or the ref is of
    /// another world, of a closed portal, or of nothing. Keep it in a variable: `for (Vec3 c :
    /// world.face(ref)->corners)` would go through corners that are no longer there. Costs a walk through the index to
    /// the face, and allocates the outline.
    [[nodiscard]] FIRMA_EXPORT std::optional<Face> face(const FaceRef& ref) const;
    /// The same without its outline. Never allocates.
    [[nodiscard]] FIRMA_EXPORT std::optional<FaceInfo> face_info(const FaceRef& ref) const;
    /// The same by id alone. Goes through all faces of the world.
    [[nodiscard]] FIRMA_EXPORT std::optional<Face> find_face(FaceId id) const;
    /// Every face, in order of id. Costs some hundred nanoseconds a face, with an allocation for each outline, and
    /// sorting them; each_face() goes without.
    [[nodiscard]] FIRMA_EXPORT std::vector<Face> faces() const;

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
    /// Whether how textures lie is kept, for texture_of(): of a mesh with texture coordinates some 90 bytes a face.
    bool textures = true;
    /// What the level is made of: nothing takes default_matters().
    std::optional<MatterTable> matters{};
    WorkOptions work{};  ///< for many faces
};

/// The same world with its index built anew, over all faces. Only how quickly it answers changes: no id, answer, edit
/// or hash depends on an index. Takes about as long as make_world() without reading, and ten times that where faces
/// have many corners.
[[nodiscard]] FIRMA_EXPORT World rebuild_index(const World& world, const TreeOptions& options);

/// The same world under other rules for carving, of the same version. Shares all else: costs the zones and hardnesses
/// given.
/// @return kInvalid, naming the zone or material: a hardness that is not within 0..1, a box that is empty or not of
///         numbers, a max_cutter_size that is no length above zero
[[nodiscard]] FIRMA_EXPORT Result<World> with_rules(const World& world, CarveRules rules);

/// A world of one room around a solid. Shares all of it, unless it was a world's of several rooms: then its faces, as
/// many as there are, are put into blocks anew. Materials keep their numbers and have no names.
/// @return kInvalid when the contact offset is negative or not finite, and for rules as with_rules()
/// Goes through all faces, for their counts and materials, also where it shares them.
[[nodiscard]] FIRMA_EXPORT Result<World> make_world(const Solid& solid, const WorldOptions& options = {});

/// Makes a world of a level: one room.
/// @return kTooLarge beyond 2^31 faces; kCancelled when WorkOptions::progress said so; kInvalid when the contact offset
/// is negative or not finite, for rules as
///         with_rules(), or when a face of the level is not convex, planar and of 3 to 64 corners, or has a corner,
///         material or group that is not there (readers never make such), naming it; kMalformed for a level without a
///         face, with what its reader left out: such a world would answer every cast with a miss (World() is one).
/// Time and memory grow with the faces, time a little faster than in proportion, as they are sorted into a tree; what
/// can be carved is found at the cost of level_solidity().
[[nodiscard]] FIRMA_EXPORT Result<World> make_world(const Level& level, const WorldOptions& options = {});

/// All faces by visitor, once each.
/// @return whether the visitor let it come to an end, here and below: true also where there was no face to show
/// Costs all faces, up to the one that the visitor ends it at. Never allocates.
FIRMA_EXPORT bool each_face(const World& world, FaceVisitor visit);
/// Those whose own box shares a point with a box (metres, closed). A box that is empty or not finite has none.
/// Costs a walk through the index down to the faces near the box. Never allocates.
FIRMA_EXPORT bool each_face(const World& world, const Box& box, FaceVisitor visit);
/// Those that look into a room, or into the one that it became part of. A room that is not there has none; kAnyRoom has
/// all. Costs the faces of the room. Never allocates.
FIRMA_EXPORT bool each_face(const World& world, RoomId room, FaceVisitor visit);
/// Those of a region: whose lowest corner lies in this cube of 32 m (RegionHash::region). Each face is in one region; a
/// region that holds nothing has none. Costs a walk through the index down to the faces there. Never allocates.
FIRMA_EXPORT bool each_face(const World& world, const Region& region, FaceVisitor visit);

/// How the texture lies on a face, as the level's file says it: that of the file's face that it was cut from. Edits
/// share what they do not change, and no hash sees it.
/// @param ref  nothing also for a face that this world does not have
/// @return nothing for a face that an edit's cutter made (source_edit is not 0), and where the file says nothing:
///         box_projection() is what to take then.
/// Never allocates. Costs a walk through the index to the face, and a search among the faces of the file.
[[nodiscard]] FIRMA_EXPORT std::optional<TextureProjection> texture_of(const World& world, const FaceRef& ref);
/// The same without the walk, of a face of this world or a part of one. Costs a binary search among the faces of the
/// file, and a test of each piece of one that was divided into pieces with maps of their own. Never allocates.
/// @param corners  the face's, metres: of a file's face that was divided into pieces they tell which
[[nodiscard]] FIRMA_EXPORT std::optional<TextureProjection> texture_of(const World& world, const FaceInfo& face,
                                                                       std::span<const Vec3> corners);

/// The face across an edge of a face, from its corner `edge` to the next.
/// @return invalid where that edge is not shared by exactly two faces of the room, wound alike, and for a face or an
///         edge that is not there.
/// Never allocates. Costs two walks through the index: to the face, and to the middle of the edge.
[[nodiscard]] FIRMA_EXPORT FaceId other_face(const World& world, const FaceRef& face, std::uint32_t edge);

/// A hash of what the world holds: faces with ids, exact forms and rooms, portals, doors, counters, version; not of the
/// rules for carving, nor of how textures lie, nor of how faces are kept and found. Worlds made by equal edits in equal
/// order have equal ones on every machine. It is kept as edits go: asking costs a few nanoseconds a material, whose
/// names it covers, whatever the faces. Never allocates.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_world(const World& world);

/// Of one room: its faces, name and number. Costs the same for every room, but for the length of its name. Never
/// allocates.
/// @param room  below World::room_count(); 0 for others
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_room(const World& world, RoomId room);

/// Of each cube of 32 m with anything in it, in an order that is the same everywhere: so two machines can find where
/// their worlds differ. Kept as edits go: costs the regions that hold or held anything, whatever the faces.
[[nodiscard]] FIRMA_EXPORT std::vector<RegionHash> hash_regions(const World& world);

/// A broken invariant, named.
struct WorldFault {
    std::string what;
    FaceId face;
};

/// The first invariant that does not hold, or nothing: faces planar, convex, with area and in range; boxes of nodes
/// around what they hold; every face in exactly one leaf of its room; ids unique; hashes those of the faces. In a world
/// of several rooms also: portals join two rooms that are there, by polygons as sound as faces; around each room, the
/// directed edges of the solid's faces and of its portals cancel exactly. Of the exact solid behind the faces see
/// check_solid().
/// Costs all faces, in time and in memory, and sorting them: for tests, not for each frame.
[[nodiscard]] FIRMA_EXPORT std::optional<WorldFault> check_world(const World& world);

}  // namespace firma
