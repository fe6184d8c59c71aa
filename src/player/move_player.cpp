// SPDX-License-Identifier: MIT
// Players moved: what was given is judged, then one tick is made.
#include "firma/players.h"

#include "geometry/rounding.h"
#include "moving/part_frame.h"
#include "player/player_tick.h"
#include "player/way_out.h"

namespace firma {
namespace {

constexpr double kMaxTick = 1;  // seconds
/// A cosine: below that of any PlayerRules::max_slope.
constexpr double kLeastRise = 0.01;
/// Rounding, metres: a touch is no overlap.
constexpr double kTouching = 1e-9;

bool is_good(const Vec3& v) {
    return is_finite(v) && max_abs(v) <= kLargestNumber;
}

/// A face that was walked on is no steeper than rules allow.
bool is_good_ground(const Player& player, const Vec3& up) {
    if (!player.on_ground) return is_finite(player.ground_normal);
    return is_good(player.ground_normal) && length(player.ground_normal) < 2 &&
           dot(player.ground_normal, up) > kLeastRise;
}

bool all_good(const PlayerRules& rules) {
    for (const double value : {rules.gravity, rules.max_slope, rules.step_height, rules.max_drop, rules.overhang,
                               rules.jump_speed, rules.ground_acceleration, rules.air_acceleration,
                               rules.crouched_speed, rules.max_push, rules.contact_offset})
        if (!is_finite(value) || value < 0 || value > kLargestNumber) return false;
    return rules.max_slope < 1.5;
}

}  // namespace

PlayerMove move_player(const Scene& scene, const PlayerShape& shape, const Player& player, const PlayerWish& wish,
                       double seconds, const PlayerRules& rules) {
    PlayerMove refused;
    refused.player = player;
    refused.valid = false;
    if (!shape.valid() || !is_good(player.position) || !is_good(player.velocity) || !is_good(wish.velocity))
        return refused;
    if (!is_good(player.ground_velocity) || !is_good_ground(player, shape.up())) return refused;
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
    return posture.where(position).where == Where::kAir && posture.part_around(position) == kNoPart &&
           !(posture.deepest(position).depth > kTouching);
}

}  // namespace firma
