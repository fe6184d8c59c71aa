// SPDX-License-Identifier: MIT
// Projectiles: thousands of fast particles that fall, ricochet, go through walls or stay in them. Plain arrays outside
// the World: a snapshot of them is a copy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/bodies.h"
#include "firma/export.h"
#include "firma/hit.h"
#include "firma/moving_parts.h"
#include "firma/pierce.h"
#include "firma/result.h"
#include "firma/tasks.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

enum class ProjectileState : std::uint8_t {
    kFlying,
    kStopped,  ///< at a face, in solid, at a body or a part: its velocity is zero, but for a part that moves
    kExpired,  ///< flew longer than FlyOptions::max_age, or out of reach
};

/// One particle. All of it may be set between steps. fly() leaves those that do not fly as they are.
struct Projectile {
    Vec3 position{};           ///< metres; while it flies in the air, on a grid of 2^-38 m (4e-12)
    Vec3 velocity{};           ///< metres a second
    double mass = 0.01;        ///< kilograms
    double age = 0;            ///< seconds that it flew
    std::uint32_t mask = ~0u;  ///< faces, closed portals, parts and bodies that share a bit are met
    std::uint32_t user = 0;    ///< of the game: no answer depends on it
    /// hash_world() of the world that it flew in last. In another one fly() looks whether it is in solid there.
    std::uint64_t world_hash = 0;
    ProjectileState state = ProjectileState::kFlying;
};

/// Farther from the origin along an axis, in metres, is out of reach.
inline constexpr double kFlightReach = 16384;
/// Newtons: what resists as much is not entered.
inline constexpr double kUnpierced = 0x1p200;

/// What something does to a projectile that meets it.
struct ShotTerms {
    double ricochet_below = 0.25;    ///< radians between path and face: at less it ricochets; 0: never
    double restitution = 0.4;        ///< 0..1: what is left of the speed along the normal
    double friction = 0.3;           ///< of the change of speed along the normal, so much is lost along the face
    double resistance = kUnpierced;  ///< newtons: joules that it loses for each metre it goes through
};

/// What a projectile meets.
struct ShotImpact {
    std::uint32_t projectile = 0;  ///< its index
    Vec3 point;                    ///< metres
    Vec3 normal;                   ///< unit, toward where it came from
    Vec3 velocity;                 ///< metres a second, before
    double mass = 0;               ///< kilograms
    FaceRef face;                  ///< invalid of portals and bodies; of a part of its world
    PortalId portal;
    BodyId body;                   ///< slot ~0u of all else
    std::uint32_t material = 0;    ///< of the face or portal
    bool pane = false;             ///< a face that bounds no solid, or a closed portal
    std::uint32_t part = kNoPart;  ///< index into Scene::parts; `material`, like the matter, is then of its world
    Vec3 surface;                  ///< of the part there, metres a second: what ricochets sees velocity - surface
};

struct FlyOptions {
    Vec3 gravity{0, 0, -9.81};  ///< metres a second squared
    /// Metres: no chord of the parabola is farther from it, at any time.
    double max_bow = 0.001;
    double max_age = 10;       ///< seconds
    double stop_speed = 1;     ///< metres a second: what an impact leaves slower stops there
    int max_impacts = 8;       ///< of one projectile in one step, 1 to 1,000: with the last one it stops
    double max_thickness = 4;  ///< metres of a straight way through solid: what would take more stops
    /// By index into the world's table of matters. Those of a part are found in that table by their names.
    std::span<const ShotTerms> matters{};
    ShotTerms other{};                ///< of matters beyond these
    ShotTerms bodies{};               ///< their resistance does not count: what does not ricochet stops
    double pane_energy = kUnpierced;  ///< joules that it takes to go through a pane
    /// In place of the tables, where given: the terms of a matter (bodies: 0) in an impact; asked once for the face,
    /// and for each matter on the way through. Called from any thread. Terms that are out of range stop the projectile.
    ShotTerms (*rule)(const ShotImpact& impact, std::uint32_t matter, void* user) = nullptr;
    void* user = nullptr;          ///< handed to rule
    const Tasks* tasks = nullptr;  ///< null: this thread does it all
};

enum class ShotEventKind : std::uint8_t {
    kRicochet,
    kEntered,  ///< went into solid: kLeft or kStopped comes next
    kLeft,     ///< came out of it
    kPassed,   ///< went through a pane
    kStopped,  ///< at a face, a pane or a body; after kEntered in the solid; `face` is invalid where the solid came to
               ///< it, or lies right behind another
    kExpired,
};

struct ShotEvent {
    ShotEventKind kind = ShotEventKind::kStopped;
    std::uint32_t projectile = 0;    ///< its index
    std::uint32_t number = 0;        ///< among the events of this projectile in this step
    double time = 0;                 ///< seconds from the start of the step
    Vec3 point;                      ///< metres; where it stopped or left
    Vec3 normal;                     ///< unit, of what was met, toward where it came from; of kLeft out of the solid
    Vec3 velocity;                   ///< metres a second, after it; of what stopped at a part that of its surface
    Vec3 impulse;                    ///< newton seconds that it gave to what it met
    double energy = 0;               ///< joules that it lost, as the surface of what it met sees it
    FaceRef face;                    ///< that was met, or where it came out
    PortalId portal;                 ///< a closed one
    BodyId body;                     ///< slot ~0u: none
    std::uint32_t material = 0;      ///< of the face or portal
    std::uint32_t matter = 0;        ///< of the face; of kLeft the last one, of kStopped where it stopped
    double thickness = 0;            ///< metres that it went through: of kLeft, and of kStopped in solid
    std::uint32_t first_matter = 0;  ///< of these, in ShotEvents::matters: what it went through
    std::uint32_t matter_count = 0;
    /// Index into Scene::parts of what was met; face, material and matters are then of its world. kNoPart: no part.
    std::uint32_t part = kNoPart;
    Vec3 in_part;  ///< `point` in the part's frame, metres: where one that stopped stays as the part goes on
};

