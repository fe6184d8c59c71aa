// SPDX-License-Identifier: MIT
// What every reader promises of a level, for fuzzers: stops the program where it does not hold.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "firma/level.h"
#include "firma/polygon.h"

namespace firma::fuzz {

inline void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

inline void expect_sound(const Level& level) {
    expect(!level.materials.empty() && !level.groups.empty(), "names of none");
    std::vector<Vec3> corners;
    std::uint32_t last_source = 0;
    for (const LevelFace& face : level.faces) {
        expect(face.corner_count >= 3 && face.corner_count <= 64, "3 to 64 corners");
        expect(std::size_t(face.first_corner) + face.corner_count <= level.corners.size(), "corners in range");
        corners.clear();
        for (std::uint32_t k = face.first_corner; k < face.first_corner + face.corner_count; ++k) {
            expect(level.corners[k] < level.vertices.size(), "vertices in range");
            corners.push_back(to_metres(level.vertices[level.corners[k]]));
        }
        expect(check_polygon(corners) == PolygonFault::kNone, "convex, planar and with area");
        expect(face.source < level.source_faces, "sources in range");
        expect(face.source >= last_source, "sources in order");
        expect(face.material < level.materials.size() && face.group < level.groups.size(), "names in range");
        expect(face.texture == kNoTexture || face.texture < level.textures.size(), "textures in range");
        last_source = face.source;
    }
    for (const TextureProjection& lies : level.textures) expect(is_usable(lies), "projections that can be used");
    for (const LevelNote& note : level.notes) expect(note.source < level.source_faces, "sources of notes in range");
}

__extension__ using Wide = __int128;

/// The sum over all faces of normals twice the area long: zero for a closed surface.
inline std::array<Wide, 3> area_vector(const Level& level) {
    std::array<Wide, 3> sum{};
    for (const LevelFace& face : level.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const auto corner = [&](std::uint32_t n) {
                return level.vertices[level.corners[face.first_corner + n % face.corner_count]];
            };
            const GridPoint a = corner(k), b = corner(k + 1);
            for (int axis = 0; axis < 3; ++axis) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                sum[std::size_t(axis)] += Wide(a[u]) * b[v] - Wide(a[v]) * b[u];
            }
        }
    return sum;
}

}  // namespace firma::fuzz
