// SPDX-License-Identifier: MIT
// Projectiles of a game in one tick.
//
// fly() knows no parts. So each is first cast at them along the chord of its tick; what meets one flies up to there
// alone, and ricochets or stops. After a ricochet off the level within the same tick, parts are met from the next on.
#include "game/game_shots.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/sort.h"
#include "body/shot_flight.h"
#include "firma/queries.h"
#include "firma/turn.h"

namespace firma {
namespace {

constexpr double kFastestShot = 0x1p20;  // metres a second: what fly() takes
constexpr double kStrongestPull = 1000;  // metres a second squared
constexpr double kLongestFuse = 3600;    // seconds
/// Metres along the normal: so far from a part a projectile goes on.
constexpr double kPartClearance = 1e-5;
constexpr double kRightAngle = 1.5707963267948966;

FlyOptions fly_options(const Weapon& weapon) {
    FlyOptions options;
    options.gravity = weapon.gravity;
    options.max_age = weapon.fuse;
    options.stop_speed = weapon.stop_speed;
    options.other = weapon.terms;
    options.bodies = weapon.bodies;
    options.pane_energy = weapon.pane_energy;
    return options;
}

/// Those of one weapon.
class WeaponFlight {
public:
    WeaponFlight(GameState& game, std::uint32_t number, double seconds, GameReport& report)
        : game_(game),
          number_(number),
          weapon_(game.shots[number].weapon),
          shots_(game.shots[number].projectiles),
          options_(fly_options(weapon_)),
          seconds_(seconds),
          report_(report) {}

    void run(std::vector<Bang>& bangs) {
        begin();
        fly_all();
        for (const MetPart& met : met_) fly_to_part(met);
        finish(bangs);
    }

private:
    /// A projectile that meets a part on its chord.
    struct MetPart {
        std::size_t index = 0;
        Projectile before;
        PartHit hit;
    };

    void begin() {
        ages_.resize(shots_.size());
        lay_.resize(shots_.size());
        times_.assign(shots_.size(), seconds_);
        for (std::size_t k = 0; k < shots_.size(); ++k) {
            Projectile& shot = shots_[k];
            ages_[k] = shot.age;
            lay_[k] = weapon_.lies && shot.state == ProjectileState::kStopped;
            if (lay_[k]) shot.state = ProjectileState::kFlying;  // what it lay on may be away
            if (game_.parts.empty() || shot.state != ProjectileState::kFlying) continue;
            const Vec3 chord = shot.velocity * seconds_ + weapon_.gravity * (0.5 * seconds_ * seconds_);
            CastOptions options;
            options.mask = shot.mask;
            const PartHit hit = cast(Scene{nothing_, game_.parts}, Ray{shot.position, chord}, options);
            if (!hit.touched()) continue;
            met_.push_back({k, shot, hit});
            shot.state = ProjectileState::kStopped;  // left out
        }
    }

    void fly_all() {
        ShotEvents events;
        const auto flown = fly(shots_, game_.world, seconds_, events, options_, &game_.bodies);
        if (!flown) return;  // fault_of_shots() was asked before
        for (const ShotEvent& event : events.events) tell(event);
    }

    void fly_to_part(const MetPart& met) {
        Projectile& shot = shots_[met.index];
        shot = met.before;
        const double seconds = met.hit.fraction * seconds_;
        bool undisturbed = true;
        if (seconds > 0) {
            ShotEvents events;
            static_cast<void>(fly({&shot, 1}, game_.world, seconds, events, options_, &game_.bodies));
            for (ShotEvent& event : events.events) {
                event.projectile = std::uint32_t(met.index);
                tell(event);
            }
            undisturbed = events.events.empty();
        }
        if (undisturbed && shot.state == ProjectileState::kFlying) meet_part(shot, met, seconds);
    }

    void meet_part(Projectile& shot, const MetPart& met, double seconds) {
        const Vec3 &normal = met.hit.normal, surface = met.hit.surface_velocity * (1 / seconds_);
        const Vec3 place = on_flight_grid(met.hit.point + normal * kPartClearance);
        CastOptions options;
        options.mask = shot.mask;
        if (cast_any(game_.world, Ray{shot.position, place - shot.position}, options) == Status::kMiss)
            shot.position = place;
        const Vec3 relative = shot.velocity - surface, after = ricocheted(relative, normal);
        ShotEvent event;
        event.kind = length(after) > 0 ? ShotEventKind::kRicochet : ShotEventKind::kStopped;
        event.projectile = std::uint32_t(met.index);
        event.time = seconds;
        event.point = met.hit.point;
        event.normal = normal;
        event.face = met.hit.face;
        event.material = met.hit.material;
        const bool goes_on = event.kind == ShotEventKind::kRicochet;
        event.velocity = goes_on ? after + surface : Vec3{};
        event.impulse = (shot.velocity - event.velocity) * shot.mass;
        shot.velocity = event.velocity;
        if (!goes_on) shot.state = ProjectileState::kStopped;
        tell(event);
    }

