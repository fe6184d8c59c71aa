// SPDX-License-Identifier: MIT
// The hash of a world: the same for the same edits, another for any other world.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/hasher.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/world.h"
#include "scenes/room_grid.h"
#include "solid/append_faces.h"
#include "solid/hash_facet.h"
#include "tests/solid/edited_tree.h"
#include "tests/world/two_halves.h"

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
    EXPECT_EQ(hash, 16880447857065109092ull);
}

/// What a world is made of, in plain lists: two rooms of triangles, some of them marked as solid, and two portals.
struct Parts {
    FaceSet solid, castable;
    StoredWorld rest;  ///< all but the faces

    Parts() {
        std::uint32_t id = 0;
        for (const Corners& corners : bowl({0, 0, 0}, 1, 2, {0, 0, 1})) {
            FaceSet& set = id % 3 == 0 ? castable : solid;
            append(set, {id}, corners);
            set.faces.back().part = id % 2;
            set.faces.back().solid = id % 3 != 0;
            ++id;
        }
        rest.records.resize(3);
        for (std::uint32_t k = 0; k < 3; ++k) rest.records[k].merged_into = k;
        rest.records[0].name = "hall";
        rest.records[1].name = "cellar";
        for (const std::int32_t x : {0, 4096}) {
            PortalPart portal;
            portal.rooms = {RoomId{0}, RoomId{1}};
            for (const std::int32_t y : {0, 4096})
                portal.polygons.push_back({{x, y, 0}, {x, y + 4096, 0}, {x, y + 4096, 4096}, {x, y, 4096}});
            portal.name = "door";
            rest.portals.push_back(portal);
        }
        rest.known = true;
        rest.next_face = id;
        rest.materials = std::make_shared<std::vector<std::string>>(1);
    }
    World world(const TreeOptions& options = {}) const {
        StoredWorld stored = rest;
        stored.solid = build_store(solid, options);
        stored.castable = build_store(castable, options);
        stored.tree_options = options;
        return world_of(std::move(stored));
    }
};

template <class Change>
World changed(const Change& change) {
    Parts parts;
    change(parts);
    return parts.world();
}

struct Owner : FaceOwner {
    explicit Owner(std::uint64_t number) { hash = number; }
    std::size_t bytes() const override { return sizeof *this; }
};

/// Moves a face from one set to another.
void move_face(FaceSet& from, std::size_t at, FaceSet& to) {
    append_face(from, from.faces[at], to);
    from.faces.erase(from.faces.begin() + std::ptrdiff_t(at));
}

