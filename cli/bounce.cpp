// SPDX-License-Identifier: MIT
// Nothing here but +, -, *, / and sqrt, and no order that depends on addresses: the same walk on every machine.
#include "cli/bounce.h"
#include "firma/queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "cli/failure.h"
#include "cli/numbers.h"

namespace firma::cli {

namespace {

// Kept from faces, metres: far more than casts are rounded by even at 8 km, and little enough for the narrowest doors.
constexpr double kSkin = 1e-6;
// Where not even that much room is left. A sphere may go up to the faces themselves; a particle would pass them by
// rounding.
constexpr double kTightSkin = 0, kTightParticleSkin = 1e-7;
constexpr double kLeastSphere = 1e-6;  // metres of radius; smaller ones are treated as particles
/// A start this much nearer than the radius, metres, is taken for touching: decimals are rounded.
constexpr double kStartSlack = 1e-9;
constexpr int kLooks = 16;      // directions compared at a bounce, at least ...
constexpr int kMostLooks = 96;  // ... and at most, while none leads to new ground
constexpr double kNewGround = 0.25;
constexpr int kTightLooks = 32;     // more of them, out of the corner, where none of those goes anywhere
constexpr int kSamples = 32;        // cells looked at along one flight, at most
constexpr double kRowsPerCell = 8;  // on average, if all cells are visited alike
constexpr double kTiny = 1.0 / 64;  // of a cell: a flight that does not count as going anywhere

Vec3 unit(const Vec3& v) {
    return v * (1 / length(v));
}

/// The part of a unit direction that leads along a face, unit; the direction itself where there is no such part.
Vec3 along(const Vec3& direction, const Vec3& normal) {
    const Vec3 flat = direction - normal * dot(direction, normal);
    return dot(flat, flat) > 1e-6 ? unit(flat) : direction;
}

/// Of the air that the faces enclose, cubic metres; of the bounds when they enclose none.
double volume_of(const World& world) {
    const Box bounds = world.bounds();
    const Vec3 size = bounds.high - bounds.low;
    double six = 0;
    for (const Face& face : world.faces()) {
        const Vec3 first = face.corners[0] - bounds.low;
        for (std::size_t k = 1; k + 1 < face.corners.size(); ++k)
            six += dot(first, cross(face.corners[k] - bounds.low, face.corners[k + 1] - bounds.low));
    }
    const double volume = std::fabs(six) / 6;
    return volume > 0 ? volume : size.x * size.y * size.z;
}

/// Metres, so that each cell gets about kRowsPerCell rows. (A cube root by the library differs between machines.)
double choose_cell_size(double volume, std::uint64_t frames) {
    double size = 1024;
    while (size > 0x1p-10 && volume * kRowsPerCell < double(frames) * size * size * size) size *= 0.875;
    return size;
}

}  // namespace

std::size_t Bouncer::CellHash::operator()(const Cell& cell) const {
    return scenes::Rng(std::uint64_t(cell.x) * 0x9E3779B97F4A7C15ull ^ std::uint64_t(cell.y) * 0xC2B2AE3D27D4EB4Full ^
                       std::uint64_t(cell.z) * 0x165667B19E3779F9ull)
        .next();
}

Bouncer::Bouncer(const World& world, const Sphere& start, std::uint64_t frames, std::uint64_t seed)
    : world_(world), rng_(seed), place_(start.centre), radius_(start.radius) {
    const Box bounds = world.bounds();
    if (bounds.empty()) throw Failure("walk", "the level has no faces, so nothing holds the sphere");
    for (int axis = 0; axis < 3; ++axis) {
        if (place_[axis] - radius_ < bounds.low[axis] - kSkin || place_[axis] + radius_ > bounds.high[axis] + kSkin)
            throw Failure("--start",
                          fmt::format("{} with radius {} lies outside of the level, {} .. {}", point_text(place_),
                                      radius_, point_text(bounds.low), point_text(bounds.high)));
    }
    const NearFace nearest = closest(world, place_);
    const std::optional<FaceInfo> face = world.face_info(nearest.face);
    const std::uint32_t source = face ? face->source : 0;
    if (nearest.found() && nearest.distance == 0)
        throw Failure("--start", fmt::format("{} lies on face {}", point_text(place_), source));
    if (nearest.found() && nearest.distance < radius_ - kStartSlack)
        throw Failure("--start", fmt::format("{} is {} m from face {}, nearer than the radius of {} m",
                                             point_text(place_), nearest.distance, source, radius_));
    const Vec3 size = bounds.high - bounds.low;
    span_ = 2 * (length(size) + 1);
    cell_size_ = choose_cell_size(volume_of(world), frames);
    ++visits_[cell_at(place_)];
}

void Bouncer::step() {
    // A flight that was seen from afar may turn out to end right here, by rounding; then another is chosen in the same
    // frame.
    for (int attempt = 0; attempt < 4; ++attempt) {
        if (!flying_ && !choose_flight()) break;
        if (fly()) break;
    }
    ++visits_[cell_at(place_)];
}

/// Moves along the flight, as far as one frame goes. @return whether it moved at all
bool Bouncer::fly() {
    const Vec3 path = flight_.direction * (cell_size_ * rng_.uniform(1, 3));
    CastOptions options;
    options.sides = Sides::kBoth;
    options.contact_offset = flight_.contact_offset;
    const Hit hit = cast(world_, {place_, radius_}, path, options);
    const Vec3 before = place_;
    if (hit.touched()) {
        place_ = place_ + path * hit.safe_fraction;
        normal_ = hit.normal;
        flying_ = false;
    } else {
        place_ = place_ + path;
    }
    return place_ != before;
}

/// Looks in several directions and sets out in the best. @return false when there is nowhere to go
bool Bouncer::choose_flight() {
    flight_ = {};
    for (int k = 0; k < kMostLooks && (k < kLooks || flight_.worth < kNewGround); ++k) {
        // Half of them nearer to the face than chalk would send them: that is the way along a corridor.
        const Flight seen = look(k % 2 == 0 ? chalk_direction(normal_) : even_direction(normal_), kSkin);
        if (seen.length > 0 && seen.worth > flight_.worth) flight_ = seen;
    }
    if (flight_.length < kTiny * cell_size_) look_for_a_way_out();
    flying_ = flight_.length > 0;
    return flying_;
}

/// In a sharp corner or a slot: away from all faces at once, ever more narrowly, or along one of them.
void Bouncer::look_for_a_way_out() {
    const std::vector<Vec3> normals = normals_in_reach();
    Vec3 away;
    for (const Vec3& normal : normals) away = away + normal;
    for (const double contact_offset : {kSkin, radius_ < kLeastSphere ? kTightParticleSkin : kTightSkin}) {
        for (int k = 0; k < kTightLooks && flight_.length < kTiny * cell_size_; ++k) {
            Vec3 direction = direction_near(away);
            if (k % 2 == 1 && !normals.empty())
                direction = along(direction, normals[rng_.below(std::uint32_t(normals.size()))]);
            const Flight seen = look(direction, contact_offset);
            if (seen.length > flight_.length) flight_ = seen;
        }
    }
}

/// How far the sphere could go, and over what ground.
Bouncer::Flight Bouncer::look(const Vec3& direction, double contact_offset) const {
    CastOptions options;
    options.sides = Sides::kBoth;
    options.contact_offset = contact_offset;
    const Hit hit = cast(world_, {place_, radius_}, direction * span_, options);
    if (!hit.touched())
        throw Failure(
            "walk", fmt::format("the level is not closed: from {} nothing stops the sphere along {} (see firma check)",
                                point_text(place_), point_text(direction)));
    Flight flight{direction, hit.safe_fraction * span_, contact_offset, 0};
    flight.worth = worth_of(flight);
    return flight;
}

double Bouncer::worth_of(const Flight& flight) const {
    const int samples = 1 + int(std::min(flight.length / cell_size_, double(kSamples - 1)));
    double worth = 0;
    for (int k = 0; k < samples; ++k) {
        const auto found = visits_.find(cell_at(place_ + flight.direction * (flight.length * (k + 1) / samples)));
        const double visits = found == visits_.end() ? 0 : found->second;
        worth += 1 / ((1 + visits) * (1 + visits));
    }
    return worth / (samples + 1);
}

/// By the cosine law about a unit normal; evenly in all directions when there is none.
Vec3 Bouncer::chalk_direction(const Vec3& normal) {
    for (;;) {
        const Vec3 v = rng_.direction() + normal;
        if (dot(v, v) > 1e-6) return unit(v);
    }
}

/// Evenly over the half of all directions that leads away from a face.
Vec3 Bouncer::even_direction(const Vec3& normal) {
    const Vec3 direction = rng_.direction();
    return dot(direction, normal) < 0 ? -direction : direction;
}

/// Narrower and narrower about a direction, by chance: the way out of a sharp corner is a thin cone.
Vec3 Bouncer::direction_near(const Vec3& direction) {
    const double width = std::ldexp(1.0, 1 - int(rng_.below(20)));
    for (;;) {
        const Vec3 v = direction + rng_.direction() * width;
        if (dot(v, v) > 1e-12) return unit(v);
    }
}

/// From the faces about to be touched, unit.
std::vector<Vec3> Bouncer::normals_in_reach() const {
    std::vector<Overlap> near;
    overlap(world_, {place_, radius_ + 4 * kSkin}, near);
    std::vector<Vec3> normals;
    for (const Overlap& face : near) {
        const Vec3 away = place_ - face.point;
        if (dot(away, away) > 0) normals.push_back(unit(away));
    }
    return normals;
}

Bouncer::Cell Bouncer::cell_at(const Vec3& point) const {
    const auto index = [&](double x) { return std::int64_t(std::floor(x / cell_size_)); };
    return {index(point.x), index(point.y), index(point.z)};
}

}  // namespace firma::cli
