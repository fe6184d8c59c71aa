// SPDX-License-Identifier: MIT
// Faces as triangles.
#include "firma/triangles.h"

#include <algorithm>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "world/world_data.h"

namespace firma::c {
namespace {

struct TrianglesObject final : Object {
    static constexpr Kind kKind = Kind::kTriangles;
    static constexpr const char* kNoun = "list of triangles";
    TriangleMesh made;
    std::vector<std::uint32_t> faces;
    std::vector<firma_triangle_run> runs;
    std::vector<firma_triangle_source> sources;
};

std::unique_ptr<TrianglesObject> object_of(TriangleMesh made) {
    auto object = std::make_unique<TrianglesObject>();
    object->made = std::move(made);
    object->faces.reserve(object->made.faces.size());
    for (const FaceId face : object->made.faces) object->faces.push_back(face.value);
    for (const TriangleMesh::Run& run : object->made.runs)
        object->runs.push_back(
            {run.material, run.first_triangle, run.triangle_count, run.first_vertex, run.vertex_count, 0});
    object->sources.reserve(object->made.sources.size());
    for (const TriangleMesh::Source& one : object->made.sources) {
        const std::uint32_t flags = (one.two_sided ? FIRMA_FACE_TWO_SIDED : 0) | (one.solid ? FIRMA_FACE_SOLID : 0);
        object->sources.push_back({one.face.value, one.room.value, one.source, one.source_edit, one.material, one.mask,
                                   flags, one.first_triangle, one.triangle_count, one.first_vertex, one.vertex_count,
                                   std::uint32_t(one.uv_unit)});
    }
    return object;
}

std::size_t materials_of(const World& world) {
    return world.data().materials ? world.data().materials->size() : 0;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_triangle_options_defaults(firma_triangle_options* options) {
    if (!options) return;
    *options = {};
    options->size = sizeof(firma_triangle_options);
    options->mask = ~0u;
    options->room = FIRMA_ANY_ROOM;
}

firma_code firma_world_triangles(firma_world world, const firma_triangle_options* given, firma_triangles* triangles) {
    return guarded(__func__, [&, function = __func__] {
        if (!triangles) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        firma_triangle_options whole;
        firma_triangle_options_defaults(&whole);
        if (given && !sized(given)) return bad_call(function, kWrongSize);
        if (given) take_sized(given, whole);
        const firma_triangle_options* const options = &whole;
        if (options->solid_only > 1) return fail(FIRMA_ERROR_INVALID, function, "solid_only must be 0 or 1");
        if (options->uvs > 1) return fail(FIRMA_ERROR_INVALID, function, "uvs must be 0 or 1");
        if (options->reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
        if (options->texture_size_count && !options->texture_sizes)
            return bad_call(function, "a count without its array");
        const bool in_room = options->room != FIRMA_ANY_ROOM;
        if (in_room && options->region)
            return fail(FIRMA_ERROR_INVALID, function, "either a room or a region, not both");
        if (in_room && options->room >= object->world.room_count())
            return fail(FIRMA_ERROR_INVALID, function, "the world has no such room");
        if (!is_finite(vec(options->origin)) || max_abs(vec(options->origin)) > kMaxTriangleOrigin)
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the origin is not finite or too large");
        std::vector<std::array<double, 2>> sizes(std::min(options->texture_size_count, materials_of(object->world)));
        for (std::size_t k = 0; k < sizes.size(); ++k)
            sizes[k] = {options->texture_sizes[2 * k], options->texture_sizes[2 * k + 1]};
        const TriangleOptions chosen{vec(options->origin), options->mask, options->solid_only == 0, options->uvs == 1,
                                     sizes};
        if (!options->region)
            return give(object_of(triangles_of(object->world, RoomId{options->room}, chosen)), triangles, function);
        const Region region{options->region[0], options->region[1], options->region[2]};
        return give(object_of(triangles_of(object->world, region, chosen)), triangles, function);
    });
}

firma_code firma_triangles_get_view(firma_triangles triangles, firma_triangles_view* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const TrianglesObject* object = find<TrianglesObject>(triangles.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const TriangleMesh& made = object->made;
        static_assert(sizeof made.positions[0] == 3 * sizeof(float) && sizeof made.corners[0] == 3 * sizeof(uint32_t) &&
                      sizeof made.uvs[0] == 2 * sizeof(float));
        firma_triangles_view view{};
        if (!made.positions.empty()) {
            view.positions = made.positions[0].data();
            view.normals = made.normals[0].data();
            view.corners = made.corners[0].data();
        }
        if (!made.uvs.empty()) view.uvs = made.uvs[0].data();
        view.vertex_count = made.positions.size();
        view.faces = object->faces.data();
        view.triangle_count = made.corners.size();
        view.runs = object->runs.data();
        view.run_count = object->runs.size();
        view.sources = object->sources.data();
        view.source_count = object->sources.size();
        put_sized(view, out);
        return FIRMA_OK;
    });
}

firma_code firma_triangles_release(firma_triangles triangles) {
    return release<TrianglesObject>(triangles.id, __func__);
}
