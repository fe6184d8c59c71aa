// SPDX-License-Identifier: MIT
// Seeded closed meshes wound into the air, and shots from inside that aim at where faces meet: none may get out.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scenes/cast_families.h"

namespace firma::scenes {

enum class MeshKind : std::uint8_t {
    kBox,           ///< six rectangles
    kTriangleBox,   ///< twelve triangles
    kBipyramid,     ///< two hubs, 3 to 64 triangles around each
    kCup,           ///< a fan for its bottom, one for its lid, both dented: hubs that are not convex
    kVoxelRoom,     ///< joined cubes, unit squares
    kJitteredRoom,  ///< joined cubes, triangles, corners moved a little
    kIcosphere,     ///< 80 or 320 triangles, snapped
    kTurnedBox,     ///< a box in a whole frame, rectangles not along the axes
};
inline constexpr int kMeshKinds = 8;

struct ClosedMesh {
    MeshKind kind = MeshKind::kBox;
    std::vector<GridPolygon> faces;  ///< wound into the air: their fronts look at the inside
    std::vector<Vec3> inside;        ///< centres of balls that lie inside with certainty
    double free_radius = 0;          ///< of those balls, metres
    double size = 0;                 ///< a path of this length from inside leads outside
};

const char* name_of(MeshKind kind);

/// At the origin or up to 8 km away.
ClosedMesh make_closed_mesh(MeshKind kind, Rng& rng);

/// From inside to far outside, at a face, an edge or a corner: the way is the difference of two positions (in float or
/// double) times a power of two. A particle, or with `sphere` a ball of any size up to the free radius.
CastQuery escaping_cast(const ClosedMesh& mesh, bool sphere, Rng& rng);

}  // namespace firma::scenes
