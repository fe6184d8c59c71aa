// SPDX-License-Identifier: MIT
// What chunks are made of: how much of each matter, and masses by their densities; against closed forms and points.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/level.h"
#include "firma/matter.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/sample.h"
#include "tests/world/matter_levels.h"

namespace firma {
namespace {

/// What stands free does not hold by itself; what is painted so does.
World held_by(const World& world, const std::string& material) {
    AnchorRules rules;
    rules.hanging = false;
    rules.materials = {material};
    return with_anchors(world, rules);
}

CarveOptions asking(double density = 0) {
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = 0, .density = density};
    return options;
}

/// The one piece that a box cuts loose.
Chunk cut_loose(const World& world, const Vec3& low, const Vec3& high, const CarveOptions& options = asking()) {
    const CarveResult cut = carve(world, test::box_mesh(low, high).cutter().value(), {}, options);
    EXPECT_TRUE(cut.done()) << cut.error.reason;
    EXPECT_EQ(cut.chunks.size(), 1u);
    return cut.chunks.empty() ? Chunk{} : cut.chunks[0];
}

struct BoxOf {
    Vec3 low, high;
    double density;
};

/// By the formulas for boxes and Steiner's; `origin` is where the chunk's frame lay.
MassProperties closed_form(const std::vector<BoxOf>& boxes, const Vec3& origin) {
    MassProperties all;
    Vec3 first;
    for (const BoxOf& box : boxes) {
        const Vec3 size = box.high - box.low;
        const double volume = size.x * size.y * size.z;
        all.volume += volume;
        all.mass += box.density * volume;
        first = first + (box.low + box.high) * (0.5 * box.density * volume);
    }
    const Vec3 centre = first * (1 / all.mass);
    all.centre = centre - origin;
    for (const BoxOf& box : boxes) {
        const Vec3 size = box.high - box.low, arm = (box.low + box.high) * 0.5 - centre;
        const double mass = box.density * size.x * size.y * size.z;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double own = i == j ? (dot(size, size) - size[i] * size[i]) / 12 + dot(arm, arm) : 0;
                all.inertia[std::size_t(i)][j] += mass * (own - arm[i] * arm[j]);
            }
    }
    return all;
}

void expect_mass(const MassProperties& mass, const MassProperties& expected) {
    constexpr double kClose = 1e-12;
    EXPECT_NEAR(mass.volume, expected.volume, kClose * expected.volume);
    EXPECT_NEAR(mass.mass, expected.mass, kClose * expected.mass);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(mass.centre[i], expected.centre[i], kClose * std::cbrt(expected.volume));
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(mass.inertia[std::size_t(i)][j], expected.inertia[std::size_t(i)][j],
                        kClose * expected.inertia[0].x)
                << i << " " << j;
    }
}

struct NamedVolume {
    std::string name;
    double volume;
};

void expect_volumes(const World& world, const Chunk& chunk, const std::vector<NamedVolume>& expected) {
    ASSERT_EQ(chunk.matters.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(matter(world, chunk.matters[k].matter).name, expected[k].name);
        EXPECT_NEAR(chunk.matters[k].volume, expected[k].volume, 1e-12 * chunk.mass.volume) << expected[k].name;
    }
}

TEST(ChunkMatters, WoodAndSteelEqualClosedForms) {
    const World world = held_by(test::brush_world(test::three_matters()), "old_brick");
    const Chunk chunk = cut_loose(world, {3, -1, -1}, {5.25, 5, 5});
    expect_volumes(world, chunk, {{"wood", 2.75 * 16}, {"steel", 4 * 16}});
    const std::vector<BoxOf> boxes{{{5.25, 0, 0}, {8, 4, 4}, 600}, {{8, 0, 0}, {12, 4, 4}, 7850}};
    expect_mass(chunk.mass, closed_form(boxes, chunk.origin));
    EXPECT_GT(chunk.mass.centre.x, 1) << "steel is heavier";
}

/// How many faces show each material, by the names of a world.
std::map<std::string, int> shown_by(const World& names, const Solid& solid) {
    std::map<std::string, int> count;
    for (const Face& face : make_world(solid).value().faces()) ++count[names.material_name(face.material)];
    return count;
}

