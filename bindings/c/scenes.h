// SPDX-License-Identifier: MIT
// Levels with their parts, as a caller has them.
#pragma once

#include <span>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/break_parts.h"
#include "firma/brush_parts.h"
#include "firma/moving_parts.h"

namespace firma::c {

/// What a level gives a part besides its solid: its world is left out.
struct LevelPart {
    BrushPart brush;
    Breakable breakable;
    bool bears = true;                   ///< `breakable` is what it bears
    std::vector<firma_part_stop> stops;  ///< of its path, as the view shows them
};

struct PartsObject final : Object {
    static constexpr Kind kKind = Kind::kParts;
    static constexpr const char* kNoun = "list of parts";
    std::vector<MovingPart> parts;
    /// What a level gave them; shorter than `parts`, or empty, where none did.
    std::vector<LevelPart> given;
    std::vector<EntityNote> notes;
};

/// One part of a list, and what a level gave it.
struct PartThere {
    PartsObject* object = nullptr;
    MovingPart* part = nullptr;
    const LevelPart* given = nullptr;  ///< null where none did

    firma_code find_part(firma_parts parts, std::uint32_t index, const char* function);
};

/// A path as a caller has it.
firma_code read_path(const firma_part_path* given, PartPath& path, const char* function);
firma_motion motion_told(const RigidMotion& from);
RigidMotion motion_of(const firma_motion& from);
std::vector<firma_part_stop> stops_told(const PartPath& path);
/// @param stops  of it, kept by the caller
firma_part_path path_told(const PartPath& from, const std::vector<firma_part_stop>& stops);

/// What a firma_scene names. Views: good as long as its handles are held.
struct SceneThere {
    const World* world = nullptr;
    std::span<const MovingPart> parts{};
    double from = 0, to = 1;

    firma_code read(const firma_scene* given, const char* function);
    Scene scene() const { return {*world, parts, from, to}; }
    /// Whether its stretch is one.
    bool has_stretch() const { return from >= 0 && from <= to && to <= 1; }
};

}  // namespace firma::c
