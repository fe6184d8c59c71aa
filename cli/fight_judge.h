// SPDX-License-Identifier: MIT
// Looks at a fire fight after each frame: what must hold of bodies and of the player.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/fight_game.h"

namespace firma::cli {

class FightJudge {
public:
    /// @param game  as it begins
    explicit FightJudge(const FightGame& game) : level_(game.level()), shape_(game.shape()), kept_in_(game.kept_in()) {}

    /// Bodies that moved, and all of them where the world is another one than last time; the player; rays.
    /// @return "" where all holds: no sphere of a body deeper in what bounds solid than the contact offset and no
    /// centre
    ///         in solid none lost; the player not in
    ///         solid, overlapping nothing, not stuck and not lost; no ray out of a closed level
    /// @param escaped  rays so far
    std::string fault(const FightState& state, std::size_t escaped);

    double deepest() const { return deepest_; }         ///< metres, of all spheres that were judged
    std::uint64_t spheres() const { return spheres_; }  ///< judged
    std::size_t lost() const { return lost_; }          ///< bodies in the last frame

private:
    std::string fault_of_body(const World& world, const Body& body);
    std::string fault_of_player(const FightState& state) const;
    bool is_lost(const World& world, const Vec3& at) const;

    const World level_;
    const PlayerShape shape_;
    const bool kept_in_;
    std::vector<bool> slept_, outside_;
    std::uint64_t world_hash_ = 0;
    double deepest_ = 0;
    std::uint64_t spheres_ = 0;
    std::size_t lost_ = 0;
};

}  // namespace firma::cli
