// SPDX-License-Identifier: MIT
// Bodies in solid.
#include "body/stuck_bodies.h"

#include <algorithm>

#include "body/rest.h"
#include "firma/rooms.h"

namespace firma {
namespace {

constexpr double kWayOutSpeed = 4;  // metres a second

template <class Visit>
void each_sphere(const Body& body, const Visit& visit) {
    const Pose pose = pose_of(body);
    const TurnMatrix turn = matrix_of(pose.rotation);
    for (const Sphere& sphere : body.shape.spheres())
        if (!visit(Sphere{pose.position + turn * sphere.centre, sphere.radius})) return;
}

bool is_in(const World& world, const Vec3& point) {
    return locate(world.solid(), point) == Where::kSolid;
}

/// Of the spheres in solid the one that is deepest decides: its way to the nearest face, and as far as it is thick.
Vec3 way_out(const Body& body, const World& world) {
    Vec3 way;
    double deepest = 0;
    each_sphere(body, [&](const Sphere& sphere) {
        if (!is_in(world, sphere.centre)) return true;
        const NearFace near = closest(world, sphere.centre);
        if (!near || near.distance + sphere.radius <= deepest) return true;
        deepest = near.distance + sphere.radius;
        const Vec3 to = near.point - sphere.centre;
        const std::optional<FaceInfo> face = world.face_info(near.face);
        way = near.distance > 0 ? to * (deepest / near.distance) : face ? face->normal * deepest : Vec3{};
        return true;
    });
    return way;
}

}  // namespace

void find_stuck(Bodies& bodies, const World& world, bool all) {
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& body = bodies.slots[slot];
        if (!body.shape.valid() || !(all || body.stuck)) continue;
        bool stuck = false;
        each_sphere(body, [&](const Sphere& sphere) { return !(stuck = is_in(world, sphere.centre)); });
        if (stuck && body.asleep) wake_island(bodies, slot);
        body.stuck = stuck;
    }
}

void move_out(Body& body, const World& world, double seconds) {
    const Vec3 way = way_out(body, world);
    const double far = length(way), step = std::min(far, kWayOutSpeed * seconds);
    if (far > 0) body.position += way * (step / far);
    body.velocity = body.spin = {};
}

}  // namespace firma
