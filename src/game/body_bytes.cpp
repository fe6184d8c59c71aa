// SPDX-License-Identifier: MIT
// Bodies, their shapes and contacts as bytes.
#include "game/body_bytes.h"

#include <utility>

#include "body/body_shape.h"
#include "game/number_bytes.h"

namespace firma {
namespace {

constexpr std::size_t kSphereBytes = 32, kShapeBytes = 1 + 14 * 8, kSlotBytes = 2;
constexpr std::size_t kBodyContactBytes = 168;

void put_mass(ByteWriter& out, const MassProperties& mass) {
    put_numbers(out, {mass.volume, mass.mass});
    put_vec(out, mass.centre);
    for (const Vec3& row : mass.inertia) put_vec(out, row);
}
MassProperties take_mass(ByteReader& in) {
    MassProperties mass;
    take_numbers(in, {&mass.volume, &mass.mass});
    mass.centre = take_vec(in);
    for (Vec3& row : mass.inertia) row = take_vec(in);
    return mass;
}

void put_contact(ByteWriter& out, const BodyContact& contact) {
    for (const std::uint32_t number : {contact.body, contact.other, contact.sphere, contact.other_sphere, contact.part})
        out.u32(number);
    put_face_ref(out, contact.face);
    out.u32(contact.portal.value);
    put_vec(out, contact.point);
    put_vec(out, contact.normal);
    out.f64(contact.force);
    for (const Vec3& v : {contact.friction, contact.slip, contact.rolling}) put_vec(out, v);
}
BodyContact take_contact(ByteReader& in) {
    BodyContact contact;
    for (std::uint32_t* number : {&contact.body, &contact.other, &contact.sphere, &contact.other_sphere, &contact.part})
        *number = in.u32();
    contact.face = take_face_ref(in);
    contact.portal.value = in.u32();
    contact.point = take_vec(in);
    contact.normal = take_vec(in);
    contact.force = in.f64();
    for (Vec3* v : {&contact.friction, &contact.slip, &contact.rolling}) *v = take_vec(in);
    return contact;
}

}  // namespace

void put_shape(ByteWriter& out, const BodyShape& shape) {
    const BodyShapeData& data = shape.data();
    put_whole(out, data.given.size());
    for (const Sphere& sphere : data.given) {
        put_vec(out, sphere.centre);
        out.f64(sphere.radius);
    }
    put_mass(out, data.given_mass);
}

BodyShape take_shape(ByteReader& in) {
    const std::size_t where = in.place();
    SphereSet spheres(take_count(in, kSphereBytes));
    for (Sphere& sphere : spheres) {
        sphere.centre = take_vec(in);
        sphere.radius = in.f64();
    }
    const MassProperties mass = take_mass(in);
    if (!in.ok()) return {};
    Result<BodyShape> shape = make_body_shape(spheres, mass);
    if (shape) return std::move(shape).value();
    in.fail_at(where, ErrorCode::kMalformed, "no shape of a body: " + shape.error().reason);
    return {};
}

std::uint32_t ShapeNumbers::number(const BodyShape& shape) {
    ByteWriter bytes;
    put_shape(bytes, shape);
    const auto [found, is_new] = numbers_.try_emplace(bytes.bytes(), std::uint32_t(numbers_.size()));
    if (is_new) in_order_.push_back(&found->first);
    return found->second;
}

void ShapeNumbers::put(ByteWriter& out) const {
    put_whole(out, in_order_.size());
    for (const std::vector<std::byte>* bytes : in_order_) put_bytes(out, *bytes);
}

void put_body(ByteWriter& out, const Body& body) {
    put_vec(out, body.position);
    put_turn(out, body.rotation);
    for (const Vec3& v : {body.velocity, body.spin, body.force, body.torque}) put_vec(out, v);
    put_numbers(out, {body.friction, body.restitution, body.rolling, body.still_for});
    put_vec(out, body.still_at);
    put_turn(out, body.still_turn);
    out.u32(body.mask);
    out.u32(body.island);
    put_flags(out, {body.asleep, body.stuck, body.crushed});
}

void take_body(ByteReader& in, Body& body) {
    body.position = take_vec(in);
    body.rotation = take_turn(in);
    for (Vec3* v : {&body.velocity, &body.spin, &body.force, &body.torque}) *v = take_vec(in);
    take_numbers(in, {&body.friction, &body.restitution, &body.rolling, &body.still_for});
    body.still_at = take_vec(in);
    body.still_turn = take_turn(in);
    body.mask = in.u32();
    body.island = in.u32();
    take_flags(in, {&body.asleep, &body.stuck, &body.crushed});
}

void put_bodies(ByteWriter& out, const Bodies& bodies) {
    ShapeNumbers shapes;
    ByteWriter slots;
    put_whole(slots, bodies.slots.size());
    for (const Body& body : bodies.slots) {
        put_flags(slots, {body.shape.valid()});
        put_whole(slots, body.use);
        if (!body.shape.valid()) continue;
        put_whole(slots, shapes.number(body.shape));
        put_body(slots, body);
    }
    shapes.put(out);
    put_bytes(out, slots.bytes());
    put_whole(out, bodies.free.size());
    for (const std::uint32_t slot : bodies.free) put_whole(out, slot);
    put_whole(out, bodies.contacts.size());
    for (const BodyContact& contact : bodies.contacts) put_contact(out, contact);
    out.u64(bodies.steps);
    out.u64(bodies.world_hash);
    out.u32(bodies.islands);
    put_whole(out, bodies.part_hashes.size());
    for (const std::uint64_t hash : bodies.part_hashes) out.u64(hash);
}

Bodies take_bodies(ByteReader& in) {
    Bodies bodies;
    std::vector<BodyShape> shapes(take_count(in, kShapeBytes));
    for (BodyShape& shape : shapes)
        if (in.ok()) shape = take_shape(in);
    const std::size_t slots = take_count(in, kSlotBytes);
    for (std::size_t k = 0; k < slots && in.ok(); ++k) {
        Body body;
        bool is_there = false;
        take_flags(in, {&is_there});
        body.use = take_u32_whole(in);
        if (is_there) {
            const std::size_t where = in.place();
            const std::uint64_t shape = in.whole();
            if (in.ok() && shape >= shapes.size())
                in.fail_at(where, ErrorCode::kMalformed, "a body of a shape that is not there");
            if (in.ok()) body.shape = shapes[std::size_t(shape)];
            take_body(in, body);
        }
        bodies.slots.push_back(std::move(body));
    }
    bodies.free.resize(take_count(in, 1));
    for (std::uint32_t& slot : bodies.free) slot = take_u32_whole(in);
    const std::size_t contacts = take_count(in, kBodyContactBytes);
    for (std::size_t k = 0; k < contacts && in.ok(); ++k) bodies.contacts.push_back(take_contact(in));
    bodies.steps = in.u64();
    bodies.world_hash = in.u64();
    bodies.islands = in.u32();
    bodies.part_hashes.resize(take_count(in, 8));
    for (std::uint64_t& hash : bodies.part_hashes) hash = in.u64();
    return bodies;
}

}  // namespace firma
