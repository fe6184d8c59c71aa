// SPDX-License-Identifier: MIT
// Players: upright shapes that walk, jump, crouch, climb steps and slide along walls. move_player() is a function of
// what it is given: the world, the player, what is wished. Nothing is kept between calls, so a player is replayed,
// predicted and rolled back as plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "firma/export.h"
#include "firma/moving_parts.h"
#include "firma/queries.h"
#include "firma/result.h"
#include "firma/sphere_set.h"
#include "firma/world.h"

namespace firma {

struct PlayerShapeData;

/// What a player is: a capsule, an upright box or spheres, standing and crouched, over one point, its feet: the lowest
/// on its middle axis. Immutable; copies share it.
class PlayerShape {
public:
    PlayerShape() = default;
    FIRMA_EXPORT explicit PlayerShape(std::shared_ptr<const PlayerShapeData> data);

    bool valid() const { return data_ != nullptr; }
    FIRMA_EXPORT double height(bool crouched = false) const;  ///< metres
    FIRMA_EXPORT double radius() const;   ///< metres: of a box half its width, of spheres as far as they reach sideways
    FIRMA_EXPORT const Vec3& up() const;  ///< unit

    const PlayerShapeData& data() const { return *data_; }

private:
    std::shared_ptr<const PlayerShapeData> data_;
};

/// Metres, ends of the capsule included.
struct PlayerSize {
    double radius = 0.3, height = 1.8, crouched_height = 1.1;
    Vec3 up{0, 0, 1};  ///< made unit
};

/// @return kInvalid for a number that is not finite or not above zero, an `up` shorter than 1e-3, a height below twice
///         the radius, or a crouched height above the other
[[nodiscard]] FIRMA_EXPORT Result<PlayerShape> make_player_capsule(const PlayerSize& size = {});
/// A box as wide and as deep as twice the radius, its sides along the axes where `up` is one of them. Heights may be
/// lower than it is wide.
[[nodiscard]] FIRMA_EXPORT Result<PlayerShape> make_player_box(const PlayerSize& size = {});
/// Spheres around a middle axis that leads up from the origin; what is below the origin counts as part of the feet.
/// @param crouched  no sphere: as standing
/// @return kInvalid for a sphere with a number that is not finite or a radius not above zero, for none or more than
///         kMaxSpheres
[[nodiscard]] FIRMA_EXPORT Result<PlayerShape> make_player_spheres(std::span<const Sphere> standing,
                                                                   std::span<const Sphere> crouched = {},
                                                                   const Vec3& up = {0, 0, 1});

/// One player, between two moves. All of it may be set.
struct Player {
    Vec3 position{};           ///< of the feet, metres
    Vec3 velocity{};           ///< metres a second; on the ground over what it stands on, along `up` 0
    std::uint32_t mask = ~0u;  ///< faces that share a bit are met
    bool on_ground = false;
    bool crouched = false;
    bool stuck = false;                   ///< it overlaps, and no place to go was found
    Vec3 ground_normal{};                 ///< of the face that it stands on; with on_ground
    std::uint32_t ground_part = kNoPart;  ///< the part that it stands on: index into Scene::parts
    Vec3 ground_velocity{};               ///< of that part at its feet, metres a second
    RoomId room;                          ///< where its middle was last in air
    std::uint64_t world_hash = 0;         ///< hash_world() of the world that it was last moved in
};

/// What is wished of it for one move.
struct PlayerWish {
    Vec3 velocity{};       ///< metres a second; what of it is along `up` does not count
    bool jump = false;     ///< from the ground
    bool crouch = false;   ///< as long as it is set, and on as long as there is no room to stand
    bool careful = false;  ///< it does not walk where the ground is more than PlayerRules::max_drop lower
};

/// How players move. What is not finite, below zero or beyond 2^200 is refused.
struct PlayerRules {
    double gravity = 9.81;                  ///< metres a second squared, against `up`
    double max_slope = 0.7853981633974483;  ///< radians: of faces that it walks on, judged by their normals
    double step_height = 0.45;              ///< metres: higher steps are walls; lower ones are walked up, and down
    double max_drop = 0.6;                  ///< metres; see PlayerWish::careful
    double overhang = 0.7;            ///< in radii: so far beyond an edge its middle may be where nothing is below
    double jump_speed = 4.4;          ///< metres a second
    double ground_acceleration = 60;  ///< metres a second squared
    double air_acceleration = 12;     ///< likewise
    double crouched_speed = 0.5;      ///< times the speed that is wished
    double max_push = 4;              ///< metres: so far at most it is moved out of what came where it was
    double contact_offset = 0;        ///< metres kept from what it touches; 0 takes the World's
};

enum class ContactKind : std::uint8_t { kGround, kWall, kCeiling };

/// What a player touched on its way.
struct PlayerContact {
    ContactKind kind = ContactKind::kWall;
    Vec3 point;        ///< metres
    Vec3 normal;       ///< unit, toward the player
    Vec3 face_normal;  ///< unit, of the face; of ground, of the flattest one there
    FaceRef face;      ///< invalid of a closed portal
    PortalId portal;
    std::uint32_t part = kNoPart;  ///< that the face is of; kNoPart: of the level
    std::uint32_t material = 0;
};

inline constexpr std::size_t kMaxPlayerContacts = 8;

/// Where a move led to.
struct PlayerMove {
    Player player;
    std::array<PlayerContact, kMaxPlayerContacts> touched{};
    std::size_t contact_count = 0;
    /// Metres: the way out of what came where the player was, before it moved; what it backs off by, less than the
    /// contact offset at a time, from what it has come nearer to than that; and what it slides aside by, within four
    /// contact offsets, down to ground below. What is farther than asked is in here.
    Vec3 pushed{};
    Vec3 carried{};                     ///< metres: with the part that it stood on, and out of the way of parts
    std::uint32_t pushed_by = kNoPart;  ///< a part that came where it was, the last one
    /// A part that it is pressed by without room to give way: it overlaps that, never the level. The game decides: stop
    /// the part, let it turn back, or hurt the player.
    std::uint32_t crushed_by = kNoPart;
    double landed_speed = 0;  ///< metres a second against the ground, where it came down; else 0
    bool jumped = false;
    bool stepped = false;  ///< up a step
    bool valid = true;     ///< false: a number was bad or the shape not valid(); the player is as it was

