// SPDX-License-Identifier: MIT
// Energies of bodies that met, before and after a step.
#include "body/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"

namespace firma {
namespace {

/// Bodies that met each other.
struct Group {
    double gained = 0, moving = 0;  ///< joules: more than before; of motion, now
    double mass = 0;
    Vec3 momentum;
    bool held = false, free = false;
};

double turning_energy(const Quaternion& rotation, const Vec3& spin, const BodyShapeData& shape) {
    const TurnMatrix matrix = matrix_of(rotation);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double about = dot(matrix.column(axis), spin);
        sum += shape.moments[axis] * about * about;
    }
    return 0.5 * sum;
}

double moving_energy(const Vec3& velocity, const BodyShapeData& shape) {
    return 0.5 * shape.mass * dot(velocity, velocity);
}

}  // namespace

void EnergyGuard::run(std::span<Mover> movers, std::span<const std::uint32_t> movers_of_slots,
                      std::span<const Body> bodies) {
    // Whoever met nothing falls as it should.
    DisjointSets sets(movers.size());
    std::vector<bool> met(movers.size());
    for (const auto& [one, other] : pairs_) {
        const std::uint32_t a = movers_of_slots[one], b = movers_of_slots[other];
        if (a == kFixed) {
            held_.push_back(other);  // by one that sleeps
        } else if (b == kFixed) {
            held_.push_back(one);
        } else {
            sets.join(a, b);
            met[a] = met[b] = true;
        }
    }
    for (const std::uint32_t slot : held_) met[movers_of_slots[slot]] = true;
    std::vector<Group> groups(movers.size());
    for (std::uint32_t k = 0; k < movers.size(); ++k) {
        if (!met[k]) continue;
        const Mover& mover = movers[k];
        const Body& body = bodies[mover.slot];
        Group& group = groups[sets.find(k)];
        const double before =
            moving_energy(body.velocity, *mover.shape) + turning_energy(mover.start_rotation, body.spin, *mover.shape);
        const double now =
            moving_energy(mover.velocity, *mover.shape) + turning_energy(mover.rotation, mover.spin, *mover.shape);
        const Vec3 pull = gravity_ * mover.shape->mass + body.force;
        group.moving += now;
        group.gained += now - before - dot(pull, mover.position - mover.start);
        group.mass += mover.shape->mass;
        group.momentum += mover.velocity * mover.shape->mass;
    }
    for (const auto& [slot, joules] : works_) groups[sets.find(movers_of_slots[slot])].gained -= joules;
    for (const std::uint32_t slot : held_) groups[sets.find(movers_of_slots[slot])].held = true;
    for (const std::uint32_t slot : free_) groups[sets.find(movers_of_slots[slot])].free = true;
    for (std::uint32_t k = 0; k < movers.size(); ++k) {
        const Group& group = groups[sets.find(k)];
        if (!met[k] || group.free || !(group.gained > 0)) continue;
        const Vec3 common = group.held ? Vec3{} : group.momentum * (1 / group.mass);
        const double taken_from = group.moving - 0.5 * group.mass * dot(common, common);
        const double scale = taken_from > group.gained ? std::sqrt(1 - group.gained / taken_from) : 0;
        movers[k].velocity = common + (movers[k].velocity - common) * scale;
        movers[k].spin *= scale;
    }
}

}  // namespace firma
