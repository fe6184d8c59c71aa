// SPDX-License-Identifier: MIT
// A step of all projectiles: in pieces of work, their events in one order.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "base/hasher.h"
#include "base/run_tasks.h"
#include "base/sort.h"
#include "body/shot_flight.h"

namespace firma {
namespace {

constexpr std::size_t kPerPiece = 256;
constexpr int kMostImpacts = 1000;

Error refused(std::string reason) {
    return {ErrorCode::kInvalid, "fly", std::move(reason)};
}

std::optional<Error> fault_of_flight(double seconds, const FlyOptions& options) {
    if (!(seconds > 0 && seconds <= kMaxFlightSeconds)) return refused("seconds are not above 0 and at most 1");
    if (!is_finite(options.gravity)) return refused("gravity is not finite");
    if (!(options.max_bow > 0) || !is_finite(options.max_bow)) return refused("max_bow is no length above 0");
    if (!(options.max_age >= 0) || !is_finite(options.max_age)) return refused("max_age is no time");
    if (!(options.stop_speed >= 0) || !is_finite(options.stop_speed)) return refused("stop_speed is no speed");
    if (options.max_impacts < 1 || options.max_impacts > kMostImpacts) return refused("max_impacts is out of range");
    if (!(options.max_thickness >= 0 && options.max_thickness <= kFlightReach))
        return refused("max_thickness is no length within reach");
    if (!(options.pane_energy >= 0) || !is_finite(options.pane_energy)) return refused("pane_energy is no energy");
    if (!is_usable(options.other) || !is_usable(options.bodies)) return refused("terms are out of range");
    for (std::size_t k = 0; k < options.matters.size(); ++k)
        if (!is_usable(options.matters[k]))
            return refused("terms of matter " + std::to_string(k) + " are out of range");
    if (!(chords_for(seconds, options) <= kMaxFlightChords))
        return Error{ErrorCode::kTooLarge, "fly", "gravity and max_bow ask for too many chords"};
    return std::nullopt;
}

std::optional<Error> fault_of_projectiles(std::span<const Projectile> projectiles) {
    for (std::size_t k = 0; k < projectiles.size(); ++k) {
        const Projectile& it = projectiles[k];
        if (it.state != ProjectileState::kFlying) continue;
        const bool sound = is_finite(it.position) && max_abs(it.velocity) <= kMaxFlightSpeed && it.mass > 0 &&
                           is_finite(it.mass) && it.age >= 0 && is_finite(it.age) && is_finite(it.velocity);
        if (!sound)
            return Error{ErrorCode::kOutOfRange, "projectile " + std::to_string(k),
                         "a number is not finite or out of range"};
    }
    return std::nullopt;
}

std::optional<Error> fault_of_scene(const Scene& scene, double seconds) {
    if (!(scene.from >= 0 && scene.from <= scene.to && scene.to <= 1))
        return refused("the scene's stretch is not within 0 to 1");
    for (std::size_t k = 0; k < scene.parts.size(); ++k) {
        const MovingPart& part = scene.parts[k];
        const char* reason = nullptr;
        if (!is_usable_part(part))
            reason = "its motion cannot be used";
        else if (!(fastest_of_part(scene, part, seconds) <= kMaxPartSpeed))
            reason = "it goes faster than 2^60 m/s";
        if (reason) return Error{ErrorCode::kInvalid, "part " + std::to_string(k), reason};
    }
    return std::nullopt;
}

/// What one piece of work made.
struct FlownPiece {
    std::vector<Projectile> projectiles;
    ShotEvents events;
    std::size_t chords = 0, impacts = 0;
};

class FlightOfAll {
public:
    FlightOfAll(std::span<const Projectile> projectiles, const Scene& scene, double seconds, const FlyOptions& options,
                const Bodies* bodies)
        : projectiles_(projectiles), world_(scene.world), seconds_(seconds), options_(options), bodies_(bodies) {
        if (bodies) targets_ = std::make_unique<BodyTargets>(*bodies);
        if (!scene.parts.empty()) parts_ = std::make_unique<PartTargets>(scene, seconds);
        pieces_.resize((projectiles.size() + kPerPiece - 1) / kPerPiece);
    }