TEST(HashWorld, EverythingCounts) {
    std::set<std::uint64_t> hashes;
    int count = 0;
    const auto differs = [&](auto&& change) {
        EXPECT_TRUE(hashes.insert(hash_world(changed(change))).second) << "change " << count;
        ++count;
    };
    differs([](Parts&) {});
    // Counters, rules of the world as a whole.
    differs([](Parts& p) { ++p.rest.version; });
    differs([](Parts& p) { p.rest.version += std::uint64_t(1) << 40; });
    differs([](Parts& p) { ++p.rest.next_face; });
    differs([](Parts& p) { ++p.rest.edits; });
    differs([](Parts& p) { p.rest.rock_outside = true; });
    differs([](Parts& p) { p.rest.known = false; });
    differs([](Parts& p) { p.rest.tolerance.contact_offset = 0.002; });
    for (const std::vector<std::string>& names : {std::vector<std::string>{""},
                                                  {"", ""},
                                                  {"a"},
                                                  {"", "a"},
                                                  {"a", ""},
                                                  {"ab", "c"},
                                                  {"a", "bc"},
                                                  {"stone that is long enough"},
                                                  {"stone that is long enouhg"}}) {
        if (names != std::vector<std::string>{""})
            differs([&](Parts& p) { p.rest.materials = std::make_shared<std::vector<std::string>>(names); });
    }
    // Rooms.
    differs([](Parts& p) { p.rest.records.pop_back(); });
    differs([](Parts& p) {
        p.rest.records.emplace_back();
        p.rest.records[3].merged_into = 3;
    });
    differs([](Parts& p) { p.rest.records[0].name = "hell"; });
    differs([](Parts& p) { std::swap(p.rest.records[0].name, p.rest.records[1].name); });
    differs([](Parts& p) { p.rest.records[2].name = "a room whose name is long enough"; });
    differs([](Parts& p) { p.rest.records[1].exterior = true; });
    differs([](Parts& p) { p.rest.records[2].exterior = true; });
    differs([](Parts& p) { p.rest.records[2].merged_into = 0; });
    differs([](Parts& p) { p.rest.records[2].merged_into = 1; });
    // Portals.
    differs([](Parts& p) { p.rest.portals.pop_back(); });
    differs([](Parts& p) { p.rest.portals.push_back(p.rest.portals[1]); });
    differs([](Parts& p) { p.rest.portals[0].rooms[1] = {2}; });
    differs([](Parts& p) { p.rest.portals[1].rooms[1] = {2}; });
    differs([](Parts& p) { std::swap(p.rest.portals[0].rooms[0], p.rest.portals[0].rooms[1]); });
    differs([](Parts& p) { p.rest.portals[0].name = "gate"; });
    differs([](Parts& p) { p.rest.portals[1].name = "gate"; });
    differs([](Parts& p) { p.rest.portals[0].material = 1; });
    differs([](Parts& p) { p.rest.portals[0].mask ^= 1; });
    differs([](Parts& p) { p.rest.portals[0].open = false; });
    differs([](Parts& p) { p.rest.portals[1].open = false; });
    differs([](Parts& p) { p.rest.portals[0].open = p.rest.portals[1].open = false; });
    differs([](Parts& p) { p.rest.portals[0].polygons.pop_back(); });
    differs([](Parts& p) { p.rest.portals[0].polygons.clear(); });
    differs([](Parts& p) { std::swap(p.rest.portals[0].polygons[0], p.rest.portals[0].polygons[1]); });
    for (int axis = 0; axis < 3; ++axis) differs([&](Parts& p) { p.rest.portals[0].polygons[1][2][axis] ^= 1; });
    differs([](Parts& p) { std::swap(p.rest.portals[0].polygons[1][0], p.rest.portals[0].polygons[1][2]); });
    // Faces, of both kinds.
    for (FaceSet Parts::* const set : {&Parts::solid, &Parts::castable}) {
        const auto face = [&](Parts& p, std::size_t k) -> FaceSet::Entry& { return (p.*set).faces[k]; };
        for (int axis = 0; axis < 3; ++axis) {
            differs([&](Parts& p) { (p.*set).vertices[3][axis] += kSurfacePerInput; });
            differs([&](Parts& p) { (p.*set).vertices[3][axis] ^= 1 << 30; });
        }
        differs([&](Parts& p) { std::swap((p.*set).corners[0], (p.*set).corners[1]); });
        differs([&](Parts& p) {
            std::rotate((p.*set).corners.begin(), (p.*set).corners.begin() + 1, (p.*set).corners.begin() + 3);
        });
        differs([&](Parts& p) { (p.*set).faces.pop_back(); });
        differs([&](Parts& p) { append_face(p.*set, face(p, 0), p.*set); });
        differs([&](Parts& p) { face(p, 2).id.value += 1000; });
        differs([&](Parts& p) { std::swap(face(p, 2).id, face(p, 3).id); });
        differs([&](Parts& p) { ++face(p, 2).source; });
        differs([&](Parts& p) { std::swap(face(p, 2).source, face(p, 3).source); });
        differs([&](Parts& p) { ++face(p, 2).edit; });
        differs([&](Parts& p) { ++face(p, 2).material; });
        differs([&](Parts& p) { ++face(p, 2).mask; });
        differs([&](Parts& p) { face(p, 2).two_sided = true; });
        differs([&](Parts& p) {
            FaceSet& other = &(p.*set) == &p.solid ? p.castable : p.solid;
            move_face(p.*set, 2, other);
            other.faces.back().solid ^= true;
        });
        differs([&](Parts& p) { face(p, 2).part ^= 1; });
        differs([&](Parts& p) { face(p, 2).part = 2; });
        differs([&](Parts& p) { std::swap(face(p, 2).part, face(p, 3).part); });
    }
    // The exact face that a facet is of.
    for (const std::uint64_t number : {5, 6})
        for (const std::size_t at : {0u, 1u})
            differs([&](Parts& p) {
                p.castable.owners.emplace_back(new Owner(number));
                p.castable.faces[at].owner = p.castable.owners[0].get();
            });
    EXPECT_GT(count, 80);
}

