// SPDX-License-Identifier: MIT
// What contacts do to bodies in the substeps of a step: impulses that keep spheres apart, with friction and
// restitution.
//
// Source: E. Catto, Solver2D, 2024 (soft contacts in substeps, then once more without softness).
#pragma once

#include <span>
#include <vector>

#include "body/mover.h"
#include "body/step_parts.h"

namespace firma {

class ContactSolver {
public:
    /// @param movers    all of the step's
    /// @param contacts  between `island` and what does not move
    /// @param kept        the contacts of the step before, in order: what they pressed with
    /// @param parts       that contacts name
    /// @param iterations  of a substep: how often it goes through all contacts
    ContactSolver(std::span<Mover> movers, std::span<Mover> island, std::span<NearContact> contacts,
                  std::span<const BodyContact> kept, const StepParts& parts, double substep, int iterations);

    /// One substep of `substep` seconds; forces have been added to velocities.
    void substep();
    /// After the last: what met faster than this bounces.
    void bounce(double least_speed);
    /// Puts what pressed into the contacts.
    void keep_forces();

    /// The largest impulse along the normal in any substep: a contact that pressed.
    double pressed(std::size_t contact) const { return rows_[contact].max_normal; }

private:
    struct Row {
        Vec3 normal, across[2];
        Vec3 from_a, from_b;  ///< from the centres of mass to the point
        double normal_mass = 0, across_mass[2] = {};
        double impulse = 0, across_impulse[2] = {};
        Vec3 rolling, slip;
        Vec3 surface, surface_spin;  ///< of the part that it lies on, in this substep
        double surface_moved = 0;    ///< along the normal since the step began
        double gap = 0;              ///< as bodies lie now
        double max_normal = 0;
        double approach = 0;  ///< along the normal, before it first pressed
    };

    void prepare(Row& row, const NearContact& contact);
    void put_masses(Row& row, const NearContact& contact);
    bool turns_far(std::uint32_t mover) const;
    void start_warm(std::span<const BodyContact> kept);
    Vec3 speed_at(const Row& row, const NearContact& contact) const;
    void push(const Row& row, const NearContact& contact, const Vec3& impulse);
    void resist_rolling(Row& row, const NearContact& contact);
    void twist(const NearContact& contact, const Vec3& impulse);
    void solve(bool soft);
    void move();
    void put_surfaces();
    void put_gaps();
    double gap_now(const Row& row, const NearContact& contact) const;

    std::span<Mover> movers_, island_;
    std::span<NearContact> contacts_;
    std::vector<Row> rows_;
    const StepParts& parts_;
    bool on_parts_ = false;
    int substeps_done_ = 0;
    const double seconds_;
    const int iterations_;
};

}  // namespace firma
