// SPDX-License-Identifier: MIT
// Sets of spheres: against a world, against each other, and fitted into a world's solid.
#include "bindings/c/sphere_sets.h"

#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/cast_set.h"

namespace firma::c {
namespace {

/// cast() looks at the room only where something is near.
SetHit cast_in_room(const World& world, const MovingSetThere& set, CastOptions options) {
    const bool known =
        options.room == kAnyRoom || options.room == kLocateRoom || options.room.value < world.room_count();
    if (known) return cast(world, set.spheres, set.motion, options);
    SetHit unasked;
    unasked.status = Status::kInvalid;
    unasked.fraction = unasked.safe_fraction = 0;
    return unasked;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_cast_set(firma_world world, const double* spheres, size_t count, const firma_motion* motion,
                          const firma_cast_options* options, firma_set_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        MovingSetThere set;
        if (const firma_code code = set.read(spheres, count, motion, function)) return code;
        CastOptions chosen;
        if (const firma_code code = read_options(options, chosen, function)) return code;
        const SetHit met = cast_in_room(object->world, set, chosen);
        *hit = {};
        put_hit(met, hit->hit);
        hit->sphere = met.sphere;
        return FIRMA_OK;
    });
}

firma_code firma_cast_set_pair(const double* a, size_t a_count, const firma_motion* motion_a, const double* b,
                               size_t b_count, const firma_motion* motion_b, firma_set_pair_hit* hit) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit) return bad_call(function, kNull);
        MovingSetThere first, second;
        if (const firma_code code = first.read(a, a_count, motion_a, function)) return code;
        if (const firma_code code = second.read(b, b_count, motion_b, function)) return code;
        const SetPairHit met = cast(first.spheres, first.motion, second.spheres, second.motion);
        *hit = {};
        hit->fraction = met.fraction;
        put(met.point, hit->point);
        put(met.normal, hit->normal);
        hit->status = std::uint32_t(met.status);
        hit->sphere_a = met.sphere_a;
        hit->sphere_b = met.sphere_b;
        return FIRMA_OK;
    });
}

firma_code firma_world_fit_spheres(firma_world world, const firma_fit_options* fit, double* spheres, size_t capacity,
                                   size_t* count, double* error) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!spheres && capacity)) return bad_call(function, kNull);
        FitOptions chosen;
        if (const firma_code code = read_fit(fit, chosen, function)) return code;
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Result<SphereFit> made = fit_spheres(object->world.solid(), chosen);
        if (!made) return fail(made.error());
        put_spheres(made.value().spheres, spheres, capacity);
        *count = made.value().spheres.size();
        if (error) *error = made.value().error;
        return FIRMA_OK;
    });
}