    bool run() {
        const auto fly_piece = [](void* self, std::size_t k) { static_cast<FlightOfAll*>(self)->fly_piece(k); };
        return run_tasks(options_.tasks ? *options_.tasks : Tasks{}, pieces_.size(), fly_piece, this);
    }

    FlyReport put_back(std::span<Projectile> projectiles, ShotEvents& all) const {
        FlyReport report;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const FlownPiece& piece = pieces_[k];
            report.chords += piece.chords;
            report.impacts += piece.impacts;
            std::copy(piece.projectiles.begin(), piece.projectiles.end(),
                      projectiles.begin() + std::ptrdiff_t(k * kPerPiece));
            const std::uint32_t moved = std::uint32_t(all.matters.size());
            all.matters.insert(all.matters.end(), piece.events.matters.begin(), piece.events.matters.end());
            for (ShotEvent event : piece.events.events) {
                if (event.matter_count > 0) event.first_matter += moved;
                all.events.push_back(event);
            }
        }
        for (const Projectile& it : projectiles) report.flying += it.state == ProjectileState::kFlying;
        sort_range(all.events, [](const ShotEvent& a, const ShotEvent& b) {
            return std::tuple(a.time, a.projectile, a.number) < std::tuple(b.time, b.projectile, b.number);
        });
        return report;
    }

private:
    void fly_piece(std::size_t k) {
        const std::size_t first = k * kPerPiece, count = std::min(kPerPiece, projectiles_.size() - first);
        FlownPiece& piece = pieces_[k];
        piece.projectiles.assign(projectiles_.begin() + std::ptrdiff_t(first),
                                 projectiles_.begin() + std::ptrdiff_t(first + count));
        ShotFlight flight(world_, options_, bodies_, targets_.get(), parts_.get(), piece.events);
        for (std::size_t at = 0; at < count; ++at)
            if (piece.projectiles[at].state == ProjectileState::kFlying)
                flight.fly(piece.projectiles[at], std::uint32_t(first + at), seconds_);
        piece.chords = flight.chords();
        piece.impacts = flight.impacts();
    }

    const std::span<const Projectile> projectiles_;
    const World& world_;
    const double seconds_;
    const FlyOptions& options_;
    const Bodies* bodies_;
    std::unique_ptr<BodyTargets> targets_;
    std::unique_ptr<PartTargets> parts_;
    std::vector<FlownPiece> pieces_;
};

}  // namespace

Result<FlyReport> fly(std::span<Projectile> projectiles, const Scene& scene, double seconds, ShotEvents& events,
                      const FlyOptions& options, Bodies* bodies) {
    events.events.clear();
    events.matters.clear();
    if (const auto fault = fault_of_flight(seconds, options)) return *fault;
    if (const auto fault = fault_of_projectiles(projectiles)) return *fault;
    if (const auto fault = fault_of_scene(scene, seconds)) return *fault;
    FlightOfAll flight(projectiles, scene, seconds, options, bodies);
    if (!flight.run()) return refused("Tasks::run returned before all its work had");
    const FlyReport report = flight.put_back(projectiles, events);
    for (const ShotEvent& event : events.events)
        if (event.body.slot != ~0u) push_body(*bodies, event.body, event.impulse, event.point);
    return report;
}

Result<FlyReport> fly(std::span<Projectile> projectiles, const World& world, double seconds, ShotEvents& events,
                      const FlyOptions& options, Bodies* bodies) {
    return fly(projectiles, Scene{world}, seconds, events, options, bodies);
}

std::uint64_t hash_projectiles(std::span<const Projectile> projectiles) {
    Hasher hash;
    for (const Projectile& it : projectiles) {
        for (const Vec3& v : {it.position, it.velocity})
            for (int axis = 0; axis < 3; ++axis) hash.add(v[axis]);
        hash.add(it.mass);
        hash.add(it.age);
        hash.add(it.mask);
        hash.add(it.world_hash);
        hash.add(std::uint32_t(it.state));
    }
    return hash.value();
}

}  // namespace firma
