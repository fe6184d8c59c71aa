// SPDX-License-Identifier: MIT
// What happens to games between two ticks, and a tick.
#include <memory>
#include <utility>

#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/game_object.h"
#include "bindings/c/numbers.h"
#include "bindings/c/objects.h"
#include "bindings/c/players_object.h"

namespace firma::c {
namespace {

/// Something happens to a game, and is kept where it is recorded. `done` is called with the game afterwards.
template <class What, class Done>
firma_code happen(firma_game game, What what, const char* function, const Done& done) {
    firma_code code = FIRMA_OK;
    GameObject* const object = find_played(game, code, function);
    if (!object) return code;
    GameEvent event{object->own.tick, std::move(what)};
    const std::optional<Error> error = object->change([&](GameReport& report) {
        std::optional<Error> refused = apply_event(object->own, event, &report);
        if (!refused && object->recording) object->recording->events.push_back(std::move(event));
        return refused;
    });
    if (error) return fail_in(function, *error);
    done(*object);
    return FIRMA_OK;
}

template <class What>
firma_code happen(firma_game game, What what, const char* function) {
    return happen(game, std::move(what), function, [](const GameObject&) {});
}

/// The name that the next body gets.
BodyId next_body(const Bodies& bodies) {
    if (bodies.free.empty()) return {std::uint32_t(bodies.slots.size()), 0};
    return {bodies.free.back(), 0};
}

/// A tick of a replay; with the last one also what it ended with is compared.
firma_code step_replay(GameObject& object, const char* function) {
    if (object.replay->finished()) return bad_call(function, "the replay is over");
    object.broken = true;
    bool over = object.replay->step();
    if (!over && object.replay->result().ticks == object.played->hashes.size()) over = object.replay->step();
    object.broken = false;
    const GameReplay& result = object.replay->result();
    return result.error ? fail_in(function, *result.error) : FIRMA_OK;
}

/// What a report tells of edits, set aside while one more is made.
class RefusalsBefore {
public:
    explicit RefusalsBefore(GameObject& game) {
        if (game.ticked) return;
        edits_ = game.own_report.edits;
        refused_ = std::exchange(game.own_report.refused, 0);
        if (refused_ > 0) refusal_ = game.own_report.refusal;
    }

