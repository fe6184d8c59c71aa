// SPDX-License-Identifier: MIT
// Parts of a level that move: doors, lifts, trains, blades. Each is a solid in a frame of its own, and goes by a motion
// that is given. Casts, overlaps and the nearest point of the level and of all its parts together.
//
// docs/moving.md has the contract. Nothing here allocates but making a part; any number of threads may ask the same
// scene.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firma/capsule.h"
#include "firma/export.h"
#include "firma/function_ref.h"
#include "firma/hull.h"
#include "firma/motion.h"
#include "firma/queries.h"
#include "firma/world.h"

namespace firma {

/// In place of a part: the level itself, or nothing.
inline constexpr std::uint32_t kNoPart = ~0u;

/// Radians. A part that turns more in one motion is refused: kInvalid.
inline constexpr double kMaxPartTurn = 8;
/// Metres. Against a part that turns, a mover that starts, goes or reaches farther than this is refused: kInvalid.
inline constexpr double kMaxPartReach = 0x1p28;
/// Metres: so near a part that turns counts as in touch with it. See cast().
inline constexpr double kPartTouch = 1.0 / 16384;
/// Metres: the same of hulls and a part that stands turned.
inline constexpr double kTurnedHullTouch = 1.0 / 1048576;

/// A part: its solid, and how that moves from fraction 0 to 1 of the time at hand. A value; a copy costs the name's
/// and a count that threads share.
class MovingPart {
public:
    MovingPart() = default;
    /// @param world  the solid in the part's frame, of one room; its portals, if it has any, are met as faces are
    /// Costs World::bounds().
    FIRMA_EXPORT explicit MovingPart(World world, const RigidMotion& motion = {});

    const World& world() const { return world_; }
    /// Another solid in place of this one: what a cut left of it.
    FIRMA_EXPORT void set_world(World world);
    /// Of the solid, in its frame, metres; empty for a part without faces.
    const Box& bounds() const { return bounds_; }

