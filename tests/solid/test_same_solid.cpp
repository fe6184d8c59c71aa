// SPDX-License-Identifier: MIT
// Two solids are the same set of points or not, however their surfaces are divided: by hand, and against the reference.
#include "firma/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes/rng.h"
#include "solid/same_boundary.h"
#include "tests/carve/cutters.h"
#include "tests/reference/carve_oracle.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using Steps = std::vector<int>;

/// Whether two solids are the same by their faces alone, whatever their hashes say.
bool same_faces(const Solid& a, const Solid& b) {
    return same_boundary(a.data().faces.root.get(), b.data().faces.root.get());
}

void expect_same(const Solid& a, const Solid& b, bool same) {
    EXPECT_EQ(same_solid(a, b), same);
    EXPECT_EQ(same_solid(b, a), same);
    if (a.rock_outside() == b.rock_outside()) {
        EXPECT_EQ(same_faces(a, b), same);
        EXPECT_EQ(same_faces(b, a), same);
    }
    EXPECT_EQ(hash_solid(a) == hash_solid(b), same);
    const auto world = [](const Solid& solid) { return make_world(solid).value(); };
    if (a.face_count() > 0 && b.face_count() > 0 && a.rock_outside() == b.rock_outside()) {
        EXPECT_EQ(reference::same_solid(world(a), world(b)), same);
        EXPECT_EQ(same_solid(world(a), world(b)), same);
    }
}

Solid sound(const Level& level) {
    const Result<Solid> solid = make_solid(level);
    EXPECT_TRUE(solid) << solid.error().text();
    EXPECT_EQ(solid.value().face_count(), level.faces.size()) << "left out";
    EXPECT_FALSE(check_solid(solid.value()));
    return solid.value();
}

/// Input steps to metres, sheared where asked for: slopes in every plane, no corner off the grid.
struct Shape {
    bool sheared = false;

    Vec3 operator()(const Steps& p) const {
        const double x = p[0], y = p[1], z = p[2];
        const Vec3 steps = sheared ? Vec3{7 * x + 3 * y - z, 5 * y + 2 * z - x, 11 * z + y + 2 * x} : Vec3{x, y, z};
        return steps * (1 / kInputSteps);
    }
};

/// A box of which all edges are divided at the numbers of each axis, and each face as `style` says: 0 not at all, 1
/// into rectangles, 2 and 3 into triangles.
void add_divided_box(Level& level, const Steps (&at)[3], const Shape& shape, scenes::Rng& rng) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto add = [&](const std::vector<std::pair<int, int>>& corners) {
                std::vector<Vec3> points;
                for (const auto& [i, j] : corners) {
                    Steps p(3);
                    p[axis] = upper ? at[axis].back() : at[axis].front();
                    p[u] = at[u][i];
                    p[v] = at[v][j];
                    points.push_back(shape(p));
                }
                if (!upper) std::reverse(points.begin(), points.end());
                test::add_polygon(level, points);
            };
            const int columns = int(at[u].size()) - 1, rows = int(at[v].size()) - 1;
            const std::uint32_t style = rng.below(4);
            if (style == 0) {
                std::vector<std::pair<int, int>> rim;
                for (int i = 0; i < columns; ++i) rim.push_back({i, 0});
                for (int j = 0; j < rows; ++j) rim.push_back({columns, j});
                for (int i = columns; i > 0; --i) rim.push_back({i, rows});
                for (int j = rows; j > 0; --j) rim.push_back({0, j});
                std::rotate(rim.begin(), rim.begin() + rng.below(std::uint32_t(rim.size())), rim.end());
                add(rim);
                continue;
            }
            for (int i = 0; i < columns; ++i)
                for (int j = 0; j < rows; ++j) {
                    if (style == 1) {
                        add({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                    } else if (style == 2) {
                        add({{i, j}, {i + 1, j}, {i + 1, j + 1}});
                        add({{i, j}, {i + 1, j + 1}, {i, j + 1}});
                    } else {
                        add({{i, j}, {i + 1, j}, {i, j + 1}});
                        add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                    }
                }
        }
}

