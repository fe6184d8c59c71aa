// SPDX-License-Identifier: MIT
// A step gives bodies no energy but that of what pulls them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "body/mover.h"

namespace firma {

/// Contacts are found once a step, and a sweep stops a body elsewhere than the step had put it: both may leave more
/// energy than there was. Bodies that met each other in the step are guarded together: what they have too much is taken
/// from their velocities and spins, of all in the same proportion, but not from the motion that they have in common
/// where they met nothing else. What lies too high with no velocity left to take from stays there at rest.
class EnergyGuard {
public:
    /// @param gravity  metres a second squared
    explicit EnergyGuard(const Vec3& gravity) : gravity_(gravity) {}

    /// The work of a torque within a substep, joules.
    void add_work(std::uint32_t slot, double joules) { works_.emplace_back(slot, joules); }
    void join(std::uint32_t one, std::uint32_t other) { pairs_.emplace_back(one, other); }
    /// It met the level.
    void hold(std::uint32_t slot) { held_.push_back(slot); }
    /// It met a part that moves, which may give it any energy.
    void let_go(std::uint32_t slot) { free_.push_back(slot); }

    /// @param bodies  as the step began, of slots: forces and velocities
    void run(std::span<Mover> movers, std::span<const std::uint32_t> movers_of_slots, std::span<const Body> bodies);

private:
    Vec3 gravity_;
    std::vector<std::pair<std::uint32_t, double>> works_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  ///< of slots, as the others
    std::vector<std::uint32_t> held_, free_;
};

}  // namespace firma
