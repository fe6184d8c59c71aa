// SPDX-License-Identifier: MIT
// Parts that break: by damage, by blasts, by cuts; what their pieces are, what a cut leaves held, doors that open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "firma/break_parts.h"
#include "firma/part_edits.h"
#include "firma/rooms.h"
#include "firma/support.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/moving/part_worlds.h"

namespace firma {
namespace {

struct Game {
    World level = test::ground();
    Bodies bodies;
    Debris debris;

    double mass() const {
        double sum = 0;
        for (const Body& body : bodies.slots)
            if (body.shape.valid()) sum += body.shape.mass();
        return sum;
    }
    double volume(const std::vector<BodyId>& ids) const {
        double sum = 0;
        for (const BodyId id : ids) sum += mass_properties(debris.find(bodies, id)->solid, 1).volume;
        return sum;
    }
    std::size_t there() const {
        return std::size_t(std::count_if(bodies.slots.begin(), bodies.slots.end(),
                                         [](const Body& body) { return body.shape.valid(); }));
    }
};

double volume_of(const MovingPart& part) {
    return mass_properties(part.world().solid(), 1).volume;
}

/// A part of a matter by the name of its texture.
MovingPart box_part(const Vec3& low, const Vec3& high, const std::string& texture) {
    return MovingPart(test::brush_world(map_text::box(low, high, texture)));
}

Cutter box_cutter(const Vec3& low, const Vec3& high) {
    return test::box_mesh(low, high).cutter().value();
}

std::string key(const std::string& name, const std::string& value) {
    return "\"" + name + "\" \"" + value + "\"\n";
}

BrushPart part_of(const std::string& classname, const std::string& keys) {
    const std::string text = map_text::world(map_text::box({-9, -9, -2}, {9, 9, 0}, "floor")) + "{\n\"classname\" \"" +
                             classname + "\"\n" + keys + map_text::box({4, 0, 0}, {6, 1, 3}, "planks") + "}\n";
    return make_brush_parts(read_map(text, "test.map", {.scale = 1}).value()).value().parts.at(0);
}

TEST(BreakParts, KeysOfBreakables) {
    const BrushPart usual = part_of("func_breakable", "");
    EXPECT_TRUE(usual.breaks);
    EXPECT_EQ(usual.health, 100);
    EXPECT_EQ(usual.damage, 0);
    EXPECT_EQ(part_of("func_explosive", key("targetname", "x")).health, 0) << "a trigger alone";
    EXPECT_EQ(part_of("func_explosive", key("targetname", "x") + key("health", "5")).health, 5);
    EXPECT_EQ(part_of("func_breakable", key("health", "-5")).health, 0);
    EXPECT_EQ(part_of("func_explosive", key("dmg", "120")).damage, 120);
    const auto matter_named_by = [](const std::string& keys) {
        const BrushPart part = part_of("func_breakable", keys);
        const Breakable breakable = breakable_of(part);
        EXPECT_NEAR(breakable.whole, 6, 1e-9);
        return breakable.matter ? matters_of(part.world).matters[*breakable.matter].name : "";
    };
    EXPECT_EQ(matter_named_by(key("type", "glass")), "glass");
    EXPECT_EQ(matter_named_by(key("type", "metal")), "steel");
    EXPECT_EQ(matter_named_by(key("material", "1")), "wood");
    EXPECT_EQ(matter_named_by(key("material", "8")), "rock");
    EXPECT_EQ(matter_named_by(key("type", "cheese")), "");
    EXPECT_EQ(matter_named_by(""), "");
}

TEST(BreakParts, DamageAddsUpOnce) {
    Breakable crate{.health = 40};
    EXPECT_FALSE(hurt_part(crate, 30));
    EXPECT_FALSE(hurt_part(crate, NAN));
    EXPECT_FALSE(hurt_part(crate, -30));
    EXPECT_FALSE(hurt_part(crate, INFINITY));
    EXPECT_EQ(crate.health, 10);
    EXPECT_TRUE(hurt_part(crate, 10));
    EXPECT_FALSE(hurt_part(crate, 10)) << "it is told once";
    Breakable by_trigger{.health = 0};
    EXPECT_FALSE(hurt_part(by_trigger, 1e9));
}

TEST(BreakParts, PiecesAreThePart) {
    Game game;
    MovingPart crate = box_part({-1, -1, 0}, {1, 1, 2}, "wood_planks");
    crate.motion.position = {3, 4, 0};
    crate.motion.rotation = turn_by({0, 0, 0.5});
    Breakable breakable{.health = 10};
    const World before = crate.world();
    const BrokenPart broken =
        break_part(game.level, crate, &breakable, game.bodies, game.debris, {.impact = Vec3{3, 3, 1}, .min_volume = 0});
    EXPECT_GT(broken.pieces.size(), 4u);
    EXPECT_EQ(broken.unfit, 0u);
    EXPECT_TRUE(breakable.broken);
    EXPECT_EQ(crate.world().face_count(), 0u);
    EXPECT_TRUE(broken.opened.empty());
    EXPECT_EQ(hash_world(broken.level), hash_world(game.level));
    const Matter& wood = matter(before, *matter_named(matters_of(before), "wood"));
    EXPECT_NEAR(game.mass() + broken.dust_mass, 8 * wood.density, 1e-6);
    for (const BodyId id : broken.pieces) {
        const DebrisPiece& piece = *game.debris.find(game.bodies, id);
        EXPECT_TRUE(piece.of_part);
        EXPECT_EQ(matter(before, piece.matter).name, "wood");
        // Where the part stood.
        const Body& body = *game.bodies.find(id);
        const Vec3 in_part = matrix_of(crate.motion.rotation).back(body.position - crate.motion.position);
        EXPECT_TRUE(std::fabs(in_part.x) < 1 && std::fabs(in_part.y) < 1 && in_part.z > 0 && in_part.z < 2);
        EXPECT_EQ(body.velocity, (Vec3{}));
    }
    // Nothing meets the part, and the pieces lie in a heap.
    EXPECT_FALSE(cast(firma::Scene{game.level, {&crate, 1}}, Ray{{3, -4, 1}, {0, 20, 0}}));
    for (int k = 0; k < 180; ++k) step(game.bodies, firma::Scene{game.level, {&crate, 1}}, 1.0 / 60);
    for (const BodyId id : broken.pieces) {
        EXPECT_GT(game.bodies.find(id)->position.z, 0);
        EXPECT_LT(game.bodies.find(id)->position.z, 2);
    }
    // It breaks once.
    EXPECT_TRUE(break_part(game.level, crate, &breakable, game.bodies, game.debris).pieces.empty());
    // A blast later: its pieces are of wood still, although the level is of rock there.
    const BlastResult blast = explode(game.level, game.bodies, game.debris, {.at = {3, 4, 0.5}}, Cutter{}, {},
                                      {.break_radius = 9, .min_volume = 0});
    EXPECT_GT(blast.pieces.size(), broken.pieces.size());
    for (const BodyId id : blast.pieces)
        EXPECT_EQ(matter(before, game.debris.find(game.bodies, id)->matter).name, "wood");
}

TEST(BreakParts, AMatterThatItsAuthorNamesAndMotion) {
    Game game;
    MovingPart pane = box_part({-1, -0.0625, 0}, {1, 0.0625, 2}, "wood_planks");
    pane.motion.position = {0, 0, 5};
    pane.motion.path = {0.5, 0, 0};
    const auto glass = matter_named(matters_of(pane.world()), "glass");
    ASSERT_TRUE(glass);
    Breakable breakable{.health = 10, .matter = glass};
    const double density = matter(pane.world(), *glass).density;
    const BrokenPart broken =
        break_part(game.level, pane, &breakable, game.bodies, game.debris, {.seconds = 0.25, .min_volume = 0});
    ASSERT_GT(broken.pieces.size(), 3u);
    EXPECT_NEAR(game.mass() + broken.dust_mass, 0.5 * density, 1e-6);
    for (const BodyId id : broken.pieces) {
        EXPECT_EQ(game.debris.find(game.bodies, id)->matter, *glass);
        EXPECT_NEAR(game.bodies.find(id)->velocity.x, 2, 1e-9);
    }
}

TEST(BreakParts, WhatCannotBreakStays) {
    Game game;
    MovingPart part = box_part({-1, -1, 0}, {1, 1, 2}, "wood");
    part.motion.path.x = NAN;
    Breakable breakable{.health = 10};
    EXPECT_TRUE(break_part(game.level, part, &breakable, game.bodies, game.debris).pieces.empty());
    EXPECT_FALSE(breakable.broken);
    part.motion.path.x = 0;
    EXPECT_TRUE(break_part(game.level, part, &breakable, game.bodies, game.debris, {.fraction = 2}).pieces.empty());
    EXPECT_GT(part.world().face_count(), 0u);
    EXPECT_EQ(game.there(), 0u);
}

TEST(BreakParts, ABlastIsFeltWhereTheLevelLeavesItThrough) {
    const World ground = test::ground();
    const MovingPart part = box_part({-1, -1, 0}, {1, 1, 2}, "wood");
    const Blast blast{.at = {4, 0, 1}, .radius = 6};
    EXPECT_NEAR(blast_felt(ground, part, blast), 0.25, 1e-9) << "three metres away of six";
    const CarveResult wall = fill(ground, box_cutter({2, -5, -1}, {2.5, 5, 5}), {});
    ASSERT_TRUE(wall.done());
    EXPECT_EQ(blast_felt(wall.world, part, blast), 0);
    EXPECT_EQ(blast_felt(ground, part, {.at = {40, 0, 1}, .radius = 6}), 0);
    EXPECT_EQ(blast_felt(ground, part, blast, NAN), 0);
}

/// A door of the level: the portal that it closed is open once it is broken.
TEST(BreakParts, ADoorsPortalOpens) {
    Game game;
    game.level = test::depot_world();
    std::optional<PortalId> portal;
    MovingPart door;
    for (std::uint32_t k = 0; k < portal_count(game.level) && !portal; ++k) {
        const PortalInfo info = portal_info(game.level, {k}).value();
        const Vec3 size = info.bounds.high - info.bounds.low;
        if (info.polygons == 0 || std::min({size.x, size.y, size.z}) > 0.01) continue;
        const Vec3 middle = (info.bounds.low + info.bounds.high) * 0.5,
                   half = size * 0.5 + Vec3{0.0625, 0.0625, 0.0625};
        door = box_part(-half, half, "wood");
        door.motion.position = middle;
        const std::vector<PortalId> closes = portals_closed_by(game.level, door);
        if (closes.size() == 1) portal = closes[0];
    }
    ASSERT_TRUE(portal);
    game.level = *set_portal_open(game.level, *portal, false);
    // A notch in its front lets nothing through; a hole does. What breaks with a hole in it opens what is named.
    MovingPart holed = door;
    const Pose middle{door.motion.position, {0, 0, 0, 1}, 1};
    const Vec3 thin = door.bounds().high;
    const int across = thin.x < thin.y && thin.x < thin.z ? 0 : thin.y < thin.z ? 1 : 2;
    Vec3 low{-0.2, -0.2, -0.2}, high{0.2, 0.2, 0.2};
    low[across] = 0.03125;
    const PartCut notch =
        carve_part(game.level, holed, nullptr, box_cutter(low, high), middle, game.bodies, game.debris);
    ASSERT_EQ(notch.status, CarveStatus::kDone);
    EXPECT_TRUE(notch.opened.empty());
    EXPECT_FALSE(portal_info(notch.level, *portal)->open);
    low[across] = -0.2;
    Pose aside = middle;
    aside.position[across == 2 ? 0 : 2] += 0.3;
    const PartCut hole = carve_part(game.level, holed, nullptr, box_cutter(low, high), aside, game.bodies, game.debris);
    ASSERT_EQ(hole.status, CarveStatus::kDone);
    EXPECT_EQ(hole.opened, std::vector<PortalId>{*portal});
    EXPECT_TRUE(portal_info(hole.level, *portal)->open);
    EXPECT_EQ(break_part(game.level, holed, nullptr, game.bodies, game.debris, {.portals = {*portal, PortalId{999999}}})
                  .opened,
              std::vector<PortalId>{*portal});
    // Cut so that it breaks at once.
    MovingPart weak = door;
    Breakable bears{.health = 1, .whole = volume_of(door), .max_taken = 0};
    const PartCut cut = carve_part(game.level, weak, &bears, box_cutter(low, high), aside, game.bodies, game.debris);
    ASSERT_TRUE(cut.broken);
    EXPECT_EQ(cut.opened, std::vector<PortalId>{*portal});
    EXPECT_TRUE(portal_info(cut.level, *portal)->open);
    const BrokenPart broken = break_part(game.level, door, nullptr, game.bodies, game.debris);
    EXPECT_EQ(broken.opened, std::vector<PortalId>{*portal});
    EXPECT_TRUE(portal_info(broken.level, *portal)->open);
    EXPECT_FALSE(portal_info(game.level, *portal)->open);
    EXPECT_FALSE(broken.pieces.empty());
}

/// A wall 4 m wide on the ground, cut off above the ground: what stands stays the part, the rest falls as a body.
TEST(BreakParts, ACutDividesAWallAndWhatNothingHoldsFalls) {
    Game game;
    MovingPart wall = box_part({-2, -0.25, 0}, {2, 0.25, 4}, "brick");
    const PartCut cut =
        carve_part(game.level, wall, nullptr, box_cutter({-3, -1, 1}, {3, 1, 1.5}), {}, game.bodies, game.debris);
    ASSERT_EQ(cut.status, CarveStatus::kDone);
    EXPECT_FALSE(cut.broken);
    ASSERT_EQ(cut.loose.size(), 1u);
    EXPECT_NEAR(volume_of(wall), 2, 1e-9);
    EXPECT_NEAR(game.volume(cut.loose), 5, 1e-9);
    EXPECT_EQ(cut.report.chunks, 1u);
    const Body& above = *game.bodies.find(cut.loose[0]);
    EXPECT_NEAR(above.position.z, 2.75, 1e-9);
    const Matter& brick = matter(wall.world(), *matter_named(matters_of(wall.world()), "brick"));
    EXPECT_NEAR(above.shape.mass(), 5 * brick.density, 1e-6);
    // It falls onto what stands, and both hold: the part is met by bodies.
    for (int k = 0; k < 30; ++k) step(game.bodies, firma::Scene{game.level, {&wall, 1}}, 1.0 / 60);
    EXPECT_LT(game.bodies.find(cut.loose[0])->position.z, 2.5);
    EXPECT_GT(game.bodies.find(cut.loose[0])->position.z, 1.8);
    // A second cut of the same place does nothing.
    const PartCut again =
        carve_part(game.level, wall, nullptr, box_cutter({-3, -1, 1}, {3, 1, 1.5}), {}, game.bodies, game.debris);
    EXPECT_EQ(again.status, CarveStatus::kNothing);
}

/// An arch whose two feet stand: cut in the middle both stay; one foot cut off, that side falls.
TEST(BreakParts, EachPieceIsHeldByWhatItTouches) {
    Game game;
    MovingPart arch(test::brush_world(map_text::box({-3, -0.5, 0}, {-2, 0.5, 3}, "concrete") +
                                      map_text::box({2, -0.5, 0}, {3, 0.5, 3}, "concrete") +
                                      map_text::box({-3, -0.5, 3}, {3, 0.5, 4}, "concrete")));
    const PartCut middle =
        carve_part(game.level, arch, nullptr, box_cutter({-0.5, -1, 2.5}, {0.5, 1, 5}), {}, game.bodies, game.debris);
    ASSERT_EQ(middle.status, CarveStatus::kDone);
    EXPECT_TRUE(middle.loose.empty());
    EXPECT_NEAR(volume_of(arch), 11, 1e-9);
    const PartCut foot =
        carve_part(game.level, arch, nullptr, box_cutter({1.5, -1, -1}, {3.5, 1, 1}), {}, game.bodies, game.debris);
    ASSERT_EQ(foot.loose.size(), 1u);
    EXPECT_NEAR(game.volume(foot.loose), 4.5, 1e-9);
    EXPECT_NEAR(volume_of(arch), 5.5, 1e-9);
    const PartCut other =
        carve_part(game.level, arch, nullptr, box_cutter({-3.5, -1, -1}, {-1.5, 1, 1}), {}, game.bodies, game.debris);
    ASSERT_TRUE(other.broken) << "nothing holds any of it: it falls, unbroken";
    EXPECT_EQ(other.broken->pieces.size(), 1u);
    EXPECT_NEAR(game.volume(other.broken->pieces), 4.5, 1e-9);
    EXPECT_EQ(arch.world().face_count(), 0u);
}

/// A door that goes is held by what moves it; one that hangs in the air by its author's will stays there.
TEST(BreakParts, WhatMovesGoesOnWithTheLargestPiece) {
    Game game;
    for (const PartHold hold : {PartHold::kLargest, PartHold::kLevel}) {
        MovingPart leaf = box_part({0, -0.0625, 0}, {4, 0.0625, 2}, "steel");
        leaf.motion.position = {0, 0, 3};
        leaf.motion.rotation = turn_by({0, 0, 1});
        const Vec3 at = test::part_point(leaf.motion, 0, {3, 0, 1});
        Pose pose;
        pose.position = at;
        pose.rotation = leaf.motion.rotation;
        const PartCut cut = carve_part(game.level, leaf, nullptr, box_cutter({-0.125, -1, -3}, {0.125, 1, 3}), pose,
                                       game.bodies, game.debris, {.hold = hold});
        ASSERT_EQ(cut.loose.size(), 1u);
        EXPECT_NEAR(volume_of(leaf), 0.125 * 2 * 2.875, 2e-3);
        const Body& end = *game.bodies.find(cut.loose[0]);
        EXPECT_LT(length(end.position - test::part_point(leaf.motion, 0, {3.5625, 0, 1})), 2e-3);
    }
}

/// Whether a face of the level holds a piece of a part.
bool is_held(const World& level, const Solid& piece, const RigidMotion& motion) {
    SupportedThing thing;
    thing.sides = support_sides(MovingPart(make_world(piece).value(), motion));
    thing.reach = 1.0 / 32;
    return find_supports(level, {thing}).value().things[0].area > 0;
}

/// Shots at fences on the ground, turned anyhow: nothing is lost, all is sound, and what is left stands.
TEST(BreakParts, ShotsAtRandomLoseNothing) {
    scenes::Rng rng(9);
    std::size_t loose = 0, fell = 0, cuts = 0;
    for (int fence = 0; fence < 6; ++fence) {
        Game game;
        std::string text = map_text::box({-4, -0.125, 2}, {4, 0.125, 2.5}, "wood");
        for (int post = 0; post < 4; ++post)
            text += map_text::box({-4 + 2.5 * post, -0.25, 0}, {-3.5 + 2.5 * post, 0.25, 3}, "concrete");
        MovingPart part(test::brush_world(text));
        part.motion.position = {rng.uniform(-5, 5), rng.uniform(-5, 5), 0};
        part.motion.rotation = turn_by({0, 0, rng.uniform(0, 6)});
        for (int shot = 0; shot < 24 && part.world().face_count() > 0; ++shot) {
            Pose pose;
            pose.position =
                test::part_point(part.motion, 0, {rng.uniform(-4, 4), rng.uniform(-0.3, 0.3), rng.uniform(0, 3)});
            pose.rotation = random_turn(rng.next());
            pose.scale = rng.uniform(0.3, 0.8);
            const double before = volume_of(part);
            const PartCut cut = carve_part(game.level, part, nullptr, make_crater(CutterShape::kRocky, rng.next()),
                                           pose, game.bodies, game.debris);
            ASSERT_NE(cut.status, CarveStatus::kRefused) << cut.error.text();
            if (cut.status == CarveStatus::kNothing) continue;
            ++cuts;
            EXPECT_EQ(cut.unfit, 0u);
            const double left = before - cut.report.volume - cut.report.chunk_volume - cut.report.crumb_volume;
            EXPECT_NEAR(game.volume(cut.loose), cut.report.chunk_volume, 1e-9);
            loose += cut.loose.size();
            if (cut.broken) {
                fell += cut.broken->pieces.size();
                EXPECT_NEAR(game.volume(cut.broken->pieces), left, 1e-9);
                continue;
            }
            EXPECT_NEAR(volume_of(part), left, 1e-9) << fence << " " << shot;
            const std::optional<WorldFault> fault = check_world(part.world());
            EXPECT_FALSE(fault) << fault->what;
            const std::optional<SolidFault> crack = check_solid(part.world());
            EXPECT_FALSE(crack) << crack->what;
            for (const Solid& piece : connected_pieces(part.world().solid()))
                EXPECT_TRUE(is_held(game.level, piece, part.motion)) << fence << " " << shot;
        }
    }
    EXPECT_GT(cuts, 50u);
    EXPECT_GT(loose, 3u);
    EXPECT_LT(fell, cuts);
}

TEST(BreakParts, TooMuchTakenBreaksTheRest) {
    Game game;
    MovingPart block = box_part({-1, -1, 0}, {1, 1, 2}, "concrete");
    Breakable breakable{.health = 100, .whole = 8, .max_taken = 0.5};
    const auto take = [&](double x0, double x1) {
        return carve_part(game.level, block, &breakable, box_cutter({x0, -2, -1}, {x1, 2, 3}), {}, game.bodies,
                          game.debris);
    };
    EXPECT_FALSE(take(-2, -0.25).broken);
    EXPECT_FALSE(breakable.broken);
    const PartCut rest = take(-2, 0.25);
    ASSERT_TRUE(rest.broken);
    EXPECT_TRUE(breakable.broken);
    EXPECT_GT(rest.broken->pieces.size(), 2u);
    EXPECT_NEAR(game.volume(rest.broken->pieces), 3, 0.05);
    EXPECT_EQ(block.world().face_count(), 0u);
}

TEST(BreakParts, RefusedCutsChangeNothing) {
    Game game;
    MovingPart block = box_part({-1, -1, 0}, {1, 1, 2}, "concrete");
    const std::uint64_t before = hash_world(block.world());
    Pose pose;
    pose.scale = NAN;
    const PartCut cut =
        carve_part(game.level, block, nullptr, box_cutter({-2, -2, 1}, {2, 2, 3}), pose, game.bodies, game.debris);
    EXPECT_EQ(cut.status, CarveStatus::kRefused);
    EXPECT_FALSE(cut.error.reason.empty());
    EXPECT_EQ(hash_world(block.world()), before);
    EXPECT_EQ(game.there(), 0u);
}

}  // namespace
}  // namespace firma
