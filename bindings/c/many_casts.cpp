// SPDX-License-Identifier: MIT
// Many casts at once, each answered into the caller's structs and columns.
#include <cstdint>
#include <string>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/batch.h"
#include "world/cast_many.h"

namespace firma::c {
namespace {

constexpr const char* kNotRun = "the function `run` of firma_set_tasks() returned before all was done";

/// firma_casts as they are read: columns with a stride.
struct GivenCasts {
    firma_casts casts{};
    std::vector<Hull> hulls;

    firma_code read(const firma_casts* given, const char* function) {
        if (!sized(given)) return bad_call(function, kWrongSize);
        take_sized(given, casts);
        if (casts.kind > FIRMA_MOVER_HULL)
            return fail(FIRMA_ERROR_INVALID, function, "there is no mover of kind " + std::to_string(casts.kind));
        if (casts.stride == 0) casts.stride = sizeof(double);
        if (casts.stride % sizeof(double) != 0)
            return fail(FIRMA_ERROR_INVALID, function, "the stride must be a multiple of 8");
        if (casts.count > PTRDIFF_MAX / casts.stride)
            return fail(FIRMA_ERROR_TOO_LARGE, function, "no memory can hold so many casts");
        if (casts.hull_count && !casts.hulls) return bad_call(function, kNull);
        if (casts.count == 0) return FIRMA_OK;
        if (!casts.x || !casts.y || !casts.z || !casts.path_x || !casts.path_y || !casts.path_z)
            return bad_call(function, kNull);
        if (casts.kind == FIRMA_MOVER_CAPSULE && (!casts.to_x || !casts.to_y || !casts.to_z))
            return bad_call(function, kNull);
        return casts.kind == FIRMA_MOVER_HULL ? read_hulls(function) : FIRMA_OK;
    }

    double number(const double* column, std::size_t k) const {
        return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(column) + k * casts.stride);
    }
    double radius(std::size_t k) const { return casts.radius ? number(casts.radius, k) : 0; }
    Vec3 start(std::size_t k) const { return {number(casts.x, k), number(casts.y, k), number(casts.z, k)}; }
    Vec3 path(std::size_t k) const {
        return {number(casts.path_x, k), number(casts.path_y, k), number(casts.path_z, k)};
    }

    bool spheres() const { return casts.kind == FIRMA_MOVER_SPHERE; }
    Asked ask(std::size_t k) const {
        if (casts.kind == FIRMA_MOVER_HULL)
            return Asked(HullInput{&hulls[casts.hull_of ? casts.hull_of[k] : 0], start(k), path(k)});
        if (spheres()) return Asked(CastInput{{start(k), radius(k)}, path(k)});
        const Vec3 to{number(casts.to_x, k), number(casts.to_y, k), number(casts.to_z, k)};
        return Asked(CapsuleInput{Capsule(start(k), to, radius(k)), path(k)});
    }

private:
    firma_code read_hulls(const char* function) {
        for (std::size_t k = 0; k < casts.hull_count; ++k) {
            const HullObject* object = find<HullObject>(casts.hulls[k].id, function);
            if (!object) return FIRMA_ERROR_BAD_HANDLE;
            hulls.push_back(object->hull);
        }
        for (std::size_t k = 0; k < (casts.hull_of ? casts.count : 1); ++k) {
            const std::size_t hull = casts.hull_of ? casts.hull_of[k] : 0;
            if (hull >= hulls.size())
                return fail(FIRMA_ERROR_INVALID, function,
                            "cast " + std::to_string(k) + " is of hull " + std::to_string(hull) + " of " +
                                std::to_string(hulls.size()));
        }
        return FIRMA_OK;
    }
};

/// firma_answers as they are written.
struct GivenAnswers {
    firma_answers answers{};

