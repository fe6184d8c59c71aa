// SPDX-License-Identifier: MIT
// One projectile on its way: chords of its parabola as rays, and what it does where one meets something.
//
// Of x(t) = x + v t + g t^2 / 2 the chord between two times t0 and t1 differs by g (t - t0) (t1 - t) / 2 at each time
// between, so by |g| h^2 / 8 at most, with h = t1 - t0.
//
// A place counts as in the air when a ray from another such place leads there and meets nothing, or when what it goes
// through ends before. Rays are exact, and so are chords: places lie on a grid whose differences double holds.
#include "body/shot_flight.h"

#include <algorithm>
#include <cmath>

#include "cast/side_met.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/turn.h"
#include "solid/matter_pieces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// With coordinates within kFlightReach = 2^14 m these have 52 bits.
constexpr double kFlightSteps = 0x1p38;
constexpr double kQuarterTurn = 1.5707963267948966;
/// Metres behind a face: as matter_of() looks.
constexpr double kBehindFace = 1.0 / 1024;

bool within_reach(const Vec3& point) {
    return max_abs(point) <= kFlightReach;
}

double energy_at(double mass, const Vec3& velocity) {
    return 0.5 * mass * dot(velocity, velocity);
}

/// Which of the level's matters one of a part's is, by its name; beyond all where the level has none.
std::uint32_t matter_of_level(const World& level, const World& part, std::uint32_t matter) {
    const MatterTable &own = matters_of(part), &table = matters_of(level);
    if (matter >= own.matters.size()) return ~0u;
    const std::string& name = own.matters[matter].name;
    if (matter < table.matters.size() && table.matters[matter].name == name) return matter;
    return matter_named(table, name).value_or(~0u);
}

}  // namespace

Vec3 on_flight_grid(const Vec3& point) {
    Vec3 rounded;
    for (int axis = 0; axis < 3; ++axis) rounded[axis] = std::floor(point[axis] * kFlightSteps + 0.5) / kFlightSteps;
    return rounded;
}

double chords_for(double seconds, const FlyOptions& options) {
    return 1 + std::floor(seconds * std::sqrt(length(options.gravity) / (8 * options.max_bow)));
}

bool is_usable(const ShotTerms& terms) {
    return terms.ricochet_below >= 0 && is_finite(terms.ricochet_below) && terms.restitution >= 0 &&
           terms.restitution <= 1 && terms.friction >= 0 && is_finite(terms.friction) && terms.resistance >= 0 &&
           is_finite(terms.resistance);
}

void ShotFlight::fly(Projectile& projectile, std::uint32_t index, double seconds) {
    it_ = &projectile;
    index_ = index;
    number_ = 0;
    impacts_ = 0;
    time_ = 0;
    const double left = options_.max_age - it_->age;
    if (!(left > 0) || !within_reach(it_->position)) return expire();
    it_->position = on_flight_grid(it_->position);
    if (it_->world_hash != world_hash_) {
        it_->world_hash = world_hash_;
        if (stops_inside({&world_})) return;
    }
    if (parts_)
        if (const auto part = part_around(it_->position, kNoPart); part && stops_inside(*part)) return;
    fly_on(std::min(seconds, left));
    it_->age += time_;
    if (it_->state == ProjectileState::kFlying && left <= seconds) expire();
}

/// Parabola by parabola: from impact to impact.
void ShotFlight::fly_on(double seconds) {
    while (it_->state == ProjectileState::kFlying && time_ < seconds) {
        const double began = time_, rest = seconds - began;
        const Vec3 start = it_->position, velocity = it_->velocity;
        const int count = int(chords_for(rest, options_));
        bool met_any = false;
        for (int k = 0; k < count && !met_any; ++k) {
            const double from = rest * k / count, to = rest * (k + 1) / count;
            const Vec3 target = on_flight_grid(start + (velocity + options_.gravity * (0.5 * to)) * to);
            const Vec3 path = target - it_->position;
            const Met met =
                first_on({path, velocity + options_.gravity * from, options_.gravity * (to - from), began, from, to});
            ++chords_;
            met_any = met.any;
            if (met.any) {
                time_ = met.time;
                meet(met);
            } else {
                it_->position = target;
                if (within_reach(target)) continue;
                time_ = began + to;
                return expire();
            }
        }
        if (met_any) continue;
        it_->velocity = velocity + options_.gravity * rest;
        time_ = seconds;
    }
}

