// SPDX-License-Identifier: MIT
// Questions to a world: casts of rays, spheres, capsules and hulls, what these overlap, the nearest point.
//
// None of them allocates, but where one fills a vector, and batches (batch.h); none takes a lock or touches a reference
// count (by room, where there are more than 4,096 rooms or more than 256 wait at a time, a thread's first such casts
// take memory that it keeps). Any number of threads may ask the same World.
//
// What they cost grows with the logarithm of the faces, and with the faces near the path: up to the first touch for
// cast(), up to any touch for cast_any(), up to where the visitor ends it for cast_each(), along all of it for
// cast_all(). For overlap() these are the faces near the ball (around a capsule or hull), for closest() those about as
// near as the nearest. By room a cast goes through the indices of the rooms that it reaches alone, and tests the box of
// each of their portals; it also clears two bits for each room of the world. kLocateRoom adds what locate() costs. Over
// all rooms closed portals are found by an index of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/export.h"
#include "firma/function_ref.h"
#include "firma/hit.h"
#include "firma/polygon.h"
#include "firma/tasks.h"
#include "firma/world.h"

namespace firma {

struct Capsule;
class Hull;

/// The rooms that a cast went through, for who asks.
struct RoomTrail {
    std::span<RoomId> rooms;  ///< filled in the order in which the sweep reaches them, as far as they fit
    /// How many there were, the first included; 0 when the cast asked all rooms of a world of several, by
    /// CastOptions::room or as its start is in none, and when nothing was asked (a zero path, kInvalid).
    std::uint32_t count = 0;
    /// portals[k] is the one that rooms[k] was reached through first, filled as far as they fit; the first is invalid,
    /// as there the sweep began.
    std::span<PortalId> portals{};
};

struct CastOptions {
    std::uint32_t mask = ~0u;      ///< faces that share a bit are met
    Sides sides = Sides::kFront;   ///< kFront leaves the choice to the face; kBoth meets both sides of all
    double contact_offset = -1;    ///< metres for safe_fraction; negative takes the World's
    CastCounts* counts = nullptr;  ///< added to, when given; not shared between threads
    /// The room that the start lies in, and the cast goes on from there through portals; kLocateRoom: the cast finds
    /// out; kAnyRoom: all rooms are asked. For starts in the air, clear of all faces, the answers are the same;
    /// docs/rooms.md says what they are for others.
    RoomId room = kAnyRoom;
    RoomTrail* trail = nullptr;  ///< replaced, when given; not shared between threads
};

/// The first touch of a moving sphere with the world.
///
/// @param sphere  centre at the start and radius; both may lie outside the world
/// @param path    motion (metres)
/// @return as cast_polygon(), over all faces, and over closed portals as two-sided ones; of several at the smallest
///         fraction the one with the lowest id, faces before portals. A miss has fraction and safe_fraction 1 and the
///         end of the path as its centre. kInvalid also for a room that is not there and a contact offset that is not
///         finite: then the fractions are 0.
/// Never allocates, but as the head of this file says.
[[nodiscard]] FIRMA_EXPORT Hit cast(const World& world, const Sphere& sphere, const Vec3& path,
                                    const CastOptions& options = {});
/// Of a particle.
[[nodiscard]] inline Hit cast(const World& world, const Ray& ray, const CastOptions& options = {}) {
    return cast(world, {ray.start, 0}, ray.path, options);
}

/// Whether cast() would touch anything, without looking for the first. Costs less where much is met.
/// @return kHit, kInitialOverlap, kMiss or kInvalid; kHit also stands for a touch where another face would have said
///         kInitialOverlap
[[nodiscard]] FIRMA_EXPORT Status cast_any(const World& world, const Sphere& sphere, const Vec3& path,
                                           const CastOptions& options = {});
[[nodiscard]] inline Status cast_any(const World& world, const Ray& ray, const CastOptions& options = {}) {
    return cast_any(world, {ray.start, 0}, ray.path, options);
}

/// Is given one hit at a time; returns the fraction up to which to look on: 1 goes on as before, hit.fraction asks for
/// nothing later than this hit, 0 or less ends the cast. It can only bring the end nearer.
using HitVisitor = FunctionRef<double(const Hit& hit)>;

/// Every face and every closed portal that the sphere would meet along the whole path, as if alone, in no particular
/// order: to filter (return 1 for what does not count, the fraction for what does: the last that counted is then the
/// first on the way), to stop early, to collect. By room: those of the rooms that the path, as far as it is wanted,
/// leads to through portals, open or closed.
/// @return kMiss when the visitor was given nothing, kInvalid as cast(), else kHit
/// Never allocates, but as cast().
FIRMA_EXPORT Status cast_each(const World& world, const Sphere& sphere, const Vec3& path, HitVisitor visit,
                              const CastOptions& options = {});
inline Status cast_each(const World& world, const Ray& ray, HitVisitor visit, const CastOptions& options = {}) {
    return cast_each(world, {ray.start, 0}, ray.path, visit, options);
}

/// The same in a list, by fraction, then id, faces before portals. Costs sorting them, too.
/// @param hits  replaced; keeps its memory from call to call
/// @return kMiss when there is none, else the first one's status; kInvalid as cast(), with no hits
FIRMA_EXPORT Status cast_all(const World& world, const Sphere& sphere, const Vec3& path, std::vector<Hit>& hits,
                             const CastOptions& options = {});
inline Status cast_all(const World& world, const Ray& ray, std::vector<Hit>& hits, const CastOptions& options = {}) {
    return cast_all(world, {ray.start, 0}, ray.path, hits, options);
}

/// The same of a convex hull or box (hull.h) that is put at `at`. Options name the room of `at`, and kLocateRoom finds
/// it. Answers as cast_polygon() of a hull over all faces, else as above; Hit::centre is where the hull is put. Costs
/// as a sphere, and for each face near the box around the hull what cast_polygon() costs.
[[nodiscard]] FIRMA_EXPORT Hit cast(const World& world, const Hull& hull, const Vec3& at, const Vec3& path,
                                    const CastOptions& options = {});
[[nodiscard]] FIRMA_EXPORT Status cast_any(const World& world, const Hull& hull, const Vec3& at, const Vec3& path,
                                           const CastOptions& options = {});
FIRMA_EXPORT Status cast_each(const World& world, const Hull& hull, const Vec3& at, const Vec3& path, HitVisitor visit,
                              const CastOptions& options = {});
FIRMA_EXPORT Status cast_all(const World& world, const Hull& hull, const Vec3& at, const Vec3& path,
                             std::vector<Hit>& hits, const CastOptions& options = {});

/// The same of a capsule (capsule.h). Options name the room of its middle, and kLocateRoom finds it. Answers as
/// cast_polygon() of a capsule over all faces, else as above; Hit::centre is its middle. Costs as a sphere, and for
/// each face near the capsule what cast_polygon() costs.
[[nodiscard]] FIRMA_EXPORT Hit cast(const World& world, const Capsule& capsule, const Vec3& path,
                                    const CastOptions& options = {});
[[nodiscard]] FIRMA_EXPORT Status cast_any(const World& world, const Capsule& capsule, const Vec3& path,
                                           const CastOptions& options = {});
FIRMA_EXPORT Status cast_each(const World& world, const Capsule& capsule, const Vec3& path, HitVisitor visit,
                              const CastOptions& options = {});
FIRMA_EXPORT Status cast_all(const World& world, const Capsule& capsule, const Vec3& path, std::vector<Hit>& hits,
                             const CastOptions& options = {});

/// One of many casts.
struct CastInput {
    Sphere sphere{};
    Vec3 path{};
};

/// Many casts: hits[k] answers inputs[k] as cast() would.
/// @param hits     as many as inputs
/// @param options  for all; its trail is left as it is
/// @param tasks    null: this thread does it all
/// @return whether all was done: false when hits are not as many as inputs, or when `run` returned before all its work
///         had; then every hit is kInvalid
/// Costs, and allocates, as cast_many() of batch.h, which also takes other shapes and columns.
[[nodiscard]] FIRMA_EXPORT bool cast_batch(const World& world, std::span<const CastInput> inputs, std::span<Hit> hits,
                                           const CastOptions& options = {}, const Tasks* tasks = nullptr);

/// What questions without motion are limited to.
struct NearOptions {
    std::uint32_t mask = ~0u;  ///< faces and closed portals that share a bit
    RoomId room = kAnyRoom;    ///< only what bounds this room; kAnyRoom: all of them
};

/// A face near a point, or a closed portal.
struct NearFace : ClosestPoint {
    Status status = Status::kMiss;  ///< kHit; kMiss: nothing was found; kInvalid: nothing could be asked
    FaceRef face;                   ///< invalid of a portal
    PortalId portal;                ///< invalid of a face
    std::uint32_t material = 0;

