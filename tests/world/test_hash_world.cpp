// SPDX-License-Identifier: MIT
// The hash of a world: the same for the same edits, another for any other world.
#include <gtest/gtest.h>

#include <set>

#include "base/hasher.h"
#include "firma/world.h"
#include "scenes/room_grid.h"
#include "tests/tree/edited_tree.h"

namespace firma {
namespace {

World edited_world(int craters, std::uint64_t seed) {
    EditedTree edited(face_set_of(scenes::room_grid({2, 1, 1})));
    scenes::Rng rng(seed);
    for (int k = 0; k < craters; ++k) {
        const double x = rng.uniform(0, 18);
        edited.crater({x, 4, 1}, 1.2, 4, rng);
    }
    return edited.world();
}

TEST(HashWorld, EqualEditsEqualHash) {
    EXPECT_EQ(hash_world(edited_world(12, 1)), hash_world(edited_world(12, 1)));
    EXPECT_NE(hash_world(edited_world(12, 1)), hash_world(edited_world(11, 1)));
    EXPECT_NE(hash_world(edited_world(12, 1)), hash_world(edited_world(12, 2)));
    EXPECT_EQ(hash_world(World()), hash_world(World()));
}

/// The same for every compiler and its options. No file is read and no function of libm but sqrt and floor is called.
TEST(HashWorld, SameOnEveryMachine) {
    const std::uint64_t hash = hash_world(edited_world(12, 1));
    EXPECT_EQ(hash, 16132653582724770532ull);
}

/// A copy of a one-block world with something changed.
template <class Change>
std::uint64_t changed(const Change& change) {
    EditedTree edited(FaceSet{});
    edited.edit({}, 0, bowl({0, 0, 0}, 1, 2, {0, 0, 1}));
    const Block& sound = *edited.tree;
    Ref<Block> block(new Block);
    block->bins = sound.bins;
    block->faces = sound.faces;
    block->vertices = sound.vertices;
    block->corner_vertices = sound.corner_vertices;
    auto data = std::make_shared<WorldData>(edited.world().data());
    change(*block, *data);
    Ref<Room> room(new Room);
    room->tree = Ref<const Block>(block.get());
    data->rooms[0] = Ref<const Room>(room.get());
    return hash_world(World(std::move(data)));
}

struct Owner : FaceOwner {
    explicit Owner(std::uint64_t number) : number_(number) {}
    void add_to(Hasher& hasher) const override { hasher.add(number_); }
    std::size_t bytes() const override { return sizeof *this; }
    std::uint64_t number_;
};

TEST(HashWorld, EverythingCounts) {
    std::set<std::uint64_t> hashes;
    int count = 0;
    const auto differs = [&](auto&& change) {
        EXPECT_TRUE(hashes.insert(changed(change)).second) << "change " << count;
        ++count;
    };
    differs([](Block&, WorldData&) {});
    differs([](Block&, WorldData& d) { ++d.version; });
    differs([](Block&, WorldData& d) { ++d.next_face; });
    differs([](Block&, WorldData& d) { ++d.face_count; });
    differs([](Block&, WorldData& d) { d.tolerance.skin = 0.002; });
    differs([](Block&, WorldData& d) { d.rooms.emplace_back(new Room); });
    differs([](Block&, WorldData& d) {
        d.materials = std::make_shared<std::vector<std::string>>(1, "stone that is long enough");
    });
    differs([](Block&, WorldData& d) {
        d.materials = std::make_shared<std::vector<std::string>>(1, "stone that is long enouhg");
    });
    differs([](Block& b, WorldData&) { b.bins[0].box.high[2] = 7; });
    differs([](Block& b, WorldData&) { b.bins[0].first ^= 1; });
    differs([](Block& b, WorldData&) { b.vertices[3].z ^= 1; });
    differs([](Block& b, WorldData&) { std::swap(b.vertices[0], b.vertices[1]); });
    differs([](Block& b, WorldData&) { std::swap(b.corner_vertices[0], b.corner_vertices[1]); });
    differs([](Block& b, WorldData&) { ++b.faces[2].id.value; });
    differs([](Block& b, WorldData&) { ++b.faces[2].source; });
    differs([](Block& b, WorldData&) { ++b.faces[2].edit; });
    differs([](Block& b, WorldData&) { ++b.faces[2].material; });
    differs([](Block& b, WorldData&) { ++b.faces[2].mask; });
    differs([](Block& b, WorldData&) { b.faces[2].two_sided = true; });
    differs([](Block& b, WorldData&) { b.faces[2].solid = true; });
    for (const std::uint64_t number : {5, 6})
        differs([&](Block& b, WorldData&) {
            b.owners.emplace_back(new Owner(number));
            b.faces[1].owner = 0;
        });
}

TEST(Hasher, ShortStreamsDoNotCollide) {
    std::set<std::uint64_t> values{Hasher().value()};
    for (std::uint32_t a = 0; a < 200; ++a) {
        Hasher one;
        one.add(a);
        EXPECT_TRUE(values.insert(one.value()).second);
        for (std::uint32_t b = 0; b < 200; ++b) {
            Hasher two = one;
            two.add(b);
            EXPECT_TRUE(values.insert(two.value()).second);
        }
    }
}

}  // namespace
}  // namespace firma
