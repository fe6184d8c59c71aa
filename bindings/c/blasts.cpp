// SPDX-License-Identifier: MIT
// Blasts: what they give at a distance and behind cover, pushes, explosions.
#include "firma/blast.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/debris_object.h"
#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"

namespace firma::c {
namespace {

/// Options of an explosion, with those that they hold.
firma_code read_explode(const firma_explode_options* given, BlastOptions& options, const char* function) {
    firma_explode_options whole;
    firma_explode_options_defaults(&whole);
    if (given && !sized(given)) return bad_call(function, kWrongSize);
    if (given) take_sized(given, whole);
    if (whole.max_pieces < 1 || whole.max_pieces > kMaxPieces || whole.max_spheres < 1 ||
        whole.max_spheres > kMaxSpheres || !is_not_below_zero(whole.break_radius) ||
        !is_not_below_zero(whole.min_volume))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "an option is not finite or out of its range");
    options.max_broken = whole.max_broken;
    options.max_pieces = whole.max_pieces;
    options.max_spheres = whole.max_spheres;
    options.break_radius = whole.break_radius;
    options.min_volume = whole.min_volume;
    options.seed = whole.seed;
    if (whole.carve)
        if (const firma_code code = read_cut(whole.carve, options.carve, function)) return code;
    return read_push(&whole.push, options.push, function);
}

}  // namespace

firma_explosion explosion_told(const BlastResult& from, const firma_carve_report& carve) {
    firma_explosion out{};
    out.status = std::uint32_t(from.carve.status);
    out.loose = from.loose.size();
    out.pieces = from.pieces.size();
    out.broken = from.broken;
    out.unfit = from.unfit;
    out.dust = from.dust;
    out.dust_mass = from.dust_mass;
    out.reached = from.push.reached;
    out.pushed = from.push.pushed;
    out.carve = carve;
    return out;
}

firma_code read_blast(const firma_blast* given, Blast& blast, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_blast whole;
    firma_blast_defaults(&whole);
    take_sized(given, whole);
    blast = {vec(whole.at), whole.radius, whole.impulse};
    if (!is_finite(blast.at) || !is_above_zero(blast.radius) || !is_not_below_zero(blast.impulse))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the blast is not finite or out of its range");
    return FIRMA_OK;
}

firma_code read_push(const firma_push_options* given, PushOptions& push, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_push_options whole;
    firma_push_options_defaults(&whole);
    take_sized(given, whole);
    push.mask = whole.mask;
    push.max_speed = whole.max_speed;
    return push.max_speed >= 0 ? FIRMA_OK
                               : fail(FIRMA_ERROR_OUT_OF_RANGE, function, "max_speed is not a number, or negative");
}

firma_code read_cut(const firma_carve_options* given, CarveOptions& carve, const char* function) {
    CarveKind kind = CarveKind::kCarve;
    CarveOptions chosen;
    if (const firma_code code = read_options(given, chosen, kind, function)) return code;
    if (kind == CarveKind::kFill) return fail(FIRMA_ERROR_INVALID, function, "`carve` may not be a fill");
    carve = std::move(chosen);
    return FIRMA_OK;
}

