// SPDX-License-Identifier: MIT
// Cutters and edits.
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "bindings/c/orders.h"
#include "bindings/c/results.h"

namespace firma::c {
namespace {

firma_code give_cutter(Result<Cutter> cutter, firma_cutter* out, const char* function) {
    if (!cutter) return fail(cutter.error());
    return give(std::make_unique<CutterObject>(std::move(cutter).value()), out, function);
}

constexpr const char* kBrokenJob = "the job ran out of memory before: release it and start another";

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_cutter_crater(uint32_t shape, uint64_t seed, firma_cutter* cutter) {
    return guarded(__func__, [&, function = __func__] {
        if (!cutter) return bad_call(function, kNull);
        if (shape > FIRMA_BOX) return fail(FIRMA_ERROR_INVALID, function, "there is no shape " + std::to_string(shape));
        const CraterSeed crater{CutterShape(shape), seed};
        return give(std::make_unique<CutterObject>(make_crater(crater.shape, seed), crater), cutter, function);
    });
}

firma_code firma_cutter_from_mesh(const double* positions, size_t vertex_count, const uint32_t* corners,
                                  size_t triangle_count, const char* name, firma_cutter* cutter) {
    return guarded(__func__, [&, function = __func__] {
        if (!cutter || (vertex_count && !positions) || (triangle_count && !corners)) return bad_call(function, kNull);
        if (triangle_count > kMaxCutterTriangles || vertex_count > 3 * kMaxCutterTriangles)
            return fail(FIRMA_ERROR_TOO_LARGE, function,
                        "a cutter has at most " + std::to_string(kMaxCutterTriangles) + " triangles");
        std::vector<Vec3> vertices(vertex_count);
        for (std::size_t k = 0; k < vertex_count; ++k)
            vertices[k] = {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]};
        std::vector<CutterTriangle> triangles(triangle_count);
        for (std::size_t k = 0; k < triangle_count; ++k)
            triangles[k] = {corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]};
        return give_cutter(make_cutter(vertices, triangles, text_of(name)), cutter, function);
    });
}

firma_code firma_cutter_from_obj(const char* text, size_t length, const char* name, firma_cutter* cutter) {
    return guarded(__func__, [&, function = __func__] {
        if (!cutter || (length && !text)) return bad_call(function, kNull);
        const Result<Level> level = read_obj({text, length}, name_or(name, "obj"));
        if (!level) return fail(level.error());
        return give_cutter(cutter_from_level(level.value()), cutter, function);
    });
}

firma_code firma_cutter_from_world(firma_world world, const char* name, firma_cutter* cutter) {
    return guarded(__func__, [&, function = __func__] {
        if (!cutter) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_cutter(cutter_from_solid(object->world.solid(), text_of(name)), cutter, function);
    });
}

firma_code firma_cutter_release(firma_cutter cutter) {
    return release<CutterObject>(cutter.id, __func__);
}

void firma_random_turn(uint64_t seed, double rotation[4]) {
    if (!rotation) return;
    const Quaternion turn = random_turn(seed);
    std::memcpy(rotation, turn.data(), sizeof turn);
}

firma_code firma_carve(firma_world world, firma_cutter cutter, const firma_pose* pose,
                       const firma_carve_options* options, firma_world* after, firma_carve_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        Order order;
        if (const firma_code code = read_order(cutter, pose, options, order, function)) return code;
        const auto edit = order.kind == CarveKind::kFill ? firma::fill : firma::carve;
        return give_result(edit(object->world, order.cutter->cutter, order.pose, order.options), after, report,
                           function);
    });
}

firma_code firma_job_start(firma_world world, firma_cutter cutter, const firma_pose* pose,
                           const firma_carve_options* options, firma_job* job) {
    return guarded(__func__, [&, function = __func__] {
        if (!job) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        Order order;
        if (const firma_code code = read_order(cutter, pose, options, order, function)) return code;
        return give(std::make_unique<JobObject>(
                        CarveJob(object->world, order.cutter->cutter, order.pose, order.options, order.kind)),
                    job, function);
    });
}

firma_code firma_job_run(firma_job job, double microseconds, uint32_t* finished) {
    return guarded(__func__, [&, function = __func__] {
        if (!finished) return bad_call(function, kNull);
        JobObject* object = find<JobObject>(job.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (!(microseconds >= 0)) return fail(FIRMA_ERROR_INVALID, function, "the time is negative, or no number");
        if (object->broken) return fail(FIRMA_ERROR_NO_MEMORY, function, kBrokenJob);
        object->broken = true;  // unless it comes back
        *finished = std::visit([&](auto& work) { return work.run(microseconds); }, object->job);
        object->broken = false;
        return FIRMA_OK;
    });
}

firma_code firma_job_result(firma_job job, firma_world* after, firma_carve_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        const JobObject* object = find<JobObject>(job.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (object->broken) return fail(FIRMA_ERROR_NO_MEMORY, function, kBrokenJob);
        if (!std::visit([](const auto& work) { return work.finished(); }, object->job))
            return bad_call(function, "the job is not finished: run it on first");
        return give_result(std::visit([](const auto& work) { return carve_result(work.result()); }, object->job), after,
                           report, function);
    });
}

firma_code firma_job_release(firma_job job) {
    return release<JobObject>(job.id, __func__);
}

firma_code firma_edit_begin(firma_world world, firma_edit* edit) {
    return guarded(__func__, [&, function = __func__] {
        if (!edit) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give(std::make_unique<EditObject>(object->world), edit, function);
    });
}

firma_code firma_edit_carve(firma_edit edit, firma_cutter cutter, const firma_pose* pose,
                            const firma_carve_options* options, firma_carve_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        EditObject* object = find<EditObject>(edit.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        Order order;
        if (const firma_code code = read_order(cutter, pose, options, order, function)) return code;
        WorldEdit next = object->edit;
        const auto step = order.kind == CarveKind::kFill ? &WorldEdit::fill : &WorldEdit::carve;
        const firma_code code =
            give_result((next.*step)(order.cutter->cutter, order.pose, order.options), nullptr, report, function);
        if (code == FIRMA_OK) object->edit = std::move(next);
        return code;
    });
}

firma_code firma_edit_finish(firma_edit edit, firma_world* after) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        const EditObject* object = find<EditObject>(edit.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give(std::make_unique<WorldObject>(object->edit.finish()), after, function);
    });
}

firma_code firma_edit_release(firma_edit edit) {
    return release<EditObject>(edit.id, __func__);
}