/// What happened in a step.
struct ShotEvents {
    std::vector<ShotEvent> events;      ///< by time, then projectile, then number
    std::vector<MatterLength> matters;  ///< fractions are of the way through the solid
};

struct FlyReport {
    std::size_t flying = 0;  ///< of those that still fly
    std::size_t chords = 0;
    std::size_t impacts = 0;
};

/// A step of more seconds, or of more chords a projectile, is refused.
inline constexpr double kMaxFlightSeconds = 1;
inline constexpr int kMaxFlightChords = 4096;

/// Lets projectiles fly on for some seconds.
///
/// In free air each is on the parabola x + v t + g t^2 / 2, but for 2^-39 m a coordinate for each chord. The parabola
/// is divided into chords of equal time h, with |g| h^2 / 8 <= max_bow: at each time the chord is no farther from it.
/// So what it meets by more than max_bow is met, and what it clears by more is cleared. Chords are cast as rays and
/// join exactly, so no projectile slips between faces.
///
/// What is met:
/// - At an angle below ShotTerms::ricochet_below it ricochets: its speed along the normal is turned about and
/// multiplied
///   by the restitution; along the face it loses at most friction times the change along the normal. It goes on from
///   0.01 mm in front of the face. (Where the chord meets a face that the parabola leads away from, within max_bow, it
///   goes on as fast as it was.)
/// - Else it goes into solid, straight along the chord, in no time: each matter takes its resistance times its length
///   of the kinetic energy. It comes out with what is left, in the direction that it had; or it stops where nothing is
///   left. It goes on from 0.01 mm behind the face where it came out (half way, where air is thinner than that). Panes
///   and bodies inside solid, and so near behind it, do not count.
/// - A pane takes FlyOptions::pane_energy, or stops it.
/// - A body that it meets as a ray does its spheres, as they lie when the step begins, makes it ricochet or stop. When
///   all have flown, the impulses are given by push_body(), in the order of events; so all see the same bodies.
///
/// A projectile has to start in the air. One that is new to this world and is in solid stops at once.
///
/// @param projectiles  those that fly
/// @param seconds      above zero, at most kMaxFlightSeconds
/// @param events       replaced; keeps its memory
/// @param bodies       may be null
/// @return kInvalid for seconds or options that are not finite or out of range; kTooLarge for more than
/// kMaxFlightChords;
///         kOutOfRange for a projectile that flies with a number that is not finite, a speed above 2^20 m/s, a mass not
///         above zero or a negative age, naming it; kInvalid also when Tasks::run returned before all its work had.
///         Nothing has moved then, and `events` is empty.
/// The same bits on every machine, with any tasks. Costs a cast for each chord, three more for each impact, pierce()
/// twice for each way through solid. 256 projectiles are a piece of work; each allocates some vectors.
[[nodiscard]] FIRMA_EXPORT Result<FlyReport> fly(std::span<Projectile> projectiles, const World& world, double seconds,
                                                 ShotEvents& events, const FlyOptions& options = {},
                                                 Bodies* bodies = nullptr);

/// The same among parts that go along the scene's stretch of their motions while the projectiles fly, as by cast() of a
/// scene: both move at the same time.
///
/// - A part is met as the level is, by the velocity that its surface sees: the projectile's less the surface's at that
///   place. So angle, ricochet, the way through (thickness and matters of the part's own world, in no time) and
///   FlyOptions::stop_speed go by it, and a blade or a lift that comes faster strikes a projectile that stands.
/// - What stops at a part, or in one, goes along with it until the step ends, where the level lets it; its position and
///   velocity are those of the part there then. From there on it is the caller's: ShotEvent::in_part, and `part`, say
///   where it stays.
/// - What comes out of the level into a part that lies flush with it, or reaches into it, goes into that at once, and
///   likewise out of a part into the level or another part: kEntered without a face. In solid of both it counts as in
///   the one that it was in before.
/// - What is in a part's solid when the step begins (it was fired there, or the part was put there) stops at once.
/// - What has no place left between the level and a part that comes stops. A ricochet that would go faster than 2^20
///   m/s stops as well.
///
/// @param scene  its level is the world of the other call; without parts the answers have the same bits
/// @return kInvalid also for a part whose motion cannot be used, or a point of which would go faster than 2^60 m/s,
///         naming it, and for a stretch that is not within 0..1
/// Costs also a tree over the parts' ways, and for each chord a cast through each part whose way's box it meets.
[[nodiscard]] FIRMA_EXPORT Result<FlyReport> fly(std::span<Projectile> projectiles, const Scene& scene, double seconds,
                                                 ShotEvents& events, const FlyOptions& options = {},
                                                 Bodies* bodies = nullptr);

/// A hash of all that the next steps depend on.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_projectiles(std::span<const Projectile> projectiles);

}  // namespace firma
