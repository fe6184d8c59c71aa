// SPDX-License-Identifier: MIT
// Players: their shapes, and one tick of one player. Moving one takes no memory.
#include "firma/players.h"

#include <initializer_list>
#include <memory>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "bindings/c/players_object.h"
#include "bindings/c/scenes.h"
#include "bindings/c/sphere_sets.h"

namespace firma::c {
namespace {

static_assert(FIRMA_MAX_PLAYER_CONTACTS == kMaxPlayerContacts && FIRMA_CONTACT_GROUND == int(ContactKind::kGround) &&
              FIRMA_CONTACT_WALL == int(ContactKind::kWall) && FIRMA_CONTACT_CEILING == int(ContactKind::kCeiling));

firma_code give_shape(const Result<PlayerShape>& made, firma_player_shape* out, const char* function) {
    if (!made) return fail(made.error());
    return give(std::make_unique<PlayerShapeObject>(made.value()), out, function);
}

firma_code read_size(const firma_player_size* given, PlayerSize& size, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_player_size whole;
    firma_player_size_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    size = {whole.radius, whole.height, whole.crouched_height, vec(whole.up)};
    return FIRMA_OK;
}

firma_code judge_flags(std::initializer_list<std::uint32_t> flags, const char* function) {
    for (const std::uint32_t flag : flags)
        if (flag > 1) return fail(FIRMA_ERROR_INVALID, function, "what is 0 or 1 is neither");
    return FIRMA_OK;
}

}  // namespace

firma_code judge_player_flags(const firma_player& given, const char* function) {
    return judge_flags({given.on_ground, given.crouched, given.stuck}, function);
}

Player player_of(const firma_player& from) {
    Player player;
    player.position = vec(from.position);
    player.velocity = vec(from.velocity);
    player.mask = from.mask;
    player.on_ground = from.on_ground != 0;
    player.crouched = from.crouched != 0;
    player.stuck = from.stuck != 0;
    player.ground_normal = vec(from.ground_normal);
    player.ground_part = from.ground_part;
    player.ground_velocity = vec(from.ground_velocity);
    player.room = {from.room};
    player.world_hash = from.world_hash;
    return player;
}

void put_player(const Player& from, firma_player& out) {
    out = {};
    put(from.position, out.position);
    put(from.velocity, out.velocity);
    put(from.ground_normal, out.ground_normal);
    put(from.ground_velocity, out.ground_velocity);
    out.world_hash = from.world_hash;
    out.mask = from.mask;
    out.room = from.room.value;
    out.ground_part = from.ground_part;
    out.on_ground = from.on_ground;
    out.crouched = from.crouched;
    out.stuck = from.stuck;
}

namespace {

void put_contact(const PlayerContact& from, firma_player_contact& out) {
    put(from.point, out.point);
    put(from.normal, out.normal);
    put(from.face_normal, out.face_normal);
    out.kind = std::uint32_t(from.kind);
    out.face = from.face.id.value;
    put_corner(from.face, out.corner);
    out.portal = from.portal.value;
    out.part = from.part;
    out.material = from.material;
}

}  // namespace

firma_player_move move_of(const PlayerMove& from) {
    firma_player_move out{};
    out.contact_count = std::uint32_t(from.contact_count);
    put_player(from.player, out.player);
    put(from.pushed, out.pushed);
    put(from.carried, out.carried);
    out.landed_speed = from.landed_speed;
    out.pushed_by = from.pushed_by;
    out.crushed_by = from.crushed_by;
    out.jumped = from.jumped;
    out.stepped = from.stepped;
    for (std::size_t k = 0; k < from.contact_count; ++k) put_contact(from.touched[k], out.contacts[k]);
    return out;
}

firma_code read_wish(const firma_player_wish* given, PlayerWish& wish, const char* function) {
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_player_wish whole{};
    take_sized(given, whole);
    if (const firma_code code = judge_flags({whole.jump, whole.crouch, whole.careful}, function)) return code;
    wish = {vec(whole.velocity), whole.jump != 0, whole.crouch != 0, whole.careful != 0};
    return FIRMA_OK;
}

firma_player_wish wish_told(const PlayerWish& from) {
    firma_player_wish out{};
    out.size = sizeof out;
    out.jump = from.jump;
    out.crouch = from.crouch;
    out.careful = from.careful;
    put(from.velocity, out.velocity);
    return out;
}

firma_code read_player_rules(const firma_player_rules* given, PlayerRules& rules, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_player_rules whole;
    firma_player_rules_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    rules.gravity = whole.gravity;
    rules.max_slope = whole.max_slope;
    rules.step_height = whole.step_height;
    rules.max_drop = whole.max_drop;
    rules.overhang = whole.overhang;
    rules.jump_speed = whole.jump_speed;
    rules.ground_acceleration = whole.ground_acceleration;
    rules.air_acceleration = whole.air_acceleration;
    rules.crouched_speed = whole.crouched_speed;
    rules.max_push = whole.max_push;
    rules.contact_offset = whole.contact_offset;
    return FIRMA_OK;
}

firma_player_rules player_rules_told(const PlayerRules& from) {
    return {sizeof(firma_player_rules),
            0,
            from.gravity,
            from.max_slope,
            from.step_height,
            from.max_drop,
            from.overhang,
            from.jump_speed,
            from.ground_acceleration,
            from.air_acceleration,
            from.crouched_speed,
            from.max_push,
            from.contact_offset};
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_player_size_defaults(firma_player_size* size) {
    if (!size) return;
    const PlayerSize usual;
    *size = {sizeof(firma_player_size),           0, usual.radius, usual.height, usual.crouched_height,
             {usual.up.x, usual.up.y, usual.up.z}};
}

void firma_player_defaults(firma_player* player) {
    if (player) put_player({}, *player);
}

void firma_player_rules_defaults(firma_player_rules* rules) {
    if (rules) *rules = player_rules_told({});
}

firma_code firma_player_shape_capsule(const firma_player_size* size, firma_player_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!shape) return bad_call(function, kNull);
        PlayerSize chosen;
        if (const firma_code code = read_size(size, chosen, function)) return code;
        return give_shape(make_player_capsule(chosen), shape, function);
    });
}

