// SPDX-License-Identifier: MIT
// What happens to a game from outside.
#include <utility>

#include "game/game_blast.h"
#include "game/game_edits.h"
#include "game/game_parts.h"
#include "game/judge_event.h"

namespace firma {
namespace {

class EventDoer {
public:
    EventDoer(GameState& game, GameReport& report) : game_(game), report_(report) {}

    void operator()(const EditEvent& event) const { do_edit(game_, event.command, report_); }
    void operator()(const BlastEvent& event) const { explode_charge(game_, event.at, event.charge, report_); }
    void operator()(const FireEvent& event) const {
        GameShots& shots = game_.shots[event.weapon];
        Projectile projectile;
        projectile.position = event.position;
        projectile.velocity = event.velocity;
        projectile.mass = shots.weapon.mass;
        shots.projectiles.push_back(projectile);
    }
    void operator()(const BodyEvent& event) const { add_body(game_.bodies, event.body); }
    void operator()(const PlayerEvent& event) const { game_.players.push_back(event.player); }
    void operator()(const WishEvent& event) const { game_.players[event.player].wish = event.wish; }
    void operator()(const PartEvent& event) const {
        PartDrive& drive = game_.drives[event.part];
        if (!drive.waits) return;
        const bool rests =
            drive.started == kNoTick || at_first_stop(drive.path, drive_seconds(game_, drive, game_.tick));
        if (!rests) return;
        drive.started = game_.tick;
        drive.held = 0;
        drive.ahead = 0;
    }

private:
    GameState& game_;
    GameReport& report_;
};

}  // namespace

GameState begin_game(const World& level, std::uint32_t rate) {
    GameState game;
    game.rate = rate;
    game.world = level;
    game.log = EditLog(level);
    for (Weapon& weapon : standard_weapons()) game.shots.push_back({std::move(weapon), {}});
    return game;
}

std::optional<Error> apply_event(GameState& game, const GameEvent& event, GameReport* report) {
    const GameCounts counts{game.shots.size(), game.players.size(), game.parts.size()};
    if (const auto error = judge_event(event, counts)) return error;
    GameReport unread;
    std::visit(EventDoer(game, report ? *report : unread), event.what);
    return std::nullopt;
}

}  // namespace firma