    std::span<const PlayerContact> contacts() const { return std::span(touched).first(contact_count); }
};

/// Moves a player by one tick.
///
/// On the ground it goes along the ground with the wished speed, which it comes to by PlayerRules::ground_acceleration,
/// never faster sideways, slopes and steps included. In the air it flies on, a parabola as long as it meets nothing.
/// What it meets it slides along: of all motions that lead into nothing that was met, the one nearest to what is left
/// (one plane, two, or three; the solution is that of the linear problem, without a nudge away from walls). It keeps
/// the contact offset from all, but from what it comes upon at less than 3.6 degrees and slower than the offset a tick:
/// that it backs off from once it is nearer than half of it. A face too steep to walk on lifts nobody, but to ground
/// that is within a step above and near; between several it stands where the groove of these is not too steep. No sweep
/// is ever shortened, so it passes no wall at any speed.
///
/// Where another world is given than last time, it is looked whether something came where the player is. If so it is
/// moved out: the shortest way that overlaps lead to, else to the nearest of places around it that are free; none in
/// the exterior of a world of several rooms, unless the player was there. Where there is none it is `stuck` and stays.
///
/// @param seconds  0..1 of time; more is refused: divide it
/// Parts go from fraction 0 to 1 of their motions first, in up to 64 steps of at most a quarter of the radius (what
/// goes farther than 16 radii in a tick takes larger ones, and may pass a player): what the player stands on carries
/// it, what comes pushes it. Then it moves as above, parts standing at fraction 1. Whoever steps or jumps off a part
/// keeps its speed. Part k has to be the same one from tick to tick, as Player::ground_part names it.
///
/// The same bits on every machine. Never allocates. Costs two to four casts on plain ground, some more at walls and
/// steps; at most a few hundred where a way out is looked for, and some thousand, milliseconds, where none is near, in
/// the first move in a world alone.
[[nodiscard]] FIRMA_EXPORT PlayerMove move_player(const Scene& scene, const PlayerShape& shape, const Player& player,
                                                  const PlayerWish& wish, double seconds,
                                                  const PlayerRules& rules = {});
/// Without parts.
[[nodiscard]] inline PlayerMove move_player(const World& world, const PlayerShape& shape, const Player& player,
                                            const PlayerWish& wish, double seconds, const PlayerRules& rules = {}) {
    return move_player(Scene{world}, shape, player, wish, seconds, rules);
}

/// Whether a player would overlap anything there, or its middle lie in solid: for places to begin at.
/// @param scene  its parts where they are at Scene::from
[[nodiscard]] FIRMA_EXPORT bool player_fits(const Scene& scene, const PlayerShape& shape, const Vec3& position,
                                            bool crouched = false, std::uint32_t mask = ~0u);
[[nodiscard]] inline bool player_fits(const World& world, const PlayerShape& shape, const Vec3& position,
                                      bool crouched = false, std::uint32_t mask = ~0u) {
    return player_fits(Scene{world}, shape, position, crouched, mask);
}

}  // namespace firma