TEST(HashWorld, OrderBlocksBinsAndTreeOptionsDoNotCount) {
    const World world = Parts().world();
    const std::uint64_t hash = hash_world(world);
    const std::vector<RegionHash> regions = hash_regions(world);
    Parts turned;
    std::reverse(turned.solid.faces.begin(), turned.solid.faces.end());
    std::reverse(turned.castable.faces.begin(), turned.castable.faces.end());
    EXPECT_EQ(hash_world(turned.world()), hash);
    for (const TreeOptions& options : {TreeOptions{}, TreeOptions{.faces_per_leaf = 1}, TreeOptions{.max_depth = 0},
                                       TreeOptions{.min_node_volume = 1}, TreeOptions{.split = Split::kSurfaceArea}}) {
        for (const World& other : {Parts().world(options), rebuild_index(world, options)}) {
            EXPECT_EQ(hash_world(other), hash);
            EXPECT_EQ(hash_solid(other), hash_solid(world));
            EXPECT_EQ(hash_regions(other), regions);
            for (std::uint32_t room = 0; room < 3; ++room)
                EXPECT_EQ(hash_room(other, {room}), hash_room(world, {room}));
        }
    }
    EXPECT_EQ(hash_room(world, {3}), 0u);
}

TEST(HashWorld, OfEditedStoresIsThatOfStoresFromScratch) {
    EditedTree edited(face_set_of(scenes::room_grid({2, 1, 1})));
    scenes::Rng rng(7);
    for (int k = 0; k < 60; ++k) {
        edited.crater({rng.uniform(0, 18), 4, 1}, 1.2, 1 + int(rng.below(6)), rng);
        ASSERT_EQ(hash_world(edited.world()), hash_world(edited.world_from_scratch()));
        ASSERT_EQ(hash_regions(edited.world()), hash_regions(edited.world_from_scratch()));
        ASSERT_EQ(hash_world(rebuild_index(edited.world(), {.faces_per_leaf = 2})), hash_world(edited.world()));
    }
}

TEST(HashWorld, OneRoomsHashFollowsThatRoomAlone) {
    const World plain = Parts().world();
    const auto differing = [&](auto&& change) {
        const World other = changed(change);
        std::set<std::uint32_t> rooms;
        for (std::uint32_t room = 0; room < 3; ++room)
            if (hash_room(plain, {room}) != hash_room(other, {room})) rooms.insert(room);
        return rooms;
    };
    using Rooms = std::set<std::uint32_t>;
    EXPECT_EQ(differing([](Parts&) {}), Rooms{});
    EXPECT_EQ(differing([](Parts& p) { ++p.rest.version; }), Rooms{});
    EXPECT_EQ(differing([](Parts& p) { p.rest.portals[0].open = false; }), Rooms{});
    EXPECT_EQ(differing([](Parts& p) { p.rest.records[2].name = "x"; }), (Rooms{2}));
    EXPECT_EQ(differing([](Parts& p) { p.rest.records[1].exterior = true; }), (Rooms{1}));
    EXPECT_EQ(differing([](Parts& p) { p.solid.faces[2].material = 1; }), (Rooms{Parts().solid.faces[2].part}));
    EXPECT_EQ(differing([](Parts& p) { p.castable.faces[1].mask = 1; }), (Rooms{Parts().castable.faces[1].part}));
    EXPECT_EQ(differing([](Parts& p) { p.castable.faces[1].part = 2; }), (Rooms{Parts().castable.faces[1].part, 2}));
    std::set<std::uint64_t> empty;
    const World rooms = changed([](Parts& p) {
        p.rest.records[0].name = p.rest.records[1].name = "";
        p.solid = p.castable = {};
    });
    for (std::uint32_t room = 0; room < 3; ++room) empty.insert(hash_room(rooms, {room}));
    EXPECT_EQ(empty.size(), 3u) << "the number counts";
}

/// Sums taken anew: all facets out of their blocks into sets, rooms and portals as they are now.
World taken_anew(const World& world) {
    const WorldData& data = world.data();
    StoredWorld stored;
    const auto anew = [&](const FaceStore& store) {
        FaceSet set;
        if (store.root) append_all_faces(*store.root, set);
        return build_store(set, {});
    };
    stored.solid = anew(data.solid.data().faces);
    stored.castable = anew(data.castable);
    for (std::uint32_t room = 0; room < data.cells.room_count(); ++room) {
        stored.records.push_back(data.cells.room(room));
        stored.records.back().portals.clear();
    }
    for (std::uint32_t portal = 0; portal < data.cells.portal_count(); ++portal) {
        stored.portals.push_back(data.cells.portal(portal).part());
        stored.portals.back().rooms = data.cells.rooms_of(data.cells.portal(portal));
        stored.portals.back().open = !data.cells.is_closed(portal);
    }
    stored.known = data.cells.known();
    stored.rock_outside = data.rock_outside();
    stored.next_face = data.next_face();
    stored.edits = data.edits();
    stored.version = data.version;
    stored.materials = data.materials;
    stored.tolerance = data.tolerance;
    return world_of(std::move(stored));
}

