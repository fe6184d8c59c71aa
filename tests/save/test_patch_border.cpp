// SPDX-License-Identifier: MIT
// apply_patch() judges what a patch exchanges, and its border. Beside it the whole world that it makes is judged: what
// that refuses must be refused by the border too, and what it takes, taken.
#include <gtest/gtest.h>

#include <string>

#include "firma/chunk.h"
#include "firma/edit_log.h"
#include "firma/rooms.h"
#include "save/apply_patch.h"
#include "tests/sample.h"
#include "tests/save/changed_patches.h"

namespace firma {
namespace {

/// What came of patches that were changed.
struct Verdicts {
    int sound = 0, unread = 0, broken_world = 0, broken_solid = 0;

    int judged() const { return sound + broken_world + broken_solid; }
};

void judge(const World& world, std::span<const std::byte> patch, const std::string& what, Verdicts& verdicts) {
    const Result<World> whole = apply_patch(world, patch, "patch", PatchChecks{.whole = true, .hash = false});
    const Result<World> border = apply_patch(world, patch, "patch", PatchChecks{.whole = false, .hash = false});
    ASSERT_EQ(whole.ok(), border.ok()) << what << ": the whole " << (whole ? "is sound" : whole.error().text())
                                       << ", the border " << (border ? "is sound" : border.error().text());
    if (whole) {
        ++verdicts.sound;
        EXPECT_EQ(hash_world(whole.value()), hash_world(border.value())) << what;
        EXPECT_EQ(hash_solid(whole.value()), hash_solid(border.value())) << what;
        EXPECT_EQ(hash_regions(whole.value()), hash_regions(border.value())) << what;
        return;
    }
    const std::string text = whole.error().text();
    if (text.find("the world is broken") != text.npos)
        ++verdicts.broken_world;
    else if (text.find("the solid is broken") != text.npos)
        ++verdicts.broken_solid;
    else
        ++verdicts.unread;
}

EditCommand crater(std::uint32_t number, const Vec3& at, double radius, CutterShape shape = CutterShape::kWedge) {
    return crater_command(number, {shape, number}, at, radius, {.material = "crater"});
}

/// A peer that lacks something, and one that does not.
struct Peers {
    const char* what;
    World from, to;
};

/// Craters in a floor, side by side: the lost one shares edges with others.
Peers floor_peers() {
    Peers peers{"floor", two_rooms(), two_rooms()};
    for (std::uint32_t k = 1; k <= 4; ++k) {
        const EditCommand command = crater(k, {1.2 + 0.4 * k, 2, 0.05}, 0.6);
        peers.to = apply(peers.to, command).world;
        if (k != 2) peers.from = apply(peers.from, command).world;
    }
    return peers;
}

/// Craters at the rim of the portal: its edges are divided, a pocket in the rock makes a room.
Peers portal_peers() {
    Peers peers{"portal", two_rooms(), two_rooms()};
    for (std::uint32_t k = 1; k <= 3; ++k) {
        const EditCommand command = crater(k, {3.7 + 0.2 * k, 1.0 * k, 0.1}, 0.5, CutterShape::kBox);
        peers.to = apply(peers.to, command).world;
        if (k == 1) peers.from = peers.to;
    }
    peers.to = apply(peers.to, crater(4, {2, 2, -3}, 0.5, CutterShape::kBox)).world;
    return peers;
}

/// Rooms that a level of one material bounds: what cuts have not touched are faces of their own.
Peers untouched_peers() {
    const World level = room_world();
    return {"untouched", apply(level, crater(1, {0, 3.9, 0}, 0.5)).world, level};
}

Peers grown_peers() {
    World from = cut_room(6, 11);
    World to = from;
    scenes::Rng rng(12);
    for (int k = 0; k < 3; ++k) cut_somewhere(to, rng, 0.7);
    return {"grown", from, to};
}

std::vector<Peers> all_peers() {
    std::vector<Peers> all{floor_peers(), portal_peers(), untouched_peers(), grown_peers()};
    const std::size_t count = all.size();
    for (std::size_t k = 0; k < count; ++k) all.push_back({all[k].what, all[k].to, all[k].from});
    return all;
}

TEST(PatchBorder, TakesSoundPatches) {
    Verdicts verdicts;
    for (const Peers& peers : all_peers()) judge(peers.from, make_patch(peers.from, peers.to), peers.what, verdicts);
    EXPECT_EQ(verdicts.sound, int(all_peers().size()));
}

TEST(PatchBorder, RefusesWhatTheWholeCheckRefuses) {
    Verdicts verdicts;
    scenes::Rng rng(1);
    for (const Peers& peers : all_peers()) {
        const std::vector<ChangedSection> sound = sections_of(make_patch(peers.from, peers.to));
        for (int k = 0; k < test::sample(1500); ++k) {
            std::vector<ChangedSection> sections = sound;
            for (std::uint64_t changes = 1 + rng.next() % 2; changes > 0; --changes) change_patch(sections, rng);
            judge(peers.from, file_of(sections), peers.what + (" " + std::to_string(k)), verdicts);
            if (HasFatalFailure()) return;
        }
    }
    RecordProperty("judged", verdicts.judged());
    EXPECT_GT(verdicts.broken_world, 100) << "mutations that readers do not see are too few";
    EXPECT_GT(verdicts.broken_solid, 100);
    EXPECT_GT(verdicts.sound, 0);
}

/// A patch that leaves faces out, or brings some that are there: it closes by itself no more.
TEST(PatchBorder, RefusesPatchesOfListsThatLie) {
    Verdicts verdicts;
    scenes::Rng rng(2);
    for (const Peers& peers : all_peers())
        for (int k = 0; k < test::sample(150); ++k) {
            const auto patch =
                make_patch(peers.to, lying_list(peers.from, peers.to, rng, std::size_t(1 + k % 4)), "list");
            ASSERT_TRUE(patch) << patch.error().text();
            judge(peers.from, patch.value(), peers.what + (" lie " + std::to_string(k)), verdicts);
            if (HasFatalFailure()) return;
        }
    EXPECT_GT(verdicts.broken_world + verdicts.broken_solid, test::sample(100));
    EXPECT_GT(verdicts.sound, test::sample(10));
}

/// Sections of two sound patches, mixed.
TEST(PatchBorder, RefusesMixedPatches) {
    Verdicts verdicts;
    scenes::Rng rng(3);
    for (const Peers& peers : all_peers()) {
        World elsewhere = peers.to;
        cut_somewhere(elsewhere, rng, 0.6);
        const auto one = sections_of(make_patch(peers.from, peers.to));
        const auto two = sections_of(make_patch(peers.from, elsewhere));
        for (int k = 0; k < test::sample(100); ++k) {
            std::vector<ChangedSection> mixed = one;
            for (ChangedSection& section : mixed)
                for (const ChangedSection& other : two)
                    if (other.type == section.type && section.type != kPatchSection && rng.next() % 6 == 0)
                        section.bytes = other.bytes;
            judge(peers.from, file_of(mixed), peers.what + (" mixed " + std::to_string(k)), verdicts);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(verdicts.sound, 0);
}

/// Pillars as a file gives them, on a grid: one more may touch one that stays along an edge, which four faces have
/// then.
World pillar_world(bool touching) {
    WorldParts parts = two_halves_parts(16);
    std::uint32_t id = 100;
    const auto add_pillar = [&](std::int32_t x, std::int32_t y) {
        const auto at = [&](int corner) {
            const auto step = std::int32_t(kSurfaceSteps);
            return GridPoint{(x + (corner & 1)) * step, (y + (corner >> 1 & 1)) * step, (5 + (corner >> 2)) * step};
        };
        constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        FaceSet& set = parts.rooms[0].faces;
        for (const auto& side : kSides) {
            set.faces.push_back(
                {.id = {id++}, .first_corner = std::uint32_t(set.corners.size()), .corner_count = 4, .solid = true});
            for (const int corner : side) {
                set.corners.push_back(std::uint32_t(set.vertices.size()));
                set.vertices.push_back(at(corner));
            }
        }
    };
    add_pillar(4, 4);
    if (touching)
        add_pillar(5, 5);
    else
        add_pillar(7, 7);
    return assemble_world(std::move(parts)).value();
}

TEST(PatchBorder, RefusesEdgesThatFacesWhichStayHave) {
    const World one = pillar_world(false), two = pillar_world(true);
    ASSERT_FALSE(check_solid(one));
    ASSERT_TRUE(check_solid(two)) << "four faces along an edge that says nothing of it";
    Verdicts verdicts;
    judge(one, make_patch(one, two), "a pillar that touches", verdicts);
    EXPECT_EQ(verdicts.broken_solid, 1);
    judge(two, make_patch(two, one), "and back", verdicts);
}

/// A level that nothing was known of before: all of it is judged.
TEST(PatchBorder, JudgesAllWhereRoomsAreOthers) {
    const World one = two_rooms(), none;
    Verdicts verdicts;
    judge(none, make_patch(none, one), "from nothing", verdicts);
    judge(one, make_patch(one, none), "to nothing", verdicts);
    EXPECT_EQ(verdicts.sound + verdicts.broken_world + verdicts.broken_solid + verdicts.unread, 2);
}

}  // namespace
}  // namespace firma
