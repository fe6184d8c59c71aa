// SPDX-License-Identifier: MIT
// Players moved: what was given is judged, then one tick is made.
#include "firma/players.h"
#include "moving/part_frame.h"
#include "player/player_tick.h"
#include "player/way_out.h"

namespace firma {
namespace {

constexpr double kMaxTick = 1;  // seconds
/// Rounding, metres: a touch is no overlap.
constexpr double kTouching = 1e-9;

bool all_good(const PlayerRules& rules) {
    for (const double value : {rules.gravity, rules.max_slope, rules.step_height, rules.max_drop, rules.overhang,
                               rules.jump_speed, rules.ground_acceleration, rules.air_acceleration,
                               rules.crouched_speed, rules.max_push, rules.contact_offset})
        if (!is_finite(value) || value < 0) return false;
    return rules.max_slope < 1.5;
}

}  // namespace

PlayerMove move_player(const Scene& scene, const PlayerShape& shape, const Player& player, const PlayerWish& wish,
                       double seconds, const PlayerRules& rules) {
    PlayerMove refused;
    refused.player = player;
    refused.valid = false;
    if (!shape.valid() || !is_finite(player.position) || !is_finite(player.velocity) || !is_finite(wish.velocity))
        return refused;
    if (!is_finite(player.ground_normal) || (player.on_ground && !(dot(player.ground_normal, shape.up()) > 0)))
        return refused;
    if (!is_finite(seconds) || seconds < 0 || seconds > kMaxTick || !all_good(rules)) return refused;
    for (const MovingPart& part : scene.parts)
        if (!is_usable_part(part)) return refused;
    const double offset = rules.contact_offset > 0 ? rules.contact_offset : scene.world.tolerance().contact_offset;
    return PlayerTick(scene, shape.data(), player, wish, seconds, rules, offset).run();
}

bool player_fits(const Scene& scene, const PlayerShape& shape, const Vec3& position, bool crouched,
                 std::uint32_t mask) {
    if (!shape.valid() || !is_finite(position)) return false;
    const Scene there{scene.world, scene.parts, scene.from, scene.from};
    const PostureIn posture(there, shape.data(), crouched, mask, 0);
    return posture.where(position).where == Where::kAir && !(posture.deepest(position).depth > kTouching);
}

}  // namespace firma
