// SPDX-License-Identifier: MIT
// Bodies: their shapes, what is in a list of them, and steps.
#include "firma/bodies.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/numbers.h"
#include "bindings/c/objects.h"
#include "bindings/c/scenes.h"
#include "bindings/c/sphere_sets.h"

namespace firma::c {
namespace {

constexpr int kMaxSubsteps = 10'000, kMostBounces = 1'000;

MassProperties mass_from(const firma_mass& from) {
    MassProperties mass;
    mass.volume = from.volume;
    mass.mass = from.mass;
    mass.centre = vec(from.centre);
    for (std::size_t row = 0; row < 3; ++row)
        mass.inertia[row] = {from.inertia[3 * row], from.inertia[3 * row + 1], from.inertia[3 * row + 2]};
    return mass;
}

bool is_there(const Body& body) {
    return body.shape.valid();
}

/// What all that asks of one body begins with: the list and the body.
template <class Work>
firma_code ask_of_body(firma_bodies bodies, firma_body_id id, const char* function, const Work& work) {
    firma_code code = FIRMA_OK;
    BodiesObject* const object = find_bodies(bodies, code, function);
    if (!object) return code;
    Body* const body = object->bodies.find(id_of(id));
    if (!body) return fail(FIRMA_ERROR_INVALID, function, kNoSuchBody);
    return work(object->bodies, *body);
}

}  // namespace

firma_body body_told(const Body& from) {
    firma_body out{};
    out.size = sizeof out;
    out.mask = from.mask;
    put(from.position, out.position);
    for (std::size_t k = 0; k < 4; ++k) out.rotation[k] = from.rotation[k];
    put(from.velocity, out.velocity);
    put(from.spin, out.spin);
    put(from.force, out.force);
    put(from.torque, out.torque);
    out.friction = from.friction;
    out.restitution = from.restitution;
    out.rolling = from.rolling;
    if (from.shape.valid()) out.mass = from.shape.mass();
    out.asleep = from.asleep;
    out.stuck = from.stuck;
    out.crushed = from.crushed;
    return out;
}

bool is_good(const firma_body& body) {
    for (const double(*v)[3] : {&body.position, &body.velocity, &body.spin, &body.force, &body.torque})
        if (!is_finite(vec(*v))) return false;
    return is_rotation(body.rotation) && is_not_below_zero(body.friction) && is_not_below_zero(body.rolling) &&
           body.restitution >= 0 && body.restitution <= 1;
}

void take_body(const firma_body& from, Body& body) {
    body.mask = from.mask;
    body.position = vec(from.position);
    for (std::size_t k = 0; k < 4; ++k) body.rotation[k] = from.rotation[k];
    body.velocity = vec(from.velocity);
    body.spin = vec(from.spin);
    body.force = vec(from.force);
    body.torque = vec(from.torque);
    body.friction = from.friction;
    body.restitution = from.restitution;
    body.rolling = from.rolling;
    body.still_for = 0;
}

namespace {

firma_code add_body_here(firma_bodies bodies, const Result<Body>& made, firma_body_id* id, const char* function) {
    if (!made) return fail(made.error());
    firma_code code = FIRMA_OK;
    BodiesObject* const object = find_bodies(bodies, code, function);
    if (!object) return code;
    const BodyId added = add_body(object->bodies, made.value());
    *id = {added.slot, added.use};
    return FIRMA_OK;
}

}  // namespace

firma_code read_step(const firma_step_options* given, StepOptions& step, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_step_options whole;
    firma_step_options_defaults(&whole);
    take_sized(given, whole);
    if (whole.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    if (whole.substeps_a_second < 1 || whole.substeps_a_second > kMaxSubsteps || whole.max_bounces > kMostBounces ||
        !is_finite(vec(whole.gravity)) || !is_not_below_zero(whole.contact_friction) ||
        !is_not_below_zero(whole.contact_offset) || !is_not_below_zero(whole.sleep_speed) || !(whole.sleep_after >= 0))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "an option is not finite or out of its range");
    step.substeps_a_second = int(whole.substeps_a_second);
    step.max_bounces = int(whole.max_bounces);
    step.gravity = vec(whole.gravity);
    step.contact_friction = whole.contact_friction;
    step.contact_offset = whole.contact_offset;
    step.sleep_speed = whole.sleep_speed;
    step.sleep_after = whole.sleep_after;
    return FIRMA_OK;
}

firma_step_options step_told(const StepOptions& from) {
    return {sizeof(firma_step_options),
            std::uint32_t(from.substeps_a_second),
            std::uint32_t(from.max_bounces),
            0,
            {from.gravity.x, from.gravity.y, from.gravity.z},
            from.contact_friction,
            from.contact_offset,
            from.sleep_speed,
            from.sleep_after};
}

firma_step_report step_report_told(const StepReport& from) {
    return {sizeof(firma_step_report),
            0,
            from.awake,
            from.contacts,
            from.swept,
            from.bounces,
            from.woken,
            from.stuck,
            from.crushed};
}

namespace {

/// A step of bodies, in the scene that `find_scene` fills.
template <class FindScene>
firma_code step_bodies(firma_bodies bodies, const FindScene& find_scene, double seconds,
                       const firma_step_options* options, firma_step_report* report, const char* function) {
    if (report && !sized(report)) return bad_call(function, kWrongSize);
    StepOptions chosen;
    if (const firma_code code = read_step(options, chosen, function)) return code;
    if (!is_above_zero(seconds))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not a finite number above zero");
    SceneThere there;
    if (const firma_code code = find_scene(there)) return code;
    firma_code code = FIRMA_OK;
    BodiesObject* const object = find_bodies(bodies, code, function);
    if (!object) return code;
    object->broken = true;  // unless it comes back
    const StepReport made = step(object->bodies, there.scene(), seconds, chosen);
    object->broken = false;
    if (report) put_sized(step_report_told(made), report);
    return FIRMA_OK;
}

firma_body_contact contact_told(const BodyContact& from, const Bodies& bodies) {
    firma_body_contact out{};
    out.body = {from.body, bodies.slots[from.body].use};
    out.other = {from.other, from.other == FIRMA_NO_BODY ? 0 : bodies.slots[from.other].use};
    put(from.point, out.point);
    put(from.normal, out.normal);
    out.force = from.force;
    out.face = from.face.id.value;
    put_corner(from.face, out.corner);
    out.portal = from.portal.value;
    out.part = from.part;
    return out;
}

}  // namespace

firma_code read_fit(const firma_fit_options* given, FitOptions& fit, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_fit_options whole{};
    take_sized(given, whole);
    if (whole.max_spheres) fit.max_spheres = whole.max_spheres;
    fit.max_error = whole.max_error;
    fit.margin = whole.margin;
    return FIRMA_OK;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_mass_of_ball(double radius, double density, firma_mass* mass) {
    return guarded(__func__, [&, function = __func__] {
        if (!mass) return bad_call(function, kNull);
        if (!is_above_zero(radius) || !is_above_zero(density))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the radius or density is not a finite number above zero");
        put(mass_of_ball(radius, density), *mass);
        return FIRMA_OK;
    });
}

firma_code firma_mass_of_box(const double half[3], double density, firma_mass* mass) {
    return guarded(__func__, [&, function = __func__] {
        if (!half || !mass) return bad_call(function, kNull);
        for (int k = 0; k < 3; ++k)
            if (!is_above_zero(half[k]) || !is_above_zero(density))
                return fail(FIRMA_ERROR_OUT_OF_RANGE, function,
                            "a side or the density is not a finite number above zero");
        put(mass_of_box({half[0], half[1], half[2]}, density), *mass);
        return FIRMA_OK;
    });
}

firma_code firma_body_shape_spheres(const double* spheres, size_t count, const firma_mass* mass,
                                    firma_body_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!mass || !shape || (!spheres && count)) return bad_call(function, kNull);
        const Result<BodyShape> made = make_body_shape(spheres_of(spheres, count), mass_from(*mass));
        if (!made) return fail(made.error());
        return give(std::make_unique<BodyShapeObject>(made.value()), shape, function);
    });
}

