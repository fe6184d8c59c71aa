// SPDX-License-Identifier: MIT
// Casts at bodies: where these are, kept in an index, and what a sphere or a set of spheres meets of them.
#include <memory>
#include <utility>

#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/numbers.h"
#include "bindings/c/sphere_sets.h"
#include "firma/body_index.h"

namespace firma::c {
namespace {

struct BodyIndexObject final : Object {
    static constexpr Kind kKind = Kind::kBodyIndex;
    static constexpr const char* kNoun = "body index";
    explicit BodyIndexObject(BodyIndex of) : index(std::move(of)) {}
    const BodyIndex index;
};

void put_body_hit(const BodyHit& from, firma_body_hit& out) {
    out = {};
    out.fraction = from.fraction;
    out.safe_fraction = from.safe_fraction;
    put(from.centre, out.centre);
    put(from.point, out.point);
    put(from.normal, out.normal);
    put(from.surface_velocity, out.surface_velocity);
    out.body = {from.body.slot, from.body.use};
    out.body_sphere = from.body_sphere;
    out.sphere = from.sphere;
    out.status = std::uint32_t(from.status);
}

/// What all casts at bodies begin with: the index and the options.
template <class Work>
firma_code ask_of_index(firma_body_index index, const firma_body_cast_options* options, const char* function,
                        const Work& work) {
    const BodyIndexObject* const object = find<BodyIndexObject>(index.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    if (options && !sized(options)) return bad_call(function, kWrongSize);
    firma_body_cast_options whole;
    firma_body_cast_options_defaults(&whole);
    if (options) take_sized(options, whole);
    return work(object->index, BodyCastOptions{whole.mask, id_of(whole.except), whole.contact_offset});
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_body_index_create(firma_bodies bodies, double seconds, firma_body_index* index) {
    return guarded(__func__, [&, function = __func__] {
        if (!index) return bad_call(function, kNull);
        if (!is_not_below_zero(seconds))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not finite, or below zero");
        firma_code code = FIRMA_OK;
        const BodiesObject* const object = find_bodies(bodies, code, function);
        if (!object) return code;
        return give(std::make_unique<BodyIndexObject>(BodyIndex(object->bodies, seconds)), index, function);
    });
}

firma_code firma_body_index_release(firma_body_index index) {
    return release<BodyIndexObject>(index.id, __func__);
}

void firma_body_cast_options_defaults(firma_body_cast_options* options) {
    if (options) *options = {sizeof *options, ~0u, {FIRMA_NO_BODY, 0}, BodyCastOptions{}.contact_offset};
}

firma_code firma_body_index_cast(firma_body_index index, const firma_cast_input* input,
                                 const firma_body_cast_options* options, firma_body_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!input || !hit) return bad_call(function, kNull);
        return ask_of_index(index, options, function, [&](const BodyIndex& asked, const BodyCastOptions& chosen) {
            put_body_hit(asked.cast(sphere_of(*input), vec(input->path), chosen), *hit);
            return FIRMA_OK;
        });
    });
}

firma_code firma_body_index_cast_set(firma_body_index index, const double* spheres, size_t count,
                                     const firma_motion* motion, const firma_body_cast_options* options,
                                     firma_body_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit) return bad_call(function, kNull);
        MovingSetThere set;
        if (const firma_code code = set.read(spheres, count, motion, function)) return code;
        return ask_of_index(index, options, function, [&](const BodyIndex& asked, const BodyCastOptions& chosen) {
            put_body_hit(asked.cast(set.spheres, set.motion, chosen), *hit);
            return FIRMA_OK;
        });
    });
}