ShotFlight::Met ShotFlight::first_on(const Chord& chord) {
    Met met;
    CastOptions options;
    options.mask = it_->mask;
    options.contact_offset = kClearance;
    const Ray ray{it_->position, chord.path};
    const Hit hit = cast(world_, ray, options);
    double safe = hit.safe_fraction;
    met.solid.world = &world_;
    if (hit.touched()) put_face(met, hit);
    if (parts_) {
        const PartHit of_part = parts_->first(ray, chord.began + chord.from, chord.began + chord.to, options);
        if (of_part.touched() && !(met.any && met.fraction <= of_part.fraction)) {
            const double time = chord.began + chord.from + (chord.to - chord.from) * of_part.fraction;
            met = {};
            met.solid = part_at(of_part.part, time, of_part.centre);
            put_face(met, of_part);
            safe = of_part.safe_fraction;
        }
    }
    if (targets_) {
        const BodyMet body = targets_->first(ray, it_->mask);
        if (body.fraction < (met.any ? met.fraction : 1.5)) {
            met = {};
            met.solid.world = &world_;
            met.any = true;
            met.fraction = body.fraction;
            met.impact.point = body.point;
            met.impact.normal = body.normal;
            met.impact.body = {body.slot, bodies_->slots[body.slot].use};
            safe = std::max(0.0, body.fraction - kClearance / length(chord.path));
        }
    }
    if (!met.any) return met;
    met.time = chord.began + chord.from + (chord.to - chord.from) * met.fraction;
    met.impact.projectile = index_;
    met.impact.velocity = chord.velocity + chord.gain * met.fraction;
    met.impact.mass = it_->mass;
    met.impact.part = met.solid.part;
    met.impact.surface = met.solid.surface;
    const Vec3 velocity = met.solid.seen(met.impact.velocity);
    const double speed = length(velocity);
    met.sine = speed > 0 ? -dot(met.impact.normal, velocity) / speed : 0;
    if (met.solid.of_part())
        come_before_part(met, chord, safe);
    else
        come_before(met, chord, safe);
    return met;
}

void ShotFlight::put_face(Met& met, const Hit& hit) const {
    met.any = true;
    met.fraction = hit.fraction;
    met.impact.point = hit.centre;
    met.impact.normal = hit.normal;
    met.impact.face = hit.face;
    met.impact.portal = hit.portal;
    met.impact.material = hit.material;
    const std::optional<FaceInfo> face = met.solid.world->face_info(hit.face);
    met.impact.pane = !face || !face->solid;
    if (face) met.matter = matter_behind(met.solid, *face, hit.centre);
}

void ShotFlight::come_before(Met& met, const Chord& chord, double safe) const {
    met.way = chord.path * (1 / length(chord.path));
    // The way there is free, but the place, once it is on the grid, may lie beside it.
    met.before = on_flight_grid(it_->position + chord.path * safe);
    if (!is_free(met.before)) met.before = it_->position;
}

/// On the way that it came as the part sees it, which is free of the part; else along the normal.
void ShotFlight::come_before_part(Met& met, const Chord& chord, double safe) const {
    const Vec3 path = chord.path - met.solid.surface * (chord.to - chord.from);
    const double whole = length(path);
    met.way = whole > 0 ? path * (1 / whole) : -met.impact.normal;
    const double back = std::min(whole * (met.fraction - safe), kLongestClearance);
    met.before = on_flight_grid(met.impact.point - met.way * back);
    if (is_free(met.before)) return;
    met.before = on_flight_grid(met.impact.point + met.impact.normal * kClearance);
    if (is_free(met.before)) return;
    met.before = it_->position;
    met.crushed = true;
}

/// Whether the level lets it go straight to a place.
bool ShotFlight::is_free(const Vec3& place) const {
    CastOptions options;
    options.mask = it_->mask;
    options.contact_offset = kClearance;
    return cast_any(world_, Ray{it_->position, place - it_->position}, options) == Status::kMiss;
}

void ShotFlight::meet(const Met& met) {
    meet_first(met);
    if (parts_) go_on_inside(met.solid.part);
}

void ShotFlight::meet_first(const Met& met) {
    ++impacts_;
    ++impacts_of_all_;
    it_->position = met.before;
    it_->velocity = met.impact.velocity;
    const bool body = met.impact.body.slot != ~0u;
    const ShotTerms terms = terms_of(met.impact, met.solid, met.matter);
    const bool flat = terms.ricochet_below >= kQuarterTurn || met.sine < sine_cosine(terms.ricochet_below).sine;
    if (impacts_ < options_.max_impacts && !met.crushed) {
        if (flat) return ricochet(met, terms);
        if (met.impact.pane) return pass_pane(met);
        if (!body && terms.resistance < kUnpierced) return enter(met);
    }
    ShotEvent event = event_of(met, ShotEventKind::kStopped);
    stop(event, met.solid);
}

void ShotFlight::ricochet(const Met& met, const ShotTerms& terms) {
    const Vec3 &normal = met.impact.normal, velocity = met.solid.seen(it_->velocity);
    const double toward = std::min(0.0, dot(velocity, normal));
    const Vec3 along = velocity - normal * toward;
    const double change = -(1 + terms.restitution) * toward, slides = length(along);
    const double kept = slides > 0 ? std::max(0.0, 1 - terms.friction * change / slides) : 0;
    const Vec3 after = along * kept - normal * (terms.restitution * toward);
    const bool goes_on = length(after) >= options_.stop_speed && max_abs(met.solid.unseen(after)) <= kMaxFlightSpeed;
    ShotEvent event = event_of(met, goes_on ? ShotEventKind::kRicochet : ShotEventKind::kStopped);
    if (goes_on)
        tell(event, met.solid, after);
    else
        stop(event, met.solid);
}