firma_code firma_body_shape_get_spheres(firma_body_shape shape, double* spheres, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!spheres && capacity)) return bad_call(function, kNull);
        const BodyShapeObject* const object = find<BodyShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::span<const Sphere> all = object->shape.spheres();
        put_spheres(all, spheres, capacity);
        *count = all.size();
        return FIRMA_OK;
    });
}

firma_code firma_body_shape_release(firma_body_shape shape) {
    return release<BodyShapeObject>(shape.id, __func__);
}

void firma_body_defaults(firma_body* body) {
    if (body) *body = body_told({});
}

firma_code firma_bodies_create(firma_bodies* bodies) {
    return guarded(__func__, [&, function = __func__] {
        if (!bodies) return bad_call(function, kNull);
        return give(std::make_unique<BodiesObject>(), bodies, function);
    });
}

firma_code firma_bodies_copy(firma_bodies bodies, firma_bodies* copy) {
    return guarded(__func__, [&, function = __func__] {
        if (!copy) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        return object ? give(std::make_unique<BodiesObject>(object->bodies), copy, function) : code;
    });
}

firma_code firma_bodies_release(firma_bodies bodies) {
    return release<BodiesObject>(bodies.id, __func__);
}

firma_code firma_bodies_get_count(firma_bodies bodies, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        if (!object) return code;
        *count = std::size_t(std::count_if(object->bodies.slots.begin(), object->bodies.slots.end(), is_there));
        return FIRMA_OK;
    });
}

