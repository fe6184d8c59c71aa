// SPDX-License-Identifier: MIT
// Loose chunks: what holds pieces, the pieces as bodies and as worlds, and how they become ground again.
#include "firma/chunk.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/mass.h"
#include "world/world_data.h"

namespace firma::c {
namespace {

firma_code judge_density(double density, const char* function) {
    if (is_finite(density) && density >= 0) return FIRMA_OK;
    return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the density is not a finite number, or is negative");
}

firma_code read_anchors(const firma_anchors& from, AnchorRules& rules, const char* function) {
    if (!sized(&from)) return bad_call(function, kWrongSize);
    firma_anchors given{};
    take_sized(&from, given);
    if (given.no_hanging > 1) return fail(FIRMA_ERROR_INVALID, function, "no_hanging must be 0 or 1");
    if ((given.material_count && !given.materials) || (given.source_count && !given.sources) ||
        (given.volume_count && !given.volumes))
        return bad_call(function, "a count without its array");
    rules.hanging = given.no_hanging == 0;
    for (std::size_t k = 0; k < given.material_count; ++k) {
        if (!given.materials[k]) return bad_call(function, "the name of a material is null");
        rules.materials.emplace_back(given.materials[k]);
    }
    if (given.source_count) rules.sources.assign(given.sources, given.sources + given.source_count);
    for (std::size_t k = 0; k < given.volume_count; ++k)
        rules.volumes.push_back({vec(given.volumes[k].low), vec(given.volumes[k].high)});
    return FIRMA_OK;
}

/// The piece with this number; null with the message said.
const firma::Chunk* find_chunk(const ChunksObject& object, std::size_t chunk, const char* function) {
    if (chunk < object.chunks.size()) return &object.chunks[chunk];
    fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such chunk");
    return nullptr;
}

/// A world of a piece whose materials have their names.
Result<World> named_world(const Solid& solid, const ChunksObject& of) {
    WorldOptions options;
    options.tolerance = of.tolerance;
    options.tree = of.tree;
    Result<World> world = make_world(solid, options);
    if (!world || !of.materials) return world;
    auto data = std::make_shared<WorldData>(world.value().data());
    data->materials = of.materials;
    return World(std::move(data));
}

}  // namespace

ChunksObject::ChunksObject(std::vector<firma::Chunk> all, const World& of)
    : chunks(std::move(all)), materials(of.data().materials), tolerance(of.tolerance()), tree(of.data().tree_options) {
    for (const firma::Chunk& chunk : chunks) {
        std::vector<firma_matter_volume>& of_chunk = volumes.emplace_back();
        for (const MatterVolume& it : chunk.matters) of_chunk.push_back({it.matter, 0, it.volume});
    }
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_world_with_anchors(firma_world world, const firma_anchors* anchors, firma_world* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        AnchorRules rules;
        if (anchors)
            if (const firma_code code = read_anchors(*anchors, rules, function)) return code;
        return give(std::make_unique<WorldObject>(with_anchors(object->world, rules)), out, function);
    });
}

firma_code firma_world_mass(firma_world world, double density, firma_mass* mass) {
    return guarded(__func__, [&, function = __func__] {
        if (!mass) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = judge_density(density, function)) return code;
        put(mass_properties(object->world.solid(), density), *mass);
        return FIRMA_OK;
    });
}

firma_code firma_chunks_get_count(firma_chunks chunks, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const ChunksObject* object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *count = object->chunks.size();
        return FIRMA_OK;
    });
}

firma_code firma_chunks_get(firma_chunks chunks, size_t chunk, firma_chunk* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const ChunksObject* object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const firma::Chunk* const found = find_chunk(*object, chunk, function);
        if (!found) return FIRMA_ERROR_OUT_OF_RANGE;
        const Box bounds = found->solid.bounds();
        firma_chunk made{};
        put(found->origin, made.origin);
        put(found->mass, made.mass);
        made.face_count = found->solid.face_count();
        put(bounds.low, made.low);
        put(bounds.high, made.high);
        made.matters = object->volumes[chunk].data();
        made.matter_count = object->volumes[chunk].size();
        put_sized(made, out);
        return FIRMA_OK;
    });
}

firma_code firma_chunks_world(firma_chunks chunks, size_t chunk, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        const ChunksObject* object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const firma::Chunk* const found = find_chunk(*object, chunk, function);
        if (!found) return FIRMA_ERROR_OUT_OF_RANGE;
        Result<World> made = named_world(found->solid, *object);
        if (!made) return fail(made.error());
        return give(std::make_unique<WorldObject>(std::move(made).value()), world, function);
    });
}

firma_code firma_chunks_release(firma_chunks chunks) {
    return release<ChunksObject>(chunks.id, __func__);
}

firma_code firma_world_pieces(firma_world world, double density, firma_chunks* pieces) {
    return guarded(__func__, [&, function = __func__] {
        if (!pieces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (const firma_code code = judge_density(density, function)) return code;
        std::vector<firma::Chunk> all;
        for (Solid& solid : connected_pieces(object->world.solid())) {
            const MassProperties mass = mass_properties(solid, density);
            all.push_back({std::move(solid), {}, mass, {}});
        }
        return give(std::make_unique<ChunksObject>(std::move(all), object->world), pieces, function);
    });
}

firma_code firma_cutter_at_rest(firma_world world, const firma_pose* pose, const char* name, firma_cutter* cutter,
                                firma_rest* rest) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose || !cutter || !rest) return bad_call(function, kNull);
        if (!sized(rest)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Result<RestingSolid> made = resting_solid(object->world.solid(), pose_of(*pose), text_of(name));
        if (!made) return fail(made.error());
        const RestingSolid& resting = made.value();
        const firma_code code = give(std::make_unique<CutterObject>(resting.cutter), cutter, function);
        if (code) return code;
        firma_rest out{};
        out.mended = std::uint32_t(resting.mended);
        put_pose(resting.pose, out.pose);
        out.volume_change = resting.volume_change;
        put_sized(out, rest);
        return FIRMA_OK;
    });
}