    firma_code read(const firma_answers* given, bool any, std::size_t count, const char* function) {
        if (!sized(given)) return bad_call(function, kWrongSize);
        take_sized(given, answers);
        if (answers.reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
        if (count > PTRDIFF_MAX / sizeof(firma_hit))
            return fail(FIRMA_ERROR_TOO_LARGE, function, "no memory can hold so many hits");
        const firma_answers& a = answers;
        const bool more = a.hits || a.fraction || a.safe_fraction || a.normal_x || a.normal_y || a.normal_z || a.face ||
                          a.portal || a.material;
        if (any && more) return fail(FIRMA_ERROR_INVALID, function, "`any` answers with a status alone");
        return FIRMA_OK;
    }

    void put(std::size_t k, const Hit& hit) const {
        const auto to = [k](auto* column, auto value) {
            if (column) column[k] = value;
        };
        if (answers.hits) put_hit(hit, answers.hits[k]);
        to(answers.status, std::uint32_t(hit.status));
        to(answers.fraction, hit.fraction);
        to(answers.safe_fraction, hit.safe_fraction);
        to(answers.normal_x, hit.normal.x);
        to(answers.normal_y, hit.normal.y);
        to(answers.normal_z, hit.normal.z);
        to(answers.face, hit.face.id.value);
        to(answers.portal, hit.portal.value);
        to(answers.material, hit.material);
    }
};

firma_code read_many(const firma_many_options* given, firma_many_options& whole, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    take_sized(given, whole);
    if (whole.any > 1) return fail(FIRMA_ERROR_INVALID, function, "any must be 0 or 1");
    return FIRMA_OK;
}

bool tell(std::size_t done, std::size_t count, void* user) {
    const firma_many_options& many = *static_cast<const firma_many_options*>(user);
    return many.progress(done, count, many.user) != 0;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_cast_batch(firma_world world, const firma_cast_input* inputs, size_t count,
                            const firma_cast_options* options, firma_hit* hits, firma_cast_counts* counts) {
    return guarded(__func__, [&, function = __func__] {
        if (count && (!inputs || !hits)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        ManyOptions many;
        if (const firma_code code = read_options(options, many.cast, function)) return code;
        if (count > PTRDIFF_MAX / sizeof(firma_hit))
            return fail(FIRMA_ERROR_TOO_LARGE, function, "no memory can hold so many hits");
        const Tasks tasks = batch_tasks();
        CastCounts seen;
        if (counts) many.cast.counts = &seen;
        if (tasks.run) many.tasks = &tasks;
        const auto ask = [&](std::size_t k) { return Asked(CastInput{sphere_of(inputs[k]), vec(inputs[k].path)}); };
        const auto answer = [&](std::size_t k, PutHit put) {
            Hit hit;
            put(hit);
            put_hit(hit, hits[k]);
        };
        if (run_many(object->world, {count, true, true, ask}, answer, many) == ManyResult::kRefused)
            return bad_call(function, kNotRun);
        if (counts) add(seen, *counts);
        return FIRMA_OK;
    });
}

firma_code firma_cast_many(firma_world world, const firma_casts* casts, const firma_cast_options* options,
                           const firma_many_options* many, const firma_answers* answers, firma_cast_counts* counts,
                           uint32_t* cancelled) {
    return guarded(__func__, [&, function = __func__] {
        if (!casts || !answers) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        firma_many_options whole{};
        if (const firma_code code = read_many(many, whole, function)) return code;
        GivenCasts given;
        if (const firma_code code = given.read(casts, function)) return code;
        GivenAnswers out;
        if (const firma_code code = out.read(answers, whole.any != 0, given.casts.count, function)) return code;
        ManyOptions chosen;
        if (const firma_code code = read_options(options, chosen.cast, function)) return code;
        const Tasks tasks = batch_tasks();
        CastCounts seen;
        if (counts) chosen.cast.counts = &seen;
        if (tasks.run) chosen.tasks = &tasks;
        if (whole.progress) {
            chosen.progress = tell;
            chosen.user = &whole;
        }
        const World held = object->world;  // which progress may release
        const auto ask = [&](std::size_t k) { return given.ask(k); };
        const auto answer_any = [&](std::size_t k, Status status) {
            if (out.answers.status) out.answers.status[k] = std::uint32_t(status);
        };
        const auto answer_first = [&](std::size_t k, PutHit put) {
            Hit hit;
            put(hit);
            out.put(k, hit);
        };
        const ManyCasts asked{given.casts.count, true, given.spheres(), ask};
        const ManyResult result =
            whole.any ? run_many_any(held, asked, answer_any, chosen) : run_many(held, asked, answer_first, chosen);
        if (result == ManyResult::kRefused) return bad_call(function, kNotRun);
        if (counts) add(seen, *counts);
        if (cancelled) *cancelled = result == ManyResult::kCancelled;
        return FIRMA_OK;
    });
}
