// SPDX-License-Identifier: MIT
// One projectile on its way through one step.
#pragma once

#include <cstdint>

#include "body/body_targets.h"
#include "firma/projectiles.h"

namespace firma {

/// The nearest place of the grid on which projectiles fly: so that chords are exact, and each begins where the one
/// before it ended.
Vec3 on_flight_grid(const Vec3& point);

/// How many chords a parabola is divided into.
double chords_for(double seconds, const FlyOptions& options);

bool is_usable(const ShotTerms& terms);

/// Flies projectiles of one piece of work, one after the other.
class ShotFlight {
public:
    /// @param targets  null: no bodies
    ShotFlight(const World& world, const FlyOptions& options, const Bodies* bodies, const BodyTargets* targets,
               ShotEvents& events)
        : world_(world),
          world_hash_(hash_world(world)),
          options_(options),
          bodies_(bodies),
          targets_(targets),
          events_(events) {}

    void fly(Projectile& projectile, std::uint32_t index, double seconds);

    std::size_t chords() const { return chords_; }
    std::size_t impacts() const { return impacts_of_all_; }

private:
    /// What a chord meets first, and the place before it that is surely in the air.
    struct Met {
        bool any = false;
        double fraction = 1;
        Vec3 before;
        Vec3 way;  ///< of the chord, unit
        ShotImpact impact;
        std::uint32_t matter = 0;
        double sine = 0;  ///< of the angle between path and face
    };

    void fly_on(double seconds);
    Met first_on(const Vec3& path, const Vec3& velocity, const Vec3& gain);
    void meet(Met& met);
    void ricochet(const Met& met, const ShotTerms& terms);
    void pass_pane(const Met& met);
    void enter(const Met& met);
    const PierceSpan* solid_at(const Met& met) const;
    bool go_through(const PierceSpan& span, ShotEvent& entered, ShotEvent& left);
    void leave(const Met& met, const PierceSpan* span, ShotEvent& left);
    bool goes_on_from(const Vec3& place);
    bool goes_on_behind(const Vec3& from, const Vec3& way, double at, double clearance);

    ShotTerms terms_of(const ShotImpact& impact, std::uint32_t matter) const;
    std::uint32_t matter_behind(const FaceInfo& face, const Vec3& point) const;
    bool is_in_solid(const Vec3& point);
    ShotEvent event_of(const Met& met, ShotEventKind kind) const;
    void tell(ShotEvent& event, const Vec3& velocity_after);
    void stop(ShotEvent& event);
    void expire();

    const World& world_;
    const std::uint64_t world_hash_;
    const FlyOptions& options_;
    const Bodies* bodies_;
    const BodyTargets* targets_;
    ShotEvents& events_;
    Piercing found_;
    std::size_t chords_ = 0, impacts_of_all_ = 0;

    // Of the projectile at hand.
    Projectile* it_ = nullptr;
    std::uint32_t index_ = 0, number_ = 0;
    int impacts_ = 0;
    double time_ = 0;
};

}  // namespace firma
