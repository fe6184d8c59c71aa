// SPDX-License-Identifier: MIT
// Bodies swept along their ways, touch by touch.
#include "body/sweep_bodies.h"

#include <algorithm>
#include <cmath>

#include "body/body_tolerance.h"
#include "body/cast_spheres.h"
#include "body/pair_contacts.h"
#include "body/rest.h"
#include "body/turn_between.h"

namespace firma {
namespace {

/// Of the thinnest sphere of two bodies: what comes no nearer to each other in a step than this is left to contacts.
constexpr double kSlowShare = 0.5;
/// Of the skin: a sweep stops so far before a sphere would be as deep as the skin, too.
constexpr double kSinks = 0.75;
/// What has met enough may be met by parts, and what these take along, so often again.
constexpr int kMostCarries = 8;
/// Radians: what turns farther in what is left of a step goes so far. Arcs are divided by angle, and a spin by numbers
/// that make no sense would take hours.
constexpr double kMaxTurn = 64;

/// As far as any point of a set may go.
double way_of(const RigidMotion& motion, double reach) {
    return length(motion.path) + length(motion.turn) * reach;
}

/// Twice the energy of a spin.
double turning_of(const Mover& mover, const Vec3& spin) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double about = dot(mover.matrix.column(axis), spin);
        sum += mover.shape->moments[axis] * about * about;
    }
    return sum;
}

/// The turn that brought it where it touches is straight, as its own was not: what comes nearer by that has to do so by
/// its spin. The energy stays.
void turn_as_swept(Mover& mover, const Vec3& turn) {
    const double as_swept = turning_of(mover, turn);
    if (as_swept > 0) mover.spin = turn * std::sqrt(turning_of(mover, mover.spin) / as_swept);
}

/// Whether it may be left where it is: it moved too little to be deeper than the skin.
bool moved_clearly(const Mover& mover, const RigidMotion& motion) {
    return way_of(motion, mover.shape->reach) < mover.clear;
}

RigidMotion motion_of(const Mover& mover) {
    return {mover.start, mover.start_rotation, mover.position - mover.start,
            turn_between(mover.start_rotation, mover.rotation)};
}

}  // namespace

BodySweep::BodySweep(const World& world, const StepParts& parts, Bodies& bodies, std::vector<Mover>& movers,
                     std::span<const NearPlane> planes, std::vector<std::uint32_t>& movers_of_slots,
                     const std::vector<bool>& sound, const SweepRules& rules)
    : world_(world),
      parts_(parts),
      bodies_(bodies),
      movers_(movers),
      planes_(planes),
      movers_of_slots_(movers_of_slots),
      sound_(sound),
      rules_(rules) {}

void BodySweep::run() {
    start();
    while (!touches_.empty()) {
        const Touching next = touches_.top();
        touches_.pop();
        if (next.piece != ways_[next.slot].piece) continue;
        if (next.other != kFixed && next.other_piece != ways_[next.other].piece) continue;
        touch(next);
    }
    for (Mover& mover : movers_) {
        const Way& way = ways_[mover.slot];
        if (!way.swept) continue;
        const Pose end = pose_at(way.motion, 1);
        mover.put_at(end.position, normalised(end.rotation));
    }
}

void BodySweep::tell(EnergyGuard& guard) const {
    for (const auto& [one, other] : met_pairs_) guard.join(one, other);
    for (std::uint32_t slot = 0; slot < ways_.size(); ++slot) {
        if (ways_[slot].met_level) guard.hold(slot);
        if (ways_[slot].pushed_by != kNoPart) guard.hold(slot), guard.let_go(slot);
    }
}

