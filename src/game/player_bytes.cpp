// SPDX-License-Identifier: MIT
// Players as bytes.
#include "game/player_bytes.h"

#include <utility>

#include "game/number_bytes.h"
#include "player/player_shape.h"

namespace firma {
namespace {

using ShapeKind = PlayerShapeData::Kind;
constexpr std::size_t kPlayerSphereBytes = 32;

void put_spheres(ByteWriter& out, const SphereSet& spheres) {
    put_whole(out, spheres.size());
    for (const Sphere& sphere : spheres) {
        put_vec(out, sphere.centre);
        out.f64(sphere.radius);
    }
}
SphereSet take_spheres(ByteReader& in) {
    SphereSet spheres(take_count(in, kPlayerSphereBytes));
    for (Sphere& sphere : spheres) {
        sphere.centre = take_vec(in);
        sphere.radius = in.f64();
    }
    return spheres;
}

void put_player_shape(ByteWriter& out, const PlayerShapeData& shape) {
    out.u8(std::uint8_t(shape.kind));
    put_vec(out, shape.given.up);
    if (shape.kind == ShapeKind::kSpheres) {
        for (const Posture& posture : shape.postures) put_spheres(out, posture.spheres);
    } else {
        put_numbers(out, {shape.given.radius, shape.given.height, shape.given.crouched_height});
    }
}

PlayerShape take_player_shape(ByteReader& in) {
    const std::size_t where = in.place();
    const unsigned kind = in.u8();
    if (kind > unsigned(ShapeKind::kSpheres)) in.fail_at(where, ErrorCode::kMalformed, "a player of no kind of shape");
    PlayerSize size;
    size.up = take_vec(in);
    SphereSet spheres[2];
    if (ShapeKind(kind) == ShapeKind::kSpheres) {
        for (SphereSet& posture : spheres) posture = take_spheres(in);
    } else {
        take_numbers(in, {&size.radius, &size.height, &size.crouched_height});
    }
    if (!in.ok()) return {};
    Result<PlayerShape> shape = ShapeKind(kind) == ShapeKind::kCapsule ? make_player_capsule(size)
                                : ShapeKind(kind) == ShapeKind::kBox
                                    ? make_player_box(size)
                                    : make_player_spheres(spheres[0], spheres[1], size.up);
    if (shape) return std::move(shape).value();
    in.fail_at(where, ErrorCode::kMalformed, "no shape of a player: " + shape.error().reason);
    return {};
}

void put_player_rules(ByteWriter& out, const PlayerRules& rules) {
    put_numbers(out, {rules.gravity, rules.max_slope, rules.step_height, rules.max_drop, rules.overhang,
                      rules.jump_speed, rules.ground_acceleration, rules.air_acceleration, rules.crouched_speed,
                      rules.max_push, rules.contact_offset});
}
void take_player_rules(ByteReader& in, PlayerRules& rules) {
    take_numbers(in, {&rules.gravity, &rules.max_slope, &rules.step_height, &rules.max_drop, &rules.overhang,
                      &rules.jump_speed, &rules.ground_acceleration, &rules.air_acceleration, &rules.crouched_speed,
                      &rules.max_push, &rules.contact_offset});
}

}  // namespace

void put_wish(ByteWriter& out, const PlayerWish& wish) {
    put_vec(out, wish.velocity);
    put_flags(out, {wish.jump, wish.crouch, wish.careful});
}
PlayerWish take_wish(ByteReader& in) {
    PlayerWish wish;
    wish.velocity = take_vec(in);
    take_flags(in, {&wish.jump, &wish.crouch, &wish.careful});
    return wish;
}

void put_player(ByteWriter& out, const GamePlayer& player) {
    put_player_shape(out, player.shape.data());
    put_player_rules(out, player.rules);
    out.f64(player.mass);
    const Player& it = player.player;
    put_vec(out, it.position);
    put_vec(out, it.velocity);
    out.u32(it.mask);
    put_flags(out, {it.on_ground, it.crouched, it.stuck});
    put_vec(out, it.ground_normal);
    out.u32(it.ground_part);
    put_vec(out, it.ground_velocity);
    out.u32(it.room.value);
    out.u64(it.world_hash);
    put_wish(out, player.wish);
}

GamePlayer take_player(ByteReader& in) {
    GamePlayer player;
    player.shape = take_player_shape(in);
    take_player_rules(in, player.rules);
    player.mass = in.f64();
    Player& it = player.player;
    it.position = take_vec(in);
    it.velocity = take_vec(in);
    it.mask = in.u32();
    take_flags(in, {&it.on_ground, &it.crouched, &it.stuck});
    it.ground_normal = take_vec(in);
    it.ground_part = in.u32();
    it.ground_velocity = take_vec(in);
    it.room.value = in.u32();
    it.world_hash = in.u64();
    player.wish = take_wish(in);
    return player;
}

}  // namespace firma
