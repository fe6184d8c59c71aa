// SPDX-License-Identifier: MIT
// Hashes of a game and of what it is made of.
#include <initializer_list>

#include "base/hasher.h"
#include "firma/game.h"
#include "player/player_shape.h"
#include "world/add_text.h"

namespace firma {
namespace {

void add_point(Hasher& hash, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) hash.add(v[axis]);
}
void add_turn(Hasher& hash, const Quaternion& turn) {
    for (const double part : turn) hash.add(part);
}
void add_numbers(Hasher& hash, std::initializer_list<double> numbers) {
    for (const double number : numbers) hash.add(number);
}

void add_path(Hasher& hash, const PartPath& path) {
    hash.add(path.stops.size());
    for (const PartStop& stop : path.stops) {
        add_point(hash, stop.position);
        add_numbers(hash, {stop.angle, stop.wait, stop.seconds});
    }
    hash.add(std::uint32_t(path.repeats));
    add_turn(hash, path.rotation);
    add_point(hash, path.axis);
    add_point(hash, path.swing.reach);
    add_numbers(hash, {path.spin, path.swing.angle, path.swing.period, path.swing.phase});
}

std::uint64_t hash_part(const MovingPart& part, const PartDrive& drive) {
    Hasher hash;
    hash.add(hash_world(part.world()));
    add_point(hash, part.motion.position);
    add_turn(hash, part.motion.rotation);
    add_point(hash, part.motion.path);
    add_point(hash, part.motion.turn);
    hash.add(part.mask, part.entity);
    add_text(hash, part.name);
    add_path(hash, drive.path);
    hash.add(std::uint32_t(drive.waits), std::uint32_t(drive.when_blocked));
    hash.add(drive.started);
    hash.add(drive.held);
    hash.add(drive.ahead);
    for (const PortalId portal : drive.portals) hash.add(portal.value);
    return hash.value();
}

void add_player_shape(Hasher& hash, const PlayerShape& shape) {
    if (!shape.valid()) return;
    const PlayerShapeData& data = shape.data();
    hash.add(std::uint32_t(data.kind));
    add_numbers(hash, {data.given.radius, data.given.height, data.given.crouched_height});
    add_point(hash, data.given.up);
    for (const Posture& posture : data.postures) {
        hash.add(posture.spheres.size());
        for (const Sphere& sphere : posture.spheres) {
            add_point(hash, sphere.centre);
            hash.add(sphere.radius);
        }
    }
}

std::uint64_t hash_player(const GamePlayer& player) {
    Hasher hash;
    add_player_shape(hash, player.shape);
    const PlayerRules& rules = player.rules;
    add_numbers(hash, {rules.gravity, rules.max_slope, rules.step_height, rules.max_drop, rules.overhang,
                       rules.jump_speed, rules.ground_acceleration, rules.air_acceleration, rules.crouched_speed,
                       rules.max_push, rules.contact_offset, player.mass});
    const Player& it = player.player;
    for (const Vec3& v : {it.position, it.velocity, it.ground_normal, it.ground_velocity}) add_point(hash, v);
    hash.add(it.mask, it.ground_part);
    hash.add(it.room.value,
             std::uint32_t(it.on_ground) | std::uint32_t(it.crouched) << 1 | std::uint32_t(it.stuck) << 2);
    hash.add(it.world_hash);
    add_point(hash, player.wish.velocity);
    hash.add(std::uint32_t(player.wish.jump) | std::uint32_t(player.wish.crouch) << 1 |
             std::uint32_t(player.wish.careful) << 2);
    return hash.value();
}

std::uint64_t hash_projectile(const Projectile& it) {
    Hasher hash;
    hash.add(hash_projectiles({&it, 1}));
    hash.add(it.user);
    return hash.value();
}

/// 0 for a slot without a body.
std::uint64_t hash_body(const Body& body) {
    if (!body.shape.valid()) return 0;
    Hasher hash;
    hash.add(body.shape.mass());
    hash.add(body.shape.spheres().size());
    for (const Vec3& v : {body.position, body.velocity, body.spin, body.force, body.torque, body.still_at})
        add_point(hash, v);
    for (const Quaternion& turn : {body.rotation, body.still_turn}) add_turn(hash, turn);
    add_numbers(hash, {body.friction, body.restitution, body.rolling, body.still_for});
    hash.add(body.mask, body.use);
    hash.add(body.island,
             std::uint32_t(body.asleep) | std::uint32_t(body.stuck) << 1 | std::uint32_t(body.crushed) << 2);
    return hash.value();
}

std::uint64_t hash_piece(const DebrisPiece& piece) {
    if (piece.solid.face_count() == 0) return 0;
    Hasher hash;
    hash.add(hash_solid(piece.solid));
    hash.add(piece.use, piece.matter);
    hash.add(piece.broken, std::uint32_t(piece.never_ground) | std::uint32_t(piece.of_part) << 1);
    add_point(hash, piece.origin);
    add_numbers(hash, {piece.age, piece.asleep_for});
    return hash.value();
}

void add_charge(Hasher& hash, const Charge& charge) {
    add_numbers(hash, {charge.crater, charge.radius, charge.impulse, charge.break_radius});
    hash.add(std::uint32_t(charge.shape), charge.max_pieces);
    add_text(hash, charge.material);
}

void add_weapon(Hasher& hash, const Weapon& weapon) {
    add_text(hash, weapon.name);
    add_point(hash, weapon.gravity);
    add_numbers(hash, {weapon.mass, weapon.pane_energy, weapon.stop_speed, weapon.fuse});
    for (const ShotTerms& terms : {weapon.terms, weapon.bodies})
        add_numbers(hash, {terms.ricochet_below, terms.restitution, terms.friction, terms.resistance});
    hash.add(std::uint32_t(weapon.lies), std::uint32_t(weapon.charge.has_value()));
    if (weapon.charge) add_charge(hash, *weapon.charge);
}

void add_rules(Hasher& hash, const GameRules& rules) {
    const StepOptions& bodies = rules.bodies;
    add_point(hash, bodies.gravity);
    hash.add(bodies.substeps_a_second, bodies.max_bounces);
    add_numbers(hash, {bodies.contact_friction, bodies.contact_offset, bodies.sleep_speed, bodies.sleep_after});
    const DebrisRules& debris = rules.debris;
    for (const std::size_t count : {debris.max_bodies, debris.max_spheres, debris.max_to_ground}) hash.add(count);
    add_numbers(hash, {debris.max_age, debris.max_asleep, debris.min_to_ground, debris.max_overlap});
    hash.add(std::uint32_t(debris.to_ground), std::uint32_t(rules.chunks.has_value()));
    if (rules.chunks) add_numbers(hash, {rules.chunks->min_volume, rules.chunks->density});
    hash.add(rules.max_blast_speed);
    hash.add(rules.seed);
}

/// All that no other item is of.
std::uint64_t hash_rest(const GameState& game) {
    Hasher hash;
    hash.add(game.tick);
    hash.add(game.rate);
    hash.add(game.explosions);
    hash.add(game.log.level_hash());
    hash.add(game.log.commands().size());
    hash.add(game.log.last_number());
    hash.add(hash_bodies(game.bodies));
    for (const GameShots& shots : game.shots) add_weapon(hash, shots.weapon);
    add_rules(hash, game.rules);
    return hash.value();
}

/// Calls take(kind, hash) for all items, kind by kind.
template <class Take>
void for_each_item(const GameState& game, const Take& take) {
    take(GameItem::kWorld, hash_world(game.world));
    for (std::size_t k = 0; k < game.parts.size(); ++k)
        take(GameItem::kPart, hash_part(game.parts[k], k < game.drives.size() ? game.drives[k] : PartDrive()));
    for (const GamePlayer& player : game.players) take(GameItem::kPlayer, hash_player(player));
    for (const GameShots& shots : game.shots)
        for (const Projectile& projectile : shots.projectiles) take(GameItem::kProjectile, hash_projectile(projectile));
    for (const Body& body : game.bodies.slots) take(GameItem::kBody, hash_body(body));
    for (const DebrisPiece& piece : game.debris.slots) take(GameItem::kDebris, hash_piece(piece));
    take(GameItem::kRest, hash_rest(game));
}

}  // namespace

std::uint64_t hash_game(const GameState& game) {
    Hasher hash;
    for_each_item(game, [&](GameItem item, std::uint64_t value) {
        hash.add(std::uint32_t(item));
        hash.add(value);
    });
    return hash.value();
}

GameHashes hash_game_items(const GameState& game) {
    GameHashes hashes;
    Hasher hash;
    for_each_item(game, [&](GameItem item, std::uint64_t value) {
        hash.add(std::uint32_t(item));
        hash.add(value);
        hashes.items[std::size_t(item)].push_back(std::uint32_t(value));
    });
    hashes.whole = hash.value();
    return hashes;
}

}  // namespace firma
