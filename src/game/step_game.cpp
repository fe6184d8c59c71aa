// SPDX-License-Identifier: MIT
// A tick of a game.
#include <string>
#include <utility>

#include "firma/rooms.h"
#include "game/blocked_parts.h"
#include "game/game_blast.h"
#include "game/game_edits.h"
#include "game/game_parts.h"
#include "game/game_shots.h"
#include "game/judge_event.h"
#include "game/player_spheres.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

constexpr double kFarthestWay = 0x1p40;  // metres, of a part in a tick: what fly() takes at any rate

class GameTick {
public:
    GameTick(GameState& game, GameReport& report) : game_(game), report_(report), seconds_(1.0 / game.rate) {}

    /// Why it cannot be done. Nothing has changed then.
    std::optional<Error> begin() {
        if (game_.drives.size() != game_.parts.size())
            return Error{ErrorCode::kInvalid, "", "a game has as many drives as parts"};
        for (const GameShots& shots : game_.shots)
            if (const auto fault = fault_of_shots(shots)) return fault;
        for (const GamePlayer& player : game_.players)
            if (const auto fault = judge_player(player, game_.parts.size())) return fault;
        if (const auto fault = judge_rules(game_.rules)) return fault;
        for (std::size_t k = 0; k < game_.parts.size(); ++k) {
            MovingPart next;
            next.motion = drive_motion(game_, game_.drives[k]);
            if (!is_usable_part(next) || !(max_abs(next.motion.path) <= kFarthestWay))
                return Error{ErrorCode::kInvalid, "part " + std::to_string(k), "its motion cannot be used"};
            motions_.push_back(next.motion);
        }
        return std::nullopt;
    }

    void run() {
        hold_blocked_parts(game_, motions_);
        move_parts();
        move_players();
        for (const Bang& bang : fly_shots(game_, seconds_, report_))
            explode_charge(game_, bang.at, *game_.shots[bang.weapon].weapon.charge, report_);
        report_.bodies = firma::step(game_.bodies, Scene{game_.world, game_.parts}, seconds_, game_.rules.bodies);
        tend();
        ++game_.tick;
    }

private:
    void move_parts() {
        for (std::size_t k = 0; k < game_.parts.size(); ++k) game_.parts[k].motion = motions_[k];
        for (const PortalWish& wish : portal_wishes(game_)) {
            const std::optional<PortalInfo> info = portal_info(game_.world, wish.portal);
            if (!info || info->polygons == 0 || info->open == wish.open) continue;
            do_edit(game_, door_command(0, wish.portal, wish.open), report_);
        }
    }

    void move_players() {
        const Scene scene{game_.world, game_.parts};
        for (GamePlayer& player : game_.players) {
            PlayerMove move = move_player(scene, player.shape, player.player, player.wish, seconds_, player.rules);
            player.player = move.player;
            player.wish.jump = false;
            report_.moves.push_back(std::move(move));
        }
    }

    /// Debris grows old; what becomes ground goes into the log.
    void tend() {
        SphereSet clear;
        for (const GamePlayer& player : game_.players)
            for (const Sphere& sphere : spheres_of_player(player)) clear.push_back(sphere);
        DebrisRules rules = game_.rules.debris;
        rules.keep_clear = clear;
        rules.first_edit = game_.log.next_number();
        DebrisReport done = tend_debris(game_.world, game_.bodies, game_.debris, seconds_, rules);
        game_.world = std::move(done.world);
        report_.removed += done.removed.size();
        report_.grounded += done.to_ground.size();
        for (std::size_t k = 0; k < done.fills.size(); ++k) {
            EditCommand command;
            command.number = done.fill_options[k].edit;
            command.kind = EditKind::kFill;
            command.cutter = std::move(done.fills[k].cutter);
            command.pose = done.fills[k].pose;
            command.options = std::move(done.fill_options[k]);
            keep_edit(game_, std::move(command), CarveStatus::kDone, {}, report_);
        }
    }

    GameState& game_;
    GameReport& report_;
    const double seconds_;
    std::vector<RigidMotion> motions_;
};

}  // namespace

std::optional<Error> step_game(GameState& game, GameReport* report) {
    if (game.rate < kMinTickRate || game.rate > kMaxTickRate)
        return Error{ErrorCode::kInvalid, "", "the rate of a game is not 4 to 1000 ticks a second"};
    GameReport unread;
    GameTick tick(game, report ? *report : unread);
    if (const auto error = tick.begin()) return error;
    tick.run();
    return std::nullopt;
}

}  // namespace firma
