// SPDX-License-Identifier: MIT
// A whole game as one value: the world and what was done to it, parts that move, players, projectiles, bodies, debris,
// and the tick. Events are applied to it, ticks step it, and it is hashed, saved and loaded. docs/recordings.md tells
// how.
//
// A copy is a snapshot. The same value given the same events goes through the same bits on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "firma/blast.h"
#include "firma/bodies.h"
#include "firma/cutter.h"
#include "firma/debris.h"
#include "firma/edit_log.h"
#include "firma/export.h"
#include "firma/moving_parts.h"
#include "firma/part_path.h"
#include "firma/players.h"
#include "firma/projectiles.h"
#include "firma/result.h"
#include "firma/world.h"

namespace firma {

/// Ticks a second.
inline constexpr std::uint32_t kMinTickRate = 4, kMaxTickRate = 1000;
/// In place of a tick: never.
inline constexpr std::uint64_t kNoTick = ~std::uint64_t(0);

/// What explodes.
struct Charge {
    double crater = 1.2;  ///< metres: mean radius of the crater; 0: it leaves none
    CutterShape shape = CutterShape::kRocky;
    std::string material{};  ///< of the faces that it leaves: CarveOptions::material
    double radius = 6;       ///< metres: Blast::radius
    double impulse = 3000;   ///< newton seconds a square metre: Blast::impulse
    /// Metres: debris in it that it sees breaks, into so many pieces at most; see BlastOptions.
    double break_radius = 3;
    std::uint32_t max_pieces = 12;
};

/// A kind of projectile, and what becomes of it.
struct Weapon {
    std::string name;
    double mass = 0.01;  ///< kilograms, of a projectile
    Vec3 gravity{0, 0, -9.81};
    ShotTerms terms{};                ///< of all matters, and of parts that move
    ShotTerms bodies{};               ///< of bodies
    double pane_energy = kUnpierced;  ///< joules: FlyOptions::pane_energy
    double stop_speed = 1;            ///< metres a second: FlyOptions::stop_speed
    double fuse = 10;   ///< seconds from when it was fired: then it goes, with a bang where it has a charge
    bool lies = false;  ///< one that stops lies there until its fuse ends; else it goes at once, likewise
    std::optional<Charge> charge{};
};

/// 0 "bullet": of 10 g, goes into solid and ricochets. 1 "rocket": flies straight, explodes where it stops.
/// 2 "grenade": bounces, explodes after 2.5 s.
[[nodiscard]] FIRMA_EXPORT std::vector<Weapon> standard_weapons();

/// A weapon and what was fired of it and still flies or lies.
struct GameShots {
    Weapon weapon;
    std::vector<Projectile> projectiles;
};

/// How a part that moves goes by time.
struct PartDrive {
    PartPath path;
    /// Set off by a PartEvent: time 0 of its path is then, and before it stands at its first stop. Else it is tick 0.
    bool waits = false;
    std::uint64_t started = kNoTick;  ///< of one that waits: the tick when it was set off
    /// Where a player or body would be crushed between it and something else. One that turns back does so at once.
    WhenBlocked when_blocked = WhenBlocked::kCrushes;
    std::uint64_t held = 0;         ///< ticks that it waited by that
    double ahead = 0;               ///< seconds on its path that it left out as it turned back; less than 0: went twice
    std::vector<PortalId> portals;  ///< that are closed while it stands at its first stop, and open else
};

struct GamePlayer {
    PlayerShape shape;
    PlayerRules rules;
    double mass = 80;  ///< kilograms: what blasts push
    Player player;
    PlayerWish wish;  ///< from tick to tick, but for `jump`, which is of one tick
};

struct GameRules {
    StepOptions bodies{};
    /// `keep_clear` and `first_edit` are not used: players are kept clear, and the log says the numbers.
    DebrisRules debris{};
    /// How carvings look for loose pieces, which become debris; nothing: none comes loose.
    std::optional<ChunkOptions> chunks = ChunkOptions{};
    double max_blast_speed = 30;  ///< metres a second: PushOptions::max_speed, and of players
    std::uint64_t seed = 1;       ///< of craters and cracks
};

struct GameState {
    std::uint64_t tick = 0;   ///< ticks behind it
    std::uint32_t rate = 60;  ///< ticks a second, kMinTickRate to kMaxTickRate
    World world;
    EditLog log;                    ///< all that was done to `world`, from the level on
    std::vector<MovingPart> parts;  ///< `motion` of each is that of the last tick
    std::vector<PartDrive> drives;  ///< of each part
    std::vector<GamePlayer> players;
    std::vector<GameShots> shots;  ///< by weapon
    Bodies bodies;
    Debris debris;
    GameRules rules;
    std::uint64_t explosions = 0;  ///< so far: each has a crater of its own
};

/// A game in a level, at tick 0, with the standard weapons and nothing else.
/// @param level  with_anchors() where something else than what hangs free now is to be held
/// Costs EditLog(level).
[[nodiscard]] FIRMA_EXPORT GameState begin_game(const World& level, std::uint32_t rate = 60);

/// Adds a part that moves, at its place at this tick. With `find_portals`, a part that waits closes the portals that
/// its solid covers at its first stop (portals_closed_by()), from the next tick on.
/// @return its index
/// Costs World::bounds(), and portals_closed_by().
FIRMA_EXPORT std::uint32_t add_part(GameState& game, MovingPart part, PartDrive drive, bool find_portals = true);

// ---- What happens from outside, between two ticks ----

/// An edit of the world: a carving, a fill, a door, a group. Its numbers are not used: the log's next ones are given.
/// What carvings leave loose becomes debris, by GameRules::chunks, whatever its CarveOptions::chunks say.
struct EditEvent {
    EditCommand command;
};
/// An explosion.
struct BlastEvent {
    Vec3 at{};  ///< metres
    Charge charge{};
};
/// A projectile starts.
struct FireEvent {
    std::uint32_t weapon = 0;  ///< index into GameState::shots
    Vec3 position{};           ///< metres, in the air
    Vec3 velocity{};           ///< metres a second
};
/// A body is put in: as add_body() has it.
struct BodyEvent {
    Body body;
};
/// A player comes in, the next of GameState::players.
struct PlayerEvent {
    GamePlayer player;
};
/// A player wishes something else from now on.
struct WishEvent {
    std::uint32_t player = 0;
    PlayerWish wish{};
};
/// A part that waits, and stands at its first stop, sets off.
struct PartEvent {
    std::uint32_t part = 0;
};

struct GameEvent {
    std::uint64_t tick = 0;  ///< it happens when so many ticks are behind
    std::variant<EditEvent, BlastEvent, FireEvent, BodyEvent, PlayerEvent, WishEvent, PartEvent> what;
};

/// What happened in a tick, and by the events before it, for a game to show.
struct GameReport {
    std::vector<PlayerMove> moves;          ///< of each player
    std::vector<BlastResult> blasts;        ///< in order
    std::vector<Vec3> blast_places;         ///< of these, metres
    std::vector<ShotEvent> shot_events;     ///< of all weapons one after the other; `first_matter` means nothing
    std::vector<std::uint32_t> shot_kinds;  ///< of these, the weapon
    StepReport bodies;
    std::size_t edits = 0;     ///< of the world that were done: they are in the log
    std::size_t nothing = 0;   ///< that came to nothing
    std::size_t refused = 0;   ///< that were refused
    Error refusal;             ///< of the first of these
    std::size_t loose = 0;     ///< bodies of what came loose
    std::size_t broken = 0;    ///< bodies that broke
    std::size_t removed = 0;   ///< bodies that were too old or too many
    std::size_t grounded = 0;  ///< bodies that became ground
};

/// Does what an event says, now; its tick is not used.
/// @param report  added to, where given
/// @return why it cannot be done, and nothing happened: kInvalid for a weapon, player or part that is not there, a
/// shape
///         that is not valid(), a charge or crater out of range; kOutOfRange for a number that is not finite. An edit
///         that the world refuses, or that comes to nothing, is no error: `report` counts it
/// Costs what it does: apply(), explode(), add_body().
[[nodiscard]] FIRMA_EXPORT std::optional<Error> apply_event(GameState& game, const GameEvent& event,
                                                            GameReport* report = nullptr);

/// One tick on: parts go, doors open and close, players move, projectiles fly, what explodes explodes, bodies step,
/// debris grows old. docs/recordings.md has the order.
/// @param report  added to, where given
/// @return kInvalid for a rate out of range, weapons that fly() refuses, drives that are not as many as parts, or a
///         part whose motion cannot be used, naming it: the game is as it was then
/// The same bits on every machine. Costs its parts: move_player() a player, fly() a weapon, explode() a blast, step(),
/// tend_debris().
[[nodiscard]] FIRMA_EXPORT std::optional<Error> step_game(GameState& game, GameReport* report = nullptr);

// ---- Hashes ----

/// What a game consists of, for comparing two.
enum class GameItem : std::uint8_t {
    kWorld,       ///< one
    kPart,        ///< by index
    kPlayer,      ///< by index
    kProjectile,  ///< by weapon, then index
    kBody,        ///< by slot
    kDebris,      ///< by slot
    kRest,        ///< one: counters, contacts of bodies, rules, the log
};
inline constexpr std::size_t kGameItems = 7;

/// Hashes of a game, whole and of each thing in it.
struct GameHashes {
    std::uint64_t whole = 0;                                   ///< hash_game()
    std::array<std::vector<std::uint32_t>, kGameItems> items;  ///< by GameItem: 32 bits of each
    friend bool operator==(const GameHashes&, const GameHashes&) = default;
};

/// A hash of all that the next ticks depend on.
/// Costs all bodies and players; of the world what hash_world() costs.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_game(const GameState& game);
/// The same, with what it is made of. Costs twice as much, and a vector for each kind.
[[nodiscard]] FIRMA_EXPORT GameHashes hash_game_items(const GameState& game);

// ---- Bytes ----

/// What pack_game() writes and unpack_game() reads.
inline constexpr std::uint32_t kGameFileVersion = 2;

/// A game as the bytes of a .firma file: its world, as pack_world() writes it, and sections that other readers pass
/// over, so that whoever reads worlds reads this one's. The same game gives the same bytes on every machine.
/// docs/formats.md has the layout.
/// @return kInvalid, naming it, for what unpack_game() would refuse: a number that is not finite where one is needed,
///         contacts of bodies that are not there
/// Costs pack_world() of the world, of each part and of each piece of debris.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<std::byte>> pack_game(const GameState& game);

/// The game of such bytes, taken as hostile, as by unpack_world(). Stepped on, it gives the same bits as the game
/// packed.
/// @param name  for messages
/// @return errors of unpack_world(); kMalformed with section and byte for damage, and for a file with a world alone;
///         kUnsupported for another version
[[nodiscard]] FIRMA_EXPORT Result<GameState> unpack_game(std::span<const std::byte> bytes, std::string name);

/// Whether bytes begin as those of a .firma file do and have the section that pack_game() writes first. Reads the head
/// and the table of sections.
[[nodiscard]] FIRMA_EXPORT bool is_game_file(std::span<const std::byte> bytes);

}  // namespace firma
