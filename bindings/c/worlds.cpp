// SPDX-License-Identifier: MIT
// Worlds made, released, measured.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/make_on_threads.h"
#include "bindings/c/objects.h"
#include "firma/brush_world.h"
#include "firma/memory.h"
#include "firma/mesh.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "world/world_data.h"

namespace firma::c {
namespace {

firma_code give_world(World world, firma_world* out, const char* function) {
    return give(std::make_unique<WorldObject>(std::move(world)), out, function);
}

template <class AnyLevel>
firma_code make(const Result<AnyLevel>& level, const WorldOptions& options, firma_world* out, const char* function) {
    if (!level) return fail(level.error());
    Result<World> world = make_on_threads(level.value(), options);
    if (!world) return fail(world.error());
    return give_world(std::move(world).value(), out, function);
}

/// The arrays of a mesh as views, and what they need to be held by.
struct MeshArrays {
    std::vector<Vec3> vertices;
    std::vector<std::string> names;
    std::vector<TexturePoint> uvs;
    Mesh mesh;
};

firma_code read_mesh(const firma_mesh& from, MeshArrays& arrays, const char* function) {
    if (!sized(&from)) return bad_call(function, kWrongSize);
    firma_mesh given{};
    take_sized(&from, given);
    const auto lacks = [](const void* array, std::size_t count) { return count > 0 && !array; };
    if (lacks(given.positions, given.vertex_count) || lacks(given.corners, given.face_count) ||
        lacks(given.material_names, given.material_count))
        return bad_call(function, "a count without its array");
    if (given.vertex_count >> 31 || given.face_count >> 31)
        return fail(FIRMA_ERROR_TOO_LARGE, function, "a level holds fewer than 2^31 vertices and faces");
    arrays.vertices.reserve(given.vertex_count);
    for (std::size_t k = 0; k < given.vertex_count; ++k)
        arrays.vertices.push_back({given.positions[3 * k], given.positions[3 * k + 1], given.positions[3 * k + 2]});
    for (std::uint32_t k = 0; k < given.material_count; ++k) {
        if (!given.material_names[k]) return bad_call(function, "the name of a material is null");
        arrays.names.emplace_back(given.material_names[k]);
    }
    std::uint64_t corners = 3 * std::uint64_t(given.face_count);  // more than a size_t of 32 bits may hold
    if (given.corner_counts) {
        corners = 0;
        for (std::size_t k = 0; k < given.face_count; ++k) corners += given.corner_counts[k];
        arrays.mesh.corner_counts = {given.corner_counts, given.face_count};
    }
    if (corners >> 31) return fail(FIRMA_ERROR_TOO_LARGE, function, "a level holds fewer than 2^31 corners");
    arrays.mesh.vertices = arrays.vertices;
    arrays.mesh.corners = {given.corners, std::size_t(corners)};
    arrays.mesh.material_names = arrays.names;
    if (given.materials) arrays.mesh.materials = {given.materials, given.face_count};
    if (given.masks) arrays.mesh.masks = {given.masks, given.face_count};
    if (given.two_sided) arrays.mesh.two_sided = {given.two_sided, given.face_count};
    if (!given.uvs) return FIRMA_OK;
    arrays.uvs.reserve(std::size_t(corners));
    for (std::size_t k = 0; k < std::size_t(corners); ++k)
        arrays.uvs.push_back({given.uvs[2 * k], given.uvs[2 * k + 1]});
    arrays.mesh.uvs = arrays.uvs;
    return FIRMA_OK;
}

/// A limit; one that a size_t of 32 bits cannot hold limits nothing.
std::size_t or_default(std::uint64_t given, std::size_t otherwise) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
    return given == 0 ? otherwise : std::size_t(given < kMost ? given : kMost);
}

firma_code read_rules(const firma_rules& from, CarveRules& rules, const char* function) {
    if (!sized(&from)) return bad_call(function, kWrongSize);
    firma_rules given{};
    take_sized(&from, given);
    if (given.reserved != 0 || given.reserved2 != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    if (given.no_open_faces > 1) return fail(FIRMA_ERROR_INVALID, function, "no_open_faces must be 0 or 1");
    if ((given.zone_count && !given.zones) || (given.hardness_count && !given.hardness))
        return bad_call(function, "a count without its array");
    for (std::size_t k = 0; k < given.zone_count; ++k) {
        const firma_zone& zone = given.zones[k];
        rules.zones.push_back({text_of(zone.name), {vec(zone.low), vec(zone.high)}, zone.hardness});
    }
    rules.hardness.assign(given.hardness, given.hardness + given.hardness_count);
    rules.max_faces = or_default(given.max_faces, rules.max_faces);
    rules.max_candidate_faces = or_default(given.max_candidate_faces, rules.max_candidate_faces);
    rules.max_new_faces = or_default(given.max_new_faces, rules.max_new_faces);
    rules.max_cutter_triangles = or_default(given.max_cutter_triangles, rules.max_cutter_triangles);
    rules.max_pairs = or_default(given.max_pairs, rules.max_pairs);
    rules.max_corners = or_default(given.max_corners, rules.max_corners);
    if (given.max_cutter_size != 0) rules.max_cutter_size = given.max_cutter_size;
    rules.merge_share = given.merge_share;
    rules.open_faces = given.no_open_faces == 0;
    return FIRMA_OK;
}

/// From a file's bytes to a world; `read(ReadOptions)` makes a level of them.
template <class Read>
firma_code from_bytes(const void* data, size_t length, const firma_world_options* options, firma_world* world,
                      const char* function, const Read& read) {
    if ((!data && length) || !world) return bad_call(function, kNull);
    WorldOptions made;
    ReadOptions reading;
    if (const firma_code code = read_options(options, made, reading, function)) return code;
    return make(read(reading), made, world, function);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_world_options_defaults(firma_world_options* options) {
    if (!options) return;
    const WorldOptions defaults;
    *options = {};
    options->size = sizeof(firma_world_options);
    options->surface_area = defaults.tree.split == Split::kSurfaceArea;
    options->max_depth = defaults.tree.max_depth;
    options->faces_per_leaf = defaults.tree.faces_per_leaf;
    options->min_node_volume = defaults.tree.min_node_volume;
    options->contact_offset = defaults.tolerance.contact_offset;
}

firma_code firma_world_from_mesh(const firma_mesh* mesh, const char* name, const firma_world_options* options,
                                 firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!mesh || !world) return bad_call(function, kNull);
        WorldOptions made;
        ReadOptions read;
        if (const firma_code code = read_options(options, made, read, function)) return code;
        MeshArrays arrays;
        if (const firma_code code = read_mesh(*mesh, arrays, function)) return code;
        return make(level_from_mesh(arrays.mesh, name_or(name, "mesh"), read), made, world, function);
    });
}

