// SPDX-License-Identifier: MIT
// Parts in a step, and sets of spheres on their way among them.
#include "body/step_parts.h"

#include <algorithm>
#include <cmath>

#include "base/hasher.h"
#include "body/body_tolerance.h"
#include "body/sphere_set_sweep.h"

namespace firma {
namespace {

/// As far as any point of a box is from the origin of its frame.
double radius_of(const Box& box) {
    if (box.empty()) return 0;
    Vec3 far;
    for (int axis = 0; axis < 3; ++axis) far[axis] = std::max(std::fabs(box.low[axis]), std::fabs(box.high[axis]));
    return length(far);
}

std::uint64_t hash_of(const StepPart& part) {
    Hasher hash;
    hash.add(hash_world(part.part.world()));
    for (int axis = 0; axis < 3; ++axis) hash.add(part.motion.position[axis]);
    for (const double number : part.motion.rotation) hash.add(number);
    hash.add(part.part.mask);
    return hash.value();
}

/// Where the stretch is from one fraction of the step to another.
Scene between(const Scene& stretch, double from, double to) {
    const double wide = stretch.to - stretch.from, end = std::min(stretch.from + wide * to, stretch.to);
    return {stretch.world, stretch.parts, std::min(stretch.from + wide * from, end), end};
}

}  // namespace

bool StepPart::may_meet(const Vec3& centre, double reach) const {
    Box box = part.bounds();
    if (box.empty()) return false;
    const double more = (reach + way) * (1 + 0x1p-30) + 0x1p-16;
    const Vec3 there = frame.in(centre);
    for (int axis = 0; axis < 3; ++axis)
        if (!(there[axis] >= box.low[axis] - more && there[axis] <= box.high[axis] + more)) return false;
    return true;
}

StepParts::StepParts(const Scene& scene, double seconds) : from_(scene.from), to_(scene.to), seconds_(seconds) {
    parts_.reserve(scene.parts.size());
    for (const MovingPart& part : scene.parts) {
        const RigidMotion motion = motion_between(part.motion, from_, to_);
        const double rate = 1 / seconds;
        StepPart now{part, motion, PartFrame(motion, 0), motion.path * rate, motion.turn * rate};
        now.way = length(motion.path) + length(motion.turn) * radius_of(part.bounds());
        now.moves = !(motion.path == Vec3{}) || turns(motion);
        parts_.push_back(now);
    }
}

void StepParts::compare(std::vector<std::uint64_t>& hashes) {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const std::uint64_t hash = hash_of(parts_[k]);
        parts_[k].changed = parts_[k].moves || k >= hashes.size() || hashes[k] != hash;
        if (k < hashes.size())
            hashes[k] = hash;
        else
            hashes.push_back(hash);
    }
    hashes.resize(parts_.size());
}

StepPartHit StepParts::cast_set(std::span<const Sphere> spheres, const RigidMotion& motion, double from, double to,
                                std::uint32_t left_out, const CastOptions& options) const {
    StepPartHit first;
    double reach = 0;
    for (const Sphere& sphere : spheres) reach = std::max(reach, length(sphere.centre) + sphere.radius);
    for (std::uint32_t number = 0; number < parts_.size(); ++number) {
        const StepPart& part = parts_[number];
        if (number == left_out || !(part.part.mask & options.mask)) continue;
        if (!part.may_meet(motion.position, reach + length(motion.path))) continue;
        const Scene stretch = between({nothing_, {&part.part, 1}, from_, to_}, from, to);
        const auto may_meet = [&](double, double, const Sphere& sphere, const Vec3& path) {
            return part.may_meet(sphere.centre, sphere.radius + length(path));
        };
        const auto cast_chord = [&](double begin, double end, const Sphere& sphere, const Vec3& path) {
            return cast(between(stretch, begin, end), sphere, path, options);
        };
        first_of_set(spheres, motion, first, [&](const Arc& arc, double radius, double before) {
            StepPartHit hit;
            static_cast<Hit&>(hit) = first_on_arc(arc, radius, 0, before, may_meet, cast_chord);
            if (!hit.touched()) return hit;
            hit.part = number;
            const double at = from + hit.fraction * (to - from);
            const Vec3 surface = part.velocity_of(hit.point, at * seconds_) * (seconds_ * (to - from));
            const double speed = dot(surface - arc.velocity_at(hit.fraction), hit.normal);
            hit.safe_fraction = fraction_before(hit.fraction, options.contact_offset, speed);
            return hit;
        });
        if (first.fraction == 0) break;
    }
    return first;
}

StepParts::Carried StepParts::carried(std::uint32_t part, const Vec3& position, const Quaternion& rotation,
                                      double from) const {
    const RigidMotion& motion = parts_[part].motion;
    const Vec3 seen = PartFrame(motion, from).in(position);
    // No farther from the axis than that; an arc of an angle a is r a^2 / 8 off its chord.
    const double turn = length(motion.turn) * (1 - from), radius = length(seen);
    const double most = radius > 0 ? std::sqrt(8 * kMaxSag / radius) : turn;
    const double to = turn > most ? from + (1 - from) * (most / turn) : 1;
    const Vec3 end = PartFrame(motion, to).out(seen);
    return {{position, rotation, end - position, motion.turn * (to - from)}, to};
}

}  // namespace firma