Steps divided(int low, int high, scenes::Rng& rng) {
    Steps at = {low, high};
    for (std::uint32_t k = rng.below(4); k > 0; --k)
        at.push_back(low + 1 + int(rng.below(std::uint32_t(high - low - 1))));
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

Solid box(const Steps& low, const Steps& high, const Shape& shape, std::uint64_t seed) {
    scenes::Rng rng(seed);
    Level level = test::empty_level();
    const Steps at[3] = {divided(low[0], high[0], rng), divided(low[1], high[1], rng), divided(low[2], high[2], rng)};
    add_divided_box(level, at, shape, rng);
    return sound(level);
}

TEST(SameSolid, Nothing) {
    const Solid air, rock = solid_of({}, true, 0, 0, {}),
                     block = make_solid(test::box_level({0, 0, 0}, {1, 2, 3})).value();
    const Solid hall = make_solid(test::box_level({0, 0, 0}, {1, 2, 3}, true)).value();
    ASSERT_TRUE(hall.rock_outside() && !block.rock_outside());
    expect_same(air, Solid(), true);
    expect_same(rock, solid_of({}, true, 7, 3, {}), true);
    expect_same(air, rock, false);
    expect_same(air, block, false);
    expect_same(rock, hall, false);
    expect_same(block, block, true);
    expect_same(block, hall, false);
    EXPECT_FALSE(same_faces(block, hall)) << "they look the other way";
    EXPECT_TRUE(same_solid(World(), World()));
}

TEST(SameSolid, BoxesDivided) {
    for (const bool sheared : {false, true}) {
        const Shape shape{sheared};
        const Solid plain = box({-5000, 0, 300}, {4000, 7001, 9000}, shape, 0);
        for (std::uint64_t seed = 1; seed < 25; ++seed) {
            SCOPED_TRACE(seed);
            expect_same(plain, box({-5000, 0, 300}, {4000, 7001, 9000}, shape, seed), true);
            // A grid step more or less on one side.
            Steps low = {-5000, 0, 300}, high = {4000, 7001, 9000};
            (seed % 2 ? low : high)[seed % 3] += seed % 4 < 2 ? 1 : -1;
            expect_same(plain, box(low, high, shape, seed), false);
        }
    }
}

/// Two boxes in opposite quarters around a line: they touch along an edge, and in two planes there is a face of each,
/// back to back.
Solid quarters(bool turned, const Shape& shape, std::uint64_t seed) {
    scenes::Rng rng(seed);
    Level level = test::empty_level();
    // The edge where they touch is divided alike.
    const Steps along = divided(0, 3000, rng);
    for (const bool second : {false, true}) {
        const bool right = second, up = second != turned;
        const Steps at[3] = {divided(right ? 0 : -2000, right ? 2000 : 0, rng),
                             divided(up ? 0 : -1000, up ? 1000 : 0, rng), along};
        add_divided_box(level, at, shape, rng);
    }
    return sound(level);
}

TEST(SameSolid, EdgesWhereSolidsTouch) {
    for (const bool sheared : {false, true})
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const Shape shape{sheared};
            const Solid one = quarters(false, shape, seed);
            expect_same(one, quarters(false, shape, seed + 100), true);
            expect_same(one, quarters(true, shape, seed + 100), false);
        }
}

