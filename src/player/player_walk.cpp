// SPDX-License-Identifier: MIT
// A player on foot: along the ground, up steps, and not off ledges.
#include <algorithm>

#include "player/player_tick.h"
#include "player/unit.h"

namespace firma {
namespace {

/// Slop, metres: a step up that leads no farther is none.
constexpr double kLeastClimb = 1e-4;
/// A rise under a lintel is looked for to a 64th of a step.
constexpr int kRiseHalvings = 6;
/// Slop, the length of a unit vector's part sideways: what has less is level.
constexpr double kLevel = 1e-6;
/// A ledge is come up to within this share of a tick's way.
constexpr int kLedgeHalvings = 8;

}  // namespace

void PlayerTick::walk() {
    const State begun = state_;
    const Vec3 way = sideways(player_.velocity) * seconds_;
    walk_along(way);
    if (wish_.careful && max_abs(way) > 0 && !ground_within(player_.position, rules_.max_drop))
        stop_at_ledge(begun, way);
    settle(rules_.step_height);
}

void PlayerTick::walk_along(Vec3 left) {
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = allowed_on_ground(along_ground(left));
        if (!(max_abs(path) > 0)) break;
        const PartHit hit = go(path);
        left *= 1 - hit.safe_fraction;
        if (!hit.touched()) break;
        const Ground ground = ground_rules_.under(hit, player_.position);
        note(hit, ground);
        if (ground.carries && ground_rules_.walkable(hit.normal))
            state_.ground = hit.normal;
        else if (!climb(left))
            add_wall(hit.normal);
    }
}

// By a whole step, as far as there is room; under a lintel by as much as leads between that and what it climbs.
bool PlayerTick::climb(Vec3& left) {
    const double most = rules_.step_height * posture_.sweep(player_.position, up_ * rules_.step_height).safe_fraction;
    if (!(most > offset_) || !(max_abs(left) > 0)) return false;
    Climb climbed = climb_by(most, left);
    if (climbed != Climb::kTooHigh) return climbed == Climb::kDone;
    double low = 0, high = most;
    for (int k = 0; k < kRiseHalvings; ++k) {
        const double middle = (low + high) * 0.5;
        climbed = climb_by(middle, left);
        if (climbed == Climb::kDone || climbed == Climb::kNowhere) return climbed == Climb::kDone;
        (climbed == Climb::kTooHigh ? high : low) = middle;
    }
    return false;
}

// Up, along, and down again: on a step if what it comes down on carries. Else, as on the steep side of a small pit, if
// a bit farther on something does that is no higher than a step: then it is on its way up.
PlayerTick::Climb PlayerTick::climb_by(double rise, Vec3& left) {
    const Vec3 from = player_.position;
    // A slow one goes as far as over the gap that it keeps.
    Vec3 at = from + up_ * rise, to_do = left * std::max(1.0, 2 * offset_ / length(left));
    const Vec3 ahead = unit(left) * (2 * shape_.radius);
    AllowedMotion walls = state_.walls;
    Climb not_done = Climb::kNowhere;
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = walls.nearest(to_do);
        if (!(max_abs(path) > 0)) break;
        const PartHit hit = posture_.sweep(at, path);
        at += path * hit.safe_fraction;
        to_do *= 1 - hit.safe_fraction;
        if (!hit.touched()) break;
        const bool over_head = dot(hit.point - from, up_) > posture_.height();
        if (not_done != Climb::kTooHigh) not_done = over_head ? Climb::kTooHigh : Climb::kTooLow;
        const Vec3 side = sideways(hit.normal);
        if (!(length(side) > kLevel)) break;
        walls.add(unit(side));
    }
    if (!(length(sideways(at - from)) > kLeastClimb)) return not_done;
    const Vec3 fall = up_ * -(rise + offset_);
    const Landing near = land(at, fall);
    if (!near.hit.touched() || dot(near.feet - from, up_) < 0) return not_done;
    if (is_step(near, from)) {
        state_.ground = near.ground.normal;
    } else {
        if (near.ground.carries) return not_done;
        const Landing far = land(at + ahead * posture_.sweep(at, ahead).safe_fraction, fall);
        if (!is_step(far, from)) return not_done;
        state_.climbing = true;
        state_.ground = up_;
    }
    player_.position = near.feet;
    left = to_do;
    move_.stepped = true;
    note(near.hit, near.ground);
    return Climb::kDone;
}

PlayerTick::Landing PlayerTick::land(const Vec3& feet, const Vec3& fall) const {
    Landing landing;
    landing.hit = posture_.sweep(feet, fall);
    landing.feet = feet + fall * landing.hit.safe_fraction;
    landing.ground = ground_rules_.under(landing.hit, landing.feet);
    return landing;
}

/// Whether it leads up, by no more than a step.
bool PlayerTick::is_step(const Landing& landing, const Vec3& from) const {
    return landing.ground.carries && dot(landing.feet - from, up_) > offset_ &&
           dot(landing.hit.point - foothold(from), up_) <= rules_.step_height;
}

// Where it stands: the point that carries it, which for a round foot on an edge is higher than its lowest point.
Vec3 PlayerTick::foothold(const Vec3& feet) const {
    const PartHit hit = posture_.sweep(feet, up_ * -rules_.step_height);
    return hit.touched() ? hit.point : feet;
}

bool PlayerTick::ground_within(const Vec3& feet, double far) const {
    const Vec3 fall = up_ * -far;
    const PartHit hit = posture_.sweep(feet, fall);
    return ground_rules_.under(hit, feet + fall * hit.safe_fraction).carries;
}

// As much of the way as leads to ground, then what of the rest goes along the face that drops there, if that does.
void PlayerTick::stop_at_ledge(const State& begun, const Vec3& way) {
    const Vec3 over = player_.position;
    const auto try_way = [&](double share) {
        state_ = begun;
        walk_along(way * share);
        return ground_within(player_.position, rules_.max_drop);
    };
    double share = 0, too_far = 1;
    for (int k = 0; k < kLedgeHalvings; ++k) {
        const double middle = (share + too_far) * 0.5;
        (try_way(middle) ? share : too_far) = middle;
    }
    if (!try_way(share)) state_ = begun;
    const Vec3 out = unit(way) * (2 * shape_.radius);
    CastOptions options;
    options.mask = player_.mask;
    const Hit drop = cast(scene_, Ray{over + out - up_ * (rules_.max_drop * 0.5), out * -2 - way}, options);
    if (!drop || !(length(sideways(drop.normal)) > kLevel)) return;
    const State at_ledge = state_;
    AllowedMotion ledge;
    ledge.add(unit(sideways(-drop.normal)));
    walk_along(ledge.nearest(way * (1 - share)));
    if (!ground_within(player_.position, rules_.max_drop)) state_ = at_ledge;
}

}  // namespace firma
