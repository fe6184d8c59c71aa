// SPDX-License-Identifier: MIT
// Debris in a game: it ages, goes or becomes ground within a budget; blasts make it and break it.
#include <gtest/gtest.h>

#include "firma/debris.h"
#include "tests/carve/cutters.h"
#include "tests/fracture/rubble.h"
#include "tests/reference/judge_bodies.h"

namespace firma {
namespace {

struct Scene {
    World world = test::ground();
    Bodies bodies;
    Debris debris;

    /// A box of rock, its middle here.
    BodyId add_box(const Vec3& half, const Vec3& middle) {
        DebrisPiece piece;
        piece.solid = test::brush_world(map_text::box(-half, half, "rock")).solid();
        piece.matter = *matter_named(matters_of(world), "rock");
        return add_debris(bodies, debris, test::body_here(test::box_body(half), middle), std::move(piece));
    }
    DebrisReport tend(double seconds, const DebrisRules& rules) {
        DebrisReport report = tend_debris(world, bodies, debris, seconds, rules);
        world = report.world;
        return report;
    }
    std::size_t there() const {
        std::size_t count = 0;
        for (const Body& body : bodies.slots) count += body.shape.valid();
        return count;
    }
};

double rock_volume(const World& world) {
    return measure_solid(world).volume;
}

TEST(Debris, GoesWhenItIsOldOrLongAsleep) {
    Scene scene;
    const BodyId sleeper = scene.add_box({0.1, 0.1, 0.1}, {0, 0, 1});
    const BodyId awake = scene.add_box({0.1, 0.1, 0.1}, {2, 0, 1});
    const BodyId other = add_body(scene.bodies, test::body_here(test::ball(0.2), {4, 0, 1}));
    scene.bodies.find(sleeper)->asleep = true;
    const DebrisRules rules{.max_age = 10, .max_asleep = 2};
    EXPECT_TRUE(scene.tend(1.5, rules).removed.empty());
    EXPECT_EQ(scene.debris.find(scene.bodies, sleeper)->asleep_for, 1.5);
    EXPECT_EQ(scene.debris.find(scene.bodies, awake)->asleep_for, 0);
    EXPECT_TRUE(scene.tend(NAN, rules).removed.empty());
    EXPECT_EQ(scene.tend(1, rules).removed, std::vector<BodyId>{sleeper});
    EXPECT_TRUE(scene.tend(7, rules).removed.empty());
    EXPECT_EQ(scene.tend(1, rules).removed, std::vector<BodyId>{awake});
    EXPECT_TRUE(scene.tend(100, rules).removed.empty());
    EXPECT_NE(scene.bodies.find(other), nullptr) << "what is no debris stays";
}

TEST(Debris, KeepsToItsBudget) {
    Scene scene;
    std::vector<BodyId> ids;
    for (int k = 0; k < 6; ++k) {
        const double half = 0.1 * (1 + k);
        ids.push_back(scene.add_box({half, half, half}, {3.0 * k, 0, 3}));
    }
    scene.bodies.find(ids[4])->asleep = scene.bodies.find(ids[2])->asleep = true;
    EXPECT_EQ(scene.tend(0, {.max_bodies = 4}).removed, (std::vector<BodyId>{ids[2], ids[4]}))
        << "sleepers, smallest first";
    EXPECT_EQ(scene.tend(0, {.max_spheres = 23}).removed, (std::vector<BodyId>{ids[0], ids[1]})) << "of 8 spheres each";
    EXPECT_TRUE(scene.tend(0, {.max_bodies = 2, .max_spheres = 16}).removed.empty());
    EXPECT_EQ(scene.there(), 2u);
}

TEST(Debris, BecomesGround) {
    Scene scene;
    const BodyId id = scene.add_box({0.5, 0.5, 0.25}, {0, 0, 0.4});
    scene.bodies.find(id)->rotation = turn_by({0, 0, 0.3});
    test::run(scene.bodies, scene.world, 180);
    ASSERT_TRUE(scene.bodies.find(id)->asleep);
    const double before = rock_volume(scene.world);
    const DebrisRules rules{.max_asleep = 1, .to_ground = true};
    EXPECT_TRUE(scene.tend(0.5, rules).to_ground.empty());
    const DebrisReport report = scene.tend(1, rules);
    EXPECT_EQ(report.to_ground, std::vector<BodyId>{id});
    ASSERT_EQ(report.fills.size(), 1u);
    EXPECT_EQ(scene.bodies.find(id), nullptr);
    EXPECT_NEAR(rock_volume(scene.world) - before, 0.5, 2e-3);
    EXPECT_EQ(locate(scene.world.solid(), {0, 0, 0.4}), Where::kSolid);
    test::expect_sound_world(scene.world);
    // The fills are the edits: another machine that makes them has the same world.
    const CarveResult again =
        fill(test::ground(), report.fills[0].cutter, report.fills[0].pose,
             {.material = matter(scene.world, *matter_named(matters_of(scene.world), "rock")).inside});
    EXPECT_EQ(hash_world(again.world), hash_world(scene.world));
    // And what falls on it lies on it.
    const BodyId above = scene.add_box({0.2, 0.2, 0.2}, {0, 0, 1});
    test::run(scene.bodies, scene.world, 180);
    EXPECT_NEAR(scene.bodies.find(above)->position.z, 0.7, 0.01);
}

TEST(Debris, WaitsForPlayersAndOtherBodies) {
    Scene scene;
    const BodyId id = scene.add_box({0.5, 0.5, 0.25}, {0, 0, 0.25});
    scene.bodies.find(id)->asleep = true;
    DebrisRules rules{.max_asleep = 1, .to_ground = true};
    const Sphere player{{0.6, 0, 0.3}, 0.3};
    rules.keep_clear = {&player, 1};
    EXPECT_EQ(scene.tend(2, rules).waiting, 1u);
    rules.keep_clear = {};
    const BodyId other = add_body(scene.bodies, test::body_here(test::ball(0.2), {0.6, 0, 0.3}));
    EXPECT_EQ(scene.tend(0, rules).waiting, 1u);
    EXPECT_NE(scene.bodies.find(id), nullptr);
    scene.bodies.find(other)->position.x = 0.69;  // a centimetre in it
    rules.max_to_ground = 0;
    EXPECT_EQ(scene.tend(0, rules).waiting, 1u);
    rules.max_to_ground = 1;
    EXPECT_EQ(scene.tend(0, rules).to_ground.size(), 1u);
}

TEST(Debris, StaysABodyWhereItCannotBecomeGround) {
    Scene scene;
    CarveRules hard;
    hard.zones.push_back({"vault", {{-9, -9, -9}, {9, 9, 9}}, 1});
    scene.world = with_rules(scene.world, hard).value();
    const BodyId id = scene.add_box({0.5, 0.5, 0.25}, {0, 0, 0.25});
    scene.bodies.find(id)->asleep = true;
    const DebrisRules rules{.max_age = 10, .max_asleep = 1, .to_ground = true};
    EXPECT_EQ(scene.tend(2, rules).refused, 1u);
    EXPECT_TRUE(scene.debris.find(scene.bodies, id)->never_ground);
    EXPECT_EQ(scene.tend(2, rules).refused, 0u) << "it is not tried again";
    EXPECT_NE(scene.bodies.find(id), nullptr);
    EXPECT_EQ(scene.tend(9, rules).removed, std::vector<BodyId>{id});
}

TEST(Debris, ABlastMakesItAndTheNextBreaksIt) {
    Scene scene;
    scene.world = with_anchors(test::depot_world());
    const Cutter crater = make_crater(CutterShape::kRocky, 3);
    // The bridge of the depot, shot at both ends.
    const BlastResult first =
        explode(scene.world, scene.bodies, scene.debris, {{14, 2, 3.75}}, crater, test::pose_at(14, 2, 3.75, 2.2));
    ASSERT_TRUE(first.carve.done());
    const BlastResult second = explode(first.carve.world, scene.bodies, scene.debris, {{14, 12, 3.75}}, crater,
                                       test::pose_at(14, 12, 3.75, 2.2));
    scene.world = second.carve.world;
    ASSERT_FALSE(second.carve.chunks.empty());
    EXPECT_GT(second.broken, 0u);
    EXPECT_GT(second.loose.size(), second.carve.chunks.size());
    EXPECT_GT(second.push.pushed, 0u);
    double mass = second.dust_mass, chunks = 0;
    for (const BodyId id : second.loose) mass += scene.bodies.find(id)->shape.mass();
    for (const Chunk& chunk : second.carve.chunks) chunks += chunk.mass.mass;
    EXPECT_EQ(second.unfit, 0u);
    EXPECT_NEAR(mass, chunks, 1e-9 * chunks);

    reference::BodyDepths depths;
    for (int frame = 0; frame < 120; ++frame) {
        step(scene.bodies, scene.world, 1.0 / 60);
        ASSERT_EQ(depths.fault(scene.world, scene.bodies), "") << frame;
    }
    // A grenade among the pieces.
    const BodyId target = second.loose[0];
    const Vec3 at = scene.bodies.find(target)->position + Vec3{0, 0, 1};
    const std::size_t before = scene.there();
    const BlastResult third = explode(scene.world, scene.bodies, scene.debris, {at}, {}, {}, {.min_volume = 1e-4});
    EXPECT_EQ(third.carve.status, CarveStatus::kNothing);
    EXPECT_GT(third.broken, 0u);
    EXPECT_GT(scene.there(), before);
    std::uint32_t most = 0;
    for (const BodyId id : third.pieces) most = std::max(most, scene.debris.find(scene.bodies, id)->broken);
    EXPECT_EQ(most, 2u);
    for (int frame = 0; frame < 60; ++frame) {
        step(scene.bodies, scene.world, 1.0 / 60);
        ASSERT_EQ(depths.fault(scene.world, scene.bodies), "") << frame;
    }
}

TEST(Debris, AWallKeepsABlastFromBreakingIt) {
    for (const double height : {0.1, 3.0}) {
        Scene scene;
        scene.world = test::brush_world(map_text::box({-64, -64, -4}, {64, 64, 0}, "rock") +
                                        map_text::box({1, -20, 0}, {1.5, 20, height}, "rock"));
        const BodyId id = scene.add_box({0.6, 0.6, 0.6}, {2.2, 0, 0.6});
        const BlastResult blast = explode(scene.world, scene.bodies, scene.debris, {{0.9, 0, 0.5}}, {}, {});
        EXPECT_EQ(blast.broken, height < 1 ? 1u : 0u);
        EXPECT_EQ(scene.bodies.find(id) == nullptr, height < 1);
    }
}

TEST(Debris, TheSameBitsEachTime) {
    std::uint64_t before[3] = {};
    for (int run = 0; run < 2; ++run) {
        Scene scene;
        scene.world = with_anchors(test::depot_world());
        const Cutter crater = make_crater(CutterShape::kRocky, 3);
        for (const double y : {2.0, 12.0}) {
            scene.world = explode(scene.world, scene.bodies, scene.debris, {{14, y, 3.75}}, crater,
                                  test::pose_at(14, y, 3.75, 2.2))
                              .carve.world;
            for (int frame = 0; frame < 30; ++frame) step(scene.bodies, scene.world, 1.0 / 60);
            scene.tend(0.5, {.max_bodies = 12, .to_ground = true});
        }
        EXPECT_GT(scene.there(), 5u);
        const std::uint64_t now[3] = {hash_world(scene.world), hash_bodies(scene.bodies), hash_debris(scene.debris)};
        for (int k = 0; k < 3; ++k) {
            if (run == 1) {
                EXPECT_EQ(now[k], before[k]);
            }
            before[k] = now[k];
        }
    }
}

}  // namespace
}  // namespace firma