ShotTerms ShotFlight::terms_of(const ShotImpact& impact, const ShotSolid& solid, std::uint32_t matter) const {
    if (options_.rule) {
        const ShotTerms terms = options_.rule(impact, matter, options_.user);
        return is_usable(terms) ? terms : ShotTerms{0, 0, 0, kUnpierced};
    }
    if (impact.body.slot != ~0u) return options_.bodies;
    if (solid.of_part()) matter = matter_of_level(world_, *solid.world, matter);
    return matter < options_.matters.size() ? options_.matters[matter] : options_.other;
}

/// matter_of() without its outline: of what a cut left, what is behind the place that was met.
std::uint32_t ShotFlight::matter_behind(const ShotSolid& solid, const FaceInfo& face, const Vec3& point) const {
    const MatterPieces* pieces = solid.world->data().matters.get();
    if (!pieces) return 0;
    return face.source_edit == 0 ? pieces->of_source(face.source)
                                 : matter_at(*solid.world, solid.in(point)-face.normal * kBehindFace);
}

bool ShotFlight::is_in_solid(const ShotSolid& solid, const Vec3& point) {
    const Vec3 at = solid.in(point);
    if (locate(*solid.world, at).where != Where::kSolid) return false;
    if (it_->mask == ~0u) return true;
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = options.matters = false;
    options.start = Where::kSolid;
    return pierce(*solid.world, {at, kRayWays[0] * (4 * kWorldRim)}, found_, options) == Status::kInitialOverlap;
}

ShotSolid ShotFlight::part_at(std::uint32_t part, double time, const Vec3& point) const {
    return {&(*parts_)[part].world(), part, parts_->frame(part, time), parts_->velocity(part, time, point)};
}

/// The part with the lowest index whose solid a place is in now.
std::optional<ShotSolid> ShotFlight::part_around(const Vec3& point, std::uint32_t left_out) {
    std::optional<ShotSolid> first;
    parts_->for_each_near(point, [&](std::uint32_t part) {
        if (part == left_out || (first && first->part < part) || !((*parts_)[part].mask & it_->mask)) return false;
        const ShotSolid solid = part_at(part, time_, point);
        if (is_in_solid(solid, point)) first = solid;
        return false;
    });
    return first;
}

/// One that the solid came to stops.
bool ShotFlight::stops_inside(const ShotSolid& solid) {
    if (!is_in_solid(solid, it_->position)) return false;
    ShotEvent event;
    event.point = it_->position;
    event.matter = matter_at(*solid.world, solid.in(it_->position));
    stop(event, solid);
    return true;
}

ShotEvent ShotFlight::event_of(const Met& met, ShotEventKind kind) const {
    ShotEvent event;
    event.kind = kind;
    event.point = met.impact.point;
    event.normal = met.impact.normal;
    event.face = met.impact.face;
    event.portal = met.impact.portal;
    event.body = met.impact.body;
    event.material = met.impact.material;
    event.matter = met.matter;
    return event;
}

/// @param velocity_after  as the solid sees it
void ShotFlight::tell(ShotEvent& event, const ShotSolid& solid, const Vec3& velocity_after) {
    const Vec3 before = it_->velocity, after = solid.unseen(velocity_after);
    event.projectile = index_;
    event.number = number_++;
    event.time = time_;
    event.velocity = after;
    event.impulse = (before - after) * it_->mass;
    event.energy = energy_at(it_->mass, solid.seen(before)) - energy_at(it_->mass, velocity_after);
    event.part = solid.part;
    if (solid.of_part()) event.in_part = solid.in(event.point);
    it_->velocity = after;
    events_.events.push_back(event);
}

void ShotFlight::stop(ShotEvent& event, const ShotSolid& solid) {
    event.kind = ShotEventKind::kStopped;
    it_->state = ProjectileState::kStopped;
    const Vec3 before = it_->velocity;
    tell(event, solid, {});
    it_->velocity = {};
    if (!solid.of_part()) return;
    ShotEvent& told = events_.events.back();  // in the part it stops where it is, not where it was met
    told.velocity = parts_->velocity(solid.part, time_, event.point);
    told.impulse = (before - told.velocity) * it_->mass;
    carry(solid);
}

/// What stopped at a part goes along with it until the step ends, where the level lets it.
void ShotFlight::carry(const ShotSolid& solid) {
    it_->world_hash = 0;  // if it is to fly again, it may be in the level's solid, as the part may be
    if (!parts_->moves(solid.part)) return;
    const PartFrame end = parts_->frame(solid.part, parts_->seconds());
    const Vec3 place = on_flight_grid(end.out(solid.in(it_->position)));
    if (!is_free(place)) return;
    it_->position = place;
    const Vec3 velocity = parts_->velocity(solid.part, parts_->seconds(), place);
    if (max_abs(velocity) <= kMaxFlightSpeed) it_->velocity = velocity;
}

void ShotFlight::expire() {
    ShotEvent event;
    event.kind = ShotEventKind::kExpired;
    event.point = it_->position;
    it_->state = ProjectileState::kExpired;
    tell(event, {}, it_->velocity);
}

}  // namespace firma