    /// As fly() has it; zero where it stops.
    Vec3 ricocheted(const Vec3& velocity, const Vec3& normal) const {
        const ShotTerms& terms = weapon_.terms;
        const double speed = length(velocity), toward = std::min(0.0, dot(velocity, normal));
        const double sine = speed > 0 ? -toward / speed : 0;
        if (terms.ricochet_below < kRightAngle && !(sine < sine_cosine(terms.ricochet_below).sine)) return {};
        const Vec3 along = velocity - normal * toward;
        const double change = -(1 + terms.restitution) * toward, slides = length(along);
        const double kept = slides > 0 ? std::max(0.0, 1 - terms.friction * change / slides) : 0;
        const Vec3 after = along * kept - normal * (terms.restitution * toward);
        return length(after) >= weapon_.stop_speed ? after : Vec3{};
    }

    void tell(const ShotEvent& event) {
        times_[event.projectile] = event.time;
        if (lay_[event.projectile] && event.kind == ShotEventKind::kStopped) return;  // it lies as it lay
        report_.shot_events.push_back(event);
        report_.shot_kinds.push_back(number_);
    }

    void finish(std::vector<Bang>& bangs) {
        std::vector<Projectile> kept;
        for (std::size_t k = 0; k < shots_.size(); ++k) {
            Projectile& shot = shots_[k];
            const bool stopped = shot.state == ProjectileState::kStopped;
            if (weapon_.lies && stopped) shot.age = ages_[k] + seconds_;
            const bool waits = weapon_.lies && stopped && shot.age < weapon_.fuse;
            if (shot.state == ProjectileState::kFlying || waits) {
                kept.push_back(shot);
            } else if (weapon_.charge && max_abs(shot.position) < kWorldRim) {
                bangs.push_back({lay_[k] ? seconds_ : times_[k], number_, shot.position});
            }
        }
        shots_ = std::move(kept);
    }

    GameState& game_;
    const std::uint32_t number_;
    const Weapon& weapon_;
    std::vector<Projectile>& shots_;
    const FlyOptions options_;
    const double seconds_;
    GameReport& report_;
    const World nothing_{};
    std::vector<MetPart> met_;
    std::vector<double> ages_, times_;
    std::vector<bool> lay_;
};

Error weapon_fault(const Weapon& weapon, const char* reason) {
    return {ErrorCode::kInvalid, "weapon " + weapon.name, reason};
}

}  // namespace

std::optional<Error> fault_of_weapon(const Weapon& weapon) {
    if (!(weapon.mass > 0) || !is_finite(weapon.mass)) return weapon_fault(weapon, "its mass is not above 0");
    if (!is_finite(weapon.gravity) || !(length(weapon.gravity) <= kStrongestPull))
        return weapon_fault(weapon, "its gravity is not within 1000 m/s2");
    if (!is_usable(weapon.terms) || !is_usable(weapon.bodies))
        return weapon_fault(weapon, "its terms are out of range");
    if (!(weapon.pane_energy >= 0) || !is_finite(weapon.pane_energy))
        return weapon_fault(weapon, "its pane_energy is no energy");
    if (!(weapon.stop_speed >= 0) || !is_finite(weapon.stop_speed))
        return weapon_fault(weapon, "its stop_speed is no speed");
    if (!(weapon.fuse >= 0 && weapon.fuse <= kLongestFuse)) return weapon_fault(weapon, "its fuse is not 0 to 3600 s");
    return std::nullopt;
}

std::optional<Error> fault_of_shots(const GameShots& shots) {
    if (const auto fault = fault_of_weapon(shots.weapon)) return fault;
    for (std::size_t k = 0; k < shots.projectiles.size(); ++k) {
        const Projectile& it = shots.projectiles[k];
        if (!is_finite(it.position) || !is_finite(it.velocity) || !(max_abs(it.velocity) <= kFastestShot) ||
            !(it.mass > 0) || !is_finite(it.mass) || !(it.age >= 0) || !is_finite(it.age))
            return Error{ErrorCode::kOutOfRange, "projectile " + std::to_string(k) + " of " + shots.weapon.name,
                         "a number is not finite or out of range"};
    }
    return std::nullopt;
}

std::vector<Bang> fly_shots(GameState& game, double seconds, GameReport& report) {
    std::vector<Bang> bangs;
    for (std::uint32_t k = 0; k < game.shots.size(); ++k) WeaponFlight(game, k, seconds, report).run(bangs);
    // They are in order of weapon and index: of equal times that order stays.
    sort_stably(bangs, [](const Bang& a, const Bang& b) { return a.time < b.time; });
    return bangs;
}

std::vector<Weapon> standard_weapons() {
    Weapon bullet, rocket, grenade;
    bullet.name = "bullet";
    bullet.terms.resistance = 8000;
    bullet.bodies.ricochet_below = 0;
    bullet.pane_energy = 10;
    bullet.fuse = 5;
    rocket.name = "rocket";
    rocket.mass = 2;
    rocket.gravity = {};
    rocket.terms.ricochet_below = rocket.bodies.ricochet_below = 0;
    rocket.charge = Charge{};
    grenade.name = "grenade";
    grenade.mass = 0.4;
    grenade.terms = {kRightAngle, 0.4, 0.3, kUnpierced};
    grenade.bodies = grenade.terms;
    grenade.fuse = 2.5;
    grenade.lies = true;
    grenade.charge = Charge{.crater = 0.8, .radius = 5, .impulse = 2000};
    return {bullet, rocket, grenade};
}

}  // namespace firma