/// A plate stands on a block. The plate's foot is an edge of the plate, but none of what is left of the block's top.
TEST(SameSolid, Fins) {
    const Solid block = box({0, 0, 0}, {40960, 40960, 20480}, {}, 1);
    const auto fin = [](double depth) { return test::box_mesh({2, 3, 5 - depth}, {8, 3.25, 9}).cutter().value(); };
    const auto with = [&](const Solid& solid, const Cutter& cutter) {
        const SolidResult result = unite(solid, cutter, {});
        EXPECT_TRUE(result.done()) << result.error.text();
        EXPECT_EQ(result.report.retries, 0);
        return result.solid;
    };
    const Solid finned = with(block, fin(1));
    EXPECT_FALSE(check_solid(finned));
    expect_same(finned, with(block, fin(2)), true);
    expect_same(finned, with(box({0, 0, 0}, {40960, 40960, 20480}, {}, 2), fin(1)), true);
    expect_same(finned, block, false);
    expect_same(finned, with(block, test::box_mesh({2, 3, 4}, {8, 3.25 + 1 / kInputSteps, 9}).cutter().value()), false);
    // By hand: the top divided around the plate.
    scenes::Rng rng(3);
    Level level = test::empty_level();
    const int x[4] = {0, 8192, 32768, 40960}, y[4] = {0, 12288, 13312, 40960};
    const auto quad = [&](const Steps& a, const Steps& b, const Steps& c, const Steps& d) {
        test::add_polygon(level, {Shape()(a), Shape()(b), Shape()(c), Shape()(d)});
    };
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int z = i == 1 && j == 1 ? 36864 : 20480;
            quad({x[i], y[j], z}, {x[i + 1], y[j], z}, {x[i + 1], y[j + 1], z}, {x[i], y[j + 1], z});
            quad({x[i], y[j], 0}, {x[i], y[j + 1], 0}, {x[i + 1], y[j + 1], 0}, {x[i + 1], y[j], 0});
        }
    for (int i = 0; i < 3; ++i) {
        quad({x[i], 0, 0}, {x[i + 1], 0, 0}, {x[i + 1], 0, 20480}, {x[i], 0, 20480});
        quad({x[i + 1], 40960, 0}, {x[i], 40960, 0}, {x[i], 40960, 20480}, {x[i + 1], 40960, 20480});
        quad({0, y[i + 1], 0}, {0, y[i], 0}, {0, y[i], 20480}, {0, y[i + 1], 20480});
        quad({40960, y[i], 0}, {40960, y[i + 1], 0}, {40960, y[i + 1], 20480}, {40960, y[i], 20480});
    }
    quad({x[1], y[1], 20480}, {x[2], y[1], 20480}, {x[2], y[1], 36864}, {x[1], y[1], 36864});
    quad({x[2], y[2], 20480}, {x[1], y[2], 20480}, {x[1], y[2], 36864}, {x[2], y[2], 36864});
    quad({x[1], y[2], 20480}, {x[1], y[1], 20480}, {x[1], y[1], 36864}, {x[1], y[2], 36864});
    quad({x[2], y[1], 20480}, {x[2], y[2], 20480}, {x[2], y[2], 36864}, {x[2], y[1], 36864});
    expect_same(finned, sound(level), true);
}

struct Cut {
    CutterShape shape;
    std::uint64_t seed;
    Pose pose;
};

World after(World world, const std::vector<Cut>& cuts) {
    for (const Cut& cut : cuts) {
        const CarveResult result = carve(world, make_crater(cut.shape, cut.seed), cut.pose);
        EXPECT_TRUE(result.done()) << result.error.text();
        world = result.world;
    }
    return world;
}

Pose random_pose(scenes::Rng& rng, const Vec3& position) {
    Pose pose;
    pose.position = position + Vec3{rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)};
    pose.rotation = random_turn(rng.next());
    pose.scale = rng.uniform(0.6, 1);
    return pose;
}

World block_world(std::uint64_t seed) {
    scenes::Rng rng(seed);
    Level level = test::empty_level();
    const Steps at[3] = {divided(-16384, 16384, rng), divided(-16384, 16384, rng), divided(-8192, 8192, rng)};
    add_divided_box(level, at, {}, rng);
    return make_world(level).value();
}

/// General slopes, vertices where planes meet, in worlds that share nothing and whose faces are divided differently.
TEST(SameSolid, CutsInAnyOrder) {
    for (std::uint64_t seed = 0; seed < std::uint64_t(test::sample(10)); ++seed) {
        SCOPED_TRACE(seed);
        scenes::Rng rng(seed);
        std::vector<Cut> cuts;
        for (const Vec3& place : {Vec3{-2, -2, 2}, {2, -2, 2}, {-2, 2, 2}, {2, 2, 2}, {4, 0, 0}, {0, 0, -2}})
            cuts.push_back(
                {rng.chance(0.5) ? CutterShape::kRocky : CutterShape::kSpiky, rng.next(), random_pose(rng, place)});
        for (Cut& cut : cuts)
            if (cut.shape == CutterShape::kSpiky) cut.pose.scale *= 0.5;
        const World one = after(block_world(seed), cuts);
        std::vector<Cut> other_order = {cuts[3], cuts[5], cuts[0], cuts[4], cuts[2], cuts[1]};
        const World two = after(block_world(seed + 50), other_order);
        expect_same(one.solid(), two.solid(), true);
        expect_same(one.solid(), after(block_world(seed), cuts).solid(), true);
        other_order.pop_back();
        expect_same(one.solid(), after(block_world(seed + 50), other_order).solid(), false);
        // The same but for a grid step of one cutter.
        cuts[seed % 6].pose.position.x += 1 / kInputSteps;
        expect_same(one.solid(), after(block_world(seed), cuts).solid(), false);
    }
}

