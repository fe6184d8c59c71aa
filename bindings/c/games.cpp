// SPDX-License-Identifier: MIT
// Games: begun, copied, and what they go by: rules, weapons, parts.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "bindings/c/debris_object.h"
#include "bindings/c/game_object.h"
#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"
#include "bindings/c/shots_told.h"
#include "game/game_parts.h"
#include "game/game_shots.h"
#include "game/judge_event.h"
#include "moving/part_frame.h"

namespace firma::c {

static_assert(FIRMA_NO_TICK == kNoTick);

GameObject* find_game(firma_game game, firma_code& code, const char* function) {
    GameObject* const object = find<GameObject>(game.id, function);
    code = FIRMA_ERROR_BAD_HANDLE;
    if (!object || !object->broken) return object;
    code = fail(FIRMA_ERROR_NO_MEMORY, function, "memory ran out in an earlier call with this game: it is lost");
    return nullptr;
}

GameObject* find_played(firma_game game, firma_code& code, const char* function) {
    GameObject* const object = find_game(game, code, function);
    if (!object || !object->replay) return object;
    code = bad_call(function, "the game is a replay: what happens in it was recorded");
    return nullptr;
}

GameObject* find_unrecorded(firma_game game, firma_code& code, const char* function) {
    GameObject* const object = find_played(game, code, function);
    if (!object || !object->recording) return object;
    code = bad_call(function, "the game is being recorded: only what a recording keeps may change it");
    return nullptr;
}

firma_code give_game(GameState made, firma_game* out, const char* function) {
    return give(std::make_unique<GameObject>(std::move(made)), out, function);
}

firma_code fail_in(const char* function, const Error& error) {
    return fail({error.code, error.place.empty() ? std::string(function) : error.place, error.reason});
}

namespace {

firma_charge charge_told(const Charge& from) {
    firma_charge out{};
    out.size = sizeof out;
    out.shape = std::uint32_t(from.shape);
    out.crater = from.crater;
    out.radius = from.radius;
    out.impulse = from.impulse;
    out.break_radius = from.break_radius;
    out.max_pieces = from.max_pieces;
    out.material = from.material.c_str();
    return out;
}

firma_weapon weapon_told(const Weapon& from) {
    static const Charge usual;
    firma_weapon out{};
    out.size = sizeof out;
    out.lies = from.lies;
    out.name = from.name.c_str();
    out.mass = from.mass;
    put(from.gravity, out.gravity);
    out.pane_energy = from.pane_energy;
    out.stop_speed = from.stop_speed;
    out.fuse = from.fuse;
    out.terms = terms_told(from.terms);
    out.bodies = terms_told(from.bodies);
    out.has_charge = from.charge.has_value();
    out.charge = charge_told(from.charge ? *from.charge : usual);
    return out;
}

firma_code read_weapon(const firma_weapon* given, Weapon& weapon, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_weapon whole;
    firma_weapon_defaults(&whole);
    take_sized(given, whole);
    if (whole.lies > 1 || whole.has_charge > 1 || whole.reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "what is 0 or 1 is neither, or reserved is not 0");
    weapon.name = text_of(whole.name);
    weapon.mass = whole.mass;
    weapon.gravity = vec(whole.gravity);
    weapon.terms = terms_of(whole.terms);
    weapon.bodies = terms_of(whole.bodies);
    weapon.pane_energy = whole.pane_energy;
    weapon.stop_speed = whole.stop_speed;
    weapon.fuse = whole.fuse;
    weapon.lies = whole.lies != 0;
    weapon.charge.reset();
    if (const auto fault = fault_of_weapon(weapon)) return fail_in(function, *fault);
    if (whole.has_charge == 0) return FIRMA_OK;
    if (const firma_code code = read_charge(&whole.charge, weapon.charge.emplace(), function)) return code;
    const auto fault = judge_charge(*weapon.charge);
    return fault ? fail({fault->code, "weapon " + weapon.name, fault->reason}) : FIRMA_OK;
}

firma_game_rules rules_told(const GameRules& from) {
    const ChunkOptions usual;
    firma_game_rules out{};
    out.size = sizeof out;
    out.no_chunks = !from.chunks;
    out.min_chunk_volume = from.chunks ? from.chunks->min_volume : usual.min_volume;
    out.chunk_density = from.chunks ? from.chunks->density : usual.density;
    out.max_blast_speed = from.max_blast_speed;
    out.seed = from.seed;
    out.bodies = step_told(from.bodies);
    out.debris = debris_rules_told(from.debris);
    return out;
}

firma_code read_game_rules(const firma_game_rules& given, GameRules& rules, const char* function) {
    firma_game_rules whole = rules_told({});
    take_sized(&given, whole);
    if (whole.no_chunks > 1) return fail(FIRMA_ERROR_INVALID, function, "no_chunks must be 0 or 1");
    if (const firma_code code = read_step(&whole.bodies, rules.bodies, function)) return code;
    DebrisRulesThere debris;
    if (const firma_code code = debris.read(&whole.debris, function)) return code;
    rules.debris = debris.rules;
    rules.debris.keep_clear = {};
    rules.chunks.reset();
    if (whole.no_chunks == 0) rules.chunks = ChunkOptions{whole.min_chunk_volume, whole.chunk_density};
    rules.max_blast_speed = whole.max_blast_speed;
    rules.seed = whole.seed;
    const auto fault = judge_rules(rules);
    return fault ? fail_in(function, *fault) : FIRMA_OK;
}

firma_code read_game_part(const firma_game_part* given, MovingPart& part, PartDrive& drive, bool& finds_portals,
                          const char* function) {
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_game_part whole;
    firma_game_part_defaults(&whole);
    take_sized(given, whole);
    if (whole.waits > 1 || whole.no_portals > 1)
        return fail(FIRMA_ERROR_INVALID, function, "what is 0 or 1 is neither");
    if (whole.when_blocked > FIRMA_BLOCKED_CRUSHES)
        return fail(FIRMA_ERROR_INVALID, function, "when_blocked is no firma_when_blocked");
    if (whole.portal_count && !whole.portals) return bad_call(function, "a count without its array");
    const WorldObject* const object = find<WorldObject>(whole.world.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    if (object->world.room_count() > 1)
        return fail(FIRMA_ERROR_INVALID, function, "a part's world has to be of one room");
    if (whole.path)
        if (const firma_code code = read_path(whole.path, drive.path, function)) return code;
    part = MovingPart(object->world);
    part.mask = whole.mask;
    part.entity = whole.entity;
    part.name = text_of(whole.name);
    drive.waits = whole.waits != 0;
    drive.when_blocked = WhenBlocked(whole.when_blocked);
    finds_portals = whole.no_portals == 0;
    for (std::size_t k = 0; k < whole.portal_count; ++k) drive.portals.push_back({whole.portals[k]});
    return FIRMA_OK;
}

/// One of a game's weapons, for `work`.
template <class Work>
firma_code ask_of_weapon(GameObject* object, firma_code code, std::uint32_t index, const char* function,
                         const Work& work) {
    if (!object) return code;
    if (index >= object->game().shots.size())
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no weapon " + std::to_string(index));
    return work();
}

}  // namespace

firma_code read_charge(const firma_charge* given, Charge& charge, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_charge whole;
    firma_charge_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    if (whole.shape > FIRMA_BOX) return fail(FIRMA_ERROR_INVALID, function, "a charge's shape is none");
    charge.crater = whole.crater;
    charge.shape = CutterShape(whole.shape);
    charge.material = text_of(whole.material);
    charge.radius = whole.radius;
    charge.impulse = whole.impulse;
    charge.break_radius = whole.break_radius;
    charge.max_pieces = whole.max_pieces;
    return FIRMA_OK;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_game_begin(firma_world level, uint32_t rate, firma_game* game) {
    return guarded(__func__, [&, function = __func__] {
        if (!game) return bad_call(function, kNull);
        const WorldObject* const object = find<WorldObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (rate < kMinTickRate || rate > kMaxTickRate)
            return fail(FIRMA_ERROR_INVALID, function, "the rate is not 4 to 1000 ticks a second");
        return give_game(begin_game(object->world, rate), game, function);
    });
}

firma_code firma_game_copy(firma_game game, firma_game* copy) {
    return guarded(__func__, [&, function = __func__] {
        if (!copy) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        return object ? give_game(object->game(), copy, function) : code;
    });
}

firma_code firma_game_release(firma_game game) {
    return release<GameObject>(game.id, __func__);
}

firma_code firma_game_get_facts(firma_game game, firma_game_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        const GameState& state = object->game();
        firma_game_facts facts{};
        facts.rate = state.rate;
        facts.tick = state.tick;
        facts.explosions = state.explosions;
        facts.weapons = state.shots.size();
        facts.parts = state.parts.size();
        facts.players = state.players.size();
        for (const GameShots& shots : state.shots) facts.projectiles += shots.projectiles.size();
        for (const Body& body : state.bodies.slots) facts.bodies += body.shape.valid();
        facts.recorded = object->recording.has_value();
        facts.replay = object->replay != nullptr;
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

void firma_game_rules_defaults(firma_game_rules* rules) {
    if (rules) *rules = rules_told({});
}

firma_code firma_game_get_rules(firma_game game, firma_game_rules* rules) {
    return guarded(__func__, [&, function = __func__] {
        if (!rules) return bad_call(function, kNull);
        if (!sized(rules)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        put_sized(rules_told(object->game().rules), rules);
        return FIRMA_OK;
    });
}

firma_code firma_game_set_rules(firma_game game, const firma_game_rules* rules) {
    return guarded(__func__, [&, function = __func__] {
        if (!rules) return bad_call(function, kNull);
        if (!sized(rules)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        GameObject* const object = find_unrecorded(game, code, function);
        if (!object) return code;
        GameRules read;
        if ((code = read_game_rules(*rules, read, function))) return code;
        object->own.rules = read;
        return FIRMA_OK;
    });
}

void firma_charge_defaults(firma_charge* charge) {
    if (!charge) return;
    *charge = charge_told({});
    charge->material = "";
}

void firma_weapon_defaults(firma_weapon* weapon) {
    static const Weapon usual;
    if (weapon) *weapon = weapon_told(usual);
}

firma_code firma_game_get_weapon(firma_game game, uint32_t index, firma_weapon* weapon) {
    return guarded(__func__, [&, function = __func__] {
        if (!weapon) return bad_call(function, kNull);
        if (!sized(weapon)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        GameObject* const object = find_game(game, code, function);
        return ask_of_weapon(object, code, index, function, [&] {
            put_sized(weapon_told(object->game().shots[index].weapon), weapon);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_set_weapon(firma_game game, uint32_t index, const firma_weapon* weapon) {
    return guarded(__func__, [&, function = __func__] {
        Weapon read;
        if (const firma_code code = read_weapon(weapon, read, function)) return code;
        firma_code code = FIRMA_OK;
        GameObject* const object = find_unrecorded(game, code, function);
        return ask_of_weapon(object, code, index, function, [&] {
            object->own.shots[index].weapon = std::move(read);
            return FIRMA_OK;
        });
    });
}

firma_code firma_game_add_weapon(firma_game game, const firma_weapon* weapon, uint32_t* index) {
    return guarded(__func__, [&, function = __func__] {
        Weapon read;
        if (const firma_code code = read_weapon(weapon, read, function)) return code;
        firma_code code = FIRMA_OK;
        GameObject* const object = find_unrecorded(game, code, function);
        if (!object) return code;
        object->own.shots.push_back({std::move(read), {}});
        if (index) *index = std::uint32_t(object->own.shots.size() - 1);
        return FIRMA_OK;
    });
}

void firma_game_part_defaults(firma_game_part* part) {
    if (!part) return;
    *part = {};
    part->size = sizeof *part;
    part->mask = ~0u;
    part->entity = FIRMA_NO_PART;
    part->when_blocked = FIRMA_BLOCKED_CRUSHES;
}

firma_code firma_game_add_part(firma_game game, const firma_game_part* part, uint32_t* index) {
    return guarded(__func__, [&, function = __func__] {
        if (!part) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        GameObject* const object = find_unrecorded(game, code, function);
        if (!object) return code;
        MovingPart made, tried;
        PartDrive drive;
        bool finds_portals = true;
        if ((code = read_game_part(part, made, drive, finds_portals, function))) return code;
        tried.motion = drive_motion(object->own, drive);
        if (!is_usable_part(tried))
            return fail(FIRMA_ERROR_INVALID, function, "the motion of the part's path cannot be used");
        std::uint32_t added = 0;
        static_cast<void>(object->change([&](GameReport&) {
            added = add_part(object->own, std::move(made), std::move(drive), finds_portals);
            return std::optional<Error>();
        }));
        if (index) *index = added;
        return FIRMA_OK;
    });
}

firma_code firma_game_hash(firma_game game, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        *hash = hash_game(object->game());
        return FIRMA_OK;
    });
}

static_assert(FIRMA_ITEM_WORLD == int(GameItem::kWorld) && FIRMA_ITEM_PART == int(GameItem::kPart) &&
              FIRMA_ITEM_PLAYER == int(GameItem::kPlayer) && FIRMA_ITEM_PROJECTILE == int(GameItem::kProjectile) &&
              FIRMA_ITEM_BODY == int(GameItem::kBody) && FIRMA_ITEM_DEBRIS == int(GameItem::kDebris) &&
              FIRMA_ITEM_REST == int(GameItem::kRest));

firma_code firma_game_hash_items(firma_game game, uint32_t item, uint32_t* hashes, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!hashes && capacity)) return bad_call(function, kNull);
        if (item >= kGameItems) return fail(FIRMA_ERROR_INVALID, function, "there is no such kind of item");
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        const GameHashes all = hash_game_items(object->game());
        const std::vector<std::uint32_t>& found = all.items[item];
        std::copy_n(found.begin(), std::min(capacity, found.size()), hashes);
        *count = found.size();
        return FIRMA_OK;
    });
}
