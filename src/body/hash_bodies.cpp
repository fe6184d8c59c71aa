// SPDX-License-Identifier: MIT
// A hash of all that steps depend on.
#include "base/hasher.h"
#include "firma/bodies.h"

namespace firma {
namespace {

void add_vector(Hasher& hash, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) hash.add(v[axis]);
}

void add_shape(Hasher& hash, const BodyShape& shape) {
    hash.add(shape.mass());
    add_vector(hash, shape.centre());
    add_vector(hash, shape.moments());
    for (const Sphere& sphere : shape.spheres()) {
        add_vector(hash, sphere.centre);
        hash.add(sphere.radius);
    }
}

void add_body_to(Hasher& hash, const Body& body) {
    hash.add(body.use);
    if (!body.shape.valid()) return;
    add_shape(hash, body.shape);
    for (const Vec3& v : {body.position, body.velocity, body.spin, body.force, body.torque, body.still_at})
        add_vector(hash, v);
    for (const Quaternion& turn : {body.rotation, body.still_turn})
        for (const double part : turn) hash.add(part);
    for (const double number : {body.friction, body.restitution, body.rolling, body.still_for}) hash.add(number);
    hash.add(body.mask);
    hash.add(body.island);
    hash.add(int(body.asleep) + 2 * int(body.stuck) + 4 * int(body.crushed));
}

}  // namespace

std::uint64_t hash_bodies(const Bodies& bodies) {
    Hasher hash;
    for (const Body& body : bodies.slots) add_body_to(hash, body);
    for (const std::uint32_t slot : bodies.free) hash.add(slot);
    for (const BodyContact& contact : bodies.contacts) {
        hash.add(contact.body, contact.other);
        hash.add(contact.sphere, contact.other_sphere);
        hash.add(contact.face.id.value, contact.portal.value);
        if (contact.part != kNoPart) hash.add(contact.part);
        for (const Vec3& v : {contact.point, contact.normal, contact.friction, contact.slip, contact.rolling})
            add_vector(hash, v);
        hash.add(contact.force);
    }
    hash.add(bodies.steps);
    hash.add(bodies.world_hash);
    hash.add(bodies.islands);
    for (const std::uint64_t part : bodies.part_hashes) hash.add(part);
    return hash.value();
}

}  // namespace firma
