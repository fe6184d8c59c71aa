// SPDX-License-Identifier: MIT
// Bodies that move, hit the world, its parts that move and each other, come to rest and sleep: plain arrays outside the
// World. A snapshot of a game is a World, its parts and a copy of its Bodies.
//
// Each body is kept clear of level and parts at the end of every step, at any speed. Between bodies touches are pressed
// apart by contacts, and swept where two come fast; there an overlap may last for some steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "firma/chunk.h"
#include "firma/export.h"
#include "firma/mass.h"
#include "firma/moving_parts.h"
#include "firma/queries.h"
#include "firma/result.h"
#include "firma/sphere_set.h"
#include "firma/turn.h"
#include "firma/world.h"

namespace firma {

struct BodyShapeData;

/// What a body is made of: spheres, and mass as of the solid that they stand for, in one frame. Immutable; copies share
/// it.
class BodyShape {
public:
    BodyShape() = default;
    FIRMA_EXPORT explicit BodyShape(std::shared_ptr<const BodyShapeData> data);

    bool valid() const { return data_ != nullptr; }
    FIRMA_EXPORT std::span<const Sphere> spheres() const;  ///< as given
    FIRMA_EXPORT double mass() const;                      ///< kilograms
    FIRMA_EXPORT const Vec3& centre() const;               ///< of mass, in the frame
    FIRMA_EXPORT const Vec3& moments() const;     ///< of inertia, about the principal axes, kg m2, largest first
    FIRMA_EXPORT const Quaternion& axes() const;  ///< turns the axes of the frame to the principal ones
    FIRMA_EXPORT double reach() const;            ///< metres: no sphere reaches farther from the centre of mass

    /// Inner workings. None of these, but valid(), may be asked of one that is not valid().
    const BodyShapeData& data() const { return *data_; }

private:
    std::shared_ptr<const BodyShapeData> data_;
};

/// @param spheres  1 to kMaxSpheres, of radii above zero
/// @param mass     of the solid that they stand for, in the same frame: mass_properties(), Chunk::mass
/// @return kInvalid for a number that is not finite or beyond 2^200, a radius, mass or inertia that is not above zero,
///         an inertia that no solid has (one axis 2^30 times another), or another count
[[nodiscard]] FIRMA_EXPORT Result<BodyShape> make_body_shape(std::span<const Sphere> spheres,
                                                             const MassProperties& mass);

/// Of a solid ball around the origin.
/// @param density  kilograms a cubic metre
[[nodiscard]] FIRMA_EXPORT MassProperties mass_of_ball(double radius, double density);
/// Of a solid box around the origin.
/// @param half  metres, along each axis
[[nodiscard]] FIRMA_EXPORT MassProperties mass_of_box(const Vec3& half, double density);

/// Names a body, as long as it is there. A slot is used again with another number.
struct BodyId {
    std::uint32_t slot = ~0u, use = 0;
    friend bool operator==(BodyId, BodyId) = default;
};

/// One body. All of it may be set between steps, but for `use`; set `asleep` to false then.
struct Body {
    Vec3 position{};                    ///< of the centre of mass, metres
    Quaternion rotation{0, 0, 0, 1};    ///< of the frame of its shape; normalised when used
    Vec3 velocity{};                    ///< of the centre of mass, metres a second
    Vec3 spin{};                        ///< radians a second, in the world's axes
    Vec3 force{};                       ///< newtons, besides gravity; kept from step to step
    Vec3 torque{};                      ///< newton metres
    BodyShape shape;                    ///< not valid() where no body is
    double friction = 0.6;              ///< >= 0; of two that touch the geometric mean counts, with the world's as 0.6
    double restitution = 0.1;           ///< 0..1; of two that touch the larger counts
    double rolling = 0.02;              ///< >= 0; resistance to rolling, in radii of the sphere that rolls
    double still_for = 0;               ///< seconds that it has hardly moved for from where it was then:
    Vec3 still_at{};                    ///< its position
    Quaternion still_turn{0, 0, 0, 1};  ///< its rotation
    std::uint32_t mask = ~0u;           ///< faces and bodies that share a bit are met
    std::uint32_t use = 0;              ///< of its slot
    std::uint32_t island = ~0u;         ///< of those that sleep: they wake together
    bool asleep = false;
    bool stuck = false;    ///< a sphere's centre is in solid: see StepReport::stuck
    bool crushed = false;  ///< in the last step: see StepReport::crushed
};

/// Two spheres, or a sphere and a face, that pressed on each other in the last step; of bodies that sleep in the last
/// one before. The next step goes on from them: so stacks stay as they are. docs/bodies.md says what games may read.
struct BodyContact {
    std::uint32_t body = 0, other = ~0u;         ///< slots; ~0u: the level or a part
    std::uint32_t sphere = 0, other_sphere = 0;  ///< of their shapes
    std::uint32_t part = kNoPart;                ///< that it lies on: index into Scene::parts; kNoPart: none
    FaceRef face;                                ///< of the world or the part; invalid of a body or a closed portal
    PortalId portal;                             ///< a closed one
    Vec3 point;                                  ///< metres, as the step began
    Vec3 normal;                                 ///< unit, toward `body`, likewise
    double force = 0;                            ///< along the normal, newtons, in the last substep
    Vec3 friction{};                             ///< across it, newtons, on `body`
    Vec3 slip{};                                 ///< metres slid since friction held: it pulls back
    Vec3 rolling{};                              ///< torque that resisted turning, newton metres
};

/// All bodies of a game. Plain arrays: a copy is a snapshot. Use the functions below to add and remove bodies.
struct Bodies {
    std::vector<Body> slots;
    std::vector<std::uint32_t> free;    ///< slots without a body, the last one is taken first
    std::vector<BodyContact> contacts;  ///< by body, other, sphere, other sphere
    std::uint64_t steps = 0;
    std::uint64_t world_hash = 0;            ///< hash_world() of the world that the last step was in
    std::uint32_t islands = 0;               ///< numbers given so far
    std::vector<std::uint64_t> part_hashes;  ///< of each part, its solid and place, as the last step began

