// SPDX-License-Identifier: MIT
// Diffs between versions against plain comparison of all faces.
#include "firma/versions.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "firma/level.h"
#include "scenes/room_grid.h"
#include "tests/solid/edited_tree.h"

namespace firma {
namespace {

EditedTree rooms() {
    return EditedTree(face_set_of(scenes::room_grid({2, 2, 1})));
}

/// What is in `a` but not in `b`.
std::vector<std::uint32_t> missing(const std::map<std::uint32_t, Corners>& a,
                                   const std::map<std::uint32_t, Corners>& b) {
    std::vector<std::uint32_t> ids;
    for (const auto& [id, corners] : a)
        if (const auto other = b.find(id); other == b.end() || other->second != corners) ids.push_back(id);
    return ids;
}

std::vector<std::uint32_t> ids_of(const std::vector<FaceInfo>& faces) {
    std::vector<std::uint32_t> ids;
    for (const FaceInfo& face : faces) ids.push_back(face.id.value);
    return ids;
}

std::set<Tile> tiles_of(const World& world, const std::vector<FaceInfo>& faces, double size) {
    std::set<Tile> tiles;
    for (const FaceInfo& face : faces) {
        Box box;
        const Face whole = *world.face(face.ref());
        for (const Vec3& corner : whole.corners) box.add(corner);
        for (double x = std::floor(box.low.x / size); x <= std::floor(box.high.x / size); ++x)
            for (double y = std::floor(box.low.y / size); y <= std::floor(box.high.y / size); ++y)
                for (double z = std::floor(box.low.z / size); z <= std::floor(box.high.z / size); ++z)
                    tiles.insert({std::int32_t(x), std::int32_t(y), std::int32_t(z)});
    }
    return tiles;
}

TEST(DiffWorlds, SameWorldNoDifference) {
    const EditedTree edited = rooms();
    const WorldDiff same = diff_worlds(edited.world(), edited.world(), 1);
    EXPECT_TRUE(same.empty());
    EXPECT_TRUE(same.bounds.empty());
    EXPECT_TRUE(same.tiles.empty());
    EXPECT_TRUE(diff_worlds(edited.world(), edited.world_from_scratch()).empty()) << "alike, though nothing is shared";
}

TEST(DiffWorlds, AgreesWithComparingAllFaces) {
    EditedTree edited = rooms();
    scenes::Rng rng(3);
    for (int k = 0; k < 40; ++k) {
        const EditedTree before = edited;
        const World old_world = before.world();
        const int edits = 1 + k % 3;
        for (int e = 0; e < edits; ++e) {
            Vec3 centre;
            for (int axis = 0; axis < 3; ++axis) centre[axis] = rng.uniform(-1, axis == 2 ? 6 : 19);
            edited.crater(centre, 1.2, 1 + int(rng.below(9)), rng);
        }
        const World world = edited.world();
        const WorldDiff diff = diff_worlds(old_world, world, 2);
        ASSERT_EQ(ids_of(diff.removed), missing(before.held, edited.held));
        ASSERT_EQ(ids_of(diff.added), missing(edited.held, before.held));
        Box bounds;
        for (const FaceInfo& face : diff.removed) {
            EXPECT_EQ(old_world.face(face.ref())->id, face.id);
            EXPECT_EQ(face.source, face.id.value);
            const Face whole = *old_world.face(face.ref());
            for (const Vec3& corner : whole.corners) bounds.add(corner);
        }
        for (const FaceInfo& face : diff.added) {
            const Face whole = *world.face(face.ref());
            for (const Vec3& corner : whole.corners) bounds.add(corner);
        }
        ASSERT_EQ(diff.bounds, bounds);
        std::set<Tile> tiles = tiles_of(old_world, diff.removed, 2);
        tiles.merge(tiles_of(world, diff.added, 2));
        ASSERT_EQ(diff.tiles, std::vector<Tile>(tiles.begin(), tiles.end()));
        const WorldDiff back = diff_worlds(world, old_world);
        ASSERT_EQ(ids_of(back.removed), ids_of(diff.added));
        ASSERT_EQ(ids_of(back.added), ids_of(diff.removed));
    }
}

TEST(DiffWorlds, SameIdButAnotherFaceIsAChange) {
    EditedTree one = rooms(), other = rooms();
    FaceSet set = one.faces();
    set.faces[5].material = 3;
    other.store = build_store(set, {}).store;
    const WorldDiff diff = diff_worlds(one.world(), other.world());
    ASSERT_EQ(diff.removed.size(), 1u);
    ASSERT_EQ(diff.added.size(), 1u);
    EXPECT_EQ(diff.removed[0].id, (FaceId{5}));
    EXPECT_EQ(diff.added[0].material, 3u);
}

TEST(DiffWorlds, OtherBlocksAndBinsAreNoDifference) {
    EditedTree edited = rooms();
    scenes::Rng rng(4);
    for (int k = 0; k < 10; ++k) edited.crater({rng.uniform(0, 18), rng.uniform(0, 18), 2}, 1.2, 5, rng);
    const World world = edited.world();
    for (const TreeOptions& options : {TreeOptions{}, TreeOptions{.faces_per_leaf = 1}, TreeOptions{.max_depth = 2},
                                       TreeOptions{.split = Split::kSurfaceArea}}) {
        EXPECT_TRUE(diff_worlds(world, rebuild_index(world, options), 1).empty());
        EXPECT_TRUE(diff_worlds(rebuild_index(world, options), world, 1).empty());
    }
    const World before = rooms().world();
    const WorldDiff diff = diff_worlds(before, world), other = diff_worlds(before, rebuild_index(world, {}));
    EXPECT_FALSE(diff.empty());
    EXPECT_EQ(ids_of(diff.removed), ids_of(other.removed)) << "of faces, not of blocks";
    EXPECT_EQ(ids_of(diff.added), ids_of(other.added));
}

TEST(DiffWorlds, FromAndToNothing) {
    const EditedTree edited = rooms();
    EXPECT_EQ(diff_worlds(World(), edited.world()).added.size(), edited.held.size());
    EXPECT_EQ(diff_worlds(edited.world(), World()).removed.size(), edited.held.size());
    EXPECT_TRUE(diff_worlds(World(), World()).empty());
}

/// Triangles whose boxes are cubes of 100 m, side by side.
World slanted_triangles(int count) {
    std::string text;
    for (int k = 0; k < count; ++k) {
        const std::string x = std::to_string(150 * k), beyond = std::to_string(150 * k + 100);
        text += "v " + x + " 0 0\nv " + beyond + " 0 0\nv " + x + " 100 100\nf -3 -2 -1\n";
    }
    return make_world(read_obj(text, "slanted").value()).value();
}

TEST(DiffWorlds, TilesTooSmallOrNoNumberAreNone) {
    const World world = slanted_triangles(1);
    for (const double size : {0.0, -1.0, 1e-300, 1e-9, 3e-6, 0.0624, double(INFINITY), double(NAN)}) {
        const WorldDiff diff = diff_worlds(World(), world, size);
        EXPECT_EQ(diff.added.size(), 1u);
        EXPECT_TRUE(diff.tiles.empty()) << size;
        EXPECT_FALSE(diff.too_many_tiles) << size;
    }
    const World plain = rooms().world();
    const WorldDiff least = diff_worlds(World(), plain, kMinTileSize);
    EXPECT_FALSE(least.too_many_tiles);
    const std::set<Tile> tiles = tiles_of(plain, least.added, kMinTileSize);
    EXPECT_EQ(least.tiles, std::vector<Tile>(tiles.begin(), tiles.end()));
}

TEST(DiffWorlds, TooManyTilesAreSaidSo) {
    constexpr std::size_t kOfOne = 101 * 101 * 101;
    static_assert(4 * kOfOne <= kMaxTiles && 5 * kOfOne > kMaxTiles);
    const WorldDiff four = diff_worlds(World(), slanted_triangles(4), 1);
    EXPECT_EQ(four.tiles.size(), 4 * kOfOne);
    EXPECT_FALSE(four.too_many_tiles);
    const WorldDiff five = diff_worlds(World(), slanted_triangles(5), 1);
    EXPECT_TRUE(five.tiles.empty());
    EXPECT_TRUE(five.too_many_tiles);
    EXPECT_EQ(five.added.size(), 5u);
    const WorldDiff fine = diff_worlds(slanted_triangles(1), World(), kMinTileSize);
    EXPECT_TRUE(fine.tiles.empty()) << "one face alone";
    EXPECT_TRUE(fine.too_many_tiles);
    EXPECT_FALSE(diff_worlds(World(), slanted_triangles(5), 50).too_many_tiles);
}

}  // namespace
}  // namespace firma