    [[nodiscard]] bool found() const { return status == Status::kHit; }
    [[nodiscard]] explicit operator bool() const { return found(); }
};

/// What a sphere, a capsule or a hull overlaps, and how to get out.
struct Overlap : NearFace {
    /// Unit: moved this way by `depth`, the sphere touches this face no more than in a point. From the nearest point
    /// toward the centre; for a centre behind a one-sided face along that face's normal, out of the solid; for a centre
    /// on the face along its normal. Of a capsule the same with the nearest point of its segment for the centre, and
    /// its middle where that is behind; where the segment meets the polygon itself, and of a hull: the shortest way
    /// out, to rounding. Behind a one-sided face, for the middle, or where the hull is put, out of the solid as well.
    Vec3 direction;
    double depth = 0;  ///< metres, >= 0
};

/// Is given one at a time, in no particular order; returns whether to go on.
using OverlapVisitor = FunctionRef<bool(const Overlap& overlap)>;

/// The faces that a closed ball touches, either side, then the closed portals. No tolerance.
/// @return kInvalid for a number that is not finite or too large, a negative radius, or a room that is not there;
///         otherwise kInitialOverlap when anything was found, kMiss when not
/// Never allocates. Costs a walk through the index to the faces near the ball; by room, where any portal of the world
/// is closed, a look at each portal of the room.
FIRMA_EXPORT Status overlap_each(const World& world, const Sphere& sphere, OverlapVisitor visit,
                                 const NearOptions& options = {});

/// The same in a list, in order of id, faces before portals. Costs sorting them, too.
/// @param found  replaced; keeps its memory from call to call
FIRMA_EXPORT Status overlap(const World& world, const Sphere& sphere, std::vector<Overlap>& found,
                            const NearOptions& options = {});

/// The same of a capsule. `point` is the one nearest to its segment, the middle of them if there are several, and
/// `distance` from there to the segment: 0 where it goes through. A portal of several polygons is told by the one
/// nearest to the middle. kInvalid also for ends beyond 2^199. Costs as a sphere that holds it.
FIRMA_EXPORT Status overlap_each(const World& world, const Capsule& capsule, OverlapVisitor visit,
                                 const NearOptions& options = {});
FIRMA_EXPORT Status overlap(const World& world, const Capsule& capsule, std::vector<Overlap>& found,
                            const NearOptions& options = {});

/// The same of a convex hull or box that is put at `at`. Whether it overlaps is decided exactly. `point` is where on
/// the polygon it still touches when it is out, the middle if that is more than a point; `distance` is 0. A portal of
/// several polygons is told by the one nearest to `at`. kInvalid also for a hull that is not valid(). Costs as a sphere
/// that holds it, and for each face near that sphere the product of the edges of both at most.
FIRMA_EXPORT Status overlap_each(const World& world, const Hull& hull, const Vec3& at, OverlapVisitor visit,
                                 const NearOptions& options = {});
FIRMA_EXPORT Status overlap(const World& world, const Hull& hull, const Vec3& at, std::vector<Overlap>& found,
                            const NearOptions& options = {});

/// For closest(): a reach, in metres, that leaves nothing out. It is finite, as a program built with -ffast-math has no
/// infinity to give.
inline constexpr double kEverywhere = 0x1p1000;

/// The point of all faces and closed portals nearest to `point`; of several at the same distance the lowest id, faces
/// before portals.
/// @param reach  metres; nothing farther is looked for. kEverywhere, or infinity, looks everywhere
/// @return kMiss when nothing lies within reach; kInvalid for a number that is not finite or too large, a reach that is
///         not a number, or a room that is not there
/// Never allocates. Costs a walk through the index to the faces about as near as the nearest, portals as
/// overlap_each(); a short reach where nothing is near costs least.
[[nodiscard]] FIRMA_EXPORT NearFace closest(const World& world, const Vec3& point, double reach = kEverywhere,
                                            const NearOptions& options = {});

}  // namespace firma
