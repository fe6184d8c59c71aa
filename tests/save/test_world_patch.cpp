// SPDX-License-Identifier: MIT
// Patches: what differs between two worlds makes one of the other, to the bit; peers who lost edits are repaired;
// hostile bytes never harm a world.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "firma/chunk.h"
#include "firma/edit_log.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/world_patch.h"
#include "save/patch_sections.h"
#include "scenes/rng.h"
#include "solid/solid_face.h"
#include "tests/carve/cutters.h"
#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

/// Two halls of 64 m: many regions.
World large_halls() {
    return assemble_world(two_halves_parts(64)).value();
}

/// Craters on the floor, the walls, the ceiling and around the portal, in clusters that overlap.
EditCommand some_crater(std::uint32_t number, scenes::Rng& rng) {
    constexpr CutterShape kShapes[] = {CutterShape::kRocky, CutterShape::kRocky, CutterShape::kDrill,
                                       CutterShape::kWedge, CutterShape::kBox};
    Vec3 at{rng.uniform(0, 128), rng.uniform(0, 64), rng.uniform(0, 64)};
    if (rng.next() % 2 == 0) at = {64 + rng.uniform(-6, 6), rng.uniform(0, 4), rng.uniform(0, 20)};
    at[int(rng.next() % 2) + 1] = rng.next() % 2 ? 0 : 64;
    const std::uint64_t seed = rng.next();
    return crater_command(number, {kShapes[seed % 5], seed}, at, rng.uniform(0.5, 2.5),
                          {number % 10 == 0 ? "stone" + std::to_string(number) : "crater"});
}

std::vector<EditCommand> some_commands(std::uint32_t count, std::uint64_t seed) {
    scenes::Rng rng(seed);
    std::vector<EditCommand> commands;
    for (std::uint32_t k = 1; k <= count; ++k) commands.push_back(some_crater(k, rng));
    return commands;
}

void expect_same(const World& one, const World& two) {
    EXPECT_EQ(hash_world(one), hash_world(two));
    EXPECT_EQ(hash_solid(one), hash_solid(two));
    EXPECT_EQ(hash_regions(one), hash_regions(two));
    EXPECT_TRUE(same_solid(one, two));
    EXPECT_FALSE(check_world(one));
    EXPECT_FALSE(check_solid(one));
    // Edits go on alike.
    scenes::Rng rng(77);
    World a = one, b = two;
    for (std::uint32_t k = 1; k <= 10; ++k) {
        const EditCommand command = some_crater(1000 + k, rng);
        a = apply(a, command).world;
        b = apply(b, command).world;
        ASSERT_EQ(hash_world(a), hash_world(b));
    }
}

TEST(WorldPatch, MakesOneWorldOfAnother) {
    const World level = large_halls();
    World world = level;
    for (const EditCommand& command : some_commands(60, 1)) world = apply(world, command).world;
    const std::vector<std::byte> patch = make_patch(level, world);
    const Result<World> made = apply_patch(level, patch, "patch");
    ASSERT_TRUE(made) << made.error().text();
    expect_same(made.value(), world);
    // And back.
    const Result<World> back = apply_patch(world, make_patch(world, level), "patch");
    ASSERT_TRUE(back) << back.error().text();
    expect_same(back.value(), level);
    // From a version in between, on the way from the sound peer and from the one that was made by a patch.
    World later = world;
    scenes::Rng rng(2);
    for (std::uint32_t k = 61; k <= 80; ++k) later = apply(later, some_crater(k, rng)).world;
    const std::vector<std::byte> more = make_patch(world, later);
    EXPECT_LT(more.size(), patch.size());
    for (const World& from : {world, made.value()}) {
        const Result<World> next = apply_patch(from, more, "patch");
        ASSERT_TRUE(next) << next.error().text();
        expect_same(next.value(), later);
    }
}

TEST(WorldPatch, OfNothingIsSmall) {
    const World level = large_halls();
    const std::vector<std::byte> patch = make_patch(level, level);
    EXPECT_LT(patch.size(), 1200u);
    expect_same(apply_patch(level, patch, "patch").value(), level);
}