TEST(ChunkMatters, TheWorldNamesTheInsidesThatChunksShow) {
    // The cut goes through brick and wood; the wall that stays shows brick, the piece that falls wood.
    const World world = held_by(test::brush_world(test::three_matters()), "old_brick");
    const Cutter blade = test::box_mesh({3, -1, -1}, {5.25, 5, 5}).cutter().value();
    const CarveResult cut = carve(world, blade, {}, asking());
    ASSERT_TRUE(cut.done()) << cut.error.reason;
    ASSERT_EQ(cut.chunks.size(), 1u);
    std::map<std::string, int> shown = shown_by(cut.world, cut.chunks[0].solid);
    EXPECT_EQ(shown["matter/wood"], 1);
    EXPECT_EQ(shown["matter/brick"], 0);
    EXPECT_EQ(shown[""], 0) << "a number without a name";
    EXPECT_EQ(shown_by(cut.world, cut.world.solid())["matter/brick"], 1);
    test::expect_sound_world(cut.world);
    // A crumb is no chunk, and changes no name.
    CarveOptions large = asking();
    large.chunks->min_volume = 1e6;
    const CarveResult crumbled = carve(world, blade, {}, large);
    EXPECT_TRUE(crumbled.chunks.empty());
    EXPECT_EQ(hash_world(crumbled.world), hash_world(cut.world));
}

TEST(ChunkMatters, ADensityThatIsGivenIsThatOfAll) {
    const World world = held_by(test::brush_world(test::three_matters()), "old_brick");
    const Chunk chunk = cut_loose(world, {3, -1, -1}, {5, 5, 5}, asking(1000));
    expect_volumes(world, chunk, {{"wood", 48}, {"steel", 64}});
    expect_mass(chunk.mass, closed_form({{{5, 0, 0}, {12, 4, 4}, 1000}}, chunk.origin));
}

TEST(ChunkMatters, OfOneMatterNothingIsCut) {
    const World world = held_by(test::brush_world(test::three_matters()), "old_brick");
    const Chunk chunk = cut_loose(world, {3, -1, -1}, {9, 5, 5});
    expect_volumes(world, chunk, {{"steel", 48}});
    EXPECT_EQ(chunk.mass.mass, 48 * 7850.0);
}

TEST(ChunkMatters, AWorldThatSaysNothingIsOfTheFirstMatter) {
    const std::string map = map_text::box({0, 0, 0}, {4, 4, 4}, "base") + map_text::box({4, 0, 0}, {8, 4, 4}, "plain");
    const World world = held_by(test::brush_world(map), "base");
    const Chunk chunk = cut_loose(world, {3, -1, -1}, {5, 5, 5});
    expect_volumes(world, chunk, {{"", 48}});
    EXPECT_EQ(chunk.mass.mass, 48 * 2400.0);
}

TEST(ChunkMatters, InOverlapsTheLowerNumberWinsAndWhatIsProtectedBefore) {
    const std::string map = map_text::box({-8, 0, 0}, {-4, 4, 4}, "base") +
                            map_text::box({-4, 0, 0}, {0, 4, 4}, "old_brick") +
                            map_text::box({0, 0, 0}, {4, 4, 4}, "wood") + map_text::box({2, 1, 0}, {8, 3, 6}, "steel");
    const World soft = held_by(test::brush_world(map), "base");
    const Chunk chunk = cut_loose(soft, {-5, -1, -1}, {-1, 5, 5});
    const double shared = 2 * 2 * 4;
    expect_volumes(soft, chunk, {{"brick", 16}, {"wood", 64}, {"steel", 6 * 2 * 6 - shared}});
    const std::vector<BoxOf> boxes{{{-1, 0, 0}, {0, 4, 4}, 1900},
                                   {{0, 0, 0}, {4, 4, 4}, 600},
                                   {{4, 1, 0}, {8, 3, 6}, 7850},
                                   {{2, 1, 4}, {4, 3, 6}, 7850}};
    expect_mass(chunk.mass, closed_form(boxes, chunk.origin));

    WorldOptions options;
    options.matters = default_matters();
    options.matters->matters[*matter_named(*options.matters, "steel")].hardness = 1;
    const World hard = held_by(test::brush_world(map, options), "base");
    expect_volumes(hard, cut_loose(hard, {-5, -1, -1}, {-1, 5, 5}),
                   {{"brick", 16}, {"wood", 64 - shared}, {"steel", 6 * 2 * 6}});
}