firma_code firma_world_from_obj(const char* text, size_t length, const char* name, const firma_world_options* options,
                                firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        return from_bytes(text, length, options, world, function, [&](const ReadOptions& read) {
            return read_obj({text, length}, name_or(name, "obj"), read);
        });
    });
}

firma_code firma_world_from_bsp(const void* data, size_t length, const char* name, const firma_world_options* options,
                                firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        return from_bytes(data, length, options, world, function, [&](const ReadOptions& read) {
            return read_bsp_brushes({static_cast<const std::byte*>(data), length}, name_or(name, "bsp"), read);
        });
    });
}

#if !defined(__wasm__)

firma_code firma_world_from_bsp_surfaces(const void* data, size_t length, const char* name,
                                         const firma_world_options* options, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        return from_bytes(data, length, options, world, function, [&](const ReadOptions& read) {
            return read_bsp({static_cast<const std::byte*>(data), length}, name_or(name, "bsp"), read);
        });
    });
}

#endif

firma_code firma_world_from_map(const char* text, size_t length, const char* name, const firma_world_options* options,
                                firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        return from_bytes(text, length, options, world, function, [&](const ReadOptions& read) {
            return read_map({text, length}, name_or(name, "map"), read);
        });
    });
}

firma_code firma_world_copy(firma_world world, firma_world* copy) {
    return guarded(__func__, [&, function = __func__] {
        if (!copy) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        return object ? give_world(object->world, copy, function) : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_world_release(firma_world world) {
    return release<WorldObject>(world.id, __func__);
}

firma_code firma_world_get_facts(firma_world world, firma_world_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const World& w = object->world;
        const Box bounds = w.bounds();
        firma_world_facts facts{};
        facts.version = w.version();
        facts.face_count = w.face_count();
        facts.room_count = w.room_count();
        facts.portal_count = portal_count(w);
        put(bounds.low, facts.low);
        put(bounds.high, facts.high);
        facts.contact_offset = w.tolerance().contact_offset;
        facts.material_count = std::uint32_t(w.data().materials ? w.data().materials->size() : 0);
        facts.edits = w.data().edits();
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

firma_code firma_world_hash(firma_world world, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *hash = hash_world(object->world);
        return FIRMA_OK;
    });
}

firma_code firma_world_hash_solid(firma_world world, uint64_t* hash) {
    return guarded(__func__, [&, function = __func__] {
        if (!hash) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *hash = hash_solid(object->world);
        return FIRMA_OK;
    });
}

firma_code firma_world_same_solid(firma_world a, firma_world b, uint32_t* same) {
    return guarded(__func__, [&, function = __func__] {
        if (!same) return bad_call(function, kNull);
        const WorldObject* one = find<WorldObject>(a.id, function);
        if (!one) return FIRMA_ERROR_BAD_HANDLE;
        const WorldObject* two = find<WorldObject>(b.id, function);
        if (!two) return FIRMA_ERROR_BAD_HANDLE;
        *same = same_solid(one->world, two->world);
        return FIRMA_OK;
    });
}

firma_code firma_world_hash_regions(firma_world world, firma_region_hash* hashes, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!hashes && capacity)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::vector<RegionHash> found = hash_regions(object->world);
        *count = found.size();
        for (std::size_t k = 0; k < std::min(capacity, found.size()); ++k) {
            const Region& at = found[k].region;
            hashes[k] = {{at.x, at.y, at.z}, 0, found[k].faces, found[k].points};
        }
        return FIRMA_OK;
    });
}