TEST(WorldPatch, HasDoorsAndRooms) {
    const World level = large_halls();
    const World closed = *set_portal_open(level, {0}, false);
    const Result<World> made = apply_patch(level, make_patch(level, closed), "patch");
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_FALSE(portal_info(made.value(), {0})->open);
    expect_same(made.value(), closed);
    const Result<World> opened = apply_patch(closed, make_patch(closed, level), "patch");
    ASSERT_TRUE(opened) << opened.error().text();
    expect_same(opened.value(), level);
}

/// What two peers do when their hashes differ. @return the bytes that travelled
std::size_t repair(World& broken, const World& sound) {
    // The broken peer hears the other one's hashes of regions, 28 bytes each, and answers with a list.
    const std::vector<RegionHash> heard = hash_regions(sound);
    const std::vector<Region> regions = differing_regions(hash_regions(broken), heard);
    const std::vector<std::byte> list = list_faces(broken, regions);
    const Result<std::vector<std::byte>> patch = make_patch(sound, list, "list");
    EXPECT_TRUE(patch) << patch.error().text();
    const Result<World> made = apply_patch(broken, patch.value(), "patch");
    EXPECT_TRUE(made) << made.error().text();
    broken = made.value();
    return 28 * heard.size() + list.size() + patch.value().size();
}

TEST(WorldPatch, RepairsAfterLostEdits) {
    const std::vector<EditCommand> commands = some_commands(300, 3);
    const World level = large_halls();
    for (const std::uint64_t seed : {1, 2, 3}) {
        scenes::Rng rng(seed);
        World all = level, some = level;
        std::size_t lost = 0;
        for (const EditCommand& command : commands) {
            all = apply(all, command).world;
            if (rng.next() % 100 == 0)
                ++lost;
            else
                some = apply(some, command).world;
        }
        if (lost == 0) continue;
        ASSERT_NE(hash_world(some), hash_world(all));
        repair(some, all);
        expect_same(some, all);
    }
}

TEST(WorldPatch, RepairsAgainAndAgain) {
    World all = large_halls(), some = all;
    scenes::Rng rng(5);
    for (std::uint32_t k = 1; k <= 120; ++k) {
        const EditCommand command = some_crater(k, rng);
        all = apply(all, command).world;
        if (k % 7 != 0) some = apply(some, command).world;
        if (k % 21 == 20) repair(some, all);
        if (k % 21 == 20) {
            ASSERT_EQ(hash_world(some), hash_world(all)) << k;
        }
    }
    repair(some, all);
    expect_same(some, all);
}

/// How many edges of portals are the same objects as edges of faces.
std::size_t edges_shared_with_portals(const World& world) {
    std::set<const SolidEdge*> of_faces;
    for (const FacetPlace& facet : facets_in(world.data(), differing_regions(hash_regions(world), {})))
        if (const auto* face = static_cast<const SolidFace*>(facet.block->owner_of(facet.record())))
            for (const SolidUse& use : face->uses) of_faces.insert(use.address());
    std::size_t shared = 0;
    world.data().cells.portals().for_each([&](std::uint32_t, const PortalState& state) {
        for (std::size_t k = 0; k < state.portal->all_polygons().size(); ++k)
            if (const SolidFace* face = state.portal->exact(k))
                for (const SolidUse& use : face->uses) shared += of_faces.count(use.address());
    });
    return shared;
}

/// Where craters made portals, and others that were lost changed faces around these, and no portal: portals come along,
/// as their edges are those of the faces.
TEST(WorldPatch, PortalsShareEdgesWithFacesThatCameAgain) {
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        World some = large_halls();
        const std::vector<EditCommand> commands = some_commands(40, seed);
        for (std::size_t k = 0; k < 25; ++k) some = apply(some, commands[k]).world;
        World all = some;
        for (std::size_t k = 25; k < commands.size(); ++k) {
            const World next = apply(all, commands[k]).world;
            if (hash_cells(next.data().cells) == hash_cells(all.data().cells)) all = next;
        }
        ASSERT_NE(hash_world(all), hash_world(some));
        ASSERT_EQ(hash_cells(all.data().cells), hash_cells(some.data().cells));
        repair(some, all);
        EXPECT_GT(edges_shared_with_portals(all), 0u);
        EXPECT_EQ(edges_shared_with_portals(some), edges_shared_with_portals(all)) << seed;
    }
}

