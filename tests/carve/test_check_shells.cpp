// SPDX-License-Identifier: MIT
// Shells in shells: those that bound a solid pass, those turned the wrong way are named.
#include "carve/check_shells.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/rng.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using test::box_mesh;
using test::TriangleMesh;

TriangleMesh cube(double x, double y, double z, double half, bool outward = true) {
    TriangleMesh mesh = box_mesh({x - half, y - half, z - half}, {x + half, y + half, z + half});
    if (!outward) mesh.turn_over();
    return mesh;
}

TriangleMesh all(const std::vector<TriangleMesh>& parts) {
    TriangleMesh mesh;
    for (const TriangleMesh& part : parts) mesh.add(part);
    return mesh;
}

std::optional<std::uint32_t> wrong(const TriangleMesh& mesh, const Pose& pose = {}) {
    return find_wrong_shell(place_cutter(mesh.cutter().value(), pose).value());
}

TEST(FindWrongShell, OneShell) {
    EXPECT_FALSE(wrong(cube(0, 0, 0, 1)));
    EXPECT_FALSE(wrong(test::ring_mesh(12, 8)));
}

TEST(FindWrongShell, BesideEachOther) {
    EXPECT_FALSE(wrong(all({cube(0, 0, 0, 1), cube(5, 0, 0, 1), cube(-5, 0, 0, 1)})));
    EXPECT_EQ(wrong(all({cube(0, 0, 0, 1), cube(5, 0, 0, 1), cube(-5, 0, 0, 1, false)})), 24u);
    EXPECT_EQ(wrong(all({cube(-5, 0, 0, 0.5, false), cube(0, 0, 0, 1), cube(5, 0, 0, 1)})), 0u);
}

TEST(FindWrongShell, WithinEachOther) {
    const TriangleMesh outer = cube(0, 0, 0, 9), hollow = cube(0, 0, 0, 8, false), core = cube(0, 0, 0, 7);
    for (const Pose& pose : {Pose{}, Pose{.position = {1, 2, 3}, .rotation = random_turn(4), .scale = 2.5}}) {
        EXPECT_FALSE(wrong(all({outer, hollow}), pose));
        EXPECT_FALSE(wrong(all({core, hollow, outer}), pose));
        EXPECT_FALSE(wrong(all({outer, hollow, cube(3, 3, 3, 2), cube(-3, 3, 3, 2)}), pose));
        EXPECT_FALSE(wrong(all({outer, cube(4, 4, 4, 2, false), cube(-4, 4, 4, 2, false)}), pose));
        EXPECT_EQ(wrong(all({outer, core}), pose), 12u);
        EXPECT_EQ(wrong(all({outer, hollow, cube(0, 0, 0, 5, false)}), pose), 24u);
        EXPECT_EQ(wrong(all({core, outer}), pose), 0u);
    }
}

TEST(FindWrongShell, RaysAlongEdgesAndThroughVertices) {
    // Boxes in rows, whose rays run along faces and edges of the next.
    std::vector<TriangleMesh> row;
    for (int k = 0; k < 6; ++k) row.push_back(cube(3 * k, 0, 0, 1));
    EXPECT_FALSE(wrong(all(row)));
    row.push_back(cube(9, 0, 0, 0.5, false));
    EXPECT_FALSE(wrong(all(row)));
    row.back() = cube(9, 0, 0, 0.5);
    EXPECT_EQ(wrong(all(row)), 72u);
    // The ray from the small one passes through the edge between the two triangles of the large one's side.
    EXPECT_FALSE(wrong(all({cube(0, 0, 0, 9), cube(0, 0, 1, 1, false)})));
    EXPECT_EQ(wrong(all({cube(0, 0, 0, 9), cube(0, 0, 1, 1)})), 12u);
    // From within a hollow cube, through the vertices of a ring of small ones.
    for (const double y : {-0.5, 0.0, 0.5, 1.0})
        for (const double z : {-0.5, 0.0, 0.5, 1.0}) {
            TriangleMesh mesh = all({cube(0, 0, 0, 9), cube(0, 0, 0, 8, false), cube(0, 0, 0, 1), cube(4, y, z, 0.5)});
            EXPECT_FALSE(wrong(mesh));
            mesh.add(cube(-4, y, z, 0.5, false));
            EXPECT_EQ(wrong(mesh), 48u);
        }
}

TEST(FindWrongShell, ManyAtRandom) {
    scenes::Rng rng(1);
    for (int round = 0; round < 30; ++round) {
        // A cell each, hollow or not, filled or not.
        std::vector<TriangleMesh> parts;
        for (int k = 0; k < 27; ++k) {
            const double x = 4 * (k % 3), y = 4 * (k / 3 % 3), z = 4 * (k / 9);
            parts.push_back(cube(x, y, z, rng.uniform(1.5, 1.9)));
            if (rng.chance(0.5)) continue;
            parts.push_back(cube(x, y, z, rng.uniform(1, 1.4), false));
            if (rng.chance(0.5)) parts.push_back(cube(x, y, z, rng.uniform(0.1, 0.9)));
        }
        EXPECT_FALSE(wrong(all(parts), {.rotation = random_turn(std::uint64_t(round))}));
        const std::uint32_t turned = rng.below(std::uint32_t(parts.size()));
        parts[turned].turn_over();
        EXPECT_TRUE(wrong(all(parts), {.rotation = random_turn(std::uint64_t(round))}));
    }
}

TEST(CheckCutter, SaysWhy) {
    const auto check = [](const TriangleMesh& mesh) {
        const auto error = check_cutter(place_cutter(mesh.cutter().value(), {}).value());
        return error ? error->text() : "";
    };
    EXPECT_EQ(check(cube(0, 0, 0, 1)), "");
    EXPECT_EQ(check(test::ring_mesh(12, 8)), "");
    EXPECT_EQ(check(all({cube(0, 0, 0, 2), cube(0, 0, 0, 1, false)})), "");
    EXPECT_EQ(check(all({cube(0, 0, 0, 2), cube(0, 0, 0, 1)})),
              "mesh: the shell of triangle 12 is turned the wrong way for where it lies");
    const std::string crossing = check(all({cube(0, 0, 0, 2), cube(1, 1, 1, 2)}));
    EXPECT_EQ(crossing.rfind("mesh: crosses or touches itself on the grid: triangles ", 0), 0u) << crossing;
}

}  // namespace
}  // namespace firma
