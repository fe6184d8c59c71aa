// SPDX-License-Identifier: MIT
// What is in games, and what happened in them.
#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/debris_object.h"
#include "bindings/c/game_object.h"
#include "bindings/c/players_object.h"
#include "bindings/c/scenes.h"
#include "bindings/c/shots_told.h"
#include "game/game_parts.h"

namespace firma::c {
namespace {

/// What all that asks of a game begins with.
template <class Work>
firma_code ask_of_game(firma_game game, const char* function, const Work& work) {
    firma_code code = FIRMA_OK;
    const GameObject* const object = find_game(game, code, function);
    return object ? work(*object) : code;
}

firma_code not_there(const char* what, std::size_t index, const char* function) {
    return fail(FIRMA_ERROR_OUT_OF_RANGE, function, std::string("there is no ") + what + " " + std::to_string(index));
}

/// The parts of a game, with what a level's parts have: paths, and whether they wait.
std::unique_ptr<PartsObject> parts_of(const GameState& game) {
    auto object = std::make_unique<PartsObject>();
    object->parts = game.parts;
    for (std::size_t k = 0; k < game.parts.size(); ++k) {
        LevelPart given;
        given.brush.entity = game.parts[k].entity;
        given.brush.path = game.drives[k].path;
        given.brush.waits_for_trigger = game.drives[k].waits;
        given.brush.when_blocked = game.drives[k].when_blocked;
        given.stops = stops_told(given.brush.path);
        given.bears = false;
        object->given.push_back(std::move(given));
    }
    return object;
}

firma_game_part_state part_told(const GameState& game, std::uint32_t index) {
    const MovingPart& part = game.parts[index];
    const PartDrive& drive = game.drives[index];
    firma_game_part_state out{};
    out.mask = part.mask;
    out.entity = part.entity;
    out.waits = drive.waits;
    out.when_blocked = std::uint32_t(drive.when_blocked);
    out.at_first_stop = at_first_stop(drive.path, drive_seconds(game, drive, game.tick));
    out.started = drive.started;
    out.motion = motion_told(part.motion);
    out.name = part.name.c_str();
    return out;
}

firma_game_report report_told(const GameReport& from) {
    firma_game_report out{};
    out.moves = from.moves.size();
    out.blasts = from.blasts.size();
    out.shot_events = from.shot_events.size();
    out.edits = from.edits;
    out.nothing = from.nothing;
    out.refused = from.refused;
    out.refusal = from.refusal.reason.c_str();
    out.loose = from.loose;
    out.broken = from.broken;
    out.removed = from.removed;
    out.grounded = from.grounded;
    out.bodies = step_report_told(from.bodies);
    return out;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_game_world(firma_game game, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            return give(std::make_unique<WorldObject>(it.game().world), world, function);
        });
    });
}

firma_code firma_game_log(firma_game game, firma_log* log) {
    return guarded(__func__, [&, function = __func__] {
        if (!log) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            return give(std::make_unique<LogObject>(it.game().log), log, function);
        });
    });
}

firma_code firma_game_parts(firma_game game, firma_parts* parts) {
    return guarded(__func__, [&, function = __func__] {
        if (!parts) return bad_call(function, kNull);
        return ask_of_game(game, function,
                           [&](const GameObject& it) { return give(parts_of(it.game()), parts, function); });
    });
}

firma_code firma_game_bodies(firma_game game, firma_bodies* bodies) {
    return guarded(__func__, [&, function = __func__] {
        if (!bodies) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            return give(std::make_unique<BodiesObject>(it.game().bodies), bodies, function);
        });
    });
}

firma_code firma_game_debris(firma_game game, firma_debris* debris) {
    return guarded(__func__, [&, function = __func__] {
        if (!debris) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            return give(std::make_unique<DebrisObject>(it.game().debris), debris, function);
        });
    });
}