void BodySweep::start() {
    ways_.resize(bodies_.slots.size());
    std::vector<BodyBall> balls;
    for (std::uint32_t slot = 0; slot < ways_.size(); ++slot) {
        const Body& body = bodies_.slots[slot];
        if (!sound_[slot] || body.stuck) continue;
        Way& way = ways_[slot];
        way.is_there = true;
        const bool moves = movers_of_slots_[slot] != kFixed;
        if (moves)
            way.motion = motion_of(movers_[movers_of_slots_[slot]]);
        else
            way.motion = {body.position, principal_rotation(body), {}, {}};
        balls.push_back({way.motion.position, reach_of(slot), slot, body.mask, false});
        if (!moves) continue;
        const Mover& mover = movers_[movers_of_slots_[slot]];
        balls.back().awake = way_of(way.motion, mover.shape->reach) > 0.5 * kSlowShare * mover.shape->thinnest;
        if (!parts_are_clear(mover)) find_part_touch(slot);
        if (moved_clearly(mover, way.motion)) continue;
        if (!(way_of(way.motion, mover.shape->reach) < mover.known))
            find_world_touch(slot);
        else if (const std::span<const Sphere> cores = cores_that_may_touch(mover, way.motion); !cores.empty())
            note_world_touch(slot, cast_spheres(world_, cores, way.motion, world_options(slot)));
    }
    for (const auto& [slot, other] : near_pairs(std::move(balls))) find_pair_touch(slot, other, Overlap::kPassed);
}

/// The spheres that may come to touch a face, as they are swept. Others stay, thinner by most of the skin, in front of
/// the plane of each face near them: they do where they begin and end, but for how far their arcs bulge out between.
std::span<const Sphere> BodySweep::cores_that_may_touch(const Mover& mover, const RigidMotion& motion) {
    cores_.clear();
    const double turn = length(motion.turn);
    std::uint32_t last = ~0u;
    for (const NearPlane& plane : planes_.subspan(mover.first_plane, mover.planes)) {
        if (plane.sphere == last) continue;
        const Sphere& sphere = mover.shape->spheres[plane.sphere];
        const double ends = dot(mover.centre_of(plane.sphere) - plane.point, plane.normal);
        const double bulge = length(sphere.centre) * turn * turn / 8;
        const double sinks = std::min(rules_.skin, 0.5 * sphere.radius);
        if (std::min(plane.side, ends) - bulge >= sphere.radius - kSinks * sinks) continue;
        cores_.push_back({sphere.centre, sphere.radius - sinks});
        last = plane.sphere;
    }
    return cores_;
}

/// A sphere around all of the way that is left.
double BodySweep::reach_of(std::uint32_t slot) const {
    return bodies_.slots[slot].shape.reach() + length(ways_[slot].motion.path);
}

/// The spheres as they are swept: thinner by the skin, so that what rests on something is clear of it.
std::span<const Sphere> BodySweep::cores_of(std::uint32_t slot, std::vector<Sphere>& into) const {
    into.clear();
    for (const Sphere& sphere : bodies_.slots[slot].shape.data().spheres)
        into.push_back({sphere.centre, sphere.radius - std::min(rules_.skin, 0.5 * sphere.radius)});
    return into;
}

/// Of a piece of its way.
RigidMotion BodySweep::between(const Way& way, double from, double to) const {
    if (from <= way.from && to >= way.to) return way.motion;
    const double scale = 1 / (way.to - way.from), share = (to - from) * scale;
    const Pose pose = pose_at(way.motion, std::max(from - way.from, 0.0) * scale);
    return {pose.position, normalised(pose.rotation), way.motion.path * share, way.motion.turn * share};
}

CastOptions BodySweep::world_options(std::uint32_t slot) const {
    CastOptions options;
    options.mask = bodies_.slots[slot].mask;
    options.contact_offset = rules_.skin * 0.25;
    return options;
}

void BodySweep::find_world_touch(std::uint32_t slot) {
    note_world_touch(slot, cast(world_, cores_of(slot, cores_), ways_[slot].motion, world_options(slot)));
}

void BodySweep::note_world_touch(std::uint32_t slot, const SetHit& hit) {
    Way& way = ways_[slot];
    if (!way.swept) ++swept_;
    way.swept = true;
    if (hit.status == Status::kInvalid) way.motion.path = way.motion.turn = {};
    if (!hit.touched()) return;
    touches_.push({way.from + hit.safe_fraction * (way.to - way.from), slot, kFixed, way.piece, 0, kNoPart, hit.point,
                   hit.normal, false});
}

