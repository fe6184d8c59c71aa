// SPDX-License-Identifier: MIT
// Entities of brush levels as parts that move: their solids, and how they go by time. docs/moving.md says which keys
// count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/export.h"
#include "firma/part_path.h"
#include "firma/result.h"
#include "firma/world.h"

namespace firma {

/// A part that an entity makes.
struct BrushPart {
    std::uint32_t entity = 0;  ///< index into BrushLevel::entities
    World world;               ///< its solid, and what else casts meet of it, in its frame
    PartPath path;             ///< where that frame is, by time
    WhenBlocked when_blocked = WhenBlocked::kStops;
    /// Set off by touch, use or trigger: `path` is of the time since then. Else `path` is of the level's time.
    bool waits_for_trigger = false;
    bool breaks = false;  ///< to be destroyed: func_breakable, func_explosive (break_parts.h)
    /// Of one that breaks, by its author's measure: 100 where he gives none. 0: a trigger alone breaks it, as it has a
    /// targetname, or he says so.
    double health = 0;
    double damage = 0;     ///< of the explosion that it makes when it breaks, likewise; 0: none
    std::string matter{};  ///< that its author names: keys `type`, `material`; "": that of its textures
};

/// What became of the level's entities.
struct BrushParts {
    std::vector<BrushPart> parts;   ///< by entity
    std::vector<EntityNote> notes;  ///< entities that make no part, or not what their author meant, and why; by entity
};

/// Makes a part of each entity that moves and has brushes. Brushes of one entity are joined as the level's are
/// (make_world()); those that joining leaves out are noted. In the part's frame lies the entity's origin, as its
/// `origin` or a brush of texture `origin` gives it, else the level's.
///
/// @param options  of each part's world; their work is left out
/// @return kInvalid and kTooLarge as make_world(); what is wrong with one entity alone is a note
/// Costs what joining all these brushes costs.
[[nodiscard]] FIRMA_EXPORT Result<BrushParts> make_brush_parts(const BrushLevel& level,
                                                               const WorldOptions& options = {});

}  // namespace firma