TEST(ChunkMatters, OfPiecesOfOneMatterInARowAndAgain) {
    // Two of wood, one of steel that overlaps the second, wood again, a fill at the end.
    const std::string map = map_text::box({-4, 0, 0}, {0, 4, 4}, "old_brick") +
                            map_text::box({0, 0, 0}, {2, 4, 4}, "wood") + map_text::box({2, 0, 0}, {5, 4, 4}, "wood") +
                            map_text::box({4, 0, 0}, {8, 2, 4}, "steel") + map_text::box({4, 2, 0}, {8, 4, 4}, "wood");
    const World before = held_by(test::brush_world(map), "old_brick");
    const CarveResult filled = fill(before, test::box_mesh({7, 1, 1}, {10, 3, 2}).cutter().value(), {});
    ASSERT_TRUE(filled.done()) << filled.error.reason;
    const Chunk chunk = cut_loose(filled.world, {-1, -1, -1}, {1, 5, 5});
    expect_volumes(filled.world, chunk, {{"", 2 * 2}, {"wood", 4 * 16 + 3 * 2 * 4}, {"steel", 3 * 2 * 4}});
    const std::vector<BoxOf> boxes{{{8, 1, 1}, {10, 3, 2}, 2400},
                                   {{1, 0, 0}, {5, 4, 4}, 600},
                                   {{5, 2, 0}, {8, 4, 4}, 600},
                                   {{5, 0, 0}, {8, 2, 4}, 7850}};
    expect_mass(chunk.mass, closed_form(boxes, chunk.origin));
}

TEST(ChunkMatters, WhatWasFilledInIsOfTheRest) {
    const World before = held_by(test::brush_world(test::three_matters()), "old_brick");
    const CarveResult filled = fill(before, test::box_mesh({11, 1, 1}, {14, 2, 2}).cutter().value(), {});
    ASSERT_TRUE(filled.done()) << filled.error.reason;
    const Chunk chunk = cut_loose(filled.world, {3, -1, -1}, {5, 5, 5});
    expect_volumes(filled.world, chunk, {{"", 2}, {"wood", 48}, {"steel", 64}});
}

/// Closed meshes side by side, each of one texture.
World mesh_world(const std::vector<std::pair<BoxOf, std::string>>& boxes) {
    std::string text;
    int first = 1;
    for (const auto& [box, material] : boxes) {
        text += "usemtl " + material + "\n";
        const test::TriangleMesh mesh = test::box_mesh(box.low, box.high);
        for (const Vec3& v : mesh.vertices)
            text += "v " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        for (const auto& [a, b, c] : mesh.triangles)
            text += "f " + std::to_string(first + int(a)) + " " + std::to_string(first + int(b)) + " " +
                    std::to_string(first + int(c)) + "\n";
        first += int(mesh.vertices.size());
    }
    return make_world(read_obj(text, "boxes.obj").value()).value();
}

TEST(ChunkMatters, OfClosedMeshes) {
    // A bar joins them: what of it lies in a mesh is of that, the rest of none.
    const World apart = held_by(mesh_world({{{{0, 0, 0}, {4, 4, 4}, 0}, "old_brick"},
                                            {{{5, 0, 0}, {8, 4, 4}, 0}, "wood"},
                                            {{{10, 0, 0}, {12, 4, 4}, 0}, "steel"}}),
                                "old_brick");
    ASSERT_EQ(matter(apart, matter_at(apart, {6, 1, 1})).name, "wood");
    const CarveResult filled = fill(apart, test::box_mesh({3, 1, 1}, {11, 2, 2}).cutter().value(), {});
    ASSERT_TRUE(filled.done()) << filled.error.reason;
    const Chunk chunk = cut_loose(filled.world, {2, 0.5, 0.5}, {4.5, 3, 3});
    expect_volumes(filled.world, chunk, {{"", 0.5 + 2}, {"wood", 48}, {"steel", 32}});
    const std::vector<BoxOf> boxes{{{4.5, 1, 1}, {5, 2, 2}, 2400},
                                   {{8, 1, 1}, {10, 2, 2}, 2400},
                                   {{5, 0, 0}, {8, 4, 4}, 600},
                                   {{10, 0, 0}, {12, 4, 4}, 7850}};
    expect_mass(chunk.mass, closed_form(boxes, chunk.origin));

    // All of a chunk in one of them, another one's box around it: a frame of steel beside wood.
    const CarveResult halved =
        carve(filled.world, test::box_mesh({6, -1, -1}, {7, 5, 5}).cutter().value(), {}, asking());
    ASSERT_EQ(halved.chunks.size(), 1u);
    expect_volumes(filled.world, halved.chunks[0], {{"", 2}, {"wood", 16}, {"steel", 32}});
}