/// Whether body and parts went too little for it to be deeper in one than the skin.
bool BodySweep::parts_are_clear(const Mover& mover) const {
    const double way = way_of(ways_[mover.slot].motion, mover.shape->reach);
    for (std::size_t k = 0; k < parts_.size(); ++k)
        if (!(way + parts_[k].way < mover.part_clear) &&
            parts_[k].may_meet(mover.start, mover.shape->reach + way + rules_.skin))
            return false;
    return true;
}

/// The parts go on meanwhile, whether it does or not.
void BodySweep::find_part_touch(std::uint32_t slot) {
    Way& way = ways_[slot];
    if (parts_.empty() || way.ended) return;
    if (!way.swept) ++swept_;
    way.swept = true;
    CastOptions options;
    options.mask = bodies_.slots[slot].mask;
    options.contact_offset = rules_.skin * 0.25;
    const StepPartHit hit =
        parts_.cast_set(cores_of(slot, cores_), way.motion, way.from, way.to, way.carried_by, options);
    if (!hit.touched()) return;
    touches_.push({way.from + hit.safe_fraction * (way.to - way.from), slot, kFixed, way.piece, 0, hit.part, hit.point,
                   hit.normal, false});
}

/// What one part takes along goes as one.
/// @param at_start  what overlaps then is left to contacts for all of the step, or meets there
void BodySweep::find_pair_touch(std::uint32_t slot, std::uint32_t other, Overlap at_start) {
    const Way &one = ways_[slot], &two = ways_[other];
    if (one.carried_by != kNoPart && one.carried_by == two.carried_by) return;
    const BodyShapeData &shape = bodies_.slots[slot].shape.data(), &other_shape = bodies_.slots[other].shape.data();
    const double from = std::max(one.from, two.from), to = std::min(one.to, two.to);
    if (!(from < to)) return;
    const RigidMotion motion = between(one, from, to), other_motion = between(two, from, to);
    const double nearer = length(motion.path - other_motion.path) + length(motion.turn) * shape.reach +
                          length(other_motion.turn) * other_shape.reach;
    if (nearer <= kSlowShare * std::min(shape.thinnest, other_shape.thinnest)) return;
    const SetPairHit hit = cast(cores_of(slot, cores_), motion, cores_of(other, other_cores_), other_motion);
    if (!hit.touched()) return;
    if (hit.status == Status::kInitialOverlap) {
        if (at_start == Overlap::kPassed) {
            overlapping_.emplace_back(slot, other);
            return;
        }
        const bool is_pushed = one.carried_by != kNoPart || two.carried_by != kNoPart;
        if (!is_pushed && std::binary_search(overlapping_.begin(), overlapping_.end(), std::pair(slot, other))) return;
    }
    // Whether they come nearer there by more than rounding: along the normal, in the time that is left.
    const auto moved_at = [&](const RigidMotion& of) {
        return of.path + cross(of.turn, hit.point - (of.position + of.path * hit.fraction));
    };
    if (dot(moved_at(motion) - moved_at(other_motion), hit.normal) > -kDistanceRounding) return;
    touches_.push(
        {from + hit.fraction * (to - from), slot, other, one.piece, two.piece, kNoPart, hit.point, hit.normal, false});
}

/// All that a body comes to meet, on a new piece of its way.
void BodySweep::find_touches(std::uint32_t slot) {
    find_world_touch(slot);
    find_part_touch(slot);
    const Vec3 centre = ways_[slot].motion.position;
    const double reach = reach_of(slot);
    for (std::uint32_t other = 0; other < ways_.size(); ++other) {
        if (other == slot || !ways_[other].is_there) continue;
        const Vec3 apart = ways_[other].motion.position - centre;
        const double near = reach + reach_of(other);
        if (dot(apart, apart) > near * near || !(bodies_.slots[slot].mask & bodies_.slots[other].mask)) continue;
        find_pair_touch(std::min(slot, other), std::max(slot, other), Overlap::kMeets);
    }
}

