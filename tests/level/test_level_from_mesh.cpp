// SPDX-License-Identifier: MIT
// Meshes that a program gives.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "firma/carve.h"
#include "firma/mesh.h"
#include "firma/queries.h"
#include "firma/world.h"

namespace firma {
namespace {

/// Two squares on the floor, beside each other.
struct TwoSquares {
    std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    std::vector<std::uint32_t> corners{0, 1, 4, 3, 1, 2, 5, 4}, counts{4, 4}, materials;
    std::vector<std::string> names;

    Result<World> world() const {
        Mesh mesh;
        mesh.vertices = vertices;
        mesh.corners = corners;
        mesh.corner_counts = counts;
        mesh.materials = materials;
        mesh.material_names = names;
        Result<Level> level = level_from_mesh(mesh, "squares");
        if (!level) return level.error();
        return make_world(level.value());
    }
};

std::string material_below(const World& world, double x, std::uint32_t number) {
    const Hit hit = cast(world, Ray{{x, 0.5, 1}, {0, 0, -2}});
    EXPECT_EQ(hit.material, number);
    return world.material_name(hit.material);
}

TEST(LevelFromMesh, MaterialsKeepTheirNumbers) {
    TwoSquares squares;
    squares.names = {"wall", "floor", "", "floor"};
    squares.materials = {3, 0};
    const World world = squares.world().value();
    EXPECT_EQ(material_below(world, 0.5, 3), "floor");
    EXPECT_EQ(material_below(world, 1.5, 0), "wall");
    EXPECT_EQ(world.material_name(2), "");
    EXPECT_EQ(world.material_name(4), "");  // there is none
    squares.materials = {1, 4};
    EXPECT_EQ(squares.world().error().text(), "squares: face 1: names material 4 of 4");
}

TEST(LevelFromMesh, WithoutMaterialsAllIsTheFirst) {
    TwoSquares squares;
    EXPECT_EQ(material_below(squares.world().value(), 0.5, 0), "");
    squares.names = {"wall", "floor"};
    EXPECT_EQ(material_below(squares.world().value(), 1.5, 0), "wall");
    squares.names.clear();
    squares.materials = {0, 0};
    EXPECT_EQ(squares.world().error().text(), "squares: face 0: names material 0 of 0");
}

}  // namespace
}  // namespace firma
