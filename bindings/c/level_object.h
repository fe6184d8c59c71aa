// SPDX-License-Identifier: MIT
// Levels of brushes behind a handle.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/brush_level.h"
#include "firma/brush_world.h"

namespace firma::c {

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

}  // namespace firma::c