    /// Null where it is not there any more.
    FIRMA_EXPORT Body* find(BodyId id);
    FIRMA_EXPORT const Body* find(BodyId id) const;
};

/// Where the frame of a body's shape is: where to draw what the shape was made of. Scale is 1.
[[nodiscard]] FIRMA_EXPORT Pose pose_of(const Body& body);
/// A body at rest, with the frame of its shape here; the scale does not count.
[[nodiscard]] FIRMA_EXPORT Body body_at(const BodyShape& shape, const Pose& pose);
/// A chunk as a body at rest where it came loose: spheres fitted into its solid, its mass. Its resistance to rolling is
/// half of SphereFit::error, as a share of the largest sphere, 0.02 to 0.5: one that is a single sphere does not roll
/// on like a ball.
/// @return the errors of fit_spheres(), and of make_body_shape() for one without mass
/// Costs fit_spheres().
[[nodiscard]] FIRMA_EXPORT Result<Body> body_of(const Chunk& chunk, const FitOptions& fit = {});
/// Joules: of its motion and its turning.
[[nodiscard]] FIRMA_EXPORT double kinetic_energy(const Body& body);
/// Newton metre seconds, about its centre of mass.
[[nodiscard]] FIRMA_EXPORT Vec3 angular_momentum(const Body& body);

/// Puts a body into a free slot, the last that became free, or a new one. It is named by the slot and a number that no
/// body there had before.
/// @param body  its shape has to be valid()
FIRMA_EXPORT BodyId add_body(Bodies& bodies, Body body);
/// What it touched wakes up. Does nothing for one that is not there.
FIRMA_EXPORT void remove_body(Bodies& bodies, BodyId id);
/// Wakes what sleeps with it, too. Does nothing for one that is not there.
FIRMA_EXPORT void wake_body(Bodies& bodies, BodyId id);
/// A push at a point: newton seconds, metres. Wakes it, and what sleeps with it. Does nothing for one that is not
/// there.
FIRMA_EXPORT void push_body(Bodies& bodies, BodyId id, const Vec3& impulse, const Vec3& point);

struct StepOptions {
    Vec3 gravity{0, 0, -9.81};  ///< metres a second squared
    /// At least; a step has a whole number of them. Where bodies of very different masses meet it makes up to eight
    /// times as many, of up to 16 iterations each in place of one, for those that hang together with them. 1 to 10,000.
    int substeps_a_second = 240;
    double contact_friction = 0.6;  ///< of the world, >= 0
    double contact_offset = 0;      ///< metres that spheres may sink in, >= 0; 0 takes the World's
    double sleep_speed = 0.05;      ///< metres a second: what moves less far in sleep_after at any point is still
    double sleep_after = 0.5;       ///< seconds still; infinity: never
    /// Of one body on its way in one step, off level, parts and bodies together; 0 to 1,000.
    int max_bounces = 4;
};

/// What a step did.
struct StepReport {
    std::size_t awake = 0;     ///< bodies that moved
    std::size_t contacts = 0;  ///< spheres near faces or each other, pressing or not
    std::size_t swept = 0;     ///< bodies that moved far enough to pass something, swept along their way
    std::size_t bounces = 0;   ///< touches in these sweeps
    std::size_t woken = 0;     ///< sleepers that the step woke
    /// Bodies with a sphere whose centre is in solid, as that came where they were: filled in, put back, a level made
    /// anew. They move out the shortest way, at 4 m/s, and meet nothing until they are out.
    std::size_t stuck = 0;
    /// Bodies that a part came upon and that could not give way: Body::crushed says which. They are never pushed into
    /// the level; the part goes over them. One with a sphere's centre in a part is `stuck` as well, and moves out of
    /// it as far as the level leaves room.
    std::size_t crushed = 0;
    /// Bodies with a number that is not finite or beyond 2^200, a friction or rolling below zero, a restitution that is
    /// not within 0 to 1: they stay as they are, and nothing meets them. Also those that came to such numbers in the
    /// step: they stay where they were, at rest.
    std::size_t unsound = 0;
    bool valid = true;  ///< false: nothing was done, see step()
};

/// Moves all bodies on by `seconds`, while the parts go along the scene's stretch of their motions.
///
/// No sphere of a body that was clear of the world ends deeper in it than the contact offset, and none passes a wall,
/// at any speed: at the end of a step each body is swept along its way. The same holds of parts, but for what is
/// crushed. Parts are as heavy as can be: bodies do not move them.
///
/// @param scene    parts are known by their index: each keeps its own from step to step
/// @param seconds  at least a nanosecond; of more than a quarter of a second, a quarter is made, and as much of the
///                 motions
/// @return not `valid` for seconds and options that are not finite or out of range, and where a part's motion cannot be
///         used (see cast() of a scene): then all is as it was
/// The same bits on every machine. Costs the bodies that are awake, with the faces near them, and a look at the box of
/// each part for each.
FIRMA_EXPORT StepReport step(Bodies& bodies, const Scene& scene, double seconds, const StepOptions& options = {});
/// In a world without parts.
inline StepReport step(Bodies& bodies, const World& world, double seconds, const StepOptions& options = {}) {
    return step(bodies, Scene{world}, seconds, options);
}

/// A hash of all that the next steps depend on.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_bodies(const Bodies& bodies);

}  // namespace firma
