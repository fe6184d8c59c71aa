// SPDX-License-Identifier: MIT
// What bench_scale asks of everybody: scenes of any size, and kinds of casts. A new kind of cast is a row of kKinds, a
// shape of it a case in each adapter that has one (peer_*.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/level.h"
#include "firma/world.h"
#include "scenes/cast_families.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"

namespace firma::bench {

enum class CastShape { kRay, kSphere };

struct KindOfCast {
    const char* name;
    CastShape shape;
    scenes::CastRange range;  ///< radius and length, metres
    bool at_edges;            ///< aimed exactly at corners and middles of edges; each must hit something
};

inline constexpr KindOfCast kKinds[] = {
    {"rays, 1-2 m", CastShape::kRay, scenes::kShortRays, false},
    {"rays, 5-100 m", CastShape::kRay, scenes::kLongRays, false},
    {"rays at edges", CastShape::kRay, {0, 0, 20, 20}, true},
    {"spheres, 0.1-2 m", CastShape::kSphere, {0.4, 0.4, 0.1, 2}, false},
    {"spheres, 50 m", CastShape::kSphere, {0.4, 0.4, 50, 50}, false},
};

/// Numbers that float holds, so that everybody is asked the same.
struct FloatCast {
    float start[3], path[3], radius;
};

/// The same triangles for everybody: corners lie on Firma's input grid, which float holds within 4 km.
struct TriangleMesh {
    std::vector<float> positions;        ///< three a vertex
    std::vector<std::uint32_t> corners;  ///< three a triangle

    std::size_t triangles() const { return corners.size() / 3; }
};

/// Open ground, or a closed building of rooms.
struct ScaleScene {
    std::string name;  ///< "ground" or "rooms"
    Level level;       ///< of triangles, fronts in the air
    TriangleMesh mesh;
    scenes::Terrain ground;
    scenes::RoomGrid rooms;

    bool is_ground() const { return name == "ground"; }
};

/// @param triangles  about so many
ScaleScene ground_scene(std::size_t triangles);
ScaleScene rooms_scene_of(std::size_t triangles);

TriangleMesh mesh_of_level(const Level& level);

/// What can be carved: open ground becomes the top of a block of rock, by a few more triangles along its rim and below;
/// rooms are in endless rock as they are.
Level closed_level(const ScaleScene& scene);

/// The level with both sides of every face to be met: by that nothing of it can be carved.
Level castable_only(const Level& level);

/// Casts that start in the air.
/// @param world  of this scene: what rays at edges are aimed with
std::vector<FloatCast> casts_of(const ScaleScene& scene, const KindOfCast& kind, const World& world, std::size_t count);

}  // namespace firma::bench