TEST(WorldPatch, IsForItsWorldAlone) {
    const World level = large_halls();
    scenes::Rng rng(6);
    const World one = apply(level, some_crater(1, rng)).world;
    const std::vector<std::byte> patch = make_patch(level, one);
    const Result<World> made = apply_patch(one, patch, "patch");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().text(), "patch: the patch was made for another world");
    EXPECT_FALSE(unpack_world(patch, "patch")) << "a patch is no world";
    EXPECT_FALSE(apply_patch(level, pack_world(one), "patch")) << "a world is no patch";
    EXPECT_FALSE(make_patch(level, patch, "list")) << "a patch is no list";
}

std::vector<std::byte> small_patch(const World& level) {
    Pose pose;
    pose.position = {1, 3.9, 2};
    CarveOptions options{.material = "crater", .edit = 1};
    const World once = carve(level, make_crater(CutterShape::kWedge, 1), pose, options).world;
    return make_patch(once,
                      carve(once, make_crater(CutterShape::kWedge, 5), pose, {.material = "other", .edit = 2}).world);
}

TEST(WorldPatch, EveryFlippedByteAndTruncationIsRefused) {
    const World level = two_halves();
    Pose pose;
    pose.position = {1, 3.9, 2};
    const World once = carve(level, make_crater(CutterShape::kWedge, 1), pose, {.material = "crater", .edit = 1}).world;
    std::vector<std::byte> bytes = small_patch(level);
    const std::uint64_t before = hash_world(once);
    ASSERT_TRUE(apply_patch(once, bytes, "patch"));
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        bytes[k] ^= std::byte(0x21);
        EXPECT_FALSE(apply_patch(once, bytes, "patch"));
        bytes[k] ^= std::byte(0x21);
    }
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(apply_patch(once, std::span(bytes).first(length), "patch"));
    EXPECT_EQ(hash_world(once), before);
}

TEST(WorldPatch, EveryFlippedBitBeyondTheChecksumsIsRefusedOrHarmless) {
    const World level = two_halves();
    Pose pose;
    pose.position = {1, 3.9, 2};
    const World once = carve(level, make_crater(CutterShape::kWedge, 1), pose, {.material = "crater", .edit = 1}).world;
    const std::vector<std::byte> sound = small_patch(level);
    const std::uint64_t after = hash_world(apply_patch(once, sound, "patch").value());
    std::size_t harmless = 0;
    for (const SectionPlace& place : section_places(sound))
        for (std::size_t k = place.first; k < place.first + place.length; ++k)
            for (const unsigned flip : {1u, 0x80u}) {
                std::vector<std::byte> bytes = sound;
                bytes[k] ^= std::byte(flip);
                fix_checksums(bytes);
                const Result<World> made = apply_patch(once, bytes, "patch");
                if (!made) continue;
                ++harmless;
                // A normal's last bits, or what the reader passes over.
                EXPECT_EQ(hash_world(made.value()), after) << section_name(place.type);
                EXPECT_FALSE(check_world(made.value()));
                EXPECT_FALSE(check_solid(made.value()));
            }
    EXPECT_GT(harmless, 0u);
}

/// What holds pieces travels with a patch, and only where it differs.
TEST(WorldPatch, AnchorsTravelAndAreTakenAsHostile) {
    const World level = two_halves();
    const World once = carve(level, make_crater(CutterShape::kWedge, 1), {.position = {1, 3.9, 2}}).world;
    const World held = with_anchors(once, {.hanging = false, .materials = {}, .sources = {1, 5, 9}});
    const auto has_anchors = [](std::span<const std::byte> bytes) {
        const std::vector<SectionPlace> places = section_places(bytes);
        return std::any_of(places.begin(), places.end(),
                           [](const SectionPlace& place) { return section_name(place.type) == "HOLD"; });
    };
    EXPECT_FALSE(has_anchors(make_patch(level, once)));
    EXPECT_FALSE(
        has_anchors(make_patch(with_anchors(level, {.hanging = false, .materials = {}, .sources = {5, 1, 9}}), held)));
    const std::vector<std::byte> sound = make_patch(level, held);
    ASSERT_TRUE(has_anchors(sound));
    const Result<World> made = apply_patch(level, sound, "patch");
    ASSERT_TRUE(made) << made.error().text();
    ASSERT_TRUE(made.value().data().anchors);
    EXPECT_EQ(*made.value().data().anchors, *held.data().anchors);
    // What is held stays so where the patch says nothing of it.
    const World other = with_anchors(level, {.hanging = false, .materials = {}, .sources = {7}});
    EXPECT_EQ(apply_patch(other, make_patch(level, once), "patch").value().data().anchors, other.data().anchors);
    std::size_t refused = 0;
    for (const SectionPlace& place : section_places(sound)) {
        if (section_name(place.type) != "HOLD") continue;
        for (std::size_t k = place.first; k < place.first + place.length; ++k) {
            std::vector<std::byte> bytes = sound;
            bytes[k] ^= std::byte(0x84);
            fix_checksums(bytes);
            const Result<World> read = apply_patch(level, bytes, "patch");
            refused += !read;
            if (!read) continue;
            const std::vector<std::uint32_t>& sources = read.value().data().anchors->sources;
            EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end()));
        }
    }
    EXPECT_GT(refused, 24u) << "kinds, edits where there is none, and the order";
}

