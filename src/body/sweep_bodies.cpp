// SPDX-License-Identifier: MIT
// Bodies swept along their way, and what they do where they meet the world.
#include "body/sweep_bodies.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/turn_between.h"
#include "firma/cast_set.h"

namespace firma {
namespace {

/// The spheres as they are swept: thinner by the skin, so that what rests on the world is clear of it.
const std::vector<Sphere>& cores_of(const BodyShapeData& shape, double skin) {
    thread_local std::vector<Sphere> cores;
    cores.clear();
    for (const Sphere& sphere : shape.spheres)
        cores.push_back({sphere.centre, sphere.radius - std::min(skin, 0.5 * sphere.radius)});
    return cores;
}

/// What a touch does to the velocities: Newton's restitution, and Coulomb's friction, of no more than brings sliding to
/// an end. Of both together no more than leaves the energy as it was.
/// @return whether the body was coming nearer at all
bool respond(Mover& mover, const Body& body, const SetHit& hit, const SweepRules& rules) {
    const Vec3 normal = hit.normal, from = hit.point - mover.position;
    const Vec3 speed = mover.velocity_at(from);
    const double approach = dot(speed, normal);
    if (!(approach < 0)) return false;
    const double restitution = approach < -rules.bounce_speed ? body.restitution : 0;
    const double pushed = -(1 + restitution) * approach / mover.yield(normal, from);
    Vec3 impulse = normal * pushed;
    Mover after = mover;
    after.push(impulse, from);
    const Vec3 sliding = speed - normal * approach;
    if (const double slides = length(sliding); slides > 0) {
        const Vec3 along = sliding * (1 / slides);
        const double stops = std::max(dot(after.velocity_at(from), along), 0.0) / mover.yield(along, from);
        impulse += along * -std::min(stops, std::sqrt(body.friction * rules.friction) * pushed);
    }
    after = mover;
    after.push(impulse, from);
    // Of s times the impulse the energy changes by s J.v + s^2 J.(v' - v) / 2.
    const double taken = -dot(impulse, speed), given = dot(impulse, after.velocity_at(from) - speed) / 2;
    mover.push(given > taken ? impulse * (taken / given) : impulse, from);
    return true;
}

}  // namespace

bool moved_clearly(const Mover& mover) {
    const Vec3 turn = turn_between(mover.start_rotation, mover.rotation);
    return length(mover.position - mover.start) + length(turn) * mover.shape->reach < mover.clear;
}

int sweep_body(const World& world, Mover& mover, const Body& body, const SweepRules& rules) {
    const std::vector<Sphere>& cores = cores_of(*mover.shape, rules.skin);
    CastOptions options;
    options.mask = body.mask;
    options.contact_offset = rules.skin * 0.25;
    SetMotion motion{mover.start, mover.start_rotation, mover.position - mover.start,
                     turn_between(mover.start_rotation, mover.rotation)};
    double left = rules.seconds;
    int met = 0;
    for (;;) {
        const SetHit hit = cast(world, cores, motion, options);
        if (!hit.touched()) {
            const Pose end = pose_at(motion, 1);
            mover.position = end.position;
            mover.rotation = normalised(end.rotation);
            if (hit.status == Status::kInvalid) mover.position = mover.start, mover.rotation = mover.start_rotation;
            break;
        }
        ++met;
        const Pose at = pose_at(motion, hit.safe_fraction);
        mover.position = at.position;
        mover.rotation = normalised(at.rotation);
        mover.turn_inertia();
        const bool approaching = respond(mover, body, hit, rules);
        left *= 1 - hit.safe_fraction;
        if (met > rules.max_bounces || !approaching) break;
        motion = {mover.position, mover.rotation, mover.velocity * left, mover.spin * left};
    }
    mover.turn_inertia();
    return met;
}

}  // namespace firma