firma_code firma_game_get_part(firma_game game, uint32_t index, firma_game_part_state* state) {
    return guarded(__func__, [&, function = __func__] {
        if (!state) return bad_call(function, kNull);
        if (!sized(state)) return bad_call(function, kWrongSize);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (index >= it.game().parts.size()) return not_there("part", index, function);
            put_sized(part_told(it.game(), index), state);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_get_player(firma_game game, uint32_t index, firma_game_player* player) {
    return guarded(__func__, [&, function = __func__] {
        if (!player) return bad_call(function, kNull);
        if (!sized(player)) return bad_call(function, kWrongSize);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (index >= it.game().players.size()) return not_there("player", index, function);
            put_sized(game_player_told(it.game().players[index]), player);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_player_shape(firma_game game, uint32_t index, firma_player_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!shape) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (index >= it.game().players.size()) return not_there("player", index, function);
            return give(std::make_unique<PlayerShapeObject>(it.game().players[index].shape), shape, function);
        });
    });
}

firma_code firma_game_projectiles(firma_game game, uint32_t weapon, firma_projectile* projectiles, size_t capacity,
                                  size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!projectiles && capacity)) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (weapon >= it.game().shots.size()) return not_there("weapon", weapon, function);
            const auto tell = [](const Projectile& from, firma_projectile& to) { to = projectile_told(from); };
            put_some<Projectile, firma_projectile>(it.game().shots[weapon].projectiles, projectiles, capacity, count,
                                                   tell);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_get_report(firma_game game, firma_game_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!report) return bad_call(function, kNull);
        if (!sized(report)) return bad_call(function, kWrongSize);
        return ask_of_game(game, function, [&](const GameObject& it) {
            put_sized(report_told(it.report()), report);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_move(firma_game game, uint32_t player, firma_player_move* move) {
    return guarded(__func__, [&, function = __func__] {
        if (!move) return bad_call(function, kNull);
        if (!sized(move)) return bad_call(function, kWrongSize);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (player >= it.report().moves.size()) return not_there("move of player", player, function);
            put_sized(move_of(it.report().moves[player]), move);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_blast(firma_game game, size_t blast, double at[3], firma_explosion* explosion) {
    return guarded(__func__, [&, function = __func__] {
        if (!explosion) return bad_call(function, kNull);
        if (!sized(explosion)) return bad_call(function, kWrongSize);
        firma_explosion whole{};
        take_sized(explosion, whole);
        if (whole.carve.size != 0 && !sized(&whole.carve)) return bad_call(function, kWrongSize);
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (blast >= it.report().blasts.size()) return not_there("blast", blast, function);
            const BlastResult& found = it.report().blasts[blast];
            if (whole.carve.size != 0) put_report(found.carve, {0}, &whole.carve);
            put_sized(explosion_told(found, whole.carve), explosion);
            for (int axis = 0; at && axis < 3; ++axis) at[axis] = it.report().blast_places[blast][axis];
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_blast_bodies(firma_game game, size_t blast, uint32_t list, firma_body_id* ids, size_t capacity,
                                   size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!ids && capacity)) return bad_call(function, kNull);
        if (list != FIRMA_DEBRIS_LOOSE && list != FIRMA_DEBRIS_PIECES)
            return fail(FIRMA_ERROR_INVALID, function, "a blast has no such list");
        return ask_of_game(game, function, [&](const GameObject& it) {
            if (blast >= it.report().blasts.size()) return not_there("blast", blast, function);
            const BlastResult& found = it.report().blasts[blast];
            const auto tell = [](const BodyId& from, firma_body_id& to) { to = {from.slot, from.use}; };
            put_some<BodyId, firma_body_id>(list == FIRMA_DEBRIS_LOOSE ? found.loose : found.pieces, ids, capacity,
                                            count, tell);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_shot_events(firma_game game, firma_shot_event* events, uint32_t* weapons, size_t capacity,
                                  size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        return ask_of_game(game, function, [&](const GameObject& it) {
            const GameReport& report = it.report();
            for (std::size_t k = 0; k < std::min(capacity, report.shot_events.size()); ++k) {
                if (weapons) weapons[k] = report.shot_kinds[k];
                if (!events) continue;
                events[k] = event_told(report.shot_events[k]);
                events[k].first_length = events[k].length_count = 0;
            }
            *count = report.shot_events.size();
            return FIRMA_OK;
        });
    });
}
