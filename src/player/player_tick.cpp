// SPDX-License-Identifier: MIT
// A tick of a player: out of what came, posture, speed, then on the ground or in the air.
#include "player/player_tick.h"

#include <algorithm>

#include "firma/rooms.h"
#include "player/unit.h"
#include "player/way_out.h"

namespace firma {
namespace {

/// Slop, a share of a fall: what falls no farther than that between what it touches is held.
constexpr double kHeld = 1e-3;
/// In contact offsets: so far it slides down between things to ground that carries.
constexpr double kSettling = 4;
/// Slop, metres: what would go down or up by less stays where it is, to the bit.
constexpr double kAtRest = 1e-7;
/// The length of a unit normal's part sideways: one that has less is nearly level, as of a ceiling.
constexpr double kSteep = 0.6;
/// Slop, a cosine: what leans by less is upright.
constexpr double kUpright = 1e-6;

/// As near to `to` as a change of `most` allows.
Vec3 approach(const Vec3& from, const Vec3& to, double most) {
    const Vec3 change = to - from;
    const double size = length(change);
    return size <= most ? to : from + change * (most / size);
}

}  // namespace

PlayerTick::PlayerTick(const Scene& scene, const PlayerShapeData& shape, const Player& player, const PlayerWish& wish,
                       double seconds, const PlayerRules& rules, double offset)
    : scene_{scene.world, scene.parts, 0, 0},
      world_(scene.world),
      shape_(shape),
      wish_(wish),
      rules_(rules),
      ground_rules_(scene_, shape, rules, player.mask, offset),
      up_(shape.up),
      seconds_(seconds),
      offset_(offset),
      other_world_(player.world_hash != hash_world(scene.world) || player.stuck),
      posture_(scene_, shape, player.crouched, player.mask, offset) {
    player_ = player;
    state_.ground = player.on_ground ? player.ground_normal : up_;
}

PlayerMove PlayerTick::run() {
    if (other_world_ && !get_free()) {
        player_.stuck = true;
        player_.velocity = {};
        return move_;
    }
    player_.stuck = false;
    // Before parts go: who comes to stand on one is carried by it in this tick, as its speed over it is reckoned.
    if (other_world_ && player_.on_ground) settle(rules_.step_height);
    ride();
    choose_posture();
    accelerate();
    if (player_.on_ground)
        walk();
    else
        fly();
    finish();
    return move_;
}

bool PlayerTick::get_free() {
    // One that is stuck since before in this world is looked around less: it was looked around well then.
    const std::uint64_t hash = hash_world(world_);
    const bool thorough = !player_.stuck || player_.world_hash != hash;
    player_.world_hash = hash;
    if (is_free(posture_, player_.position)) return true;
    const std::optional<Vec3> out =
        way_out(world_, posture_, shape_, player_.position, player_.room, rules_.max_push, offset_, thorough);
    if (!out) return false;
    move_.pushed = *out - player_.position;
    player_.position = *out;
    return true;
}

void PlayerTick::choose_posture() {
    if (wish_.crouch == player_.crouched) return;
    const PostureIn other(scene_, shape_, wish_.crouch, player_.mask, offset_);
    if (!wish_.crouch && other.overlaps(player_.position)) return;
    player_.crouched = wish_.crouch;
    posture_ = other;
}

void PlayerTick::accelerate() {
    const Vec3 wished = sideways(wish_.velocity) * (player_.crouched ? rules_.crouched_speed : 1);
    const Vec3 side = sideways(player_.velocity);
    double rise = dot(player_.velocity, up_);
    Vec3 faster = side;
    if (player_.on_ground) {
        faster = approach(side, wished, rules_.ground_acceleration * seconds_);
        rise = 0;
        if (wish_.jump) {
            move_.jumped = true;
        }
    } else if (dot(wished, wished) > 0) {
        faster = approach(side, wished, rules_.air_acceleration * seconds_);
    }
    player_.velocity = faster + up_ * rise;
    if (move_.jumped) {
        player_.velocity += up_ * rules_.jump_speed;
        leave_ground();
    }
}

Vec3 PlayerTick::along_ground(const Vec3& flat) const {
    const Vec3 slanted = flat - up_ * (dot(state_.ground, flat) / dot(state_.ground, up_));
    const double size = length(slanted);
    return size > 0 ? slanted * (length(flat) / size) : Vec3{};
}

Vec3 PlayerTick::allowed_on_ground(const Vec3& motion) const {
    AllowedMotion cone = state_.walls;
    cone.add(state_.ground);
    return cone.nearest(motion);
}

PartHit PlayerTick::go(const Vec3& path) {
    const PartHit hit = posture_.sweep_ahead(player_.position, path);
    player_.position += path * hit.safe_fraction;
    if (!hit.touched()) return hit;
    state_.touched.add(hit.normal);
    const double gap = -dot(path, hit.normal) * (hit.fraction - hit.safe_fraction);
    if (gap < offset_ * 0.5) back_off(hit.normal, offset_ - gap);
    return hit;
}

// It stopped for something else nearer to this than the offset. Away from it again, at most half way to what is across:
// so what has room on both sides touches neither.
void PlayerTick::back_off(const Vec3& normal, double far) {
    Vec3 path = normal * far;
    // On foot level: what backs off upward comes down again, and slides aside on what it backed off from.
    const Vec3 side = sideways(normal);
    const double size = length(side);
    if (player_.on_ground && size > kSteep && !ground_rules_.walkable(normal)) path = side * (far / (size * size));
    const PartHit hit = posture_.sweep(player_.position, path);
    const Vec3 way = path * std::max(hit.safe_fraction, hit.fraction * 0.5);
    player_.position += way;
    move_.pushed += way;
}

void PlayerTick::add_wall(const Vec3& normal) {
    state_.walls.add(normal);
    const Vec3 side = sideways(normal);
    if (dot(normal, up_) > kUpright && length(side) > kUpright) state_.walls.add(unit(side));
}

void PlayerTick::fly() {
    const Vec3 fall = up_ * (-rules_.gravity * seconds_);
    Vec3 left = (player_.velocity + fall * 0.5) * seconds_;
    player_.velocity += fall;
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = state_.walls.nearest(left);
        if (!(max_abs(path) > 0)) break;
        const PartHit hit = go(path);
        left *= 1 - hit.safe_fraction;
        if (!hit.touched()) break;
        if (come_down(hit, left) || climb_from_slide(hit, left)) return;
        add_wall(hit.normal);
    }
    if (is_held()) stand_on(up_, kNoPart);
}

