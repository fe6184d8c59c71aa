// SPDX-License-Identifier: MIT
// Neighbours found through the tree are those found by comparing every edge with every other.
#include "solid/find_neighbour.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "firma/level.h"
#include "firma/queries.h"
#include "firma/world.h"
#include "scenes/closed_meshes.h"
#include "scenes/grid_polygons.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "world/world_data.h"

namespace firma {
namespace {

using Edge = std::pair<GridPoint, GridPoint>;

/// By sorting all edges: valid where one edge is used once each way.
std::vector<std::vector<FaceId>> all_neighbours(const Level& level) {
    std::map<Edge, std::vector<FaceId>> users;
    const auto edge_of = [&](const LevelFace& face, std::uint32_t c) {
        const std::uint32_t next = c + 1 < face.corner_count ? c + 1 : 0;
        return Edge(level.vertices[level.corners[face.first_corner + c]],
                    level.vertices[level.corners[face.first_corner + next]]);
    };
    for (std::uint32_t f = 0; f < level.faces.size(); ++f)
        for (std::uint32_t c = 0; c < level.faces[f].corner_count; ++c)
            users[edge_of(level.faces[f], c)].push_back({f});
    std::vector<std::vector<FaceId>> all;
    for (const LevelFace& face : level.faces) {
        auto& of_face = all.emplace_back();
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const Edge edge = edge_of(face, c);
            const auto there = users.find(edge), back = users.find({edge.second, edge.first});
            const bool once_each = there->second.size() == 1 && back != users.end() && back->second.size() == 1;
            of_face.push_back(once_each ? back->second[0] : FaceId{});
        }
    }
    return all;
}

/// @return edges with a neighbour
std::size_t compare(const Level& level) {
    std::size_t valid = 0;
    const auto expected = all_neighbours(level);
    const World world = make_world(level).value();
    for (const Face& face : world.faces()) {
        for (std::uint32_t edge = 0; edge < face.corners.size(); ++edge) {
            const FaceId neighbour = other_face(world, face.ref(), edge);
            EXPECT_EQ(neighbour, expected[face.id.value][edge]) << "face " << face.id.value;
            valid += neighbour.valid();
        }
    }
    return valid;
}

TEST(FindNeighbour, EveryEdgeOfAClosedLevelHasOne) {
    const Level level = scenes::room_grid({2, 2, 1});
    EXPECT_EQ(compare(level), level.corners.size());
}

TEST(FindNeighbour, OfClosedMeshes) {
    scenes::Rng rng(3);
    for (int kind = 0; kind < scenes::kMeshKinds; ++kind)
        EXPECT_GT(compare(scenes::level_of(scenes::make_closed_mesh(scenes::MeshKind(kind), rng).faces)), 0u);
}

TEST(FindNeighbour, OpenDoubledAndReversedEdgesHaveNone) {
    Level level = scenes::room_grid({2, 1, 1});
    scenes::Rng rng(8);
    for (int k = 0; k < 60; ++k) {
        const std::uint32_t at = rng.below(std::uint32_t(level.faces.size()));
        const std::uint32_t choice = rng.below(3);
        LevelFace& face = level.faces[at];
        if (choice == 0) {  // opened
            level.faces.erase(level.faces.begin() + at);
        } else if (choice == 1) {  // a third user
            level.faces.push_back(LevelFace(face));
        } else {  // wound the other way
            std::swap(level.corners[face.first_corner], level.corners[face.first_corner + 1]);
        }
    }
    const std::size_t valid = compare(level);
    EXPECT_GT(valid, 0u);
    EXPECT_LT(valid + 100, level.corners.size());
}

TEST(FindNeighbour, AFaceIsTheSameByRefAndInTheList) {
    const World world = make_world(scenes::room_grid({1, 1, 1})).value();
    const std::vector<Face> faces = world.faces();
    const Hit hit = cast(world, {{5, 5, 3}, 0.5}, {20, 1, 0});
    ASSERT_TRUE(hit.touched());
    EXPECT_EQ(world.face(hit.face)->corners, faces[hit.face.id.value].corners);
}

}  // namespace
}  // namespace firma
