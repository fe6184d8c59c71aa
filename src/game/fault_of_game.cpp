// SPDX-License-Identifier: MIT
// Whether a game is one that can be stepped on.
#include "game/fault_of_game.h"

#include <string>
#include <utility>
#include <vector>

#include "game/game_parts.h"
#include "game/game_shots.h"
#include "game/judge_event.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

constexpr std::uint64_t kLastTick = std::uint64_t(1) << 53;

Error broken(std::string place, std::string reason) {
    return {ErrorCode::kInvalid, std::move(place), std::move(reason)};
}
Error named(std::string place, const Error& error) {
    return {error.code, std::move(place), error.reason};
}

std::optional<Error> fault_of_drive(const GameState& game, std::size_t k) {
    const std::string place = "part " + std::to_string(k);
    const PartDrive& drive = game.drives[k];
    if (drive.started != kNoTick && drive.started > game.tick) return broken(place, "it was set off later than now");
    if (drive.held > game.tick) return broken(place, "it waited longer than the game goes");
    if (drive.when_blocked > WhenBlocked::kCrushes) return broken(place, "what it does when blocked is none");
    const PartPath& path = drive.path;
    bool finite = is_finite(path.axis) && is_finite(path.spin) && is_finite(path.swing.reach) &&
                  is_finite(path.swing.angle) && is_finite(path.swing.period) && is_finite(path.swing.phase) &&
                  is_finite(drive.ahead);
    for (const double part : path.rotation) finite = finite && is_finite(part);
    for (const PartStop& stop : path.stops)
        finite = finite && is_finite(stop.position) && is_finite(stop.angle) && stop.wait == stop.wait &&
                 stop.seconds == stop.seconds;
    if (!finite) return broken(place, "its path has a number that is not finite");
    MovingPart next;
    next.motion = drive_motion(game, drive);
    if (!is_usable_part(game.parts[k]) || !is_usable_part(next)) return broken(place, "its motion cannot be used");
    return std::nullopt;
}

std::optional<Error> fault_of_slots(const Bodies& bodies) {
    for (std::size_t k = 0; k < bodies.slots.size(); ++k) {
        if (!bodies.slots[k].shape.valid()) continue;
        if (const auto fault = judge_body(bodies.slots[k])) return named("body " + std::to_string(k), *fault);
    }
    std::vector<bool> is_free(bodies.slots.size());
    for (const std::uint32_t slot : bodies.free) {
        if (slot >= bodies.slots.size() || bodies.slots[slot].shape.valid() || is_free[slot])
            return broken("bodies", "a free slot that is not there, not free or free twice");
        is_free[slot] = true;
    }
    return std::nullopt;
}

std::optional<Error> fault_of_contacts(const Bodies& bodies, std::size_t parts) {
    const auto has = [&](std::uint32_t slot, std::uint32_t sphere) {
        return slot < bodies.slots.size() && bodies.slots[slot].shape.valid() &&
               sphere < bodies.slots[slot].shape.spheres().size();
    };
    for (std::size_t k = 0; k < bodies.contacts.size(); ++k) {
        const BodyContact& contact = bodies.contacts[k];
        const std::string place = "contact " + std::to_string(k);
        if (!has(contact.body, contact.sphere) ||
            (contact.other != ~0u && (!has(contact.other, contact.other_sphere) || contact.other == contact.body)) ||
            (contact.part != kNoPart && contact.part >= parts))
            return broken(place, "it names a body, a sphere or a part that is not there");
        for (const Vec3& v : {contact.point, contact.normal, contact.friction, contact.slip, contact.rolling})
            if (!is_finite(v)) return broken(place, "a number is not finite");
        if (!is_finite(contact.force)) return broken(place, "a number is not finite");
    }
    return std::nullopt;
}

std::optional<Error> fault_of_debris(const GameState& game) {
    const std::vector<DebrisPiece>& slots = game.debris.slots;
    for (std::size_t k = 0; k < slots.size(); ++k) {
        const DebrisPiece& piece = slots[k];
        if (piece.solid.face_count() == 0) continue;
        const std::string place = "the solid of body " + std::to_string(k);
        if (!is_finite(piece.origin) || !is_finite(piece.age) || !is_finite(piece.asleep_for) || piece.age < 0 ||
            piece.asleep_for < 0)
            return broken(place, "a number is not finite or below 0");
        if (piece.solid.rock_outside()) return broken(place, "it has rock outside");
    }
    return std::nullopt;
}

}  // namespace

std::optional<Error> fault_of_game(const GameState& game) {
    if (game.rate < kMinTickRate || game.rate > kMaxTickRate)
        return broken("", "the rate is not 4 to 1000 ticks a second");
    if (game.tick > kLastTick) return broken("", "there are more than 2^53 ticks");
    if (game.drives.size() != game.parts.size()) return broken("", "it has not as many drives as parts");
    if (auto fault = judge_rules(game.rules)) return named("rules", *fault);
    for (std::size_t k = 0; k < game.parts.size(); ++k)
        if (auto fault = fault_of_drive(game, k)) return fault;
    for (std::size_t k = 0; k < game.players.size(); ++k)
        if (const auto fault = judge_player(game.players[k], game.parts.size()))
            return named("player " + std::to_string(k), *fault);
    for (const GameShots& shots : game.shots) {
        if (auto fault = fault_of_shots(shots)) return fault;
        if (!shots.weapon.charge) continue;
        if (const auto fault = judge_charge(*shots.weapon.charge)) return named("weapon " + shots.weapon.name, *fault);
    }
    if (auto fault = fault_of_slots(game.bodies)) return fault;
    if (auto fault = fault_of_contacts(game.bodies, game.parts.size())) return fault;
    return fault_of_debris(game);
}

}  // namespace firma
