// SPDX-License-Identifier: MIT
// A projectile on its way through panes and solid: of the level, and of parts where they are at that time.
//
// All places are in the world; what is asked of a part is asked in its frame. A part that lies flush with the level, or
// with another part, or reaches into it, leaves no air between: what comes out of one solid may be in the next at once.
// Of two that hold the same place the one counts in which the projectile is already.
#include <algorithm>
#include <cmath>

#include "body/shot_flight.h"

namespace firma {
namespace {

/// Metres: the place where a path goes into solid is where the cast met it, within this.
constexpr double kSameEntry = 1e-6;
/// A part that turns is met kPartTouch early, as far along the path as this sine has it at most.
constexpr double kFlattestEntry = 1e-3;

double energy_seen(const Projectile& it, const ShotSolid& solid) {
    const Vec3 velocity = solid.seen(it.velocity);
    return 0.5 * it.mass * dot(velocity, velocity);
}

/// Metres along the path that are so far from a face.
double clearance_along(const Vec3& way, const Vec3& normal, double clearance, double longest) {
    const double sine = std::fabs(dot(way, normal));
    return sine * longest > clearance ? clearance / sine : longest;
}

}  // namespace

void ShotFlight::pass_pane(const Met& met) {
    const double energy = energy_seen(*it_, met.solid), left = energy - options_.pane_energy;
    const Vec3 after = left > 0 ? met.solid.seen(it_->velocity) * std::sqrt(left / energy) : Vec3{};
    ShotEvent event = event_of(met, ShotEventKind::kPassed);
    if (!(length(after) >= options_.stop_speed)) return stop(event, met.solid);
    tell(event, met.solid, after);
    const double to_pane = dot(met.impact.point - it_->position, met.way);
    const double clearance = clearance_along(met.way, met.impact.normal, kClearance, kLongestClearance);
    if (goes_on_behind(met, to_pane, clearance)) return;
    enter(met);  // solid lies right behind it
}

void ShotFlight::enter(const Met& met) {
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = false;
    options.start = Where::kAir;
    const Vec3 end = on_flight_grid(it_->position + met.way * (options_.max_thickness + 2 * kLongestClearance));
    pierce_solid(met.solid, it_->position, end, options);
    const PierceSpan* span = solid_at(met);
    ShotEvent entered = event_of(met, ShotEventKind::kEntered), left = entered;
    if (!span && met.solid.of_part() && parts_->turns_in_step(met.solid.part)) {  // it passes by within kPartTouch
        if (!goes_on_behind(met, dot(met.impact.point - met.before, met.way), 4 * kPartTouch)) stop(left, met.solid);
        return;
    }
    left.normal = {};
    entered.portal = left.portal = {};
    if (span) {
        entered.point = left.point = span->in.point;
        entered.face = span->in.face;
        entered.normal = span->in.normal;
        entered.material = span->in.material;
        entered.matter = found_.matters[span->first_matter].matter;
    }
    tell(entered, met.solid, met.solid.seen(it_->velocity));
    if (span && !go_through(*span, met, entered, left)) return stop(left, met.solid);
    leave(met, span, left);
}

/// Through what it is in after it came out of something else, one solid after the other.
/// @param left  the part that it came out of; kNoPart: the level
void ShotFlight::go_on_inside(std::uint32_t left) {
    while (it_->state == ProjectileState::kFlying) {
        std::optional<ShotSolid> next;
        if (left != kNoPart && is_in_solid({&world_}, it_->position))
            next = ShotSolid{&world_};
        else
            next = part_around(it_->position, left);
        if (!next) return;
        enter_inside(*next);
        left = next->part;
    }
}

/// From a place inside on, along its velocity as the solid sees it.
void ShotFlight::enter_inside(const ShotSolid& solid) {
    ++impacts_;
    ++impacts_of_all_;
    const Vec3 velocity = solid.seen(it_->velocity);
    const double speed = length(velocity);
    Met met;
    met.any = met.inside = true;
    met.time = time_;
    met.solid = solid;
    met.before = met.impact.point = it_->position;
    met.way = speed > 0 ? velocity * (1 / speed) : Vec3{0, 0, -1};
    met.impact.normal = -met.way;
    met.matter = matter_at(*solid.world, solid.in(it_->position));
    ShotEvent entered = event_of(met, ShotEventKind::kEntered), left = entered;
    if (impacts_ >= options_.max_impacts || !(speed > 0)) return stop(left, solid);
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = false;
    options.start = Where::kSolid;
    const Vec3 end = on_flight_grid(it_->position + met.way * (options_.max_thickness + 2 * kLongestClearance));
    pierce_solid(solid, it_->position, end, options);
    if (found_.spans.empty() || !found_.spans.front().starts_inside) return;  // it lies on the surface
    const PierceSpan& span = found_.spans.front();
    ShotImpact asked = met.impact;
    asked.projectile = index_;
    asked.velocity = it_->velocity;
    asked.mass = it_->mass;
    asked.part = solid.part;
    asked.surface = solid.surface;
    entered.matter = left.matter = found_.matters[span.first_matter].matter;
    if (!(terms_of(asked, solid, entered.matter).resistance < kUnpierced)) return stop(left, solid);
    left.normal = {};
    tell(entered, solid, velocity);
    if (!go_through(span, met, entered, left)) return stop(left, solid);
    leave(met, &span, left);
}

/// As pierce(), between two places in the world.
void ShotFlight::pierce_solid(const ShotSolid& solid, const Vec3& from, const Vec3& to, const PierceOptions& options) {
    const Vec3 start = solid.in(from);
    pierce(*solid.world, {start, solid.in(to)-start}, found_, options);
    if (!solid.of_part()) return;
    for (PierceSpan& span : found_.spans) {
        for (PierceEnd* end : {&span.in, &span.out}) {
            end->point = solid.out(end->point);
            end->normal = solid.direction_out(end->normal);
        }
    }
}

/// The stretch that begins where the cast met a face; null where it has no thickness.
const PierceSpan* ShotFlight::solid_at(const Met& met) const {
    const double reached = dot(met.impact.point - it_->position, met.way);
    double farthest = reached + kSameEntry + kLongestClearance;
    if (met.solid.of_part() && parts_->turns_in_step(met.solid.part))
        farthest += 2 * kPartTouch / std::max(met.sine, kFlattestEntry);
    for (const PierceSpan& span : found_.spans)
        if (dot(span.in.point - it_->position, met.way) <= farthest) return &span;
    return nullptr;
}

/// Matter by matter, as far as the energy lasts.
/// @param left  gets what it has behind it, its velocity as the solid sees it
/// @return whether it comes out
bool ShotFlight::go_through(const PierceSpan& span, const Met& met, ShotEvent& entered, ShotEvent& left) {
    ShotImpact impact;
    impact.projectile = index_;
    impact.point = entered.point;
    impact.normal = entered.normal;
    impact.velocity = it_->velocity;
    impact.mass = it_->mass;
    impact.face = entered.face;
    impact.material = entered.material;
    impact.part = met.solid.part;
    impact.surface = met.solid.surface;
    const double energy = energy_seen(*it_, met.solid);
    const Vec3 way = (span.out.point - span.in.point) * (1 / span.thickness);
    left.first_matter = std::uint32_t(events_.matters.size());
    double rest = energy;
    for (std::uint32_t k = span.first_matter; k < span.first_matter + span.matter_count; ++k) {
        MatterLength part = found_.matters[k];
        const double resistance = terms_of(impact, met.solid, part.matter).resistance;
        const double takes = resistance * part.length;
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
    const Vec3 after = energy > 0 ? met.solid.seen(it_->velocity) * std::sqrt(rest / energy) : Vec3{};
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
    const Vec3 after = span ? left.velocity : met.solid.seen(it_->velocity);
    const double at = dot((span ? span->out.point : met.impact.point) - met.before, met.way);
    double clearance =
        clearance_along(met.way, span ? span->out.normal : met.impact.normal, kClearance, kLongestClearance);
    if (span)
        for (const PierceSpan* next = span + 1; next < found_.spans.data() + found_.spans.size(); ++next)
            clearance = std::min(clearance, 0.5 * length(next->in.point - span->out.point));
    if (!goes_on_behind(met, at, clearance)) return stop(left, met.solid);
    tell(left, met.solid, after);
}

/// Puts it on its path, some way after a place on it, where that is in the air.
/// @param at  metres along the path
bool ShotFlight::goes_on_behind(const Met& met, double at, double clearance) {
    PierceOptions options;
    options.mask = it_->mask;
    options.panes = options.matters = false;
    options.start = met.inside ? Where::kSolid : Where::kAir;
    for (const double share : {1.0, 0.25}) {
        const Vec3 place = on_flight_grid(met.before + met.way * (at + clearance * share));
        pierce_solid(met.solid, met.before, place, options);
        if (!found_.spans.empty() && found_.spans.back().ends_inside) continue;
        it_->position = place;
        return true;
    }
    return false;
}

}  // namespace firma
