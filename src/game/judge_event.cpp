// SPDX-License-Identifier: MIT
// What can be done to a game, and with which numbers.
#include "game/judge_event.h"

#include <initializer_list>
#include <string>

#include "log/command_bytes.h"

namespace firma {
namespace {

constexpr double kFastestStart = 0x1p19;  // metres a second, along an axis: projectiles get no faster than twice that
constexpr double kLargestCrater = 8192;   // metres
constexpr int kMaxSubstepsASecond = 100'000;
constexpr int kMaxBouncesInStep = 1000;
constexpr double kStrongestGravity = 1e6;  // metres a second squared

Error not_valid(std::string reason) {
    return {ErrorCode::kInvalid, "", std::move(reason)};
}
Error not_finite(const char* what) {
    return {ErrorCode::kOutOfRange, "", std::string(what) + " has a number that is not finite"};
}
Error not_there(const char* what, std::uint32_t index) {
    return not_valid(std::string("there is no ") + what + " " + std::to_string(index));
}

bool are_finite(std::initializer_list<double> numbers) {
    for (const double number : numbers)
        if (!is_finite(number)) return false;
    return true;
}
bool is_quantity(double number) {
    return is_finite(number) && number >= 0;
}

class EventJudge {
public:
    explicit EventJudge(const GameCounts& counts) : counts_(counts) {}

    std::optional<Error> operator()(const EditEvent& event) const {
        // With numbers as they will be given.
        EditCommand command = event.command;
        std::uint32_t number = 0;
        command.number = 1;
        for (EditCommand& part : command.parts) part.number = ++number;
        return judge_command(command, 0);
    }
    std::optional<Error> operator()(const BlastEvent& event) const {
        if (!is_finite(event.at)) return not_finite("the place of a blast");
        return judge_charge(event.charge);
    }
    std::optional<Error> operator()(const FireEvent& event) const {
        if (event.weapon >= counts_.weapons) return not_there("weapon", event.weapon);
        if (!is_finite(event.position) || !is_finite(event.velocity)) return not_finite("a projectile");
        if (!(max_abs(event.velocity) <= kFastestStart)) return not_valid("a projectile is faster than 524,288 m/s");
        return std::nullopt;
    }
    std::optional<Error> operator()(const BodyEvent& event) const {
        if (!event.body.shape.valid()) return not_valid("a body has no shape");
        return judge_body(event.body);
    }
    std::optional<Error> operator()(const PlayerEvent& event) const {
        return judge_player(event.player, counts_.parts);
    }
    std::optional<Error> operator()(const WishEvent& event) const {
        if (event.player >= counts_.players) return not_there("player", event.player);
        if (!is_finite(event.wish.velocity)) return not_finite("a wish");
        return std::nullopt;
    }
    std::optional<Error> operator()(const PartEvent& event) const {
        if (event.part >= counts_.parts) return not_there("part", event.part);
        return std::nullopt;
    }

private:
    const GameCounts& counts_;
};

}  // namespace

std::optional<Error> judge_charge(const Charge& charge) {
    if (!is_quantity(charge.crater) || charge.crater > kLargestCrater)
        return not_valid("a charge's crater is not 0 to 8192 m");
    if (unsigned(charge.shape) > unsigned(CutterShape::kBox)) return not_valid("a charge's shape is none");
    if (!is_finite(charge.radius) || !(charge.radius > 0)) return not_valid("a charge's radius is not above 0");
    if (!is_quantity(charge.impulse)) return not_valid("a charge's impulse is not finite or below 0");
    if (!is_quantity(charge.break_radius)) return not_valid("a charge's break_radius is not finite or below 0");
    if (charge.max_pieces < 1 || charge.max_pieces > kMaxPieces)
        return not_valid("a charge's max_pieces is not 1 to 4096");
    return std::nullopt;
}

std::optional<Error> judge_body(const Body& body) {
    for (const Vec3& v : {body.position, body.velocity, body.spin, body.force, body.torque, body.still_at})
        if (!is_finite(v)) return not_finite("a body");
    for (const Quaternion& turn : {body.rotation, body.still_turn})
        for (const double number : turn)
            if (!is_finite(number)) return not_finite("a body's rotation");
    if (!is_quantity(body.friction) || !is_quantity(body.restitution) || body.restitution > 1 ||
        !is_quantity(body.rolling) || !is_quantity(body.still_for))
        return not_valid("a body's friction, restitution or rolling is out of range");
    return std::nullopt;
}

std::optional<Error> judge_player(const GamePlayer& player, std::size_t parts) {
    if (!player.shape.valid()) return not_valid("a player has no shape");
    const Player& it = player.player;
    if (it.ground_part != kNoPart && it.ground_part >= parts) return not_there("part", it.ground_part);
    for (const Vec3& v : {it.position, it.velocity, it.ground_normal, it.ground_velocity, player.wish.velocity})
        if (!is_finite(v)) return not_finite("a player");
    const PlayerRules& rules = player.rules;
    for (const double number : {rules.gravity, rules.max_slope, rules.step_height, rules.max_drop, rules.overhang,
                                rules.jump_speed, rules.ground_acceleration, rules.air_acceleration,
                                rules.crouched_speed, rules.max_push, rules.contact_offset})
        if (!is_quantity(number)) return not_valid("a player's rules have a number that is not finite or below 0");
    if (!is_finite(player.mass) || !(player.mass > 0)) return not_valid("a player's mass is not above 0");
    return std::nullopt;
}

std::optional<Error> judge_rules(const GameRules& rules) {
    const StepOptions& bodies = rules.bodies;
    if (!is_finite(bodies.gravity) || !(length(bodies.gravity) <= kStrongestGravity))
        return not_valid("the gravity of bodies is out of range");
    if (bodies.substeps_a_second < 1 || bodies.substeps_a_second > kMaxSubstepsASecond)
        return not_valid("substeps_a_second is not 1 to 100,000");
    if (!is_quantity(bodies.contact_friction) || !is_quantity(bodies.contact_offset) ||
        !is_quantity(bodies.sleep_speed) || !(bodies.sleep_after >= 0))
        return not_valid("an option of bodies is not a number or below 0");
    if (bodies.max_bounces < 0 || bodies.max_bounces > kMaxBouncesInStep)
        return not_valid("max_bounces is not 0 to 1000");
    const DebrisRules& debris = rules.debris;
    if (!(debris.max_age >= 0) || !(debris.max_asleep >= 0) || !is_quantity(debris.min_to_ground) ||
        !is_quantity(debris.max_overlap))
        return not_valid("a rule of debris is not a number or below 0");
    if (rules.chunks && !are_finite({rules.chunks->min_volume, rules.chunks->density}))
        return not_valid("how loose pieces are looked for is not finite");
    if (rules.chunks && (rules.chunks->min_volume < 0 || rules.chunks->density < 0))
        return not_valid("how loose pieces are looked for is below 0");
    if (!(rules.max_blast_speed >= 0)) return not_valid("max_blast_speed is not a number or below 0");
    return std::nullopt;
}

std::optional<Error> judge_event(const GameEvent& event, const GameCounts& counts) {
    return std::visit(EventJudge(counts), event.what);
}

}  // namespace firma
