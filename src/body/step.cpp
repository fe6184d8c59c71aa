// SPDX-License-Identifier: MIT
// A step of all bodies: contacts, impulses in substeps, sweeps, rest.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/sort.h"
#include "body/body_tolerance.h"
#include "body/contact_solver.h"
#include "body/energy_guard.h"
#include "body/mover_islands.h"
#include "body/pair_contacts.h"
#include "body/rest.h"
#include "body/sound_body.h"
#include "body/step_parts.h"
#include "body/stuck_bodies.h"
#include "body/sweep_bodies.h"
#include "body/world_contacts.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

constexpr double kLongestStep = 0.25;   // seconds
constexpr double kShortestStep = 1e-9;  // below it the rate of what a step adds may be too large a number
constexpr int kMaxSubsteps = 10'000;    // a second
constexpr int kMaxBounces = 1'000;
/// Metres a second along the normal: what meets slower than this does not bounce.
constexpr double kBounceSpeed = 0.5;

/// Of two facets of one face, of which the order is that of their places.
bool lies_before(const BodyContact& a, const BodyContact& b) {
    const auto key = [](const BodyContact& of) {
        return std::tuple(of.face.corner, of.point.x, of.point.y, of.point.z);
    };
    return key(a) < key(b);
}

bool are_usable(const StepOptions& options) {
    const auto is_length = [](double number) { return is_finite(number) && number >= 0 && number <= kLargestNumber; };
    return is_finite(options.gravity) && max_abs(options.gravity) <= kLargestNumber && options.substeps_a_second >= 1 &&
           options.substeps_a_second <= kMaxSubsteps && options.max_bounces >= 0 &&
           options.max_bounces <= kMaxBounces && is_length(options.contact_friction) &&
           is_length(options.contact_offset);
}

/// One step of so many seconds, no longer than kLongestStep.
class Step {
public:
    Step(Bodies& bodies, const Scene& scene, double seconds, const StepOptions& options)
        : bodies_(bodies),
          world_(scene.world),
          parts_(scene, seconds),
          options_(options),
          seconds_(seconds),
          skin_(options.contact_offset > 0 ? options.contact_offset : world_.tolerance().contact_offset),
          substeps_(std::max(1, int(std::ceil(seconds * options.substeps_a_second - kSubstepSlop)))),
          guard_(options.gravity) {
        sound_.reserve(bodies.slots.size());
        for (const Body& body : bodies.slots) {
            sound_.push_back(body.shape.valid() && is_sound(body));
            report_.unsound += body.shape.valid() && !sound_.back();
        }
    }