firma_code firma_bodies_list(firma_bodies bodies, firma_body_id* ids, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!ids && capacity)) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        if (!object) return code;
        std::size_t found = 0;
        const std::vector<Body>& slots = object->bodies.slots;
        for (std::size_t k = 0; k < slots.size(); ++k) {
            if (!is_there(slots[k])) continue;
            if (found < capacity) ids[found] = {std::uint32_t(k), slots[k].use};
            ++found;
        }
        *count = found;
        return FIRMA_OK;
    });
}

firma_code firma_bodies_add(firma_bodies bodies, firma_body_shape shape, const firma_pose* pose, firma_body_id* id) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose || !id) return bad_call(function, kNull);
        const BodyShapeObject* const object = find<BodyShapeObject>(shape.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (!is_finite(vec(pose->position)) || !is_rotation(pose->rotation))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the pose is not finite, or has no rotation");
        return add_body_here(bodies, body_at(object->shape, firma::c::pose_of(*pose)), id, function);
    });
}

firma_code firma_bodies_add_chunk(firma_bodies bodies, firma_chunks chunks, size_t chunk, const firma_fit_options* fit,
                                  firma_body_id* id) {
    return guarded(__func__, [&, function = __func__] {
        if (!id) return bad_call(function, kNull);
        FitOptions chosen;
        if (const firma_code code = read_fit(fit, chosen, function)) return code;
        firma_code code = FIRMA_OK;
        if (!find_bodies(bodies, code, function)) return code;
        const ChunksObject* const object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (chunk >= object->chunks.size()) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such chunk");
        return add_body_here(bodies, body_of(object->chunks[chunk], chosen), id, function);
    });
}

firma_code firma_bodies_remove(firma_bodies bodies, firma_body_id id) {
    return guarded(__func__, [&, function = __func__] {
        return ask_of_body(bodies, id, function, [&](Bodies& all, Body&) {
            remove_body(all, id_of(id));
            return FIRMA_OK;
        });
    });
}

firma_code firma_bodies_get(firma_bodies bodies, firma_body_id id, firma_body* body) {
    return guarded(__func__, [&, function = __func__] {
        if (!body) return bad_call(function, kNull);
        if (!sized(body)) return bad_call(function, kWrongSize);
        return ask_of_body(bodies, id, function, [&](Bodies&, const Body& it) {
            put_sized(body_told(it), body);
            return FIRMA_OK;
        });
    });
}