firma_code firma_player_shape_box(const firma_player_size* size, firma_player_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!shape) return bad_call(function, kNull);
        PlayerSize chosen;
        if (const firma_code code = read_size(size, chosen, function)) return code;
        return give_shape(make_player_box(chosen), shape, function);
    });
}

firma_code firma_player_shape_spheres(const double* standing, size_t standing_count, const double* crouched,
                                      size_t crouched_count, const double up[3], firma_player_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!shape || (!standing && standing_count) || (!crouched && crouched_count)) return bad_call(function, kNull);
        const Vec3 upward = up ? Vec3{up[0], up[1], up[2]} : Vec3{0, 0, 1};
        return give_shape(
            make_player_spheres(spheres_of(standing, standing_count), spheres_of(crouched, crouched_count), upward),
            shape, function);
    });
}

firma_code firma_player_shape_get_size(firma_player_shape shape, firma_player_size* size) {
    return guarded(__func__, [&, function = __func__] {
        if (!size) return bad_call(function, kNull);
        if (!sized(size)) return bad_call(function, kWrongSize);
        const PlayerShapeObject* object = find<PlayerShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const PlayerShape& it = object->shape;
        put_sized({0, 0, it.radius(), it.height(), it.height(true), {it.up().x, it.up().y, it.up().z}}, size);
        return FIRMA_OK;
    });
}

firma_code firma_player_shape_release(firma_player_shape shape) {
    return release<PlayerShapeObject>(shape.id, __func__);
}

firma_code firma_move_player(const firma_scene* scene, firma_player_shape shape, const firma_player* player,
                             const firma_player_wish* wish, double seconds, const firma_player_rules* rules,
                             firma_player_move* move) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !player || !wish || !move) return bad_call(function, kNull);
        if (!sized(move)) return bad_call(function, kWrongSize);
        SceneThere there;
        if (const firma_code code = there.read(scene, function)) return code;
        const PlayerShapeObject* object = find<PlayerShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = judge_player_flags(*player, function)) return code;
        PlayerWish wished;
        if (const firma_code code = read_wish(wish, wished, function)) return code;
        PlayerRules by;
        if (const firma_code code = read_player_rules(rules, by, function)) return code;
        if (!there.has_stretch())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the scene's stretch is not within 0..1");
        if (!is_finite(vec(player->ground_velocity)))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the ground velocity is not finite");
        const PlayerMove made = move_player(there.scene(), object->shape, player_of(*player), wished, seconds, by);
        if (!made.valid)
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function,
                        "a number of the player, the wish, the rules or the seconds is not finite or out of range");
        put_sized(move_of(made), move);
        return FIRMA_OK;
    });
}

firma_code firma_player_fits(const firma_scene* scene, firma_player_shape shape, const double position[3],
                             uint32_t crouched, uint32_t mask, uint32_t* fits) {
    return guarded(__func__, [&, function = __func__] {
        if (!scene || !position || !fits) return bad_call(function, kNull);
        SceneThere there;
        if (const firma_code code = there.read(scene, function)) return code;
        const PlayerShapeObject* object = find<PlayerShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = judge_flags({crouched}, function)) return code;
        const Vec3 at{position[0], position[1], position[2]};
        if (!is_finite(at)) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the position is not finite");
        if (!there.has_stretch())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the scene's stretch is not within 0..1");
        *fits = player_fits(there.scene(), object->shape, at, crouched != 0, mask);
        return FIRMA_OK;
    });
}
