// SPDX-License-Identifier: MIT
// Meshes by region.
#include "firma/region_meshes.h"

#include <algorithm>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "world/world_data.h"

namespace firma::c {
namespace {

struct RegionMeshesObject final : Object {
    static constexpr Kind kKind = Kind::kRegionMeshes;
    static constexpr const char* kNoun = "list of region meshes";

    struct Item {
        RegionMesh mesh;
        std::vector<std::uint32_t> faces;
        std::vector<firma_region_run> runs;
        std::vector<firma_region_part> parts;
    };
    std::vector<std::unique_ptr<Item>> items;
};

std::unique_ptr<RegionMeshesObject::Item> item_of(RegionMesh&& mesh) {
    auto made_item = std::make_unique<RegionMeshesObject::Item>();
    RegionMeshesObject::Item& item = *made_item;
    item.faces.reserve(mesh.faces.size());
    for (const FaceId face : mesh.faces) item.faces.push_back(face.value);
    for (const RegionMesh::Run& run : mesh.runs)
        item.runs.push_back({run.material, run.cut, run.two_sided, std::uint32_t(run.uv_unit), run.first_triangle,
                             run.triangle_count, run.first_vertex, run.vertex_count});
    item.parts.reserve(mesh.parts.size());
    for (const RegionMesh::FacePart& part : mesh.parts) {
        const std::uint32_t flags = (part.two_sided ? FIRMA_FACE_TWO_SIDED : 0) | (part.solid ? FIRMA_FACE_SOLID : 0);
        firma_region_part made{part.face.id.value,  {},
                               part.source,         part.source_edit,
                               part.mask,           flags,
                               part.first_triangle, part.triangle_count,
                               part.first_vertex,   part.vertex_count};
        put_corner(part.face, made.corner);
        item.parts.push_back(made);
    }
    item.mesh = std::move(mesh);
    return made_item;
}

template <class T>
auto data_or_null(const std::vector<T>& all) {
    return all.empty() ? nullptr : all[0].data();
}

/// Of all regions, or, with a world before, of those that changed.
firma_code make_meshes(const World* before, const World& after, const firma_region_options* given,
                       firma_region_meshes* out, const char* function) {
    firma_region_options options;
    firma_region_options_defaults(&options);
    if (given && !sized(given)) return bad_call(function, kWrongSize);
    if (given) take_sized(given, options);
    if (options.solid_only > 1) return fail(FIRMA_ERROR_INVALID, function, "solid_only must be 0 or 1");
    if (options.no_textures > 1) return fail(FIRMA_ERROR_INVALID, function, "no_textures must be 0 or 1");
    if (options.texture_size_count && !options.texture_sizes) return bad_call(function, "a count without its array");
    const std::size_t materials = after.data().materials ? after.data().materials->size() : 0;
    std::vector<std::array<double, 2>> sizes(std::min(options.texture_size_count, materials));
    for (std::size_t k = 0; k < sizes.size(); ++k)
        sizes[k] = {options.texture_sizes[2 * k], options.texture_sizes[2 * k + 1]};
    const RegionMeshOptions chosen{.size = options.region_size,
                                   .mask = options.mask,
                                   .castable_only = options.solid_only == 0,
                                   .textures = options.no_textures == 0,
                                   .texture_sizes = sizes};
    const Result<std::vector<Tile>> tiles =
        before ? changed_regions(*before, after, chosen.size) : regions_of(after, chosen.size);
    if (!tiles) return fail(tiles.error());
    auto object = std::make_unique<RegionMeshesObject>();
    for (const Tile& tile : tiles.value()) {
        Result<RegionMesh> mesh = region_mesh(after, tile, chosen);
        if (!mesh) return fail(mesh.error());
        if (before || !mesh.value().empty()) object->items.push_back(item_of(std::move(mesh.value())));
    }
    return give(std::move(object), out, function);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_region_options_defaults(firma_region_options* options) {
    if (!options) return;
    *options = {};
    options->size = sizeof(firma_region_options);
    options->mask = ~0u;
    options->region_size = RegionMeshOptions().size;
}

firma_code firma_world_region_meshes(firma_world world, const firma_region_options* options,
                                     firma_region_meshes* meshes) {
    return guarded(__func__, [&, function = __func__] {
        if (!meshes) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return make_meshes(nullptr, object->world, options, meshes, function);
    });
}

firma_code firma_world_changed_region_meshes(firma_world before, firma_world after, const firma_region_options* options,
                                             firma_region_meshes* meshes) {
    return guarded(__func__, [&, function = __func__] {
        if (!meshes) return bad_call(function, kNull);
        const WorldObject* one = find<WorldObject>(before.id, function);
        const WorldObject* two = one ? find<WorldObject>(after.id, function) : nullptr;
        if (!two) return FIRMA_ERROR_BAD_HANDLE;
        return make_meshes(&one->world, two->world, options, meshes, function);
    });
}

firma_code firma_region_meshes_get_count(firma_region_meshes meshes, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const RegionMeshesObject* object = find<RegionMeshesObject>(meshes.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *count = object->items.size();
        return FIRMA_OK;
    });
}

firma_code firma_region_meshes_get_view(firma_region_meshes meshes, size_t mesh, firma_region_mesh_view* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const RegionMeshesObject* object = find<RegionMeshesObject>(meshes.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (mesh >= object->items.size()) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such mesh");
        const RegionMeshesObject::Item& item = *object->items[mesh];
        const RegionMesh& made = item.mesh;
        firma_region_mesh_view view{};
        std::copy(made.place.begin(), made.place.end(), view.place);
        put(made.origin, view.origin);
        put(made.bounds.low, view.low);
        put(made.bounds.high, view.high);
        view.positions = data_or_null(made.positions);
        view.normals = data_or_null(made.normals);
        view.tangents = data_or_null(made.tangents);
        view.uvs = data_or_null(made.uvs);
        view.blends = data_or_null(made.blends);
        view.vertex_count = made.positions.size();
        view.corners = data_or_null(made.corners);
        view.faces = item.faces.data();
        view.triangle_count = made.corners.size();
        view.runs = item.runs.data();
        view.run_count = item.runs.size();
        view.parts = item.parts.data();
        view.part_count = item.parts.size();
        put_sized(view, out);
        return FIRMA_OK;
    });
}

firma_code firma_region_meshes_release(firma_region_meshes meshes) {
    return release<RegionMeshesObject>(meshes.id, __func__);
}
