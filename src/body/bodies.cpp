// SPDX-License-Identifier: MIT
// Bodies put in, found, pushed and taken out.
#include "firma/bodies.h"

#include "body/mover.h"
#include "body/rest.h"
#include "body/rolling.h"

namespace firma {
namespace {

Body* slot_of(std::vector<Body>& slots, BodyId id) {
    if (id.slot >= slots.size()) return nullptr;
    Body& body = slots[id.slot];
    return body.use == id.use && body.shape.valid() ? &body : nullptr;
}

}  // namespace

Body* Bodies::find(BodyId id) {
    return slot_of(slots, id);
}
const Body* Bodies::find(BodyId id) const {
    return slot_of(const_cast<std::vector<Body>&>(slots), id);
}

Pose pose_of(const Body& body) {
    Pose pose;
    pose.rotation = normalised(body.rotation);
    pose.position = body.position;
    if (body.shape.valid()) pose.position = body.position - matrix_of(pose.rotation) * body.shape.centre();
    return pose;
}

Body body_at(const BodyShape& shape, const Pose& pose) {
    Body body;
    body.shape = shape;
    body.rotation = normalised(pose.rotation);
    body.position = pose.position + matrix_of(body.rotation) * shape.centre();
    return body;
}

Result<Body> body_of(const Chunk& chunk, const FitOptions& fit) {
    const Result<SphereFit> spheres = fit_spheres(chunk.solid, fit);
    if (!spheres) return spheres.error();
    const Result<BodyShape> shape = make_body_shape(spheres.value().spheres, chunk.mass);
    if (!shape) return shape.error();
    Pose pose;
    pose.position = chunk.origin;
    Body body = body_at(shape.value(), pose);
    body.rolling = rolling_of(spheres.value(), body.rolling);
    return body;
}

Vec3 angular_momentum(const Body& body) {
    const TurnMatrix axes = matrix_of(principal_rotation(body));
    const Vec3 spin = axes.back(body.spin), moments = body.shape.moments();
    return axes * Vec3{moments.x * spin.x, moments.y * spin.y, moments.z * spin.z};
}

double kinetic_energy(const Body& body) {
    return 0.5 * (body.shape.mass() * dot(body.velocity, body.velocity) + dot(body.spin, angular_momentum(body)));
}

BodyId add_body(Bodies& bodies, Body body) {
    std::uint32_t slot = std::uint32_t(bodies.slots.size());
    if (bodies.free.empty()) {
        bodies.slots.emplace_back();
    } else {
        slot = bodies.free.back();
        bodies.free.pop_back();
    }
    body.use = bodies.slots[slot].use + 1;
    bodies.slots[slot] = std::move(body);
    return {slot, bodies.slots[slot].use};
}

void remove_body(Bodies& bodies, BodyId id) {
    if (!bodies.find(id)) return;
    for (const BodyContact& contact : bodies.contacts) {
        if (contact.body == id.slot && contact.other != kFixed) wake_island(bodies, contact.other);
        if (contact.other == id.slot) wake_island(bodies, contact.body);
    }
    std::erase_if(bodies.contacts,
                  [&](const BodyContact& contact) { return contact.body == id.slot || contact.other == id.slot; });
    const std::uint32_t use = bodies.slots[id.slot].use;
    bodies.slots[id.slot] = {};
    bodies.slots[id.slot].use = use;
    bodies.free.push_back(id.slot);
}

void wake_body(Bodies& bodies, BodyId id) {
    if (bodies.find(id)) wake_island(bodies, id.slot);
}

void push_body(Bodies& bodies, BodyId id, const Vec3& impulse, const Vec3& point) {
    Body* body = bodies.find(id);
    if (!body) return;
    wake_island(bodies, id.slot);
    Mover mover = make_mover(*body, id.slot);
    mover.push(impulse, point - body->position);
    body->velocity = mover.velocity;
    body->spin = mover.spin;
}

}  // namespace firma
