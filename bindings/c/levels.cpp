// SPDX-License-Identifier: MIT
// Levels of brushes: their entities, and worlds of them.
#include <memory>
#include <string>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/level_object.h"
#include "bindings/c/make_on_threads.h"
#include "bindings/c/objects.h"
#include "firma/brush_world.h"

namespace firma::c {
namespace {

template <class Read>
firma_code give_level(const void* data, std::size_t length, double scale, firma_level* level, const char* function,
                      const Read& read) {
    if ((!data && length) || !level) return bad_call(function, kNull);
    if (!(scale >= 0) || !is_finite(scale))
        return fail(FIRMA_ERROR_INVALID, function, "the scale must be a finite number above zero, or 0");
    ReadOptions options;
    options.scale = scale;
    Result<BrushLevel> made = read(options);
    if (!made) return fail(made.error());
    return give(std::make_unique<LevelObject>(std::move(made.value())), level, function);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_level_from_map(const char* text, size_t length, const char* name, double scale, firma_level* level) {
    return guarded(__func__, [&, function = __func__] {
        return give_level(text, length, scale, level, function, [&](const ReadOptions& read) {
            return read_map({text, length}, name_or(name, "map"), read);
        });
    });
}

firma_code firma_level_from_bsp(const void* data, size_t length, const char* name, double scale, firma_level* level) {
    return guarded(__func__, [&, function = __func__] {
        return give_level(data, length, scale, level, function, [&](const ReadOptions& read) {
            return read_bsp_brushes({static_cast<const std::byte*>(data), length}, name_or(name, "bsp"), read);
        });
    });
}

#if !defined(__wasm__)

firma_code firma_level_load(const char* path, double scale, firma_level* level) {
    return guarded(__func__, [&, function = __func__] {
        return give_level(path, 1, scale, level, function,
                          [&](const ReadOptions& read) { return read_brush_level(path, read); });
    });
}

#endif

firma_code firma_world_from_level(firma_level level, const firma_world_options* options, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        const LevelObject* object = find<LevelObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        WorldOptions chosen;
        ReadOptions unused;
        if (const firma_code code = read_options(options, chosen, unused, function)) return code;
        Result<World> made = make_on_threads(object->level, chosen);
        if (!made) return fail(made.error());
        return give(std::make_unique<WorldObject>(std::move(made.value())), world, function);
    });
}

firma_code firma_level_get_view(firma_level level, firma_level_view* view) {
    return guarded(__func__, [&, function = __func__] {
        if (!view) return bad_call(function, kNull);
        if (!sized(view)) return bad_call(function, kWrongSize);
        const LevelObject* object = find<LevelObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        put_sized({0, object->entities.data(), object->entities.size(), object->notes.data(), object->notes.size(),
                   object->omissions.data(), object->omissions.size(), object->level.metres_a_unit,
                   object->anchors.data(), object->anchors.size()},
                  view);
        return FIRMA_OK;
    });
}

firma_code firma_level_release(firma_level level) {
    return release<LevelObject>(level.id, __func__);
}
