// SPDX-License-Identifier: MIT
// The end of a step: bodies that may have gone through something are swept along their way.
#pragma once

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "body/energy_guard.h"
#include "body/mover.h"
#include "body/step_parts.h"
#include "body/touch_response.h"
#include "firma/cast_set.h"
#include "firma/world.h"

namespace firma {

struct SweepRules {
    double skin = 0;          ///< metres
    double seconds = 0;       ///< of the step
    double bounce_speed = 0;  ///< metres a second along the normal: what meets slower does not bounce
    double friction = 0;      ///< of the world
    int max_bounces = 0;
};

/// Takes each body from where the step began as far along its way as no sphere, less the skin, meets the world, a part
/// or a sphere of another body, in the order of time. There it bounces, or goes on along the wall, for what is left of
/// the step. What meets more than max_bounces times stays there until the next step. If it met the level, or a body
/// that the level holds, others meet it as they would meet the level: what is light between the level and something
/// heavy hands on what it is pushed with. If a part meets it then, it is carried along, until it meets something again:
/// then it is crushed, and the part goes over it.
class BodySweep {
public:
    /// @param movers           where the step would take them; a sleeper that is met joins them
    /// @param movers_of_slots  kFixed where no mover is
    /// @param sound            of slots: others are met by nothing
    BodySweep(const World& world, const StepParts& parts, Bodies& bodies, std::vector<Mover>& movers,
              std::span<const NearPlane> planes, std::vector<std::uint32_t>& movers_of_slots,
              const std::vector<bool>& sound, const SweepRules& rules);

    void run();

    std::size_t swept() const { return swept_; }
    std::size_t bounces() const { return bounces_; }
    std::size_t woken() const { return woken_; }
    /// Of a slot: a part could not push it away.
    bool is_crushed(std::uint32_t slot) const { return slot < ways_.size() && ways_[slot].crushed; }
    /// Whether a slot's body met nothing but the level, or was held by it.
    bool is_wedged(std::uint32_t slot) const {
        if (slot >= ways_.size() || ways_[slot].met == 0) return false;
        return ways_[slot].held || !ways_[slot].met_others;
    }

    /// Who met whom.
    void tell(EnergyGuard& guard) const;

private:
    /// The straight piece of a body's way that it is on.
    struct Way {
        RigidMotion motion;
        double from = 0, to = 1;  ///< of the step: when the piece begins and ends
        int met = 0;
        std::uint32_t piece = 0;
        std::uint32_t carried_by = kNoPart;
        std::uint32_t pushed_by = kNoPart;  ///< the last part that it met
        bool is_there = false, swept = false;
        bool ended = false;  ///< it stays where it is, whatever comes
        bool crushed = false;
        bool met_others = false;  ///< parts or bodies
        bool met_level = false;
        bool held = false;  ///< it stays for the rest of the step, by the level or by what the level holds
    };
    /// A touch that comes as long as both go on as they do now.
    struct Touching {
        double at = 0;  ///< of the step
        std::uint32_t slot = 0, other = kFixed;
        std::uint32_t piece = 0, other_piece = 0;
        std::uint32_t part = kNoPart;  ///< where other is kFixed
        Vec3 point, normal;
        bool is_turn = false;  ///< no touch: what a part takes along goes on along its arc
        /// The queue takes the greatest first. Of touches at one time the order is the same whatever the queue is made
        /// of: those of parts come after that of the level.
        friend bool operator<(const Touching& a, const Touching& b) {
            if (a.at != b.at) return a.at > b.at;
            if (a.slot != b.slot) return a.slot > b.slot;
            return a.other != b.other ? a.other > b.other : a.part + 1 > b.part + 1;
        }
    };

    void start();
    CastOptions world_options(std::uint32_t slot) const;
    void find_world_touch(std::uint32_t slot);
    void note_world_touch(std::uint32_t slot, const SetHit& hit);
    void find_part_touch(std::uint32_t slot);
    bool parts_are_clear(const Mover& mover) const;
    std::span<const Sphere> cores_that_may_touch(const Mover& mover, const RigidMotion& motion);
    enum class Overlap : std::uint8_t { kPassed, kMeets };
    void find_pair_touch(std::uint32_t slot, std::uint32_t other, Overlap at_start);
    void find_touches(std::uint32_t slot);
    void touch(const Touching& it);
    Mover& mover_at(std::uint32_t slot, double at);
    void wake(std::uint32_t slot);
    void touch_fixed(const Touching& it, TouchTerms terms);
    void touch_carried(const Touching& it, std::uint32_t carried, std::uint32_t slot, const Vec3& normal,
                       TouchTerms terms);
    void touch_held(const Touching& it, std::uint32_t slot, const Vec3& normal, const TouchTerms& terms);
    void hold_if_stopped(std::uint32_t slot, bool by_level);
    void go_on(std::uint32_t slot, double at, bool stops, std::uint32_t part);
    void carry_on(std::uint32_t slot, double at);
    void take_along(std::uint32_t slot, std::uint32_t part, double at);
    RigidMotion between(const Way& way, double from, double to) const;
    double reach_of(std::uint32_t slot) const;
    std::span<const Sphere> cores_of(std::uint32_t slot, std::vector<Sphere>& into) const;

    const World& world_;
    const StepParts& parts_;
    Bodies& bodies_;
    std::vector<Mover>& movers_;
    const std::span<const NearPlane> planes_;
    std::vector<std::uint32_t>& movers_of_slots_;
    const std::vector<bool>& sound_;
    const SweepRules& rules_;
    std::vector<Way> ways_;  ///< of slots
    std::priority_queue<Touching> touches_;
    std::vector<Sphere> cores_, other_cores_;  ///< scratch
    std::vector<std::pair<std::uint32_t, std::uint32_t>> met_pairs_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping_;  ///< as the step began, in order
    std::size_t swept_ = 0, bounces_ = 0, woken_ = 0;
};

}  // namespace firma
