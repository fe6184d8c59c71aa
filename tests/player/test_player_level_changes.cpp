// SPDX-License-Identifier: MIT
// Players in the blasted depot and in blasted maps whose floors are cut and put back under them, and where parts move:
// each situation at places that are found there, with a capsule, a box and spheres.
#include <cmath>

#include "tests/moving/part_worlds.h"
#include "tests/player/path_ride.h"
#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerLevelChanges : public InPlayerLevels {
protected:
    /// A pit with upright sides; the world before where it would open a way out of the level.
    World pit(const FloorPlace& place, double half, double deep) const {
        const World cut =
            edited_at(world(), place, box_mesh({-half, -half, -deep}, {half, half, 0.5}), CarveKind::kCarve);
        return reference::opens_way_out(world(), cut) ? world() : cut;
    }
    /// Whether there is no floor within 1 m below, somewhere within 0.75 m.
    static bool has_hole(const World& now, const Vec3& at) {
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y)
                if (floor_under(now, at + Vec3{x * 0.25, y * 0.25, 1}) < at.z - 1) return true;
        return false;
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerLevelChanges, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerLevelChanges, FallsWhereTheFloorIsCutAndIsOnTheNewOne) {
    std::size_t fell = 0;
    at_places(kSquare, 4, [&](const FloorPlace& place) {
        Walk walk = stands(world(), place.at);
        walk.world = pit(place, 0.75, 0.75);
        const double floor = floor_under(walk.world, place.at + Vec3{0, 0, 0.5});
        if (!(floor < place.at.z - 0.5) || !(floor > place.at.z - 6)) return;
        walk.wait(1);
        EXPECT_FALSE(walk.player.on_ground);
        double landed = 0;
        for (int k = 0; k < 90; ++k) landed = std::max(landed, walk.move({}).landed_speed);
        EXPECT_TRUE(walk.player.on_ground);
        EXPECT_TRUE(is_inside(walk.world, walk));
        if (floor_under(walk.world, place.at + place.along * 0.5) != floor) return;  // no floor of the pit's own
        EXPECT_NEAR(walk.at().z, floor + kOffset, 1e-6);
        EXPECT_NEAR(landed, std::sqrt(2 * 9.81 * (place.at.z - floor)), 0.2);
        EXPECT_LT(length(across(walk.at() - place.at)), 1e-9);
        // Its sides are walls, for they are higher than a step.
        walk.go(place.along * 3, 60);
        EXPECT_NEAR(dot(walk.at() - place.at, place.along), 0.75 - 0.3 - kOffset, 2e-3);
        ++fell;
    });
    EXPECT_GE(fell, 1u);
}

TEST_P(PlayerLevelChanges, AnUndonePitPutsItOutNearAndInTheLevel) {
    std::size_t undone = 0;
    at_places(kSquare, 4, [&](const FloorPlace& place) {
        for (const double off : {0.0, 0.3}) {
            Walk walk = stands(world(), place.at);
            walk.world = pit(place, 0.75, 0.75);
            walk.wait(60);
            if (!(walk.at().z < place.at.z - 0.5) || !(walk.at().z > place.at.z - 1)) return;
            walk.go(place.along * 2, int(off * 30));
            const Vec3 in = walk.at();
            walk.world = world();
            walk.wait(1);
            EXPECT_FALSE(walk.player.stuck);
            EXPECT_GT(length(walk.last.pushed), 0.3);
            EXPECT_LT(length(walk.last.pushed), 1.5);
            EXPECT_TRUE(is_inside(walk.world, walk));
            if (walk.last.pushed.z < 0) continue;  // into what is below a thin floor
            walk.wait(60);
            EXPECT_TRUE(walk.player.on_ground);
            EXPECT_TRUE(is_inside(walk.world, walk));
            EXPECT_LT(length(across(walk.at() - in)), 1);
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
            ++undone;
        }
    });
    EXPECT_GE(undone, 1u);
}

TEST_P(PlayerLevelChanges, OutOfRockThatIsPutWhereItStands) {
    at_places(kSquare, 3, [&](const FloorPlace& place) {
        for (const double size : {0.25, 0.5, 0.75}) {
            Walk walk = stands(world(), place.at);
            const CarveResult rock = fill(world(), make_crater(CutterShape::kRocky, 3),
                                          pose_at(place.at.x + 0.1, place.at.y, place.at.z + 0.7, size));
            ASSERT_TRUE(rock.done());
            walk.world = rock.world;
            walk.wait(1);
            EXPECT_FALSE(walk.player.stuck) << size;
            EXPECT_GT(length(walk.last.pushed), 0.01) << size;
            EXPECT_LT(length(walk.last.pushed), 2 * size + 0.5) << size;
            EXPECT_TRUE(is_inside(walk.world, walk)) << size;
            walk.wait(90);
            EXPECT_TRUE(walk.player.on_ground) << size;
            EXPECT_TRUE(is_inside(walk.world, walk)) << size;
        }
    });
}

