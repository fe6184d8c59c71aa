// SPDX-License-Identifier: MIT
// Puts brushes together into a BrushLevel: what the readers of .map and .bsp do alike.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "brush/note_list.h"
#include "brush/patch_level.h"
#include "firma/brush_level.h"

namespace firma {

/// A plane's shift from which on people are told: CARVING.md section 1.
inline constexpr double kNotableShift = 0.001;

class BrushBuilder {
public:
    BrushBuilder(std::string name, double scale);

    BrushLevel level;
    NoteList notes;

    std::uint32_t material(std::string_view name);
    /// Its index in the level's textures; those that are equal to within a float are one.
    std::uint32_t texture(const TextureProjection& projection);

    /// A side as the reader finds it.
    struct Side {
        BrushSide side;
        bool sky = false;
        bool portal = false;  ///< its texture is that of a portal
        double area = 0;      ///< of its face, in any unit
    };

    /// Adds a brush and its sides, with their masks and portals marked: those with a portal's texture; where all sides
    /// have it, the largest (of equal ones the first).
    void add(Brush brush, std::span<const Side> sides);

    /// Reckons with a plane that was moved by so many metres.
    void shift(double metres, std::string_view place);

    /// A patch to be castable; one that nothing meets is left out.
    void add_patch(PatchSurface patch);

    /// The level, with its surfaces and notes.
    Result<BrushLevel> finish(double patch_tolerance);

private:
    double scale_;
    std::vector<PatchSurface> patches_;
    std::unordered_map<std::string, std::uint32_t> material_index_, texture_index_;
};

}  // namespace firma