/// Stored faces whose loops start elsewhere: no two faces are equal corner by corner.
TEST(SameSolid, LoopsThatStartElsewhere) {
    const World block = make_world(test::box_level({-4, -4, -4}, {4, 4, 4})).value();
    scenes::Rng rng(1);
    const World pits = after(block, {{CutterShape::kRocky, 1, random_pose(rng, {1, 1, 4})},
                                     {CutterShape::kRocky, 2, random_pose(rng, {-1, -2, 4})}});
    test::Parts parts(pits);
    for (const Ref<SolidFace>& face : parts.faces) {
        std::uint32_t first = 0;
        for (const std::uint32_t end : face->loop_ends()) {
            std::rotate(face->uses.begin() + first, face->uses.begin() + first + 1, face->uses.begin() + end);
            first = end;
        }
        face->set_hash();
    }
    const World shifted = parts.world();
    expect_same(pits.solid(), shifted.solid(), true);
    // One corner replaced by a point next to it: faces around it no longer close, but that is not asked.
    test::Parts broken(pits);
    SolidFace& face = broken.with_holes(true);
    face.uses.erase(face.uses.end() - 1);
    std::vector<std::uint32_t> ends(face.loop_ends().begin(), face.loop_ends().end());
    --ends.back();
    face.set_loop_ends(ends);
    face.set_hash();
    EXPECT_FALSE(same_faces(pits.solid(), broken.world().solid()));
}

/// Versions of one world share blocks, and faces whose facets lie in several.
TEST(SameSolid, VersionsOfOneWorld) {
    const World block = make_world(test::box_level({-30, -30, -30}, {30, 30, 30})).value();
    scenes::Rng rng(5);
    std::vector<World> versions = {block};
    for (int k = 0; k < 40; ++k) {
        const Cut cut{CutterShape::kRocky, std::uint64_t(k),
                      random_pose(rng, {rng.uniform(-28, 28), rng.uniform(-28, 28), 30})};
        const CarveResult result = carve(versions.back(), make_crater(cut.shape, cut.seed), cut.pose);
        if (result.done()) versions.push_back(result.world);
    }
    for (std::size_t k = 1; k < versions.size(); ++k) {
        EXPECT_TRUE(same_solid(versions[k], versions[k]));
        EXPECT_FALSE(same_solid(versions[k], versions[k - 1]));
        EXPECT_FALSE(same_faces(versions[k].solid(), versions[k - 1].solid()));
        EXPECT_FALSE(same_faces(versions[k].solid(), versions[0].solid()));
    }
    // Other blocks, the same faces.
    const World rebuilt = rebuild_index(versions.back(), {});
    EXPECT_TRUE(same_solid(versions.back(), rebuilt));
    EXPECT_TRUE(same_faces(versions.back().solid(), rebuilt.solid()));
}

TEST(SameSolid, RoomsAndMaterialsDoNotCount) {
    Level level = test::box_level({-4, -4, -4}, {4, 4, 4});
    const World plain = make_world(level).value();
    for (LevelFace& face : level.faces) face.material = 1;
    std::reverse(level.faces.begin(), level.faces.end());
    test::add_polygon(level, {{10, 0, 0}, {11, 0, 0}, {11, 1, 0}});
    const World other = make_world(level).value();
    EXPECT_TRUE(same_solid(plain, other)) << "a face more that is castable only";
    EXPECT_NE(hash_world(plain), hash_world(other));
}

/// What a cutter took, put back.
TEST(SameSolid, CarveThenFill) {
    const World block = block_world(1);
    scenes::Rng rng(2);
    int compared = 0;
    for (int k = 0; k < test::sample(20); ++k) {
        const Cutter cutter = make_crater(CutterShape::kRocky, std::uint64_t(k));
        const Pose pose = random_pose(rng, {rng.uniform(-2, 2), rng.uniform(-2, 2), k % 2 ? 0.0 : 2.0});
        const CarveResult pit = carve(block, cutter, pose);
        if (!pit.done()) continue;
        EXPECT_FALSE(same_solid(block, pit.world));
        const CarveResult back = fill(pit.world, cutter, pose);
        if (!back.done() || back.report.retries != 0) continue;
        ++compared;
        // The cutter reaches out of the block at the top: there more is filled than was there.
        expect_same(block.solid(), back.world.solid(), k % 2 == 1);
        const CarveResult again = carve(back.world, cutter, pose);
        if (!again.done() || again.report.retries != 0) continue;
        expect_same(pit.world.solid(), again.world.solid(), true);
    }
    RecordProperty("compared", compared);
}

}  // namespace
}  // namespace firma