TEST_P(PlayerLevelChanges, RoundTheRimOfACraterItDoesNotStick) {
    std::size_t round = 0;
    at_places(kSquare, 3, [&](const FloorPlace& place) {
        const CarveResult crater = carve(world(), make_crater(CutterShape::kRocky, 5),
                                         pose_at(place.at.x, place.at.y, place.at.z + 0.375, 0.75));
        ASSERT_TRUE(crater.done());
        if (reference::opens_way_out(world(), crater.world)) return;
        // On and across the rim, from point to point of a circle.
        Walk walk = stands(crater.world, place.at + Vec3{0.75, 0, 0});
        for (int k = 1; k <= 24; ++k) {
            const SineCosine turn = sine_cosine(k * 6.283185307179586 / 24);
            const Vec3 to = place.at + Vec3{turn.cosine, turn.sine, 0} * (k % 2 ? 0.9 : 0.7);
            int ticks = 0;
            for (; ticks < 60 && length(across(to - walk.at())) > 0.05; ++ticks) {
                const Vec3 way = across(to - walk.at());
                walk.go(way * (2 / length(way)), 1);
            }
            EXPECT_LT(ticks, 45) << k;  // some 0.3 m are 9 ticks
            EXPECT_TRUE(is_inside(walk.world, walk)) << k;
        }
        EXPECT_GT(walk.at().z, place.at.z - 1);
        ++round;
    });
    EXPECT_GE(round, 1u);
}

TEST_P(PlayerLevelChanges, OnTheGroundOfCratersItComesToStandStill) {
    std::size_t stood = 0;
    at_places(kSquare, 4, [&](const FloorPlace& place) {
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const CarveResult crater = carve(world(), make_crater(CutterShape::kRocky, seed),
                                             pose_at(place.at.x, place.at.y, place.at.z + 0.125, 0.75));
            ASSERT_TRUE(crater.done());
            if (reference::opens_way_out(world(), crater.world)) continue;
            if (has_hole(crater.world, place.at)) continue;
            Walk walk(crater.world, shape(), place.at + Vec3{0.2 * double(seed) - 0.4, 0.1, 0.5});
            walk.wait(120);
            EXPECT_TRUE(walk.player.on_ground) << seed;
            EXPECT_TRUE(is_inside(walk.world, walk)) << seed;
            EXPECT_LT(walk.at().z, place.at.z + 0.1) << seed;
            const Vec3 at = walk.at();
            walk.wait(60);
            EXPECT_EQ(walk.at(), at) << seed;
            ++stood;
        }
    });
    EXPECT_GE(stood, 3u);
}

// Between two slopes and the rim of a sheet over them: what it fell by in a tick was less than the contact offset, so
// it never met all three in one, and was never held.
TEST(PlayerFold, ABoxInTheFoldOfACraterComesToStandStill) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    const CarveResult crater =
        carve(blasted_level("oa_koth1").world, make_crater(CutterShape::kRocky, 2), pose_at(-5.5, 16, -3.375, 0.75));
    ASSERT_TRUE(crater.done());
    Walk walk(crater.world, player_shapes()[1], {-5.5, 16.1, -3});
    walk.wait(120);
    EXPECT_TRUE(walk.player.on_ground);
    const Vec3 at = walk.at();
    walk.wait(60);
    EXPECT_EQ(walk.at(), at);
}

// Begun anywhere in rock, at most 6 m from where it fits.
TEST_P(PlayerLevelChanges, DeepInTheLevelItIsStuckOnlyWhereNothingNearIsFree) {
    const std::vector<bool> outside = reference::rooms_outside(world());
    const PlayerShape shape = this->shape();
    const auto is_free = [&](const Vec3& feet) {
        const Location at = locate(world(), feet + Vec3{0, 0, 0.9});
        return at.where == Where::kAir && !outside[at.room.value] && player_fits(world(), shape, feet);
    };
    const Box box = world().bounds();
    scenes::Rng rng(7);
    int begun = 0, stuck = 0;
    while (begun < 150) {
        const double x = rng.uniform(box.low.x, box.high.x), y = rng.uniform(box.low.y, box.high.y);
        const Vec3 from{x, y, rng.uniform(box.low.z, box.high.z)};
        if (!is_free(from)) continue;
        Walk walk(world(), shape, from);
        const double far = rng.uniform(0, 6);
        walk.player.position += rng.direction() * far;
        walk.player.room = locate(world(), from + Vec3{0, 0, 0.9}).room;
        if (locate(world(), walk.at() + Vec3{0, 0, 0.9}).where == Where::kAir) continue;
        ++begun;
        const Vec3 in = walk.at();
        walk.wait(1);
        if (!walk.player.stuck) continue;
        ++stuck;
        for (int k = 0; k < 4000; ++k) {
            const double reach = rng.uniform(0, 0.95) * walk.rules.max_push;
            EXPECT_FALSE(is_free(in + rng.direction() * reach)) << in.x << ' ' << in.y << ' ' << in.z;
        }
    }
    EXPECT_LT(stuck, begun / 10);
}