firma_code firma_world_check(firma_world world) {
    return guarded(__func__, [&, function = __func__] {
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const auto broken = [](FaceId face, const std::string& what) {
            const std::string place = face.valid() ? "face " + std::to_string(face.value) : "";
            return fail(FIRMA_ERROR_BROKEN, place, what);
        };
        if (const auto fault = check_world(object->world)) return broken(fault->face, fault->what);
        if (const auto fault = check_solid(object->world)) return broken(fault->face, fault->what);
        return FIRMA_OK;
    });
}

firma_code firma_world_measure(firma_world world, double* volume, double* area) {
    return guarded(__func__, [&, function = __func__] {
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const SolidMeasures measures = measure_solid(object->world);
        if (volume) *volume = measures.volume;
        if (area) *area = measures.area;
        return FIRMA_OK;
    });
}

firma_code firma_world_memory(const firma_world* worlds, size_t count, uint64_t* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if ((!worlds && count) || !bytes) return bad_call(function, kNull);
        std::vector<World> all;
        for (std::size_t k = 0; k < count; ++k) {
            const WorldObject* object = find<WorldObject>(worlds[k].id, function);
            if (!object) return FIRMA_ERROR_BAD_HANDLE;
            all.push_back(object->world);
        }
        *bytes = memory_used(all);
        return FIRMA_OK;
    });
}

firma_code firma_world_material(firma_world world, uint32_t material, const char** name) {
    return guarded(__func__, [&, function = __func__] {
        if (!name) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const auto& names = object->world.data().materials;
        if (!names || material >= names->size())
            return fail(FIRMA_ERROR_INVALID, function, "the world has no material " + std::to_string(material));
        *name = (*names)[material].c_str();
        return FIRMA_OK;
    });
}

firma_code firma_world_with_rules(firma_world world, const firma_rules* rules, firma_world* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!rules || !out) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        CarveRules made;
        if (const firma_code code = read_rules(*rules, made, function)) return code;
        Result<World> world_with = with_rules(object->world, std::move(made));
        if (!world_with) return fail(world_with.error());
        return give_world(std::move(world_with).value(), out, function);
    });
}