// On a side too steep to stand on, with something below within a step: it may go on up as from the ground, where it
// wishes to. What only slides along slides down.
bool PlayerTick::climb_from_slide(const PartHit& hit, const Vec3& left) {
    if (dot(player_.velocity, up_) > 0 || !(dot(hit.normal, up_) > kUpright)) return false;
    Vec3 flat = sideways(left);
    if (!(dot(wish_.velocity, flat) > 0)) return false;
    if (!posture_.sweep(player_.position, up_ * -rules_.step_height).touched()) return false;
    if (!climb(flat)) return false;
    stand_on(up_, hit.part);
    settle(rules_.step_height);
    return true;
}

// Lands: what is left of the way goes along the ground.
bool PlayerTick::come_down(const PartHit& hit, const Vec3& left) {
    const Ground ground = ground_rules_.under(hit, player_.position);
    note(hit, ground);
    if (!ground.carries) return false;
    const double fall = dot(player_.velocity - speed_of(hit.part), up_);
    if (fall > 0) return false;
    move_.landed_speed = -fall;
    stand_on(ground.normal, hit.part);
    if (ground_rules_.walkable(hit.normal)) state_.ground = hit.normal;
    Vec3 flat = sideways(left);
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = allowed_on_ground(along_ground(flat));
        if (!(max_abs(path) > 0)) break;
        const PartHit next = go(path);
        flat *= 1 - next.safe_fraction;
        if (!next.touched()) break;
        note(next, ground_rules_.under(next, player_.position));
        add_wall(next.normal);
    }
    settle(rules_.step_height);
    return true;
}