    /// firma_carve_status of the edit made since.
    std::uint32_t status(const GameReport& after) const {
        if (after.edits > edits_) return FIRMA_CARVE_DONE;
        return after.refused > 0 ? FIRMA_CARVE_REFUSED : FIRMA_CARVE_NOTHING;
    }
    void put_back(GameReport& report) {
        report.refused += refused_;
        if (refused_ > 0) report.refusal = std::move(refusal_);
    }

private:
    std::size_t edits_ = 0, refused_ = 0;
    Error refusal_;
};

}  // namespace

firma_code read_game_player(const firma_game_player* given, GamePlayer& player, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_game_player whole;
    firma_game_player_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    const PlayerShapeObject* const object = find<PlayerShapeObject>(whole.shape.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    if (const firma_code code = judge_player_flags(whole.player, function)) return code;
    if (const firma_code code = read_wish(&whole.wish, player.wish, function)) return code;
    if (const firma_code code = read_player_rules(&whole.rules, player.rules, function)) return code;
    player.shape = object->shape;
    player.mass = whole.mass;
    player.player = player_of(whole.player);
    return FIRMA_OK;
}

firma_game_player game_player_told(const GamePlayer& from) {
    firma_game_player out{};
    out.size = sizeof out;
    out.mass = from.mass;
    put_player(from.player, out.player);
    out.wish = wish_told(from.wish);
    out.rules = player_rules_told(from.rules);
    return out;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_game_player_defaults(firma_game_player* player) {
    if (player) *player = game_player_told({});
}

firma_code firma_game_edit(firma_game game, firma_command command, uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        const CommandObject* const edit = find<CommandObject>(command.id, function);
        if (!edit) return FIRMA_ERROR_BAD_HANDLE;
        firma_code code = FIRMA_OK;
        GameObject* const object = find_played(game, code, function);
        if (!object) return code;
        // A report has the reason of the first refusal alone: this one's is told.
        RefusalsBefore before(*object);
        code = happen(game, EditEvent{edit->command}, function, [&](const GameObject& after) {
            const std::uint32_t found = before.status(after.own_report);
            if (found == FIRMA_CARVE_REFUSED) fail(after.own_report.refusal);
            if (status) *status = found;
        });
        before.put_back(object->own_report);
        return code;
    });
}

firma_code firma_game_explode(firma_game game, const double at[3], const firma_charge* charge) {
    return guarded(__func__, [&, function = __func__] {
        if (!at) return bad_call(function, kNull);
        BlastEvent event;
        event.at = {at[0], at[1], at[2]};
        if (const firma_code code = read_charge(charge, event.charge, function)) return code;
        return happen(game, std::move(event), function);
    });
}

firma_code firma_game_fire(firma_game game, uint32_t weapon, const double position[3], const double velocity[3]) {
    return guarded(__func__, [&, function = __func__] {
        if (!position || !velocity) return bad_call(function, kNull);
        return happen(
            game, FireEvent{weapon, {position[0], position[1], position[2]}, {velocity[0], velocity[1], velocity[2]}},
            function);
    });
}

firma_code firma_game_add_body(firma_game game, firma_body_shape shape, const firma_pose* pose, const firma_body* body,
                               firma_body_id* id) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose) return bad_call(function, kNull);
        if (body && !sized(body)) return bad_call(function, kWrongSize);
        const BodyShapeObject* const object = find<BodyShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (!is_finite(vec(pose->position)) || !is_rotation(pose->rotation))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the pose is not finite, or has no rotation");
        BodyEvent event{body_at(object->shape, firma::c::pose_of(*pose))};
        if (body) {
            firma_body whole;
            firma_body_defaults(&whole);
            take_sized(body, whole);
            put(event.body.position, whole.position);
            for (std::size_t k = 0; k < 4; ++k) whole.rotation[k] = event.body.rotation[k];
            if (!is_good(whole))
                return fail(FIRMA_ERROR_OUT_OF_RANGE, function,
                            "a number of the body is not finite or out of its range");
            take_body(whole, event.body);
        }
        firma_code code = FIRMA_OK;
        const GameObject* const before = find_played(game, code, function);
        if (!before) return code;
        BodyId next = next_body(before->own.bodies);
        return happen(game, std::move(event), function, [&](const GameObject& after) {
            next.use = after.own.bodies.slots[next.slot].use;
            if (id) *id = {next.slot, next.use};
        });
    });
}

firma_code firma_game_add_player(firma_game game, const firma_game_player* player, uint32_t* index) {
    return guarded(__func__, [&, function = __func__] {
        PlayerEvent event;
        if (const firma_code code = read_game_player(player, event.player, function)) return code;
        return happen(game, std::move(event), function, [&](const GameObject& after) {
            if (index) *index = std::uint32_t(after.own.players.size() - 1);
        });
    });
}

firma_code firma_game_wish(firma_game game, uint32_t player, const firma_player_wish* wish) {
    return guarded(__func__, [&, function = __func__] {
        if (!wish) return bad_call(function, kNull);
        WishEvent event{player, {}};
        if (const firma_code code = read_wish(wish, event.wish, function)) return code;
        return happen(game, event, function);
    });
}

firma_code firma_game_set_off(firma_game game, uint32_t part) {
    return guarded(__func__, [&, function = __func__] { return happen(game, PartEvent{part}, function); });
}

firma_code firma_game_step(firma_game game) {
    return guarded(__func__, [&, function = __func__] {
        firma_code code = FIRMA_OK;
        GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        if (object->replay) return step_replay(*object, function);
        const std::optional<Error> error = object->change([&](GameReport& report) {
            std::optional<Error> refused = step_game(object->own, &report);
            if (!refused && object->recording) object->recording->hashes.append(hash_game_items(object->own));
            return refused;
        });
        if (error) return fail_in(function, *error);
        object->ticked = true;
        return FIRMA_OK;
    });
}