/// A world of which nothing was said comes out of one of which something was.
TEST(WorldPatch, TakesAnchorsAway) {
    const World level = two_halves();
    const World held = with_anchors(level, {.hanging = false, .materials = {}, .sources = {1, 5}});
    const std::vector<std::byte> away = make_patch(held, level);
    const Result<World> made = apply_patch(held, away, "patch");
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_FALSE(made.value().data().anchors);
    // Not both: a patch that brings some and says that there are none.
    std::vector<std::byte> both = make_patch(level, held);
    for (const SectionPlace& place : section_places(both))
        if (section_name(place.type) == "PTCH") both[place.first + 4] |= std::byte(2);
    fix_checksums(both);
    EXPECT_FALSE(apply_patch(level, both, "patch"));
}

/// A patch may leave what held in edits that it takes back: the next fill's number is lower than theirs.
TEST(WorldPatch, AnchorsStayInOrderWhereItTakesEditsBack) {
    const World level = two_halves();
    const auto fill_at = [](const World& world, double x, std::uint32_t edit) {
        CarveOptions options;
        options.edit = edit;
        return fill(world, make_crater(CutterShape::kWedge, 1), {.position = {x, 2, 2}, .scale = 0.2}, options).world;
    };
    const World before = fill_at(level, 0.6, 5), after = fill_at(with_anchors(before), 1.2, 9);
    ASSERT_EQ(after.data().anchors->edits, std::vector<std::uint32_t>{9});
    // Between worlds of which nothing was said: what the reader's says of what holds stays.
    const World mute = fill_at(before, 1.2, 9);
    ASSERT_EQ(hash_world(mute), hash_world(after));
    const Result<World> back = apply_patch(after, make_patch(mute, before), "patch");
    ASSERT_TRUE(back) << back.error().text();
    const World again = fill_at(back.value(), 3, 7);
    EXPECT_EQ(again.data().anchors->edits, (std::vector<std::uint32_t>{7, 9}));
    const Result<World> read = unpack_world(pack_world(again), "world");
    EXPECT_TRUE(read) << read.error().text();
}

TEST(WorldPatch, ListsAreTakenAsHostile) {
    const World level = two_halves();
    const std::vector<Region> everywhere = differing_regions(hash_regions(level), {});
    EXPECT_EQ(everywhere.size(), hash_regions(level).size());
    const std::vector<std::byte> sound = list_faces(level, everywhere);
    for (std::size_t length = 0; length < sound.size(); ++length)
        EXPECT_FALSE(make_patch(level, std::span(sound).first(length), "list"));
    for (const SectionPlace& place : section_places(sound))
        for (std::size_t k = place.first; k < place.first + place.length; ++k) {
            std::vector<std::byte> bytes = sound;
            bytes[k] ^= std::byte(0x80);
            fix_checksums(bytes);
            const auto patch = make_patch(level, bytes, "list");
            if (patch) {
                EXPECT_FALSE(apply_patch(level, patch.value(), "patch") &&
                             hash_world(apply_patch(level, patch.value(), "patch").value()) != hash_world(level));
            }
        }
    const std::vector<Region> outside{{-300, 0, 0}, {0, 0, 256}, {INT32_MIN, INT32_MAX, 0}};
    EXPECT_TRUE(make_patch(level, list_faces(level, outside), "list"));
}

}  // namespace
}  // namespace firma
