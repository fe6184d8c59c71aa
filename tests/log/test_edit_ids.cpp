// SPDX-License-Identifier: MIT
// Ids of an edit that was given its number follow from it, whatever other edits there were.
#include <gtest/gtest.h>

#include <set>

#include "solid/face_ids.h"
#include "solid/hash_facet.h"
#include "tests/log/logged_edits.h"

namespace firma {
namespace {

/// Hashes of the facets of one edit: everything they are, ids included.
std::set<std::uint64_t> faces_of_edit(const World& world, std::uint32_t edit) {
    std::set<std::uint64_t> hashes;
    for_each_block_of(world.data(), [&](const Block& block) {
        for (const FaceRecord& face : block.faces)
            if (face.edit == edit) hashes.insert(hash_facet(block, face));
    });
    return hashes;
}

EditCommand crater(std::uint32_t number, double x, double z = 10) {
    return crater_command(number, {CutterShape::kRocky, 40 + number}, {x, 0, z}, 1.2);  // radii up to 1.44
}

TEST(EditIds, DoNotDependOnEditsThatAreLacking) {
    const World level = two_halls();
    World all = level, some = level;
    for (std::uint32_t number = 1; number <= 9; ++number) {
        const EditCommand command = crater(number, 3.0 * number);
        all = apply(all, command).world;
        if (number % 3 != 0) some = apply(some, command).world;
    }
    EXPECT_EQ(all.version(), 9u);
    EXPECT_EQ(some.version(), 6u);
    for (std::uint32_t number = 1; number <= 9; ++number) {
        const std::set<std::uint64_t> faces = faces_of_edit(all, number);
        EXPECT_GT(faces.size(), 50u);
        if (number % 3 != 0) {
            EXPECT_EQ(faces, faces_of_edit(some, number)) << number;
        }
    }
    EXPECT_FALSE(check_world(all));
    EXPECT_FALSE(check_world(some));
    EXPECT_EQ(all.solid().edits(), 9u);
    EXPECT_EQ(all.data().next_face(), level.data().next_face()) << "no id was taken from the counter";
}

TEST(EditIds, AreThoseOfTheNumber) {
    const World world = apply(two_halls(), crater(5, 9)).world;
    std::size_t numbered = 0;
    for (const Face& face : world.faces()) {
        if (face.id.value < kFirstNumberedFace) continue;
        EXPECT_EQ((face.id.value - kFirstNumberedFace) / kIdsAnEdit, 4u);
        ++numbered;
    }
    EXPECT_GT(numbered, 50u);
}

TEST(EditIds, BeyondAThousandComeFromTheCounter) {
    const World level = two_halls();
    // 300 boxes in the floor: five faces each, and pieces of the floor.
    test::TriangleMesh boxes;
    for (int k = 0; k < 300; ++k) {
        const double x = 1 + 1.5 * (k % 20), z = 1 + 1.5 * (k / 20);
        boxes.add(test::box_mesh({x, -1, z}, {x + 1, 1, z + 1}));
    }
    const World world = apply(level, cut_command(3, boxes.cutter().value(), Pose())).world;
    const std::size_t made = faces_of_edit(world, 3).size();
    ASSERT_GT(made, std::size_t(kIdsAnEdit));
    EXPECT_GT(world.data().next_face(), level.data().next_face());
    EXPECT_FALSE(check_world(world));
    EXPECT_FALSE(check_solid(world));
    const World next = apply(world, crater(4, 12, 28)).world;
    EXPECT_GT(faces_of_edit(next, 4).size(), 50u);
    EXPECT_EQ(next.data().next_face(), world.data().next_face());
    EXPECT_FALSE(check_world(next));
}

TEST(EditIds, MixWithThoseOfEditsWithoutNumbers) {
    World world = apply(two_halls(), crater(2, 5)).world;
    world = carve(world, make_crater(CutterShape::kRocky, 1), test::pose_at(12, 0, 10)).world;
    EXPECT_EQ(world.solid().edits(), 3u);
    world = apply(world, crater(7, 20)).world;
    EXPECT_EQ(world.solid().edits(), 7u);
    EXPECT_FALSE(check_world(world));
    for (const bool index : {true, false}) {
        const World read = unpack_world(pack_world(world, {.index = index}), "test").value();
        EXPECT_EQ(hash_world(read), hash_world(world));
        EXPECT_EQ(hash_world(apply(read, crater(8, 28)).world), hash_world(apply(world, crater(8, 28)).world));
    }
}

TEST(EditIds, NumbersAscendAndEnd) {
    const World world = apply(two_halls(), crater(5, 9)).world;
    for (const std::uint32_t number : {1u, 5u}) {
        const CommandResult late = apply(world, crater(number, 20));
        EXPECT_EQ(late.status, CarveStatus::kRefused);
        EXPECT_EQ(late.error.reason, "it is edit " + std::to_string(number) + ", and edit 5 was made before it");
        EXPECT_EQ(hash_world(late.world), hash_world(world));
    }
    CarveOptions options;
    options.edit = kMaxEditNumber + 1;
    const CarveResult beyond = carve(world, make_crater(CutterShape::kRocky, 1), test::pose_at(20, 0, 10), options);
    EXPECT_EQ(beyond.status, CarveStatus::kRefused);
    EXPECT_EQ(beyond.error.code, ErrorCode::kTooLarge);
    const World last = apply(world, crater(kMaxEditNumber, 20)).world;
    EXPECT_EQ(last.solid().edits(), kMaxEditNumber);
    EXPECT_FALSE(check_world(last));
    EXPECT_EQ(hash_world(unpack_world(pack_world(last), "test").value()), hash_world(last));
}

TEST(EditIds, OfAFileAreChecked) {
    const World world = apply(two_halls(), crater(5, 9)).world;
    auto data = std::make_shared<WorldData>(world.data());
    auto solid = std::make_shared<SolidData>(world.solid().data());
    solid->edits = 4;
    data->solid = Solid(std::move(solid));
    const World early{std::move(data)};
    ASSERT_TRUE(check_world(early));
    EXPECT_EQ(check_world(early)->what, "a face's id is not below the next one");
    EXPECT_FALSE(unpack_world(pack_world(early), "test"));
}

}  // namespace
}  // namespace firma