// Down to what carries, within reach of a step; else it is in the air, but where what it touches holds it.
void PlayerTick::settle(double far) {
    const Vec3 fall = up_ * -far;
    const PartHit hit = posture_.sweep(player_.position, fall);
    const Vec3 there = player_.position + fall * hit.safe_fraction;
    const Ground ground = ground_rules_.under(hit, there);
    if (ground.carries) {
        if (length(there - player_.position) > kAtRest) player_.position = there;
        keep_offset(hit, far);
        note(hit, ground);
        return stand_on(ground.normal, hit.part);
    }
    if (state_.climbing) return stand_on(up_, player_.ground_part);
    Vec3 at = player_.position;
    AllowedMotion below;
    std::uint32_t part = kNoPart;
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = below.nearest(up_ * (-kSettling * offset_));
        if (-dot(path, up_) < kSettling * offset_ * held_fall()) return stand_on(up_, part);
        const PartHit met = posture_.sweep(at, path);
        if (!met.touched()) return leave_ground();
        part = met.part;
        at += path * met.safe_fraction;
        if (const Ground under = ground_rules_.under(met, at); under.carries) {
            move_.pushed += sideways(at - player_.position);
            player_.position = at;
            note(met, under);
            return stand_on(under.normal, met.part);
        }
        below.add(met.normal);
    }
    leave_ground();
}

// Up again by what is missing of the offset from the ground, as far as there is room: slides bring it as near as the
// ground they begin on was, measured along another normal.
void PlayerTick::keep_offset(const Hit& hit, double far) {
    const double missing = offset_ / dot(hit.normal, up_) - hit.fraction * far;
    if (missing > kAtRest)
        player_.position += up_ * (missing * posture_.sweep(player_.position, up_ * missing).safe_fraction);
}

// Between steep faces whose groove is no steeper than what it walks on it stands.
double PlayerTick::held_fall() const {
    return std::max(kHeld, ground_rules_.walkable_fall());
}

bool PlayerTick::is_held() const {
    return -dot(state_.touched.nearest(-up_), up_) < held_fall();
}

// Speed on the ground is that over what it stands on.
void PlayerTick::stand_on(const Vec3& normal, std::uint32_t part) {
    const Vec3 speed = speed_of(part);
    player_.velocity = sideways(player_.velocity + player_.ground_velocity - speed);
    player_.ground_velocity = speed;
    player_.ground_part = part;
    player_.on_ground = true;
    player_.ground_normal = normal;
}

void PlayerTick::leave_ground() {
    player_.velocity += player_.ground_velocity;
    player_.ground_velocity = {};
    player_.ground_part = kNoPart;
    player_.on_ground = false;
}

void PlayerTick::note(const PartHit& hit, const Ground& ground) {
    const double rise = dot(hit.normal, up_);
    PlayerContact contact;
    contact.kind = ground.carries ? ContactKind::kGround : rise < -0.5 ? ContactKind::kCeiling : ContactKind::kWall;
    contact.point = hit.point;
    contact.normal = hit.normal;
    contact.face_normal = ground.carries ? ground.normal : hit.face_normal;
    contact.face = hit.face;
    contact.portal = hit.portal;
    contact.part = hit.part;
    contact.material = hit.material;
    for (std::size_t k = 0; k < move_.contact_count; ++k)
        if (move_.touched[k].face == contact.face && move_.touched[k].portal == contact.portal &&
            move_.touched[k].part == contact.part) {
            move_.touched[k] = contact;
            return;
        }
    if (move_.contact_count < kMaxPlayerContacts) move_.touched[move_.contact_count++] = contact;
}

void PlayerTick::finish() {
    if (player_.on_ground) {
        const Vec3 along = along_ground(player_.velocity), allowed = allowed_on_ground(along);
        if (!(allowed == along)) player_.velocity = unit(sideways(allowed)) * length(allowed);
    } else {
        player_.velocity = state_.walls.nearest(player_.velocity);
        player_.ground_normal = {};
    }
    const Location at = posture_.where(player_.position);
    if (at.where == Where::kAir) player_.room = at.room;
}

}  // namespace firma
