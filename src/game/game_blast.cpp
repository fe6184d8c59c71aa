// SPDX-License-Identifier: MIT
// An explosion in a game.
#include "game/game_blast.h"

#include <utility>

#include "base/random.h"
#include "firma/part_edits.h"
#include "game/game_edits.h"
#include "game/player_spheres.h"

namespace firma {
namespace {

/// What of a part the crater reaches goes, where the part is now.
void carve_parts(GameState& game, const Cutter& crater, const Pose& pose, const std::string& material) {
    for (MovingPart& part : game.parts) {
        const CarveResult cut = carve(part.world(), crater, pose_in_part(part, 1, pose), {.material = material});
        if (cut.done()) part.set_world(cut.world);
    }
}

/// Its parts where they are now.
Scene scene_now(const GameState& game) {
    return {game.world, game.parts, 1, 1};
}

void push_player(const GameState& game, const Blast& blast, GamePlayer& player) {
    const SphereSet spheres = spheres_of_player(player);
    const double seen = exposure(scene_now(game), blast.at, spheres);
    const double area = 2 * player.shape.radius() * player.shape.height(player.player.crouched);
    Vec3 push = blast_impulse(blast, middle_of_player(player), area, seen) * (1 / player.mass);
    const double speed = length(push);
    if (!(speed > 0)) return;
    if (speed > game.rules.max_blast_speed) push *= game.rules.max_blast_speed / speed;
    player.player.velocity += push;
    player.player.on_ground = false;
}

}  // namespace

void explode_charge(GameState& game, const Vec3& at, const Charge& charge, GameReport& report) {
    const std::uint64_t seed = mix_bits(game.rules.seed + ++game.explosions);
    const Blast blast{at, charge.radius, charge.impulse};
    CarveOptions cut;
    cut.material = charge.material;
    cut.chunks = game.rules.chunks;
    const EditCommand command =
        crater_command(game.log.next_number(), {charge.shape, seed}, at, charge.crater, std::move(cut));
    BlastOptions options;
    options.carve = command.options;
    options.carve.edit = command.number;
    options.break_radius = charge.break_radius;
    options.max_pieces = charge.max_pieces;
    options.seed = seed;
    options.push.max_speed = game.rules.max_blast_speed;
    const Cutter crater = charge.crater > 0 ? make_crater(charge.shape, seed) : Cutter();
    if (crater.valid()) carve_parts(game, crater, command.pose, charge.material);
    BlastResult result = explode(scene_now(game), game.bodies, game.debris, blast, crater, command.pose, options);
    game.world = result.carve.world;
    if (crater.valid()) keep_edit(game, command, result.carve.status, result.carve.error, report);
    for (GamePlayer& player : game.players) push_player(game, blast, player);
    report.loose += result.loose.size();
    report.broken += result.broken;
    report.blasts.push_back(std::move(result));
    report.blast_places.push_back(at);
}

}  // namespace firma
