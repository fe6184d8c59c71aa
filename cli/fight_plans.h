// SPDX-License-Identifier: MIT
// Who fires where in a fire fight: lists that were made beforehand, and a player who looks for himself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cli/fight_game.h"
#include "firma/brush_level.h"

namespace firma::cli {

/// Where the player goes. It goes to one after the other, straight.
struct FightGoal {
    double seconds = 0;  ///< it sets off then, or when it has come to the one before it, whichever is later
    Vec3 to;             ///< metres; height does not count
    double speed = 3.5;  ///< metres a second
};

/// A fire fight as it may be written down.
struct FightList {
    Vec3 start;  ///< the player's feet, metres
    std::vector<FightShot> shots;
    std::vector<FightGoal> goals;
};

/// Does what a list says.
class ListedFight : public FightPlan {
public:
    explicit ListedFight(FightList list) : list_(std::move(list)) {}
    FightOrders next(const FightGame& game) override;

private:
    const FightList list_;
    std::vector<bool> fired_;
    std::size_t goal_ = 0;
};

/// The fire fight of levels/depot.map: the bridge's ends, the crane's, the hall's pillars, rubble, crates, a wall of
/// the hall; the player goes through that wall.
FightList depot_fight();

/// A player who walks where there is room, fires at what it sees, and goes through the holes that come of it.
class RoamingFight : public FightPlan {
public:
    RoamingFight(std::uint64_t seed, double seconds) : state_(seed), seconds_(seconds) {}
    FightOrders next(const FightGame& game) override;

private:
    double random(double low, double high);
    Vec3 random_way();
    double room_ahead(const FightGame& game, const World& world, const Vec3& way, double far) const;
    void turn_about(const FightGame& game);
    void look_for_hole(const FightGame& game);
    std::optional<FightShot> aim(const FightGame& game);

    std::uint64_t state_;
    const double seconds_;
    Vec3 way_{1, 0, 0};
    std::optional<Vec3> hole_;
    double hole_until_ = 0, next_shot_ = 0.5;
    std::size_t blasts_seen_ = 0, slow_ = 0;
    Vec3 last_;
};

/// A place for the player to begin at: where the level's author has one, else in some air.
/// @return nothing where the player fits nowhere that was tried
std::optional<Vec3> find_start(const World& world, const BrushLevel* level, std::uint64_t seed);

}  // namespace firma::cli
