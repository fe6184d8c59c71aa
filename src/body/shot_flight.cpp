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
/// Metres along the normal: so far from a face a projectile goes on.
constexpr double kClearance = 1e-5;
/// Metres along the path: no farther is looked for a place at that distance where the path grazes the face.
constexpr double kLongestClearance = 1e-3;
/// Metres: the place where a path goes into solid is where the cast met it, within this.
constexpr double kSameEntry = 1e-6;
constexpr double kQuarterTurn = 1.5707963267948966;
/// Metres behind a face: as matter_of() looks.
constexpr double kBehindFace = 1.0 / 1024;

bool within_reach(const Vec3& point) {
    return max_abs(point) <= kFlightReach;
}

double energy_of(const Projectile& it) {
    return 0.5 * it.mass * dot(it.velocity, it.velocity);
}

/// Metres along the path that are so far from a face.
double clearance_along(const Vec3& way, const Vec3& normal) {
    const double sine = std::fabs(dot(way, normal));
    return sine * kLongestClearance > kClearance ? kClearance / sine : kLongestClearance;
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
        if (is_in_solid(it_->position)) {
            ShotEvent event;
            event.point = it_->position;
            event.matter = matter_at(world_, it_->position);
            return stop(event);
        }
    }
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
            Met met = first_on(path, velocity + options_.gravity * from, options_.gravity * (to - from));
            ++chords_;
            met_any = met.any;
            if (met.any) {
                time_ = began + from + (to - from) * met.fraction;
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

/// @param velocity, gain  at the start of the chord, and what is added until its end
ShotFlight::Met ShotFlight::first_on(const Vec3& path, const Vec3& velocity, const Vec3& gain) {
    Met met;
    CastOptions options;
    options.mask = it_->mask;
    options.contact_offset = kClearance;
    const Ray ray{it_->position, path};
    const Hit hit = cast(world_, ray, options);
    double safe = hit.safe_fraction;
    met.any = hit.touched();
    if (met.any) {
        met.fraction = hit.fraction;
        met.impact.point = hit.centre;
        met.impact.normal = hit.normal;
        met.impact.face = hit.face;
        met.impact.portal = hit.portal;
        met.impact.material = hit.material;
        const std::optional<FaceInfo> face = world_.face_info(hit.face);
        met.impact.pane = !face || !face->solid;
        if (face) met.matter = matter_behind(*face, hit.centre);
    }
    if (targets_) {
        const BodyMet body = targets_->first(ray, it_->mask);
        if (body.fraction < (met.any ? met.fraction : 1.5)) {
            met = {};
            met.any = true;
            met.fraction = body.fraction;
            met.impact.point = body.point;
            met.impact.normal = body.normal;
            met.impact.body = {body.slot, bodies_->slots[body.slot].use};
            safe = std::max(0.0, body.fraction - kClearance / length(path));
        }
    }
    if (!met.any) return met;
    met.impact.projectile = index_;
    met.impact.velocity = velocity + gain * met.fraction;
    met.impact.mass = it_->mass;
    const double speed = length(met.impact.velocity);
    met.sine = speed > 0 ? -dot(met.impact.normal, met.impact.velocity) / speed : 0;
    met.way = path * (1 / length(path));
    // The way there is free, but the place, once it is on the grid, may lie beside it.
    met.before = on_flight_grid(it_->position + path * safe);
    if (cast_any(world_, Ray{it_->position, met.before - it_->position}, options) != Status::kMiss)
        met.before = it_->position;
    return met;
}

void ShotFlight::meet(Met& met) {
    ++impacts_;
    ++impacts_of_all_;
    it_->position = met.before;
    it_->velocity = met.impact.velocity;
    const bool body = met.impact.body.slot != ~0u;
    const ShotTerms terms = terms_of(met.impact, met.matter);
    const bool flat = terms.ricochet_below >= kQuarterTurn || met.sine < sine_cosine(terms.ricochet_below).sine;
    if (impacts_ < options_.max_impacts) {
        if (flat) return ricochet(met, terms);
        if (met.impact.pane) return pass_pane(met);
        if (!body && terms.resistance < kUnpierced) return enter(met);
    }
    ShotEvent event = event_of(met, ShotEventKind::kStopped);
    stop(event);
}

void ShotFlight::ricochet(const Met& met, const ShotTerms& terms) {
    const Vec3 &normal = met.impact.normal, &velocity = it_->velocity;
    const double toward = std::min(0.0, dot(velocity, normal));
    const Vec3 along = velocity - normal * toward;
    const double change = -(1 + terms.restitution) * toward, slides = length(along);
    const double kept = slides > 0 ? std::max(0.0, 1 - terms.friction * change / slides) : 0;
    const Vec3 after = along * kept - normal * (terms.restitution * toward);
    const bool goes_on = length(after) >= options_.stop_speed;
    ShotEvent event = event_of(met, goes_on ? ShotEventKind::kRicochet : ShotEventKind::kStopped);
    if (goes_on)
        tell(event, after);
    else
        stop(event);
}

void ShotFlight::pass_pane(const Met& met) {
    const double energy = energy_of(*it_), left = energy - options_.pane_energy;
    const Vec3 after = left > 0 ? it_->velocity * std::sqrt(left / energy) : Vec3{};
    ShotEvent event = event_of(met, ShotEventKind::kPassed);
    if (!(length(after) >= options_.stop_speed)) return stop(event);
    tell(event, after);
    const double to_pane = dot(met.impact.point - it_->position, met.way);
    if (goes_on_behind(it_->position, met.way, to_pane, clearance_along(met.way, met.impact.normal))) return;
    enter(met);  // solid lies right behind it
}

void ShotFlight::enter(const Met& met) {
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = false;
    options.start = Where::kAir;
    const Vec3 end = on_flight_grid(it_->position + met.way * (options_.max_thickness + 2 * kLongestClearance));
    pierce(world_, {it_->position, end - it_->position}, found_, options);
    const PierceSpan* span = solid_at(met);
    ShotEvent entered = event_of(met, ShotEventKind::kEntered), left = entered;
    left.normal = {};
    entered.portal = left.portal = {};
    if (span) {
        entered.point = left.point = span->in.point;
        entered.face = span->in.face;
        entered.normal = span->in.normal;
        entered.material = span->in.material;
        entered.matter = found_.matters[span->first_matter].matter;
    }
    tell(entered, it_->velocity);
    if (span && !go_through(*span, entered, left)) return stop(left);
    leave(met, span, left);
}

/// The stretch that begins where the cast met a face; null where it has no thickness.
const PierceSpan* ShotFlight::solid_at(const Met& met) const {
    const double reached = dot(met.impact.point - it_->position, met.way);
    for (const PierceSpan& span : found_.spans)
        if (dot(span.in.point - it_->position, met.way) <= reached + kSameEntry + kLongestClearance) return &span;
    return nullptr;
}

/// Matter by matter, as far as the energy lasts.
/// @return whether it comes out
bool ShotFlight::go_through(const PierceSpan& span, ShotEvent& entered, ShotEvent& left) {
    ShotImpact impact;
    impact.projectile = index_;
    impact.point = entered.point;
    impact.normal = entered.normal;
    impact.velocity = it_->velocity;
    impact.mass = it_->mass;
    impact.face = entered.face;
    impact.material = entered.material;
    const double energy = energy_of(*it_);
    const Vec3 way = (span.out.point - span.in.point) * (1 / span.thickness);
    left.first_matter = std::uint32_t(events_.matters.size());
    double rest = energy;
    for (std::uint32_t k = span.first_matter; k < span.first_matter + span.matter_count; ++k) {
        MatterLength part = found_.matters[k];
        const double resistance = terms_of(impact, part.matter).resistance, takes = resistance * part.length;
        const bool stays = !(takes < rest);
        left.matter = part.matter;
        if (stays) part.length = rest / resistance;
        rest = stays ? 0 : rest - takes;
        part.from = left.thickness / span.thickness;
        left.thickness += part.length;
        part.to = left.thickness / span.thickness;
        events_.matters.push_back(part);
        ++left.matter_count;
        if (stays) break;
    }
    it_->position = left.point = span.in.point + way * left.thickness;
    const Vec3 after = energy > 0 ? it_->velocity * std::sqrt(rest / energy) : Vec3{};
    if (span.ends_inside || !(rest > 0) || !(length(after) >= options_.stop_speed)) return false;
    left.normal = span.out.normal;
    left.face = span.out.face;
    left.material = span.out.material;
    left.point = span.out.point;
    left.velocity = after;
    return true;
}

/// @param span  null: it has no thickness
void ShotFlight::leave(const Met& met, const PierceSpan* span, ShotEvent& left) {
    left.kind = ShotEventKind::kLeft;
    const Vec3 after = span ? left.velocity : it_->velocity;
    const double at = dot((span ? span->out.point : met.impact.point) - met.before, met.way);
    double clearance = clearance_along(met.way, span ? span->out.normal : met.impact.normal);
    if (span)
        for (const PierceSpan* next = span + 1; next < found_.spans.data() + found_.spans.size(); ++next)
            clearance = std::min(clearance, 0.5 * length(next->in.point - span->out.point));
    if (!goes_on_behind(met.before, met.way, at, clearance)) return stop(left);
    tell(left, after);
}

/// Puts it on a path, some way after a place on it, where that is in the air.
/// @param from  in the air
/// @param at    metres along the path
bool ShotFlight::goes_on_behind(const Vec3& from, const Vec3& way, double at, double clearance) {
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = options.matters = false;
    options.start = Where::kAir;
    for (const double share : {1.0, 0.25}) {
        const Vec3 place = on_flight_grid(from + way * (at + clearance * share));
        pierce(world_, {from, place - from}, found_, options);
        if (!found_.spans.empty() && found_.spans.back().ends_inside) continue;
        it_->position = place;
        return true;
    }
    return false;
}

ShotTerms ShotFlight::terms_of(const ShotImpact& impact, std::uint32_t matter) const {
    if (options_.rule) {
        const ShotTerms terms = options_.rule(impact, matter, options_.user);
        return is_usable(terms) ? terms : ShotTerms{0, 0, 0, kUnpierced};
    }
    if (impact.body.slot != ~0u) return options_.bodies;
    return matter < options_.matters.size() ? options_.matters[matter] : options_.other;
}

/// matter_of() without its outline: of what a cut left, what is behind the place that was met.
std::uint32_t ShotFlight::matter_behind(const FaceInfo& face, const Vec3& point) const {
    const MatterPieces* pieces = world_.data().matters.get();
    if (!pieces) return 0;
    return face.source_edit == 0 ? pieces->of_source(face.source)
                                 : matter_at(world_, point - face.normal * kBehindFace);
}

bool ShotFlight::is_in_solid(const Vec3& point) {
    if (locate(world_, point).where != Where::kSolid) return false;
    if (it_->mask == ~0u) return true;
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = options.matters = false;
    options.start = Where::kSolid;
    return pierce(world_, {point, kRayWays[0] * (4 * kWorldRim)}, found_, options) == Status::kInitialOverlap;
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

void ShotFlight::tell(ShotEvent& event, const Vec3& velocity_after) {
    event.projectile = index_;
    event.number = number_++;
    event.time = time_;
    event.velocity = velocity_after;
    event.impulse = (it_->velocity - velocity_after) * it_->mass;
    event.energy = energy_of(*it_);
    it_->velocity = velocity_after;
    event.energy -= energy_of(*it_);
    events_.events.push_back(event);
}

void ShotFlight::stop(ShotEvent& event) {
    event.kind = ShotEventKind::kStopped;
    it_->state = ProjectileState::kStopped;
    tell(event, {});
}

void ShotFlight::expire() {
    ShotEvent event;
    event.kind = ShotEventKind::kExpired;
    event.point = it_->position;
    it_->state = ProjectileState::kExpired;
    tell(event, it_->velocity);
}

}  // namespace firma