    RigidMotion motion;
    std::uint32_t mask = ~0u;        ///< met by what shares a bit with it, and with the face
    std::uint32_t entity = kNoPart;  ///< of the level that the part was made from, if it was: index into its entities
    std::string name{};

private:
    World world_;
    Box bounds_;
};

/// A level with its parts: views, which must outlive it.
struct Scene {
    const World& world;
    std::span<const MovingPart> parts{};
    /// Which stretch of the parts' motions the fractions 0 to 1 of questions stand for, itself in fractions of them,
    /// from 0 to 1. Equal: they stand there.
    double from = 0, to = 1;
};

/// A hit of the level or of a part.
struct PartHit : Hit {
    std::uint32_t part = kNoPart;  ///< index into Scene::parts; kNoPart: the level, or a miss
    /// Of the part's surface, at the touch: metres from fraction 0 to 1 at that pace. Zero for the level.
    Vec3 surface_velocity;
};

/// The first touch of a moving sphere with the level, or with a part that moves meanwhile.
///
/// A part that does not turn is met exactly as its world is by a sphere that starts at centre - position and goes path
/// - motion.path, both rounded once: fraction and feature have the same bits. One that stands turned, without turning
/// further, is met as its world is by a sphere turned back, to rounding (some 1e-12 m). Against one that turns, a touch
/// is never late, but for rounding (below 1e-6 m), and at most kPartTouch (0.06 mm) early, measured from the sphere to
/// the surface. What is nearer than that to such a part at the start is in touch with it: met at once if it comes
/// nearer, else left out until it has come away, or has come nearer by kPartTouch / 2.
///
/// @param path     motion (metres); it may be zero: parts come to what stands
/// @param options  `room` and `trail` are of the level; parts are met whichever room they are in
/// @return as cast() of a world, over all; of several at the smallest fraction the level, then the part with the lowest
///         index, then the face with the lowest id. Places and normals are in the world, where the part is at the
///         fraction. Of a part that turns, safe_fraction is reckoned from the speed along the normal at the touch.
///         kInvalid also where any part's motion has a number that is not finite, or a turn beyond kMaxPartTurn,
///         and for a stretch that is not within 0..1
/// Never allocates. Costs a cast through the level, a look at the box or ball around each part, and a cast through each
/// part that is near; of one that turns, for each of its faces near the way some searches (in the mean fewer than ten)
/// for the nearest points of face and shape, in all no more than 200,000 and 64 a face: what is not decided then, as of
/// a capsule longer than the world, counts as met.
[[nodiscard]] FIRMA_EXPORT PartHit cast(const Scene& scene, const Sphere& sphere, const Vec3& path,
                                        const CastOptions& options = {});
/// Of a particle.
[[nodiscard]] inline PartHit cast(const Scene& scene, const Ray& ray, const CastOptions& options = {}) {
    return cast(scene, {ray.start, 0}, ray.path, options);
}
/// Of a capsule.
[[nodiscard]] FIRMA_EXPORT PartHit cast(const Scene& scene, const Capsule& capsule, const Vec3& path,
                                        const CastOptions& options = {});
/// Of a hull or box. One that is turned back would be another hull: so a part that stands turned is met as one that
/// turns, but at most kTurnedHullTouch (0.001 mm) early.
[[nodiscard]] FIRMA_EXPORT PartHit cast(const Scene& scene, const Hull& hull, const Vec3& at, const Vec3& path,
                                        const CastOptions& options = {});

/// Whether cast() would touch anything.
/// @return kHit, kInitialOverlap, kMiss or kInvalid; which of the first two is that of whatever was found
[[nodiscard]] FIRMA_EXPORT Status cast_any(const Scene& scene, const Sphere& sphere, const Vec3& path,
                                           const CastOptions& options = {});
[[nodiscard]] inline Status cast_any(const Scene& scene, const Ray& ray, const CastOptions& options = {}) {
    return cast_any(scene, {ray.start, 0}, ray.path, options);
}
[[nodiscard]] FIRMA_EXPORT Status cast_any(const Scene& scene, const Capsule& capsule, const Vec3& path,
                                           const CastOptions& options = {});
[[nodiscard]] FIRMA_EXPORT Status cast_any(const Scene& scene, const Hull& hull, const Vec3& at, const Vec3& path,
                                           const CastOptions& options = {});

/// What is overlapped, of the level or of a part.
struct PartOverlap : Overlap {
    std::uint32_t part = kNoPart;  ///< as PartHit::part
    Vec3 surface_velocity;         ///< of the part at `point`, as PartHit::surface_velocity
};

/// Is given one at a time, those of the level first, then part by part; returns whether to go on.
using PartOverlapVisitor = FunctionRef<bool(const PartOverlap& overlap)>;

/// The faces of level and parts that a closed ball touches, the parts where they are at a fraction of their motions.
/// @param fraction  0 to 1
/// @return as overlap_each() of a world; kInvalid also for a part's motion as for cast(), and a fraction that is not
///         within 0..1. Of parts that are turned to rounding.
/// Never allocates. Costs what it costs of the level, and of each part that is near.
FIRMA_EXPORT Status overlap_each(const Scene& scene, const Sphere& sphere, PartOverlapVisitor visit,
                                 double fraction = 0, const NearOptions& options = {});
FIRMA_EXPORT Status overlap_each(const Scene& scene, const Capsule& capsule, PartOverlapVisitor visit,
                                 double fraction = 0, const NearOptions& options = {});
FIRMA_EXPORT Status overlap_each(const Scene& scene, const Hull& hull, const Vec3& at, PartOverlapVisitor visit,
                                 double fraction = 0, const NearOptions& options = {});

/// The nearest face.
struct PartNear : NearFace {
    std::uint32_t part = kNoPart;  ///< as PartHit::part
    Vec3 surface_velocity;         ///< of the part at `point`
};

/// The point of level and parts nearest to a point; of several at the same distance the level's, then that of the part
/// with the lowest index, then of the face with the lowest id.
/// @return as closest() of a world; kInvalid also as overlap_each()
/// Never allocates. Costs a search in the level, and in each part that may be nearer.
[[nodiscard]] FIRMA_EXPORT PartNear closest(const Scene& scene, const Vec3& point, double reach = kEverywhere,
                                            double fraction = 0, const NearOptions& options = {});

}  // namespace firma
