// SPDX-License-Identifier: MIT
// A player and parts of the level that move: carried by what it stands on, pushed by what comes.
#include <algorithm>
#include <cmath>

#include "moving/part_frame.h"
#include "player/player_tick.h"

namespace firma {
namespace {

constexpr int kMaxRideSteps = 64;
constexpr int kMaxPushes = 8;
/// Of the radius: no part goes farther at a time, so that what comes is met on the side that it comes from.
constexpr double kRideStep = 0.25;
/// Rounding, metres: a touch is no overlap.
constexpr double kPressed = 1e-9;
/// Slop, a share of a push: one that leads no farther is held.
constexpr double kHeldBack = 1e-3;

/// The most that any point of a part goes, metres.
double reach_of(const MovingPart& part) {
    const Box& box = part.bounds();
    if (box.empty()) return 0;
    const double far = length(
        Vec3{std::max(-box.low.x, box.high.x), std::max(-box.low.y, box.high.y), std::max(-box.low.z, box.high.z)});
    return length(part.motion.path) + length(part.motion.turn) * far;
}

}  // namespace

Vec3 PlayerTick::speed_of(std::uint32_t part) const {
    if (part == kNoPart || !(seconds_ > 0)) return {};
    return velocity_at(scene_.parts[part].motion, scene_.from, player_.position) * (1 / seconds_);
}

// All parts go to the end of their motions, in steps so small that none gets past it.
void PlayerTick::ride() {
    if (scene_.parts.empty()) return;
    if (player_.ground_part != kNoPart && !(player_.ground_part < scene_.parts.size())) leave_ground();
    double most = 0;
    for (const MovingPart& part : scene_.parts) most = std::max(most, reach_of(part));
    const int steps = int(std::clamp(std::ceil(most / (shape_.radius * kRideStep)), 1.0, double(kMaxRideSteps)));
    for (int k = 1; k <= steps; ++k) {
        const double before = scene_.from, after = double(k) / steps;
        scene_.from = scene_.to = after;
        carry(before, after);
        give_way();
    }
    // Who stands on a part stands on it still when that changes its speed.
    if (player_.on_ground) player_.ground_velocity = speed_of(player_.ground_part);
}

void PlayerTick::carry(double before, double after) {
    if (!player_.on_ground || player_.ground_part == kNoPart) return;
    const RigidMotion& motion = scene_.parts[player_.ground_part].motion;
    const PartFrame from(motion, before), to(motion, after);
    Vec3 left = to.out(from.in(player_.position)) - player_.position;
    AllowedMotion walls;
    for (int slide = 0; slide < kMaxSlides; ++slide) {
        const Vec3 path = walls.nearest(left);
        if (!(max_abs(path) > 0)) break;
        const PartHit hit = posture_.sweep_ahead(player_.position, path);
        player_.position += path * hit.safe_fraction;
        move_.carried += path * hit.safe_fraction;
        left *= 1 - hit.safe_fraction;
        if (!hit.touched()) break;
        walls.add(hit.normal);
    }
}

// Out of parts that came where it is, as far as level and other parts leave room.
void PlayerTick::give_way() {
    for (int k = 0; k < kMaxPushes; ++k) {
        const PartOverlap overlap = posture_.deepest_of_parts(player_.position);
        if (!(overlap.depth > kPressed)) break;
        const Vec3 path = overlap.direction * (overlap.depth + offset_);
        const PartHit hit = posture_.sweep(player_.position, path);
        player_.position += path * hit.safe_fraction;
        move_.carried += path * hit.safe_fraction;
        move_.pushed_by = overlap.part;
        if (hit.safe_fraction < kHeldBack) break;
    }
    const PartOverlap left = posture_.deepest_of_parts(player_.position);
    const std::uint32_t around = posture_.part_around(player_.position);
    if (left.depth > kPressed)
        move_.crushed_by = left.part;
    else if (around != kNoPart)
        move_.crushed_by = around;
}

}  // namespace firma
