// SPDX-License-Identifier: MIT
// What differs between worlds, as bytes.
#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/world_patch.h"

namespace firma::c {
namespace {

std::vector<RegionHash> hashes_of(const firma_region_hash* given, std::size_t count) {
    std::vector<RegionHash> all;
    all.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const firma_region_hash& one = given[k];
        all.push_back({{one.region[0], one.region[1], one.region[2]}, one.faces, one.points});
    }
    return all;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_differing_regions(const firma_region_hash* a, size_t a_count, const firma_region_hash* b,
                                   size_t b_count, int32_t* regions, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!a && a_count) || (!b && b_count) || (!regions && capacity)) return bad_call(function, kNull);
        const std::vector<Region> found = differing_regions(hashes_of(a, a_count), hashes_of(b, b_count));
        *count = found.size();
        for (std::size_t k = 0; k < std::min(capacity, found.size()); ++k) {
            regions[3 * k] = found[k].x;
            regions[3 * k + 1] = found[k].y;
            regions[3 * k + 2] = found[k].z;
        }
        return FIRMA_OK;
    });
}

firma_code firma_world_list_faces(firma_world world, const int32_t* regions, size_t region_count, firma_bytes* list) {
    return guarded(__func__, [&, function = __func__] {
        if (!list || (!regions && region_count)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        std::vector<Region> asked;
        asked.reserve(region_count);
        for (std::size_t k = 0; k < region_count; ++k)
            asked.push_back({regions[3 * k], regions[3 * k + 1], regions[3 * k + 2]});
        return give_bytes(list_faces(object->world, asked), list, function);
    });
}

firma_code firma_world_make_patch(firma_world world, const void* list, size_t length, const char* name,
                                  firma_bytes* patch) {
    return guarded(__func__, [&, function = __func__] {
        if (!patch || (!list && length)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_bytes(make_patch(object->world, bytes_of(list, length), name_or(name, "list")), patch, function);
    });
}

firma_code firma_world_patch_from(firma_world world, firma_world from, firma_bytes* patch) {
    return guarded(__func__, [&, function = __func__] {
        if (!patch) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        const WorldObject* before = object ? find<WorldObject>(from.id, function) : nullptr;
        if (!before) return FIRMA_ERROR_BAD_HANDLE;
        return give_bytes(make_patch(before->world, object->world), patch, function);
    });
}

firma_code firma_world_apply_patch(firma_world world, const void* patch, size_t length, const char* name,
                                   firma_world* patched) {
    return guarded(__func__, [&, function = __func__] {
        if (!patched || (!patch && length)) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        Result<World> made = apply_patch(object->world, bytes_of(patch, length), name_or(name, "patch"));
        if (!made) return fail(made.error());
        return give(std::make_unique<WorldObject>(std::move(made).value()), patched, function);
    });
}
