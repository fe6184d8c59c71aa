// SPDX-License-Identifier: MIT
// A fire fight, frame by frame: rockets fly and blow craters, what comes loose falls and breaks, a player walks about.
// What is fired and where the player goes is asked of a plan, as plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/debris.h"
#include "firma/players.h"
#include "firma/projectiles.h"
#include "firma/world.h"

namespace firma::cli {

inline constexpr double kFightRate = 60;  // frames a second

/// A rocket to be fired.
struct FightShot {
    double seconds = 0;       ///< when, for plans that are lists
    Vec3 from, at;            ///< metres: it flies so that it comes by `at`
    bool by_player = false;   ///< from the player's eye, in place of `from`
    double speed = 30;        ///< metres a second
    double radius = 1;        ///< of the crater, metres
    double into = 0.5;        ///< metres: so far behind what it met, on its way, is the crater's middle
    double break_radius = 3;  ///< metres: what comes loose, and debris, breaks within it
    std::size_t pieces = 16;  ///< that a body breaks into at most
    std::uint64_t seed = 1;   ///< of the crater and of cracks
};

/// What happens in a frame.
struct FightOrders {
    std::vector<FightShot> fire;
    PlayerWish wish;
};

/// A rocket that flies.
struct FightRocket {
    FightShot shot;
    Vec3 from;  ///< metres, where it was fired
};

/// A blast that was.
struct FightFlash {
    Vec3 at;  ///< metres
    double radius = 0;
    double seconds = 0;  ///< since the start of the fight
    CarveStatus crater = CarveStatus::kNothing;
    std::size_t loose = 0, broken = 0;  ///< bodies that came loose, and that broke
};

/// Seconds of processor time of a phase, over all frames and in the longest.
struct FightPhase {
    const char* name;
    double total = 0, worst = 0;
};

struct FightFigures {
    std::size_t frames = 0, shots = 0, hits = 0;
    std::size_t craters = 0, nothing = 0, refused = 0;  ///< hits by what became of the crater
    std::size_t undone = 0;                             ///< refused, too: craters that opened a way out of the level
    std::size_t loose = 0;                              ///< bodies of what came loose, before it broke
    std::size_t broken = 0, dust = 0, unfit = 0;        ///< see BlastResult
    std::size_t most_bodies = 0, removed = 0;           ///< at a time; taken out by the budget
    std::size_t pushed = 0;                             ///< pushes that blasts gave to bodies
    double player_way = 0;                              ///< metres
    std::size_t player_pushed = 0;                      ///< by blasts
    std::size_t holes = 0;                              ///< times that the player came to where the level was solid
    std::vector<std::string> rooms;                     ///< that the player was in, in order, by name or number
    std::size_t rays = 0, escaped = 0;
    std::array<FightPhase, 5> phases{{{"casts"}, {"cuts"}, {"bodies"}, {"debris"}, {"player"}}};
};

/// All that a frame makes another of: a copy is a snapshot.
struct FightState {
    World world;
    Bodies bodies;
    Debris debris;
    std::vector<Projectile> projectiles;  ///< rockets that fly
    Player player;
};

/// Of all of it.
std::uint64_t hash_fight(const FightState& state);

class FightGame;

/// Who says what happens.
class FightPlan {
public:
    virtual ~FightPlan() = default;
    virtual FightOrders next(const FightGame& game) = 0;
};

class FightGame {
public:
    /// @param level  with its anchors
    /// @param start  the player's feet, metres
    FightGame(World level, const Vec3& start, std::uint64_t seed);

    /// One frame.
    void advance(const FightOrders& orders);

    double seconds() const { return double(figures_.frames) / kFightRate; }
    const World& level() const { return level_; }  ///< as it was
    const FightState& state() const { return state_; }
    const World& world() const { return state_.world; }
    const Player& player() const { return state_.player; }
    const PlayerShape& shape() const { return shape_; }
    Vec3 eye() const;                                                     ///< the player's
    Vec3 middle() const;                                                  ///< likewise
    const std::vector<FightRocket>& rockets() const { return rockets_; }  ///< those of FightState::projectiles
    const std::vector<FightFlash>& flashes() const { return flashes_; }   ///< all
    const FightFigures& figures() const { return figures_; }
    /// Whether rooms of the level are closed, and the player began in one.
    bool kept_in() const { return kept_in_; }

private:
    void fire(const FightShot& shot);
    void fly_rockets();
    void blow(const FightRocket& rocket, const ShotEvent& event);
    void push_player(const firma::Blast& blast);
    void move_bodies();
    void tend();
    void move(const PlayerWish& wish);
    void look_around();
    void note_place();

    const World level_;
    FightState state_;
    std::vector<FightRocket> rockets_;
    ShotEvents events_;
    std::vector<FightFlash> flashes_;
    PlayerShape shape_;
    const std::uint64_t seed_;
    double diagonal_ = 0;
    bool kept_in_ = false, in_hole_ = false;
    FightFigures figures_;
};

}  // namespace firma::cli
