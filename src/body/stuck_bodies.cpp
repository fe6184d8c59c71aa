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
void each_sphere(const Body& body, const Pose& pose, const Visit& visit) {
    const TurnMatrix turn = matrix_of(pose.rotation);
    for (const Sphere& sphere : body.shape.spheres())
        if (!visit(Sphere{pose.position + turn * sphere.centre, sphere.radius})) return;
}

/// Of what the body meets: by the nearest face.
bool is_in(const World& world, const Vec3& point, std::uint32_t mask) {
    if (locate(world.solid(), point) != Where::kSolid) return false;
    if (mask == ~0u) return true;
    const NearFace near = closest(world, point);
    const std::optional<FaceInfo> face = near ? world.face_info(near.face) : std::nullopt;
    return !face || (face->mask & mask);
}

/// Where a body is, in a part's frame.
Pose pose_in(const StepPart& part, const Body& body) {
    Pose pose;
    const Pose frame = pose_at(part.motion, 0);
    const Pose there = pose_of(body);
    pose.position = part.frame.in(there.position);
    pose.rotation = compose(turn_back(frame.rotation), there.rotation);
    return pose;
}

bool is_met(const StepPart& part, const Body& body) {
    return (part.part.mask & body.mask) && part.may_meet(body.position, body.shape.reach());
}

bool box_has(const Box& box, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= box.low[axis] && p[axis] <= box.high[axis])) return false;
    return true;
}

bool is_in_part(const StepPart& part, const Body& body) {
    if (!is_met(part, body)) return false;
    bool found = false;
    each_sphere(body, pose_in(part, body), [&](const Sphere& sphere) {
        return !(found =
                     box_has(part.part.bounds(), sphere.centre) && is_in(part.part.world(), sphere.centre, body.mask));
    });
    return found;
}

/// Of the spheres in solid the one that is deepest decides: its way to the nearest face, and as far as it is thick.
Vec3 way_out(const Body& body, const Pose& pose, const World& world) {
    Vec3 way;
    double deepest = 0;
    each_sphere(body, pose, [&](const Sphere& sphere) {
        if (!is_in(world, sphere.centre, body.mask)) return true;
        const NearFace near = closest(world, sphere.centre, kEverywhere, {.mask = body.mask});
        if (!near || near.distance + sphere.radius <= deepest) return true;
        deepest = near.distance + sphere.radius;
        const Vec3 to = near.point - sphere.centre;
        const std::optional<FaceInfo> face = world.face_info(near.face);
        way = near.distance > 0 ? to * (deepest / near.distance) : face ? face->normal * deepest : Vec3{};
        return true;
    });
    return way;
}

/// The longest way out of any part, in the world.
Vec3 way_out_of_parts(const Body& body, const StepParts& parts) {
    Vec3 longest;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (!is_met(parts[k], body)) continue;
        const Vec3 way = parts[k].frame.direction_out(way_out(body, pose_in(parts[k], body), parts[k].part.world()));
        if (length(way) > length(longest)) longest = way;
    }
    return longest;
}

/// As much of a way as the world leaves free.
Vec3 free_way(const Body& body, const World& world, const Vec3& way, double skin) {
    std::vector<Sphere> cores;
    for (const Sphere& sphere : body.shape.data().spheres)
        cores.push_back({sphere.centre, sphere.radius - std::min(skin, 0.5 * sphere.radius)});
    CastOptions options;
    options.mask = body.mask;
    options.contact_offset = skin * 0.25;
    const SetHit hit = cast(world, cores, {body.position, principal_rotation(body), way, {}}, options);
    return way * hit.safe_fraction;
}

}  // namespace

void find_stuck(Bodies& bodies, const World& world, bool all, const StepParts& parts, const std::vector<bool>& sound) {
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& body = bodies.slots[slot];
        if (!sound[slot]) continue;
        bool ask_parts = false;
        for (std::size_t k = 0; k < parts.size(); ++k)
            ask_parts = ask_parts || ((parts[k].changed || body.crushed) && is_met(parts[k], body));
        if (!(all || body.stuck || ask_parts)) continue;
        bool stuck = false;
        if (all || body.stuck)
            each_sphere(body, pose_of(body),
                        [&](const Sphere& sphere) { return !(stuck = is_in(world, sphere.centre, body.mask)); });
        for (std::size_t k = 0; k < parts.size() && !stuck; ++k) stuck = is_in_part(parts[k], body);
        if (stuck && body.asleep) wake_island(bodies, slot);
        body.stuck = stuck;
    }
}

void move_out(Body& body, const World& world, const StepParts& parts, double seconds, double skin) {
    Vec3 way = way_out(body, pose_of(body), world);
    const bool in_part = way == Vec3{} && !parts.empty();
    if (in_part) way = way_out_of_parts(body, parts);
    body.crushed = in_part && !(way == Vec3{});
    const double far = length(way), goes = std::min(far, kWayOutSpeed * seconds);
    if (far > 0) way *= goes / far;
    body.position += body.crushed ? free_way(body, world, way, skin) : way;
    body.velocity = body.spin = {};
}

}  // namespace firma
