// SPDX-License-Identifier: MIT
// Impulses of contacts.
#include "body/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "body/free_spin.h"

namespace firma {
namespace {

/// What overlaps is pushed apart as by a spring of so many oscillations in a substep, strongly damped.
constexpr double kOscillations = 0.25, kDamping = 10;
/// Metres a second: no faster than this.
constexpr double kMaxPush = 3;

constexpr double kTwoPi = 6.283185307179586;

/// How a soft contact pushes: Catto's three numbers.
struct Softness {
    double rate, mass_scale, impulse_scale;

    /// @param oscillations  in a substep
    Softness(double oscillations, double damping, double seconds) {
        const double omega = kTwoPi * oscillations / seconds;
        const double a = 2 * damping + seconds * omega, b = seconds * omega * a, c = 1 / (1 + b);
        rate = omega / a;
        mass_scale = b * c;
        impulse_scale = c;
    }
};

auto key_of(const BodyContact& contact) {
    return std::tuple(contact.body, contact.other, contact.sphere, contact.other_sphere);
}

}  // namespace

ContactSolver::ContactSolver(std::span<Mover> movers, std::span<Mover> island, std::span<NearContact> contacts,
                             std::span<const BodyContact> kept, const StepParts& parts, double substep, int iterations)
    : movers_(movers),
      island_(island),
      contacts_(contacts),
      rows_(contacts.size()),
      parts_(parts),
      seconds_(substep),
      iterations_(iterations) {
    for (std::size_t k = 0; k < rows_.size(); ++k) prepare(rows_[k], contacts_[k]);
    start_warm(kept);
}

void ContactSolver::prepare(Row& row, const NearContact& contact) {
    const Vec3 n = contact.at.normal;
    row.normal = n;
    on_parts_ = on_parts_ || contact.at.part != kNoPart;
    // Any direction across: from the axis that the normal is least along.
    const Vec3 size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                      : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                           : Vec3{0, 0, 1};
    const Vec3 across = cross(axis, n);
    row.across[0] = across * (1 / length(across));
    row.across[1] = cross(n, row.across[0]);
    put_masses(row, contact);
}

/// Where it pushes as the bodies are turned now, and what that moves.
void ContactSolver::put_masses(Row& row, const NearContact& contact) {
    const Vec3 n = row.normal;
    const Mover& a = movers_[contact.a];
    row.from_a = a.matrix * a.shape->spheres[contact.at.sphere].centre - n * contact.radius_a;
    if (contact.b != kFixed) {
        const Mover& b = movers_[contact.b];
        row.from_b = b.matrix * b.shape->spheres[contact.at.other_sphere].centre + n * contact.radius_b;
    }
    const auto mass_along = [&](const Vec3& direction) {
        double yields = a.yield(direction, row.from_a);
        if (contact.b != kFixed) yields += movers_[contact.b].yield(direction, row.from_b);
        return 1 / yields;
    };
    row.normal_mass = mass_along(n);
    for (int k = 0; k < 2; ++k) row.across_mass[k] = mass_along(row.across[k]);
}

/// Each contact takes up the impulses of the one before between the same spheres; of a sphere at several faces, of the
/// one whose normal is nearest.
void ContactSolver::start_warm(std::span<const BodyContact> kept) {
    constexpr double kAlike = 0.9;  // cosine
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const BodyContact& now = contacts_[k].at;
        auto found = std::lower_bound(kept.begin(), kept.end(), now,
                                      [](const BodyContact& a, const BodyContact& b) { return key_of(a) < key_of(b); });
        const BodyContact* best = nullptr;
        double alike = kAlike;
        for (; found != kept.end() && key_of(*found) == key_of(now); ++found)
            if (const double cosine = dot(found->normal, now.normal); cosine > alike && found->part == now.part)
                best = &*found, alike = cosine;
        if (!best) continue;
        Row& row = rows_[k];
        row.impulse = best->force * seconds_;
        for (int axis = 0; axis < 2; ++axis)
            row.across_impulse[axis] = dot(best->friction, row.across[axis]) * seconds_;
        row.rolling = best->rolling * seconds_;
        row.slip = best->slip - row.normal * dot(best->slip, row.normal);
    }
}