void BodySweep::wake(std::uint32_t slot) {
    woken_ += wake_island(bodies_, slot);
    for (std::uint32_t k = 0; k < ways_.size(); ++k) {
        const Body& body = bodies_.slots[k];
        if (!ways_[k].is_there || body.asleep || movers_of_slots_[k] != kFixed) continue;
        movers_of_slots_[k] = std::uint32_t(movers_.size());
        movers_.push_back(make_mover(body, k));
    }
}

/// Where it is then.
Mover& BodySweep::mover_at(std::uint32_t slot, double at) {
    const RigidMotion rest = between(ways_[slot], at, ways_[slot].to);
    Mover& mover = movers_[movers_of_slots_[slot]];
    mover.put_at(rest.position, rest.rotation);
    if (ways_[slot].piece == 0) turn_as_swept(mover, rest.turn);
    return mover;
}

/// From there, with the velocities that it has now.
/// @param part  that it has met; it takes along what has met enough
void BodySweep::go_on(std::uint32_t slot, double at, bool stops, std::uint32_t part) {
    Way& way = ways_[slot];
    const Mover& mover = movers_[movers_of_slots_[slot]];
    const double left = rules_.seconds * (1 - at);
    way.motion = {mover.position, mover.rotation, {}, {}};
    way.from = at;
    way.to = 1;
    way.carried_by = kNoPart;
    if (way.met > 2 * rules_.max_bounces + kMostCarries) {
        way.ended = true;
        way.crushed = way.pushed_by != kNoPart;
    }
    if (!way.ended && (stops || way.met > rules_.max_bounces)) {
        if (part != kNoPart) take_along(slot, part, at);
    } else if (!way.ended) {
        way.motion.path = mover.velocity * left;
        way.motion.turn = mover.spin * left;
        if (const double angle = length(way.motion.turn); angle > kMaxTurn) way.motion.turn *= kMaxTurn / angle;
    }
    ++way.piece;
}

void BodySweep::take_along(std::uint32_t slot, std::uint32_t part, double at) {
    Way& way = ways_[slot];
    const Mover& mover = movers_[movers_of_slots_[slot]];
    const StepParts::Carried carried = parts_.carried(part, mover.position, mover.rotation, at);
    way.carried_by = part;
    way.motion = carried.motion;
    way.from = at;
    way.to = carried.to;
    if (way.to < 1) touches_.push({way.to, slot, kFixed, way.piece + 1, 0, kNoPart, {}, {}, true});
}

/// The next straight piece of an arc.
void BodySweep::carry_on(std::uint32_t slot, double at) {
    mover_at(slot, at);
    take_along(slot, ways_[slot].carried_by, at);
    ++ways_[slot].piece;
    find_touches(slot);
}

void BodySweep::hold_if_stopped(std::uint32_t slot, bool by_level) {
    Way& way = ways_[slot];
    const bool stopped = way.carried_by == kNoPart && way.motion.path == Vec3{} && way.motion.turn == Vec3{};
    way.held = way.held || (stopped && by_level);
}

/// The level, or a part.
void BodySweep::touch_fixed(const Touching& it, TouchTerms terms) {
    Way& way = ways_[it.slot];
    const bool is_between = way.carried_by != kNoPart;
    if (it.part != kNoPart) {
        terms.surface = parts_[it.part].velocity_of(it.point, it.at * rules_.seconds);
        way.pushed_by = it.part;
        way.met_others = true;
    } else {
        way.met_level = true;
    }
    const bool nearer = respond(mover_at(it.slot, it.at), nullptr, it.point, it.normal, terms);
    if (is_between) way.ended = way.crushed = true;
    go_on(it.slot, it.at, !nearer, it.part);
    hold_if_stopped(it.slot, way.met_level);
    if (!way.ended) find_touches(it.slot);
}

