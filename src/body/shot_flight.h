// SPDX-License-Identifier: MIT
// One projectile on its way through one step.
#pragma once

#include <cstdint>
#include <optional>

#include "body/body_targets.h"
#include "body/part_targets.h"
#include "body/shot_solid.h"
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
    /// @param parts    null: no parts
    ShotFlight(const World& world, const FlyOptions& options, const Bodies* bodies, const BodyTargets* targets,
               const PartTargets* parts, ShotEvents& events)
        : world_(world),
          world_hash_(hash_world(world)),
          options_(options),
          bodies_(bodies),
          targets_(targets),
          parts_(parts),
          events_(events) {}

    void fly(Projectile& projectile, std::uint32_t index, double seconds);

    std::size_t chords() const { return chords_; }
    std::size_t impacts() const { return impacts_of_all_; }

private:
    /// Metres along the normal: so far from a face a projectile goes on.
    static constexpr double kClearance = 1e-5;
    /// Metres along the path: no farther is looked for a place at that distance where the path grazes the face.
    static constexpr double kLongestClearance = 1e-3;

    /// A stretch of the parabola, times in seconds: `from` and `to` from where the parabola began.
    struct Chord {
        Vec3 path;      ///< metres
        Vec3 velocity;  ///< at its start
        Vec3 gain;      ///< what is added to it until its end
        double began = 0, from = 0, to = 0;
    };

    /// What a chord meets first, and the place before it that is surely in the air.
    struct Met {
        bool any = false;
        double fraction = 1;
        double time = 0;  ///< seconds from the start of the step
        Vec3 before;
        Vec3 way;  ///< of the chord, as what is met sees it, unit
        ShotImpact impact;
        ShotSolid solid;  ///< of bodies the level
        std::uint32_t matter = 0;
        double sine = 0;       ///< of the angle between path and face
        bool inside = false;   ///< it is in the solid already
        bool crushed = false;  ///< between the level and a part: there is no place before it
    };

    void fly_on(double seconds);
    Met first_on(const Chord& chord);
    void put_face(Met& met, const Hit& hit) const;
    void come_before(Met& met, const Chord& chord, double safe) const;
    void come_before_part(Met& met, const Chord& chord, double safe) const;
    bool is_free(const Vec3& place) const;
    void meet(const Met& met);
    void meet_first(const Met& met);
    void ricochet(const Met& met, const ShotTerms& terms);

    // Through solid.
    void pass_pane(const Met& met);
    void enter(const Met& met);
    void go_on_inside(std::uint32_t left);
    void enter_inside(const ShotSolid& solid);
    void pierce_solid(const ShotSolid& solid, const Vec3& from, const Vec3& to, const PierceOptions& options);
    const PierceSpan* solid_at(const Met& met) const;
    bool go_through(const PierceSpan& span, const Met& met, ShotEvent& entered, ShotEvent& left);
    void leave(const Met& met, const PierceSpan* span, ShotEvent& left);
    bool goes_on_behind(const Met& met, double at, double clearance);

    ShotTerms terms_of(const ShotImpact& impact, const ShotSolid& solid, std::uint32_t matter) const;
    std::uint32_t matter_behind(const ShotSolid& solid, const FaceInfo& face, const Vec3& point) const;
    bool is_in_solid(const ShotSolid& solid, const Vec3& point);
    ShotSolid part_at(std::uint32_t part, double time, const Vec3& point) const;
    std::optional<ShotSolid> part_around(const Vec3& point, std::uint32_t left_out);
    bool stops_inside(const ShotSolid& solid);
    ShotEvent event_of(const Met& met, ShotEventKind kind) const;
    void tell(ShotEvent& event, const ShotSolid& solid, const Vec3& velocity_after);
    void stop(ShotEvent& event, const ShotSolid& solid);
    void carry(const ShotSolid& solid);
    void expire();

    const World& world_;
    const std::uint64_t world_hash_;
    const FlyOptions& options_;
    const Bodies* bodies_;
    const BodyTargets* targets_;
    const PartTargets* parts_;
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