TEST(ChunkMatters, OfCraggyChunksOfSlopesAsPointsSayIt) {
    // Wedges of wood and steel over each other, cut out by a rocky crater.
    std::string map = map_text::box({-4, 0, 0}, {0, 4, 4}, "old_brick");
    map +=
        "{\n( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) wood 0 0 0 1 1\n( 8 0 0 ) ( 8 0 1 ) ( 8 1 0 ) wood 0 0 0 1 1\n"
        "( 0 0 0 ) ( 0 0 1 ) ( 1 0 0 ) wood 0 0 0 1 1\n( 0 4 0 ) ( 1 4 0 ) ( 0 4 1 ) wood 0 0 0 1 1\n"
        "( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) wood 0 0 0 1 1\n( 0 0 4 ) ( 0 4 4 ) ( 8 0 1 ) wood 0 0 0 1 1\n}\n";
    map += map_text::box({3, 1, -1}, {7, 3, 3}, "steel");
    const World world = held_by(test::brush_world(map), "old_brick");
    const Cutter rock = make_crater(CutterShape::kRocky, 3);
    const CarveResult cut = carve(world, rock, {.position = {0, 2, 2}, .scale = 3.8}, asking());
    ASSERT_EQ(cut.chunks.size(), 1u) << cut.error.reason;
    const Chunk& chunk = cut.chunks[0];
    ASSERT_EQ(chunk.matters.size(), 2u);
    double sum = 0, mass = 0;
    for (const MatterVolume& it : chunk.matters) {
        sum += it.volume;
        mass += it.volume * matter(world, it.matter).density;
    }
    EXPECT_NEAR(sum, chunk.mass.volume, 1e-12 * sum);
    EXPECT_NEAR(mass, chunk.mass.mass, 1e-12 * mass);
    EXPECT_EQ(chunk.mass.volume, measure_solid(chunk.solid).volume);
    // Points of its box, and the centre of mass by them.
    scenes::Rng rng(11);
    const Box box = chunk.solid.bounds();
    const Vec3 size = box.high - box.low;
    const std::size_t points = std::size_t(test::sample(60000));
    std::vector<double> found(matters_of(world).matters.size());
    Vec3 first;
    double weight = 0;
    for (std::size_t k = 0; k < points; ++k) {
        const Vec3 at{rng.uniform(box.low.x, box.high.x), rng.uniform(box.low.y, box.high.y),
                      rng.uniform(box.low.z, box.high.z)};
        if (locate(chunk.solid, at) != Where::kSolid) continue;
        const std::uint32_t of = matter_at(world, at + chunk.origin);
        found[of] += 1;
        weight += matter(world, of).density;
        first = first + at * matter(world, of).density;
    }
    const double all = size.x * size.y * size.z;
    for (const MatterVolume& it : chunk.matters) {
        const double share = it.volume / all, spread = std::sqrt(share * (1 - share) / double(points));
        EXPECT_NEAR(found[it.matter] / double(points), share, 5 * spread) << it.matter;
    }
    EXPECT_LT(length(first * (1 / weight) - chunk.mass.centre), 0.05);
}

TEST(ChunkMatters, SlicesEndInTheSameBits) {
    const World world = held_by(test::brush_world(test::three_matters()), "old_brick");
    const Cutter blade = test::box_mesh({3, -1, -1}, {5, 5, 5}).cutter().value();
    const CarveResult at_once = carve(world, blade, {}, asking());
    CarveJob job(world, blade, {}, asking());
    while (!job.run(0)) {
    }
    const CarveResult sliced = job.result();
    ASSERT_EQ(at_once.chunks.size(), 1u);
    ASSERT_EQ(sliced.chunks.size(), 1u);
    EXPECT_EQ(sliced.chunks[0].matters, at_once.chunks[0].matters);
    EXPECT_EQ(sliced.chunks[0].mass.mass, at_once.chunks[0].mass.mass);
    EXPECT_EQ(sliced.chunks[0].mass.centre, at_once.chunks[0].mass.centre);
    EXPECT_EQ(hash_world(sliced.world), hash_world(at_once.world));
}

}  // namespace
}  // namespace firma