/// What the level holds gives way no more than it does.
/// @param normal  away from what is held
void BodySweep::touch_held(const Touching& it, std::uint32_t slot, const Vec3& normal, const TouchTerms& terms) {
    ++ways_[slot].met;
    const bool nearer = respond(mover_at(slot, it.at), nullptr, it.point, normal, terms);
    go_on(slot, it.at, !nearer, kNoPart);
    hold_if_stopped(slot, true);
    find_touches(slot);
}

/// What a part takes along pushes others as the part does, however heavy they are, and goes on with the part.
/// @param normal  toward the other
void BodySweep::touch_carried(const Touching& it, std::uint32_t carried, std::uint32_t slot, const Vec3& normal,
                              TouchTerms terms) {
    Way &of_carried = ways_[carried], &way = ways_[slot];
    const std::uint32_t part = of_carried.carried_by;
    const Body &pushing = bodies_.slots[carried], &pushed = bodies_.slots[slot];
    terms.restitution = std::max(pushing.restitution, pushed.restitution);
    terms.friction = std::sqrt(pushing.friction * pushed.friction);
    terms.surface = parts_[part].velocity_of(it.point, it.at * rules_.seconds);
    Mover& mover = mover_at(carried, it.at);
    if (way.ended) {
        of_carried.ended = of_carried.crushed = true;
        of_carried.motion = {mover.position, mover.rotation, {}, {}};
        of_carried.from = it.at;
        of_carried.to = 1;
    } else {
        ++way.met;
        way.pushed_by = part;
        const bool nearer = respond(mover_at(slot, it.at), nullptr, it.point, normal, terms);
        go_on(slot, it.at, !nearer, part);
        take_along(carried, part, it.at);
    }
    ++of_carried.piece;
    for (const std::uint32_t next : {carried, slot})
        if (!ways_[next].ended) find_touches(next);
}

void BodySweep::touch(const Touching& it) {
    if (it.is_turn) return carry_on(it.slot, it.at);
    const Body& body = bodies_.slots[it.slot];
    TouchTerms terms{body.restitution, std::sqrt(body.friction * rules_.friction), rules_.bounce_speed};
    ++bounces_;
    if (it.other == kFixed) {
        ++ways_[it.slot].met;
        return touch_fixed(it, terms);
    }
    for (const std::uint32_t slot : {it.slot, it.other})
        if (movers_of_slots_[slot] == kFixed) wake(slot);
    ways_[it.slot].met_others = ways_[it.other].met_others = true;
    met_pairs_.emplace_back(it.slot, it.other);
    if (ways_[it.slot].carried_by != kNoPart && ways_[it.other].carried_by == kNoPart)
        return touch_carried(it, it.slot, it.other, it.normal * -1.0, terms);
    if (ways_[it.other].carried_by != kNoPart && ways_[it.slot].carried_by == kNoPart)
        return touch_carried(it, it.other, it.slot, it.normal, terms);
    const Body& other = bodies_.slots[it.other];
    terms.restitution = std::max(body.restitution, other.restitution);
    terms.friction = std::sqrt(body.friction * other.friction);
    if (ways_[it.other].held && !ways_[it.slot].held) return touch_held(it, it.slot, it.normal, terms);
    if (ways_[it.slot].held && !ways_[it.other].held) return touch_held(it, it.other, it.normal * -1.0, terms);
    ++ways_[it.slot].met;
    ++ways_[it.other].met;
    Mover &one = mover_at(it.slot, it.at), &two = mover_at(it.other, it.at);
    const bool nearer = respond(one, &two, it.point, it.normal, terms);
    for (const std::uint32_t slot : {it.slot, it.other}) go_on(slot, it.at, !nearer, kNoPart);
    for (const std::uint32_t slot : {it.slot, it.other}) hold_if_stopped(slot, ways_[slot].met_level);
    for (const std::uint32_t slot : {it.slot, it.other}) find_touches(slot);
}

}  // namespace firma