Vec3 ContactSolver::speed_at(const Row& row, const NearContact& contact) const {
    const Vec3 of_a = movers_[contact.a].velocity_at(row.from_a);
    return contact.b == kFixed ? of_a - row.surface : of_a - movers_[contact.b].velocity_at(row.from_b);
}

void ContactSolver::push(const Row& row, const NearContact& contact, const Vec3& impulse) {
    movers_[contact.a].push(impulse, row.from_a);
    if (contact.b != kFixed) movers_[contact.b].push(-impulse, row.from_b);
}

double ContactSolver::gap_now(const Row& row, const NearContact& contact) const {
    Vec3 moved = movers_[contact.a].centre_of(contact.at.sphere) - contact.centre_a;
    if (contact.b != kFixed) moved = moved - (movers_[contact.b].centre_of(contact.at.other_sphere) - contact.centre_b);
    return contact.gap + dot(moved, contact.at.normal) - row.surface_moved;
}

/// While impulses are sought nothing moves.
void ContactSolver::put_gaps() {
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k].gap = gap_now(rows_[k], contacts_[k]);
}

void ContactSolver::solve(bool soft) {
    const Softness softness(kOscillations, kDamping, seconds_);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        Row& row = rows_[k];
        const NearContact& contact = contacts_[k];
        const double gap = row.gap;
        double bias = 0, mass_scale = 1, impulse_scale = 0;
        if (gap > 0) {
            bias = gap / seconds_;
        } else if (soft) {
            bias = std::max(softness.rate * gap, -kMaxPush);
            mass_scale = softness.mass_scale;
            impulse_scale = softness.impulse_scale;
        }
        const double speed = dot(speed_at(row, contact), row.normal);
        const double wanted = -row.normal_mass * mass_scale * (speed + bias) - impulse_scale * row.impulse;
        const double total = std::max(row.impulse + wanted, 0.0), added = total - row.impulse;
        if (total > 0 && row.max_normal == 0) row.approach = speed;
        row.impulse = total;
        row.max_normal = std::max(row.max_normal, total);
        push(row, contact, row.normal * added);

        const Vec3 sliding = speed_at(row, contact);
        const double slip_rate = soft ? softness.rate : 0;
        double across[2];
        for (int axis = 0; axis < 2; ++axis)
            across[axis] =
                row.across_impulse[axis] -
                row.across_mass[axis] * (dot(sliding, row.across[axis]) + slip_rate * dot(row.slip, row.across[axis]));
        const double most = contact.friction * row.impulse;
        const double size = std::sqrt(across[0] * across[0] + across[1] * across[1]);
        const double scale = size > most ? most / size : 1;
        if (size > most) row.slip = {};
        Vec3 impulse;
        for (int axis = 0; axis < 2; ++axis) {
            const double next = across[axis] * scale;
            impulse += row.across[axis] * (next - row.across_impulse[axis]);
            row.across_impulse[axis] = next;
        }
        push(row, contact, impulse);
        if (contact.rolling > 0) resist_rolling(row, contact);
    }
}

/// A torque against turning relative to each other, about any axis, of no more than a lever times the normal impulse.
void ContactSolver::resist_rolling(Row& row, const NearContact& contact) {
    Mover& a = movers_[contact.a];
    const Vec3 turning = contact.b == kFixed ? a.spin - row.surface_spin : a.spin - movers_[contact.b].spin;
    const double speed = length(turning);
    if (!(speed > 0)) return;
    const Vec3 axis = turning * (1 / speed);
    double yields = dot(axis, a.inverse_inertia * axis);
    if (contact.b != kFixed) yields += dot(axis, movers_[contact.b].inverse_inertia * axis);
    Vec3 next = row.rolling - axis * (speed / yields);
    const double most = contact.rolling * row.impulse, size = length(next);
    if (size > most) next *= most / size;
    twist(contact, next - row.rolling);
    row.rolling = next;
}

