// SPDX-License-Identifier: MIT
// Levels of brushes: their entities, and worlds of them.
#include <memory>
#include <string>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/make_on_threads.h"
#include "bindings/c/objects.h"
#include "firma/brush_world.h"

namespace firma::c {
namespace {

struct LevelObject final : Object {
    static constexpr Kind kKind = Kind::kLevel;
    static constexpr const char* kNoun = "level";
    BrushLevel level;
    // What the view shows.
    std::vector<firma_entity> entities;
    std::vector<std::vector<const char*>> keys, values;
    std::vector<const char*> notes;
    std::vector<firma_omission> omissions;
    std::vector<firma_box> anchors;

    explicit LevelObject(BrushLevel from) : level(std::move(from)) {
        keys.resize(level.entities.size());
        values.resize(level.entities.size());
        entities.reserve(level.entities.size());
        for (std::size_t k = 0; k < level.entities.size(); ++k) add(level.entities[k], keys[k], values[k]);
        for (const std::string& note : level.notes) notes.push_back(note.c_str());
        for (const auto* list : {&level.omissions, &level.surfaces.omissions})
            for (const Omission& one : *list) omissions.push_back({one.what.c_str(), one.first.c_str(), one.count});
        for (const Box& volume : anchor_volumes(level)) {
            firma_box& box = anchors.emplace_back();
            put(volume.low, box.low);
            put(volume.high, box.high);
        }
    }

private:
    void add(const Entity& entity, std::vector<const char*>& of_keys, std::vector<const char*>& of_values) {
        firma_entity& out = entities.emplace_back();
        out.classname = "";
        for (const auto& [key, value] : entity.keys) {
            if (key == "classname" && !*out.classname) out.classname = value.c_str();
            of_keys.push_back(key.c_str());
            of_values.push_back(value.c_str());
        }
        out.keys = of_keys.data();
        out.values = of_values.data();
        out.key_count = of_keys.size();
        out.line = entity.line;
        if (const std::optional<Vec3> origin = entity_origin(level, entity)) {
            put(*origin, out.origin);
            out.has_origin = 1;
        }
    }
};

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