/// A term of hash_facet() for each facet, by hand.
std::uint64_t sum_of_facets(const World& world) {
    std::uint64_t sum = 0;
    for_each_block_of(world.data(), [&](const Block& block) {
        for (const FaceRecord& face : block.faces) sum += hash_facet(block, face);
    });
    return sum;
}

void expect_hashes_taken_anew(const World& world) {
    const World anew = taken_anew(world);
    ASSERT_EQ(hash_world(world), hash_world(anew));
    ASSERT_EQ(hash_solid(world), hash_solid(anew));
    ASSERT_EQ(hash_regions(world), hash_regions(anew));
    std::uint64_t of_rooms = 0, of_regions = 0;
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        ASSERT_EQ(hash_room(world, {room}), hash_room(anew, {room})) << room;
        of_rooms += world.data().faces_of(room).hash;
    }
    for (const RegionHash& region : hash_regions(world)) of_regions += region.faces;
    ASSERT_EQ(of_rooms, sum_of_facets(world));
    ASSERT_EQ(of_regions, sum_of_facets(world));
    const auto fault = check_world(world);
    ASSERT_FALSE(fault) << fault->what;
}

TEST(HashWorld, KeptByCutsItIsThatTakenAnew) {
    scenes::Rng rng(11);
    for (int round = 0; round < 4; ++round) {
        World world = round % 2 ? make_world(scenes::room_grid({2, 2, 1})).value() : two_halves(round == 0);
        const Box bounds = world.bounds();
        std::set<std::uint64_t> hashes{hash_world(world)};
        int done = 0;
        for (int k = 0; k < 40; ++k) {
            Pose pose{.scale = rng.uniform(0.3, 0.9)};
            for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
            if (round % 2 == 0 && k < 20) pose.position.x = k % 2;  // the rooms stay apart for a while
            const Cutter cutter = make_crater(k % 3 ? CutterShape::kRocky : CutterShape::kWedge, rng.next());
            const CarveOptions options{.material = k % 7 == 0 ? "stuff " + std::to_string(k) : ""};
            const CarveResult cut =
                k % 5 == 4 ? fill(world, cutter, pose, options) : carve(world, cutter, pose, options);
            world = cut.world;
            if (world.data().cells.portal_count() && k % 6 == 5)
                world = *set_portal_open(world, {0}, !portal_info(world, {0})->open);
            if (cut.done()) {
                EXPECT_TRUE(hashes.insert(hash_world(world)).second);
            }
            done += cut.done();
            expect_hashes_taken_anew(world);
            if (HasFatalFailure()) return;
        }
        EXPECT_GT(done, 20);
    }
}

TEST(HashWorld, ADoorWhoseRoomsWereJoinedStaysAsItIs) {
    WorldParts parts = two_halves_parts();
    parts.options.rules.merge_share = 1e-9;
    World world = assemble_world(std::move(parts)).value();
    world = carve(world, make_crater(CutterShape::kRocky, 1), {.position = {4, 0, 2}}).world;
    ASSERT_TRUE(portal_info(world, {0})->polygons == 0);
    const World same = *set_portal_open(world, {0}, false);
    EXPECT_TRUE(portal_info(same, {0})->open);
    EXPECT_EQ(hash_world(same), hash_world(world));
    EXPECT_EQ(same.version(), world.version());
}

TEST(HashWorld, RegionsThatDifferAreThoseOfTheEdit) {
    const World world = make_world(scenes::room_grid({8, 8, 1})).value();
    const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, 1), {.position = {4, 4, 0}});
    ASSERT_TRUE(cut.done());
    const std::vector<RegionHash> before = hash_regions(world), after = hash_regions(cut.world);
    EXPECT_GT(before.size(), 4u);
    for (const RegionHash& region : after) {
        const bool near = region.region.x <= 0 && region.region.y <= 0;
        const bool same = std::find(before.begin(), before.end(), region) != before.end();
        EXPECT_TRUE(same || near) << region.region.x << " " << region.region.y << " " << region.region.z;
    }
    EXPECT_NE(before, after);
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
