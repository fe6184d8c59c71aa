// SPDX-License-Identifier: MIT
// Pushes of explosions; rays decide what covers whom.
#include <algorithm>
#include <cmath>

#include "body/mover.h"
#include "firma/blast.h"
#include "firma/queries.h"

namespace firma {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Of a sphere's radius: how far around its middle rays go.
constexpr double kAround = 0.75;
constexpr int kRays = 5;

bool is_sound(const Blast& blast) {
    return is_finite(blast.at) && is_finite(blast.radius) && blast.radius > 0 && is_finite(blast.impulse) &&
           blast.impulse >= 0;
}

/// As its stretch begins: nothing moves while a blast goes on.
Scene standing(const Scene& scene) {
    return {scene.world, scene.parts, scene.from, scene.from};
}

bool sees(const Scene& scene, const Vec3& from, const Vec3& to, const CastOptions& options) {
    const Vec3 path = to - from;
    if (path == Vec3{}) return true;
    return cast_any(scene, Ray{from, path}, options) == Status::kMiss;
}

/// How many of the rays to a sphere get there.
int rays_seen(const Scene& scene, const Vec3& from, const Sphere& sphere, const CastOptions& options) {
    const Vec3 way = sphere.centre - from;
    const double far = length(way);
    int seen = sees(scene, from, sphere.centre, options);
    if (!(far > 0)) return seen ? kRays : 0;
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::fabs(way[axis]) < std::fabs(way[least])) least = axis;
    Vec3 along;
    along[least] = 1;
    Vec3 u = cross(way, along);
    u = u * (kAround * sphere.radius / length(u));
    const Vec3 v = cross(way, u) * (1 / far);
    for (const Vec3& around : {u, v, -u, -v}) seen += sees(scene, from, sphere.centre + around, options);
    return seen;
}

CastOptions options_of(std::uint32_t mask) {
    CastOptions options;
    options.mask = mask;
    return options;
}

/// What a body gets from a blast.
struct BodyPush {
    Vec3 impulse;  ///< newton seconds
    Vec3 twist;    ///< newton metre seconds, about its centre of mass
    bool reached = false, seen = false;
};

BodyPush push_of(const Scene& scene, const Body& body, const Blast& blast, const CastOptions& options) {
    BodyPush push;
    const Pose pose = pose_of(body);
    const TurnMatrix turn = matrix_of(pose.rotation);
    const std::span<const Sphere> spheres = body.shape.spheres();
    double squares = 0;
    for (const Sphere& sphere : spheres) squares += sphere.radius * sphere.radius;
    // Spheres lie over each other: together they show no more than the ball that they are in.
    const double reach = body.shape.reach(), shown = std::min(1.0, reach * reach / squares);
    for (const Sphere& given : spheres) {
        const Sphere sphere{pose.position + turn * given.centre, given.radius};
        if (!(length(sphere.centre - blast.at) < blast.radius)) continue;
        push.reached = true;
        const int seen = rays_seen(scene, blast.at, sphere, options);
        if (seen == 0) continue;
        push.seen = true;
        const double area = kPi * sphere.radius * sphere.radius * shown;
        const Vec3 impulse = blast_impulse(blast, sphere.centre, area, double(seen) / kRays);
        push.impulse += impulse;
        push.twist += cross(sphere.centre - body.position, impulse);
    }
    return push;
}

/// @param max_speed  of what it adds, at any point of the body
void give(Bodies& bodies, BodyId id, const BodyPush& push, double max_speed) {
    wake_body(bodies, id);
    Body& body = *bodies.find(id);
    const Mover mover = make_mover(body, id.slot);
    const Vec3 velocity = push.impulse * mover.inverse_mass, spin = mover.inverse_inertia * push.twist;
    const double speed = length(velocity), turning = length(spin) * body.shape.reach();
    if (!is_finite(speed) || !is_finite(turning)) return;  // pushes beyond all numbers
    body.velocity += velocity * (speed > max_speed ? max_speed / speed : 1);
    body.spin += spin * (turning > max_speed ? max_speed / turning : 1);
}

}  // namespace

double blast_share(const Blast& blast, double distance) {
    if (!is_sound(blast) || !is_finite(distance)) return 0;
    const double left = 1 - std::max(distance, 0.0) / blast.radius;
    return left > 0 ? left * left : 0;
}

Vec3 blast_impulse(const Blast& blast, const Vec3& point, double area, double seen) {
    if (!is_finite(point) || !is_finite(area) || !(area > 0) || !(seen > 0 && seen <= 1)) return {};
    const Vec3 way = point - blast.at;
    const double far = length(way), size = blast.impulse * blast_share(blast, far) * area * seen;
    if (!(size > 0) || !is_finite(size)) return {};
    return far > 0 ? way * (size / far) : Vec3{0, 0, size};
}

double exposure(const Scene& scene, const Vec3& from, std::span<const Vec3> points, std::uint32_t mask) {
    if (points.empty() || !is_finite(from)) return 0;
    const CastOptions options = options_of(mask);
    const Scene there = standing(scene);
    std::size_t seen = 0;
    for (const Vec3& point : points) seen += is_finite(point) && sees(there, from, point, options);
    return double(seen) / double(points.size());
}

double exposure(const Scene& scene, const Vec3& from, std::span<const Sphere> spheres, std::uint32_t mask) {
    if (!is_finite(from)) return 0;
    const CastOptions options = options_of(mask);
    const Scene there = standing(scene);
    double seen = 0, all = 0;
    for (const Sphere& sphere : spheres) {
        const double square = sphere.radius * sphere.radius;
        if (!is_finite(sphere.centre) || !is_finite(square) || !(sphere.radius >= 0)) continue;
        // Points count, too: as if of a radius that is nothing beside others'.
        const double weight = square + 0x1p-60;
        all += weight;
        seen += weight * rays_seen(there, from, sphere, options) / kRays;
    }
    return all > 0 ? std::min(seen / all, 1.0) : 0;
}

PushReport blast_push(const Scene& scene, Bodies& bodies, const Blast& blast, const PushOptions& options) {
    PushReport report;
    if (!is_sound(blast) || !(options.max_speed >= 0)) return report;
    const CastOptions rays = options_of(options.mask);
    const Scene there = standing(scene);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& body = bodies.slots[slot];
        if (!body.shape.valid()) continue;
        if (!(length(body.position - blast.at) < blast.radius + body.shape.reach())) continue;
        const BodyPush push = push_of(there, body, blast, rays);
        report.reached += push.reached;
        report.pushed += push.seen;
        if (push.seen) give(bodies, {slot, body.use}, push, options.max_speed);
    }
    return report;
}

}  // namespace firma