void ContactSolver::twist(const NearContact& contact, const Vec3& impulse) {
    Mover& a = movers_[contact.a];
    a.spin += a.inverse_inertia * impulse;
    if (contact.b == kFixed) return;
    Mover& b = movers_[contact.b];
    b.spin -= b.inverse_inertia * impulse;
}

void ContactSolver::move() {
    for (Mover& mover : island_) {
        mover.position += (mover.velocity - mover.half_gain) * seconds_;
        const Spinning next = spin_freely({mover.rotation, mover.spin}, mover.shape->moments, seconds_);
        mover.rotation = next.rotation;
        mover.spin = next.spin;
        mover.turn_inertia();
    }
}

/// How the parts' surfaces move in this substep, where they are met now: along the chord, so that what is carried round
/// stays as far from the axis as it was.
void ContactSolver::put_surfaces() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const NearContact& contact = contacts_[k];
        if (contact.at.part == kNoPart) continue;
        const StepPart& part = parts_[contact.at.part];
        Row& row = rows_[k];
        const Vec3 point = movers_[contact.a].position + row.from_a;
        const Vec3 at_start = part.velocity_of(point, substeps_done_ * seconds_);
        row.surface = at_start + cross(part.spin, at_start - part.velocity) * (0.5 * seconds_);
        row.surface_spin = part.spin;
    }
}

void ContactSolver::substep() {
    if (on_parts_) put_surfaces();
    for (std::size_t k = 0; k < rows_.size(); ++k)
        if (turns_far(contacts_[k].a) || (contacts_[k].b != kFixed && turns_far(contacts_[k].b)))
            put_masses(rows_[k], contacts_[k]);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const Row& row = rows_[k];
        push(row, contacts_[k],
             row.normal * row.impulse + row.across[0] * row.across_impulse[0] + row.across[1] * row.across_impulse[1]);
        if (contacts_[k].rolling > 0) twist(contacts_[k], row.rolling);
    }
    put_gaps();
    for (int k = 0; k < iterations_; ++k) solve(true);
    move();
    ++substeps_done_;
    if (on_parts_)
        for (Row& row : rows_) row.surface_moved += dot(row.surface, row.normal) * seconds_;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        Row& row = rows_[k];
        const Vec3 speed = speed_at(row, contacts_[k]);
        row.slip += (speed - row.normal * dot(speed, row.normal)) * seconds_;
    }
    put_gaps();
    for (int k = 0; k < iterations_; ++k) solve(false);
}

/// So far in a substep that levers and masses of before are those of another body.
bool ContactSolver::turns_far(std::uint32_t mover) const {
    constexpr double kFar = 0.03;  // radians
    const Vec3 turn = movers_[mover].spin * seconds_;
    return dot(turn, turn) > kFar * kFar;
}

void ContactSolver::bounce(double least_speed) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        Row& row = rows_[k];
        const NearContact& contact = contacts_[k];
        if (contact.restitution == 0 || row.approach > -least_speed || row.max_normal == 0) continue;
        const double speed = dot(speed_at(row, contact), row.normal);
        const double wanted = -row.normal_mass * (speed + contact.restitution * row.approach);
        const double total = std::max(row.impulse + wanted, 0.0), added = total - row.impulse;
        row.impulse = total;
        row.max_normal = std::max(row.max_normal, total);
        push(row, contact, row.normal * added);
    }
}

void ContactSolver::keep_forces() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const Row& row = rows_[k];
        BodyContact& at = contacts_[k].at;
        const double rate = 1 / seconds_;
        at.force = row.impulse * rate;
        at.friction = (row.across[0] * row.across_impulse[0] + row.across[1] * row.across_impulse[1]) * rate;
        at.rolling = row.rolling * rate;
        at.slip = row.impulse > 0 ? row.slip : Vec3{};
        if (at.part == kNoPart || row.surface_spin == Vec3{}) continue;
        // They are those of the part's surface, which has turned on.
        const TurnMatrix turn = matrix_of(turn_by(parts_[at.part].motion.turn));
        for (Vec3* across : {&at.friction, &at.slip, &at.rolling}) *across = turn * *across;
    }
}

}  // namespace firma
