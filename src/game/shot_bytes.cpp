// SPDX-License-Identifier: MIT
// Weapons, charges and projectiles as bytes.
#include "game/shot_bytes.h"

#include "game/number_bytes.h"

namespace firma {
namespace {

constexpr std::size_t kProjectileBytes = 81;

void put_terms(ByteWriter& out, const ShotTerms& terms) {
    put_numbers(out, {terms.ricochet_below, terms.restitution, terms.friction, terms.resistance});
}
ShotTerms take_terms(ByteReader& in) {
    ShotTerms terms;
    take_numbers(in, {&terms.ricochet_below, &terms.restitution, &terms.friction, &terms.resistance});
    return terms;
}

void put_projectile(ByteWriter& out, const Projectile& it) {
    put_vec(out, it.position);
    put_vec(out, it.velocity);
    put_numbers(out, {it.mass, it.age});
    out.u32(it.mask);
    out.u32(it.user);
    out.u64(it.world_hash);
    out.u8(std::uint8_t(it.state));
}
Projectile take_projectile(ByteReader& in) {
    Projectile it;
    it.position = take_vec(in);
    it.velocity = take_vec(in);
    take_numbers(in, {&it.mass, &it.age});
    it.mask = in.u32();
    it.user = in.u32();
    it.world_hash = in.u64();
    const unsigned state = in.u8();
    if (state > unsigned(ProjectileState::kExpired)) in.fail("a projectile that neither flies nor stopped");
    it.state = ProjectileState(state);
    return it;
}

}  // namespace

void put_charge(ByteWriter& out, const Charge& charge) {
    put_numbers(out, {charge.crater, charge.radius, charge.impulse, charge.break_radius});
    out.u8(std::uint8_t(charge.shape));
    put_whole(out, charge.max_pieces);
    put_text(out, charge.material);
}

Charge take_charge(ByteReader& in) {
    Charge charge;
    take_numbers(in, {&charge.crater, &charge.radius, &charge.impulse, &charge.break_radius});
    charge.shape = CutterShape(in.u8());
    charge.max_pieces = take_u32_whole(in);
    charge.material = in.text();
    return charge;
}

void put_shots(ByteWriter& out, const GameShots& shots) {
    const Weapon& weapon = shots.weapon;
    put_text(out, weapon.name);
    out.f64(weapon.mass);
    put_vec(out, weapon.gravity);
    put_terms(out, weapon.terms);
    put_terms(out, weapon.bodies);
    put_numbers(out, {weapon.pane_energy, weapon.stop_speed, weapon.fuse});
    put_flags(out, {weapon.lies, weapon.charge.has_value()});
    if (weapon.charge) put_charge(out, *weapon.charge);
    put_whole(out, shots.projectiles.size());
    for (const Projectile& projectile : shots.projectiles) put_projectile(out, projectile);
}

GameShots take_shots(ByteReader& in) {
    GameShots shots;
    Weapon& weapon = shots.weapon;
    weapon.name = in.text();
    weapon.mass = in.f64();
    weapon.gravity = take_vec(in);
    weapon.terms = take_terms(in);
    weapon.bodies = take_terms(in);
    take_numbers(in, {&weapon.pane_energy, &weapon.stop_speed, &weapon.fuse});
    bool has_charge = false;
    take_flags(in, {&weapon.lies, &has_charge});
    if (has_charge) weapon.charge = take_charge(in);
    const std::size_t count = take_count(in, kProjectileBytes);
    for (std::size_t k = 0; k < count && in.ok(); ++k) shots.projectiles.push_back(take_projectile(in));
    return shots;
}

}  // namespace firma