firma_code firma_bodies_set(firma_bodies bodies, firma_body_id id, const firma_body* body) {
    return guarded(__func__, [&, function = __func__] {
        if (!body) return bad_call(function, kNull);
        if (!sized(body)) return bad_call(function, kWrongSize);
        return ask_of_body(bodies, id, function, [&](Bodies& all, Body& it) {
            firma_body whole = body_told(it);
            take_sized(body, whole);
            if (!is_good(whole))
                return fail(FIRMA_ERROR_OUT_OF_RANGE, function,
                            "a number of the body is not finite or out of its range, or it has no rotation");
            wake_body(all, id_of(id));
            take_body(whole, it);
            return FIRMA_OK;
        });
    });
}

firma_code firma_bodies_get_pose(firma_bodies bodies, firma_body_id id, firma_pose* pose) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose) return bad_call(function, kNull);
        return ask_of_body(bodies, id, function, [&](Bodies&, const Body& it) {
            put_pose(firma::pose_of(it), *pose);
            return FIRMA_OK;
        });
    });
}

firma_code firma_bodies_shape(firma_bodies bodies, firma_body_id id, firma_body_shape* shape) {
    return guarded(__func__, [&, function = __func__] {
        if (!shape) return bad_call(function, kNull);
        return ask_of_body(bodies, id, function, [&](Bodies&, const Body& it) {
            return give(std::make_unique<BodyShapeObject>(it.shape), shape, function);
        });
    });
}

firma_code firma_bodies_wake(firma_bodies bodies, firma_body_id id) {
    return guarded(__func__, [&, function = __func__] {
        return ask_of_body(bodies, id, function, [&](Bodies& all, Body&) {
            wake_body(all, id_of(id));
            return FIRMA_OK;
        });
    });
}

firma_code firma_bodies_push(firma_bodies bodies, firma_body_id id, const double impulse[3], const double point[3]) {
    return guarded(__func__, [&, function = __func__] {
        if (!impulse || !point) return bad_call(function, kNull);
        const Vec3 push{impulse[0], impulse[1], impulse[2]}, at{point[0], point[1], point[2]};
        if (!is_finite(push) || !is_finite(at))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the impulse or the point is not finite");
        return ask_of_body(bodies, id, function, [&](Bodies& all, Body&) {
            push_body(all, id_of(id), push, at);
            return FIRMA_OK;
        });
    });
}

void firma_step_options_defaults(firma_step_options* options) {
    if (options) *options = step_told({});
}

firma_code firma_bodies_step(firma_bodies bodies, firma_world world, double seconds, const firma_step_options* options,
                             firma_step_report* report) {
    return guarded(__func__, [&, function = __func__] {
        const auto find_world = [&](SceneThere& there) {
            const WorldObject* level = find<WorldObject>(world.id, function);
            if (!level) return FIRMA_ERROR_BAD_HANDLE;
            there.world = &level->world;
            return FIRMA_OK;
        };
        return step_bodies(bodies, find_world, seconds, options, report, function);
    });
}

firma_code firma_bodies_step_scene(firma_bodies bodies, const firma_scene* scene, double seconds,
                                   const firma_step_options* options, firma_step_report* report) {
    return guarded(__func__, [&, function = __func__] {
        const auto read_scene = [&](SceneThere& there) {
            if (const firma_code code = there.read(scene, function)) return code;
            if (there.has_stretch()) return FIRMA_OK;
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the scene's stretch is not within 0..1");
        };
        return step_bodies(bodies, read_scene, seconds, options, report, function);
    });
}

firma_code firma_bodies_contacts(firma_bodies bodies, firma_body_contact* contacts, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!contacts && capacity)) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        if (!object) return code;
        const std::vector<BodyContact>& all = object->bodies.contacts;
        for (std::size_t k = 0; k < std::min(capacity, all.size()); ++k)
            contacts[k] = contact_told(all[k], object->bodies);
        *count = all.size();
        return FIRMA_OK;
    });
}

firma_code firma_bodies_hash(firma_bodies bodies, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        if (!object) return code;
        *hash = hash_bodies(object->bodies);
        return FIRMA_OK;
    });
}
