// SPDX-License-Identifier: MIT
// What every reader promises of a level of brushes, for fuzzers: stops the program where it does not hold.
#pragma once

#include "firma/brush_level.h"
#include "geometry/exact_plane.h"
#include "tests/fuzz/expect_sound_level.h"

namespace firma::fuzz {

inline void expect_sound(const BrushLevel& level) {
    expect(!level.entities.empty(), "there is a world");
    expect(!level.materials.empty() && level.materials[0].empty(), "a name of none");
    std::size_t next = 0;
    for (const Brush& brush : level.brushes) {
        expect(brush.first_side == next, "sides lie brush by brush");
        next += brush.side_count;
        expect(next <= level.sides.size(), "sides in range");
        expect(brush.entity < level.entities.size(), "entities in range");
        expect(brush.side_count >= 4 || brush.kind == BrushKind::kData, "fewer than four sides enclose nothing");
        std::size_t portals = 0;
        for (std::size_t k = brush.first_side; k < next; ++k) portals += level.sides[k].portal;
        expect((portals > 0) == (brush.kind == BrushKind::kPortal), "portals have portal sides, and nothing else has");
    }
    expect(next == level.sides.size(), "every side is a brush's");
    for (const BrushSide& side : level.sides) {
        for (const GridPoint& point : side.points) expect(on_input_grid(point), "points on the input grid");
        const Plane plane = plane_through(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2]));
        expect(plane.valid(), "points not in line");
        expect(side.material < level.materials.size(), "materials in range");
        expect(side.texture == kNoTexture || side.texture < level.textures.size(), "textures in range");
    }
    for (const TextureProjection& lies : level.textures) expect(is_usable(lies), "projections that can be used");
    for (const std::string& note : level.notes) expect(note.size() < 400, "notes are short");
    expect(level.notes.size() <= 257, "notes are few");
    expect(level.max_shift >= 0 && level.max_shift < 1e9, "a shift is a length");
    for (const LevelFace& face : level.surfaces.faces) {
        expect(face.source >= level.sides.size(), "sources of surfaces count on from the sides");
        expect(face.mask != 0, "surfaces are met by something");
    }
    expect_sound(level.surfaces);
}

inline void expect_sound_error(const Error& error, const char* name) {
    expect(error.place.starts_with(name), "errors have a place");
    expect(error.text().size() < 400, "errors are short");
}

}  // namespace firma::fuzz
