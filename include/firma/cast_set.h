// SPDX-License-Identifier: MIT
// Sets of spheres on their way: straight, turning as they go, against a world or against each other.
#pragma once

#include <cstdint>

#include "firma/export.h"
#include "firma/motion.h"
#include "firma/moving_parts.h"
#include "firma/queries.h"
#include "firma/sphere_set.h"
#include "firma/world.h"

namespace firma {

/// A hit, and which sphere it was: Hit::centre is that sphere's.
struct SetHit : Hit {
    std::uint32_t sphere = ~0u;  ///< index into the set; ~0u when nothing was touched
};

/// How much a sphere may be thicker than it is while it turns: see cast(). Metres.
inline constexpr double kMaxBulge = 1.0 / 32768;

/// The first touch of a moving set with the world.
///
/// A set that only moves straight is as exact as its spheres: the answer is that of cast() for each, the smallest
/// fraction, then the lowest sphere. The spheres of one that turns go on arcs. These are divided until the chord of a
/// piece is within kMaxBulge of the arc at all times, which is proven; then a sphere that is thicker by so much goes
/// along the chord. So a touch is early by no more than the way on which a sphere comes 2 kMaxBulge (0.06 mm) nearer,
/// and late only where an arc comes nearer to a face between two pieces that both lead away from it, by less than
/// kMaxBulge (docs/bodies.md). What comes to nothing near is not divided.
///
/// @param motion   of the set
/// @param options  as for one sphere; `room` has to hold all of the set, or be kAnyRoom; a trail is of no use here
/// @return as cast(); of a set that turns safe_fraction is reckoned from the speed along the normal at the touch.
///         kInvalid for a number that is not finite, a negative radius or a turn beyond kMaxAngle; kMiss for no sphere
/// Never allocates. Costs a look for what a sphere around all of it comes near; where that finds anything, a cast for
/// each sphere, and when turning one for each piece of its arc that comes near anything.
[[nodiscard]] FIRMA_EXPORT SetHit cast(const World& world, std::span<const Sphere> spheres, const RigidMotion& motion,
                                       const CastOptions& options = {});

/// A hit of the level or of a part, and which sphere it was.
struct SetPartHit : PartHit {
    std::uint32_t sphere = ~0u;  ///< index into the set; ~0u when nothing was touched
};

/// The first touch of a moving set with a level, or with parts that move meanwhile along the scene's stretch: as cast()
/// of a scene for each sphere, the smallest fraction, then the lowest sphere. Spheres on arcs go by chords as above, so
/// a touch is early or late by no more than what is said there, and what cast() of a scene says of parts that turn.
/// @return as above, and as cast() of a scene; of a set that turns safe_fraction is reckoned as there of parts that do
/// Never allocates. Costs a cast through the scene for each sphere, and when turning one for each piece of its arc that
/// comes near the level or the ball around a part.
[[nodiscard]] FIRMA_EXPORT SetPartHit cast(const Scene& scene, std::span<const Sphere> spheres,
                                           const RigidMotion& motion, const CastOptions& options = {});

/// The first touch of two moving sets.
struct SetPairHit {
    Status status = Status::kMiss;
    double fraction = 1;
    std::uint32_t sphere_a = ~0u, sphere_b = ~0u;
    Vec3 point;   ///< where they touch, metres
    Vec3 normal;  ///< unit, from b's sphere toward a's

    [[nodiscard]] bool touched() const { return status == Status::kHit || status == Status::kInitialOverlap; }
};

/// Both move from fraction 0 to 1 at once. What is said above of turning holds here of both together: kMaxBulge each.
/// @return kHit, kInitialOverlap where two spheres overlap at the start and come nearer, kMiss, kInvalid as above
/// Never allocates. Costs the pairs of spheres that come near each other.
[[nodiscard]] FIRMA_EXPORT SetPairHit cast(std::span<const Sphere> a, const RigidMotion& motion_a,
                                           std::span<const Sphere> b, const RigidMotion& motion_b);

}  // namespace firma