TEST_P(PlayerLevelChanges, ALiftTakesItUpAndDown) {
    at_places(kSquare, 3, [&](const FloorPlace& place) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-1, -1, -0.125}, {1, 1, 0}))}};
        ride.path.stops.emplace_back();
        ride.path.stops[0].position = place.at + Vec3{0, 0, 0.6};
        ride.path.swing = {.reach = {0, 0, 0.5}, .period = 2.5, .phase = 0.75};
        ride.player.position = place.at + Vec3{0, 0, 0.11};
        for (int k = 0; k < 10; ++k) ride.tick();
        ASSERT_EQ(ride.player.ground_part, 0u);
        ride.airborne = 0;
        double highest = 0;
        for (int k = 0; k < 300; ++k) {
            ride.tick();
            EXPECT_NEAR(ride.player.position.z - ride.part_at().z, kOffset, 1e-6) << k;
            highest = std::max(highest, ride.player.position.z - place.at.z);
        }
        EXPECT_NEAR(highest, 1.1, 0.01);
        EXPECT_EQ(ride.airborne, 0);
        EXPECT_EQ(ride.crushed, 0);
        EXPECT_LT(length(across(ride.player.position - place.at)), 1e-6);
    });
}

TEST_P(PlayerLevelChanges, OnALiftItWalksAndStaysOnIt) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-1, -1, -0.125}, {1, 1, 0}))}};
        ride.path.stops.emplace_back();
        ride.path.stops[0].position = place.at + Vec3{0, 0, 0.6};
        ride.path.swing = {.reach = {0, 0, 0.5}, .period = 2.5, .phase = 0.75};
        ride.player.position = place.at + Vec3{0, 0, 0.11};
        for (int k = 0; k < 10; ++k) ride.tick();
        ride.airborne = 0;
        for (int k = 0; k < 240; ++k) {
            const double way = k / 40 % 2 ? -1 : 1;
            ride.tick({.velocity = place.along * way});
            EXPECT_NEAR(ride.player.position.z - ride.part_at().z, kOffset, 1e-6) << k;
        }
        EXPECT_EQ(ride.airborne, 0);
    });
}

TEST_P(PlayerLevelChanges, ALeafThatSwingsPushesItAsideAndNeverIntoTheLevel) {
    at_places(kSquare, 3, [&](const FloorPlace& place) {
        for (const double period : {1.0, 3.0}) {
            PathRide ride{world(), shape(), {}, {MovingPart(leaf_world())}};
            ride.path.stops.emplace_back();
            ride.path.stops[0].position = place.at + Vec3{0, 0, 0.02};
            ride.path.swing = {.angle = 1.5, .period = period};
            ride.player.position = place.at + Vec3{0.6, 0.6, kOffset};
            for (int k = 0; k < 180; ++k) ride.tick();
            EXPECT_GT(ride.pushed, 0) << period;
            EXPECT_GT(length(across(ride.player.position - place.at - Vec3{0.6, 0.6, 0})), 0.1) << period;
            EXPECT_TRUE(ride.player.on_ground);
        }
    });
}

// Between the leaf and a wall of the level.
TEST_P(PlayerLevelChanges, ALeafThatShutsOnAWallCrushesItAndPutsItNotIntoTheWall) {
    at_walls(false, [&](const WallPlace& place) {
        PathRide ride{world(), shape(), {}, {MovingPart(box_world({-0.5, -0.5, 0}, {0.5, 0.5, 2}))}};
        const Vec3 start = place.foot + place.normal * 0.31;
        ride.path.stops = {{.position = start + place.normal * 0.9 + Vec3{0, 0, 0.02}, .wait = 0.2, .seconds = 1},
                           {.position = start + place.normal * 0.5 + Vec3{0, 0, 0.02}, .wait = 0.2, .seconds = 1}};
        ride.player.position = start + Vec3{0, 0, kOffset};
        for (int k = 0; k < 150; ++k) {
            // It presses against the block all the while.
            ride.tick({.velocity = place.normal});
            EXPECT_GT(dot(ride.player.position - place.foot, place.normal), 0.3 - 1e-6) << k;
        }
        EXPECT_GT(ride.crushed, 0);
        EXPECT_EQ(ride.last.crushed_by, kNoPart);
        EXPECT_TRUE(ride.player.on_ground);
    });
}

}  // namespace
}  // namespace firma::test