namespace {

firma_code tell_exposure(const Scene& scene, const double from[3], const double* spheres, size_t count, uint32_t mask,
                         double* seen, const char* function) {
    if (!from || !seen || (!spheres && count)) return bad_call(function, kNull);
    const Vec3 at{from[0], from[1], from[2]};
    std::vector<Sphere> all;
    bool good = is_finite(at);
    for (std::size_t k = 0; k < count; ++k) {
        all.push_back({{spheres[4 * k], spheres[4 * k + 1], spheres[4 * k + 2]}, spheres[4 * k + 3]});
        good = good && is_finite(all[k].centre) && is_not_below_zero(all[k].radius);
    }
    if (!good) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the point or a sphere is not finite or out of range");
    *seen = exposure(scene, at, std::span<const Sphere>(all), mask);
    return FIRMA_OK;
}

firma_code push_all(const Scene& scene, firma_bodies bodies, const firma_blast* blast,
                    const firma_push_options* options, firma_push_report* report, const char* function) {
    if (report && !sized(report)) return bad_call(function, kWrongSize);
    Blast asked;
    if (const firma_code code = read_blast(blast, asked, function)) return code;
    PushOptions chosen;
    if (const firma_code code = read_push(options, chosen, function)) return code;
    firma_code code = FIRMA_OK;
    BodiesObject* const object = find_bodies(bodies, code, function);
    if (!object) return code;
    const PushReport made = blast_push(scene, object->bodies, asked, chosen);
    if (report) put_sized({0, 0, made.reached, made.pushed}, report);
    return FIRMA_OK;
}

firma_code explode_in(const Scene& scene, firma_debris debris, firma_bodies bodies, const firma_blast* blast,
                      firma_cutter crater, const firma_pose* pose, const firma_explode_options* options,
                      firma_world* after, firma_explosion* report, const char* function) {
    if (!pose || !after) return bad_call(function, kNull);
    if (report && !sized(report)) return bad_call(function, kWrongSize);
    firma_explosion whole{};
    if (report) take_sized(report, whole);
    if (whole.carve.size != 0 && !sized(&whole.carve)) return bad_call(function, kWrongSize);
    Blast asked;
    if (const firma_code code = read_blast(blast, asked, function)) return code;
    BlastOptions chosen;
    if (const firma_code code = read_explode(options, chosen, function)) return code;
    const CutterObject* cutter = nullptr;
    if (crater.id != 0 && !(cutter = find<CutterObject>(crater.id, function))) return FIRMA_ERROR_BAD_HANDLE;
    DebrisThere there;
    if (const firma_code code = there.find_both(debris, bodies, function)) return code;
    auto object = std::make_unique<WorldObject>(World{});
    BlastResult made = there.change([&](Bodies& all, Debris& of) {
        return explode(scene, all, of, asked, cutter ? cutter->cutter : Cutter{}, firma::c::pose_of(*pose), chosen);
    });
    object->world = made.carve.world;
    if (const firma_code code = give(std::move(object), after, function)) {
        there.debris->broken = there.bodies->broken = true;  // its world is lost
        return code;
    }
    if (whole.carve.size != 0) put_report(made.carve, {0}, &whole.carve);
    if (report) put_sized(explosion_told(made, whole.carve), report);
    there.debris->forget();
    there.debris->named[FIRMA_DEBRIS_LOOSE].swap(made.loose);
    there.debris->named[FIRMA_DEBRIS_PIECES].swap(made.pieces);
    if (made.carve.status == CarveStatus::kRefused) fail(made.carve.error);
    return FIRMA_OK;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_blast_defaults(firma_blast* blast) {
    if (!blast) return;
    const Blast usual;
    *blast = {sizeof(firma_blast), 0, {0, 0, 0}, usual.radius, usual.impulse};
}

firma_code firma_blast_share(const firma_blast* blast, double distance, double* share) {
    return guarded(__func__, [&, function = __func__] {
        if (!share) return bad_call(function, kNull);
        Blast asked;
        if (const firma_code code = read_blast(blast, asked, function)) return code;
        if (!is_not_below_zero(distance))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the distance is not finite, or negative");
        *share = blast_share(asked, distance);
        return FIRMA_OK;
    });
}

firma_code firma_blast_impulse(const firma_blast* blast, const double point[3], double area, double seen,
                               double impulse[3]) {
    return guarded(__func__, [&, function = __func__] {
        if (!point || !impulse) return bad_call(function, kNull);
        Blast asked;
        if (const firma_code code = read_blast(blast, asked, function)) return code;
        const Vec3 at{point[0], point[1], point[2]};
        if (!is_finite(at) || !is_not_below_zero(area) || !(seen >= 0 && seen <= 1))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the point, the area or the share seen is out of range");
        const Vec3 push = blast_impulse(asked, at, area, seen);
        for (int k = 0; k < 3; ++k) impulse[k] = push[k];
        return FIRMA_OK;
    });
}

firma_code firma_exposure(firma_world world, const double from[3], const double* spheres, size_t count, uint32_t mask,
                          double* seen) {
    return guarded(__func__, [&, function = __func__] {
        const WorldObject* const object = find<WorldObject>(world.id, function);
        return object ? tell_exposure({object->world}, from, spheres, count, mask, seen, function)
                      : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_exposure_scene(const firma_scene* scene, const double from[3], const double* spheres, size_t count,
                                uint32_t mask, double* seen) {
    return guarded(__func__, [&, function = __func__] {
        SceneThere there;
        if (const firma_code code = there.read(scene, function)) return code;
        return tell_exposure(there.scene(), from, spheres, count, mask, seen, function);
    });
}

void firma_push_options_defaults(firma_push_options* options) {
    const PushOptions usual;
    if (options) *options = {sizeof(firma_push_options), usual.mask, usual.max_speed};
}

firma_code firma_blast_push(firma_world world, firma_bodies bodies, const firma_blast* blast,
                            const firma_push_options* options, firma_push_report* report) {
    return guarded(__func__, [&, function = __func__] {
        const WorldObject* const level = find<WorldObject>(world.id, function);
        return level ? push_all({level->world}, bodies, blast, options, report, function) : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_blast_push_scene(const firma_scene* scene, firma_bodies bodies, const firma_blast* blast,
                                  const firma_push_options* options, firma_push_report* report) {
    return guarded(__func__, [&, function = __func__] {
        SceneThere there;
        if (const firma_code code = there.read(scene, function)) return code;
        return push_all(there.scene(), bodies, blast, options, report, function);
    });
}

void firma_explode_options_defaults(firma_explode_options* options) {
    if (!options) return;
    const BlastOptions usual;
    *options = {};
    options->size = sizeof *options;
    options->max_broken = usual.max_broken;
    options->max_pieces = std::uint32_t(usual.max_pieces);
    options->max_spheres = std::uint32_t(usual.max_spheres);
    options->break_radius = usual.break_radius;
    options->min_volume = usual.min_volume;
    options->seed = usual.seed;
    firma_push_options_defaults(&options->push);
}

firma_code firma_explode(firma_world world, firma_debris debris, firma_bodies bodies, const firma_blast* blast,
                         firma_cutter crater, const firma_pose* pose, const firma_explode_options* options,
                         firma_world* after, firma_explosion* report) {
    return guarded(__func__, [&, function = __func__] {
        const WorldObject* const level = find<WorldObject>(world.id, function);
        if (!level) return FIRMA_ERROR_BAD_HANDLE;
        return explode_in({level->world}, debris, bodies, blast, crater, pose, options, after, report, function);
    });
}

firma_code firma_explode_scene(const firma_scene* scene, firma_debris debris, firma_bodies bodies,
                               const firma_blast* blast, firma_cutter crater, const firma_pose* pose,
                               const firma_explode_options* options, firma_world* after, firma_explosion* report) {
    return guarded(__func__, [&, function = __func__] {
        SceneThere there;
        if (const firma_code code = there.read(scene, function)) return code;
        return explode_in(there.scene(), debris, bodies, blast, crater, pose, options, after, report, function);
    });
}