    StepReport run() {
        const std::uint64_t hash = hash_world(world_);
        const bool other_world = bodies_.world_hash != hash;
        bodies_.world_hash = hash;
        const bool has_parts = !parts_.empty() || !bodies_.part_hashes.empty();
        if (has_parts) parts_.compare(bodies_.part_hashes);
        find_stuck(bodies_, world_, other_world, parts_, sound_);
        if (other_world || has_parts) report_.woken = wake_unsupported(bodies_, world_, other_world, parts_);
        if (has_parts) report_.woken += wake_in_the_way(bodies_, parts_, skin_);
        free_stuck();
        gather_movers();
        find_contacts();
        solve();
        hold_unsound();
        sweep();
        hold_unsound();
        guard_energy();
        put_back();
        rest(bodies_, movers_, movers_of_slots_, seconds_, parts_, options_);
        ++bodies_.steps;
        return report_;
    }

private:
    void free_stuck() {
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            Body& body = bodies_.slots[slot];
            if (!sound_[slot] || !body.stuck) continue;
            ++report_.stuck;
            move_out(body, world_, parts_, seconds_, skin_);
            report_.crushed += body.crushed;
        }
    }

    bool moves(std::uint32_t slot) const {
        return sound_[slot] && !bodies_.slots[slot].asleep && !bodies_.slots[slot].stuck;
    }

    void gather_movers() {
        movers_of_slots_.assign(bodies_.slots.size(), kFixed);
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            if (!moves(slot)) continue;
            movers_of_slots_[slot] = std::uint32_t(movers_.size());
            movers_.push_back(make_mover(bodies_.slots[slot], slot));
        }
        report_.awake = movers_.size();
    }

    /// How far from a body something may be and still be met within the step. What is farther the sweep finds.
    double margin_of(const Body& body, const BodyShapeData& shape) const {
        return std::min(way_in_step(body, shape), 0.5 * shape.thinnest + 2 * skin_) + 2 * skin_;
    }

    double way_in_step(const Body& body, const BodyShapeData& shape) const {
        const double speed =
            length(body.velocity) + length(body.spin) * shape.reach + length(options_.gravity) * seconds_;
        return speed * seconds_;
    }

    /// How far from a body faces are noted. What they may be met in is then known for most that move.
    double far_of(const Body& body, const BodyShapeData& shape, double margin) const {
        constexpr double kFarthest = 0.5;  // metres
        return std::max(margin, std::min(1.05 * way_in_step(body, shape), kFarthest) + 2 * skin_);
    }

    /// However fast it and a part go.
    double largest_margin(const BodyShapeData& shape) const { return 0.5 * shape.thinnest + 4 * skin_; }

    PlacedBody placed(std::uint32_t slot) const {
        const Body& body = bodies_.slots[slot];
        return {body.position, matrix_of(principal_rotation(body)), &body.shape.data(), movers_of_slots_[slot], slot};
    }

    void find_pairs() {
        std::vector<BodyBall> balls;
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            const Body& body = bodies_.slots[slot];
            if (!sound_[slot] || body.stuck) continue;
            const BodyShapeData& shape = body.shape.data();
            balls.push_back({body.position, shape.reach + margin_of(body, shape), slot, body.mask, !body.asleep});
        }
        pairs_ = near_pairs(std::move(balls));
    }

    /// What moves against a sleeper wakes it, with all that sleeps with it.
    void wake_what_is_met() {
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const auto [one, other] = pairs_[k];
            const std::uint32_t sleeper = bodies_.slots[one].asleep ? one : other, mover = one ^ other ^ sleeper;
            if (!bodies_.slots[sleeper].asleep || movers_of_slots_[mover] == kFixed) continue;
            const Body& moving = bodies_.slots[mover];
            const double speed = length(moving.velocity) + length(moving.spin) * moving.shape.reach();
            if (speed < 2 * options_.sleep_speed) continue;
            near_.clear();
            find_pair_contacts(placed(mover), placed(sleeper), margin_of(moving, moving.shape.data()), near_);
            if (near_.empty()) continue;
            report_.woken += wake_island(bodies_, sleeper);
        }
        near_.clear();
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            if (!moves(slot) || movers_of_slots_[slot] != kFixed) continue;
            movers_of_slots_[slot] = std::uint32_t(movers_.size());
            movers_.push_back(make_mover(bodies_.slots[slot], slot));
        }
    }

    void find_contacts() {
        find_pairs();
        wake_what_is_met();
        WorldContacts of_world(world_, skin_);
        for (std::uint32_t k = 0; k < movers_.size(); ++k) {
            const Body& body = bodies_.slots[movers_[k].slot];
            const std::size_t first = near_.size();
            const double margin = margin_of(body, *movers_[k].shape);
            of_world.find(movers_[k], k, body, margin, far_of(body, *movers_[k].shape, margin), near_);
            if (!parts_.empty())
                of_world.find_on_parts(parts_, movers_[k], k, body, margin, largest_margin(*movers_[k].shape), near_);
            for (std::size_t contact = first; contact < near_.size(); ++contact) {
                near_[contact].friction = std::sqrt(body.friction * options_.contact_friction);
                near_[contact].restitution = body.restitution;
                near_[contact].rolling = body.rolling * near_[contact].radius_a;
            }
        }
        planes_ = of_world.take_planes();
        for (auto [one, other] : pairs_) {
            if (movers_of_slots_[one] == kFixed) std::swap(one, other);
            if (movers_of_slots_[one] == kFixed) continue;
            const Body &a = bodies_.slots[one], &b = bodies_.slots[other];
            const std::size_t first = near_.size();
            const double margin = margin_of(a, a.shape.data()) + (b.asleep ? 0 : margin_of(b, b.shape.data()));
            find_pair_contacts(placed(one), placed(other), margin, near_);
            for (std::size_t contact = first; contact < near_.size(); ++contact) {
                near_[contact].friction = std::sqrt(a.friction * b.friction);
                near_[contact].restitution = std::max(a.restitution, b.restitution);
                near_[contact].rolling =
                    std::max(a.rolling * near_[contact].radius_a, b.rolling * near_[contact].radius_b);
            }
        }
        sort_range(near_, [](const NearContact& a, const NearContact& b) {
            const auto key = [](const NearContact& of) {
                return std::tuple(of.at.body, of.at.other, of.at.sphere, of.at.other_sphere, of.gap, of.at.face.id,
                                  of.at.portal, of.at.part);
            };
            const auto first = key(a), second = key(b);
            return first != second ? first < second : lies_before(a.at, b.at);
        });
        report_.contacts = near_.size();
    }

    void solve() {
        pressed_.resize(near_.size());
        for (const MoverIsland& island : part_into_islands(movers_, near_)) solve(island);
        for (std::uint32_t k = 0; k < movers_.size(); ++k) movers_of_slots_[movers_[k].slot] = k;
    }

    void solve(const MoverIsland& island) {
        const int count = substeps_ * substeps_for(island.mass_ratio);
        const double substep = seconds_ / count;
        const std::span<Mover> movers = std::span(movers_).subspan(island.first_mover, island.movers);
        const std::span<NearContact> contacts = std::span(near_).subspan(island.first_contact, island.contacts);
        ContactSolver solver(movers_, movers, contacts, bodies_.contacts, parts_, substep,
                             iterations_for(island.mass_ratio));
        for (int k = 0; k < count; ++k) {
            for (Mover& mover : movers) {
                const Body& body = bodies_.slots[mover.slot];
                const Vec3 gain = (options_.gravity + body.force * mover.inverse_mass) * substep;
                mover.velocity += gain;
                mover.half_gain = contacts.empty() ? gain * 0.5 : Vec3{};
                if (body.torque != Vec3{}) twist(mover, body.torque * substep);
            }
            solver.substep();
        }
        solver.bounce(kBounceSpeed);
        solver.keep_forces();
        for (std::size_t k = 0; k < contacts.size(); ++k) pressed_[island.first_contact + k] = solver.pressed(k) > 0;
    }

    void twist(Mover& mover, const Vec3& impulse) {
        const Vec3 gain = mover.inverse_inertia * impulse;
        guard_.add_work(mover.slot, dot(impulse, mover.spin + gain * 0.5));
        mover.spin += gain;
    }

    /// What a light body takes at a time of the speed of a heavy one is in proportion to its mass.
    static int iterations_for(double mass_ratio) { return std::clamp(int(std::sqrt(mass_ratio) * 0.5 + 0.5), 1, 16); }

    /// A light body gives way by so much less where there are more: how far falls with their square.
    static int substeps_for(double mass_ratio) {
        constexpr double kAlike = 16;
        constexpr int kMax = 8;
        int times = 1;
        while (times < kMax && double(times) * times * kAlike < mass_ratio) ++times;
        return times;
    }

    /// Numbers so large that what came of them is none: the body stays where it was, at rest.
    void hold_unsound() {
        for (Mover& mover : movers_) {
            if (is_sound(mover)) continue;
            ++report_.unsound;
            mover.position = mover.start;
            mover.rotation = mover.start_rotation;
            mover.velocity = mover.spin = {};
            mover.turn_inertia();
        }
    }

    void sweep() {
        const SweepRules rules{skin_, seconds_, kBounceSpeed, options_.contact_friction, options_.max_bounces};
        BodySweep sweep(world_, parts_, bodies_, movers_, planes_, movers_of_slots_, sound_, rules);
        sweep.run();
        for (Mover& mover : movers_) slow_if_wedged(mover, sweep.is_wedged(mover.slot));
        sweep.tell(guard_);
        report_.swept = sweep.swept();
        report_.bounces = sweep.bounces();
        report_.woken += sweep.woken();
        for (const Mover& mover : movers_) {
            Body& body = bodies_.slots[mover.slot];
            body.crushed = sweep.is_crushed(mover.slot);
            report_.crushed += body.crushed;
        }
    }

    void guard_energy() {
        for (std::size_t k = 0; k < near_.size(); ++k) {
            const BodyContact& at = near_[k].at;
            if (!pressed_[k]) continue;
            if (at.other != kFixed)
                guard_.join(at.body, at.other);
            else
                guard_.hold(at.body);
            if (parts_.is_moving(at.part)) guard_.let_go(at.body);
        }
        guard_.run(movers_, movers_of_slots_, bodies_.slots);
    }

    /// What bounces to and fro where it has no room comes to rest there, instead of falling on and on in its place.
    void slow_if_wedged(Mover& mover, bool is_wedged) const {
        constexpr double kNoWay = 1e-5;  // metres, of any point
        if (!is_wedged) return;
        if (way_of(mover) > kNoWay) return;
        mover.velocity *= 0.5;
        mover.spin *= 0.5;
    }

    bool is_pressed(std::uint32_t one, std::uint32_t other) const {
        for (std::size_t k = 0; k < near_.size(); ++k) {
            const BodyContact& at = near_[k].at;
            if (pressed_[k] && std::minmax(at.body, at.other) == std::minmax(one, other)) return true;
        }
        return false;
    }

    /// Whether a slot's body moves, or is not there any more.
    bool may_have_gone(std::uint32_t slot) const {
        return movers_of_slots_[slot] != kFixed || !bodies_.slots[slot].shape.valid();
    }

    /// What lay on a body that went from under it too slowly to wake it, or was put elsewhere.
    void wake_what_is_left_behind() {
        std::pair<std::uint32_t, std::uint32_t> last{kFixed, kFixed};
        for (const BodyContact& contact : bodies_.contacts) {
            if (contact.other == kFixed || last == std::pair(contact.body, contact.other)) continue;
            if (may_have_gone(contact.body) == may_have_gone(contact.other)) continue;
            last = {contact.body, contact.other};
            const bool is_upper = may_have_gone(contact.other);
            const std::uint32_t sleeper = is_upper ? contact.body : contact.other;
            const double up = dot(contact.normal, options_.gravity) * (is_upper ? -1 : 1);
            if (up > 0 && bodies_.slots[sleeper].asleep && !is_pressed(contact.body, contact.other))
                report_.woken += wake_island(bodies_, sleeper);
        }
    }

    void put_back() {
        for (const Mover& mover : movers_) {
            put_back_mover(mover, bodies_.slots[mover.slot]);
        }
        wake_what_is_left_behind();
        // Of bodies that sleep the contacts are those that they fell asleep with.
        std::erase_if(bodies_.contacts, [&](const BodyContact& contact) {
            return may_have_gone(contact.body) || (contact.other != kFixed && may_have_gone(contact.other));
        });
        for (std::size_t k = 0; k < near_.size(); ++k)
            if (pressed_[k] && is_sound(near_[k].at)) bodies_.contacts.push_back(near_[k].at);
        sort_range(bodies_.contacts, [](const BodyContact& a, const BodyContact& b) {
            const auto key = [](const BodyContact& of) {
                return std::tuple(of.body, of.other, of.sphere, of.other_sphere, of.face.id, of.portal, of.part);
            };
            const auto first = key(a), second = key(b);
            return first != second ? first < second : lies_before(a, b);
        });
    }

    Bodies& bodies_;
    const World& world_;
    StepParts parts_;
    const StepOptions& options_;
    const double seconds_, skin_;
    const int substeps_;
    StepReport report_;
    std::vector<bool> sound_;  ///< of slots
    std::vector<Mover> movers_;
    std::vector<std::uint32_t> movers_of_slots_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
    std::vector<NearContact> near_;
    std::vector<NearPlane> planes_;  ///< of movers, each one's in a row
    std::vector<bool> pressed_;
    EnergyGuard guard_;
};

}  // namespace

StepReport step(Bodies& bodies, const Scene& scene, double seconds, const StepOptions& options) {
    if (!is_finite(seconds) || seconds < kShortestStep || !are_usable(options) || !is_usable_scene(scene)) {
        StepReport refused;
        refused.valid = false;
        return refused;
    }
    if (seconds <= kLongestStep) return Step(bodies, scene, seconds, options).run();
    const double stretch = (scene.to - scene.from) * (kLongestStep / seconds);
    const Scene shorter{scene.world, scene.parts, scene.from, scene.from + stretch};
    return Step(bodies, shorter, kLongestStep, options).run();
}

}  // namespace firma
