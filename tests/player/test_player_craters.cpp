// SPDX-License-Identifier: MIT
// Players in craters, holes and rubble of the blasted depot and of blasted maps, with a capsule, a box and spheres.
#include <cmath>

#include "tests/player/free_way.h"
#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerCraters : public InPlayerLevels {
protected:
    /// Boxes that are cut one after the other; the world before where one would open a way out of the level.
    static World cut(World level, const FloorPlace& place, const std::initializer_list<std::pair<Vec3, Vec3>>& boxes) {
        for (const auto& [low, high] : boxes) {
            World next = edited_at(level, place, box_mesh(low, high), CarveKind::kCarve);
            if (reference::opens_way_out(level, next)) return level;
            level = std::move(next);
        }
        return level;
    }
    /// A pit 0.75 m deep, and what was before it: in the floor, else in a block that is put on it.
    struct Pit {
        World before, now;
        FloorPlace place;
    };
    using Boxes = std::initializer_list<std::pair<Vec3, Vec3>>;
    static constexpr std::pair<Vec3, Vec3> kHole{{-0.6, -0.6, -0.75}, {0.6, 0.6, 0.5}};
    Pit pit(const FloorPlace& place, const Room& room, const Boxes& boxes, double half) const {
        Pit made{world(), cut(world(), place, boxes), place};
        if (is_pit(made.now, made.place, half, 0.75)) return made;
        const double along = room.along - 0.1, side = room.across - 0.1;
        made.before = block_at(world(), place, {-along, -side, -0.25}, {along, side, 0.75});
        made.place.at.z += 0.75;
        made.now = cut(made.before, made.place, boxes);
        EXPECT_TRUE(is_pit(made.now, made.place, half, 0.75));
        return made;
    }
    static World crater(const World& level, const Vec3& at, double size, std::uint64_t seed) {
        const CarveResult made = carve(level, make_crater(CutterShape::kRocky, seed), pose_at(at.x, at.y, at.z, size));
        return made.done() && !reference::opens_way_out(level, made.world) ? made.world : level;
    }
    /// Rockets at two heights, each so far into a wall.
    static World shot(World level, const Vec3& foot, const Vec3& into, std::initializer_list<double> depths) {
        for (const double up : {0.8, 1.2})
            for (const double in : depths)
                level = crater(level, foot + into * in + Vec3{0, 0, up}, 0.95, std::uint64_t(up * 10 + in));
        return level;
    }
    static constexpr double kBefore = 0.4;  ///< metres: before a wall there is as much room
    FreeWay free_way(const World& now, const Vec3& floor, const Vec3& ahead, const Vec3& aside) const {
        const PlayerShape larger = player_shapes(kOffset)[std::size_t(std::get<1>(GetParam()))];
        return {now, larger, kOffset, floor + Vec3{0, 0, 0.005}, ahead, aside};
    }
    /// A player who is not judged by sheets, which pits have cut rims into.
    Walk stands(const World& now, const Vec3& feet) const {
        Walk walk = InPlayerLevels::stands(now, feet);
        walk.passes_sheets = true;
        return walk;
    }
    /// A floor so deep all over a square, with rock beside it.
    static bool is_pit(const World& now, const FloorPlace& place, double half, double deep) {
        for (const double x : {-half, 0.0, half})
            for (const double y : {-half, 0.0, half})
                if (std::fabs(floor_under(now, place.at + Vec3{x, y, 0.5}) - place.at.z + deep) > 1e-6) return false;
        for (int k = 0; k < 16; ++k)
            for (double up = 0.02; up < deep; up += 0.1) {
                const SineCosine turn = sine_cosine(k * 22.5 * kDegree);
                const Ray beside{place.at + Vec3{0, 0, up - deep}, Vec3{turn.cosine, turn.sine, 0} * (half * 3)};
                if (!cast(now, beside)) return false;
            }
        return true;
    }
    /// The place whose x leads into a wall, at its foot.
    static FloorPlace into(const WallPlace& wall) {
        return {wall.foot, {std::fabs(wall.normal.x), std::fabs(wall.normal.y), 0}, 1};
    }
    static double side_into(const WallPlace& wall) { return wall.normal.x + wall.normal.y > 0 ? -1 : 1; }
    /// A way into the wall from its foot: so deep and high, 0.8 m wide; the world itself where that is not all rock.
    static World niche(const World& level, const WallPlace& wall, double deep, double high) {
        const double far = side_into(wall);
        const Vec3 low{std::min(-far * 0.25, far * deep), -0.4, 0}, top{std::max(-far * 0.25, far * deep), 0.4, high};
        for (const double off : {-0.45, 0.0, 0.45})
            for (double in = 0.1; in < deep + 0.3; in += 0.2)
                for (double up = -0.2; up < high + 0.3; up += 0.2) {
                    const Vec3 at = wall.foot - wall.normal * in + wall.along * off + Vec3{0, 0, up};
                    if (locate(level, at).where == Where::kAir) return level;
                }
        return cut(level, into(wall), {{low, top}});
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerCraters, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerCraters, OutOfAPitDeeperThanAStepItJumps) {
    std::size_t out = 0;
    at_places(kSquare, 2, [&](const FloorPlace& found) {
        const auto [before, pit, place] = this->pit(found, kSquare, {kHole}, 0.5);
        for (int k = 0; k < 8; ++k) {
            const SineCosine turn = sine_cosine(k * 45 * kDegree);
            const Vec3 way{turn.cosine, turn.sine, 0};
            Walk walk = stands(pit, place.at - Vec3{0, 0, 0.75});
            walk.go(way * 2, 30);
            EXPECT_NEAR(walk.at().z, place.at.z - 0.75 + kOffset, 1e-6) << k;  // by walking it gets nowhere
            walk.move({.velocity = way * 2, .jump = true});
            const auto is_out = [&] {
                return std::max(std::fabs(walk.at().x - place.at.x), std::fabs(walk.at().y - place.at.y)) > 0.95;
            };
            for (int tick = 0; tick < 60 && !is_out(); ++tick) walk.go(way * 2, 1);
            EXPECT_TRUE(is_out()) << k;
            walk.wait(60);
            EXPECT_TRUE(walk.player.on_ground) << k;
            EXPECT_NEAR(walk.at().z, place.at.z, 0.1) << k;  // round feet may be on the rim
            ++out;
        }
    });
    EXPECT_GE(out, 8u);
}

TEST_P(PlayerCraters, DownAndUpAPitWithStepsItKeepsTheGround) {
    std::size_t crossed = 0;
    at_places(kRun, 2, [&](const FloorPlace& found) {
        const Boxes steps{{{-1.25, -0.5, -0.25}, {1.25, 0.5, 0.5}},
                          {{-0.875, -0.5, -0.5}, {0.875, 0.5, 0.5}},
                          {{-0.5, -0.5, -0.75}, {0.5, 0.5, 0.5}}};
        const auto [before, pit, place] = this->pit(found, kRun, steps, 0.45);
        for (const double way : {1.0, -1.0}) {
            Walk walk = stands(pit, place.at - place.along * (way * 1.7));
            double lowest = walk.at().z;
            for (int k = 0; k < 120 && dot(walk.at() - place.at, place.along) * way < 1.7; ++k) {
                walk.go(place.along * (way * 2), 1);
                lowest = std::min(lowest, walk.at().z);
            }
            EXPECT_NEAR(lowest, place.at.z - 0.75 + kOffset, 1e-6) << way;
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << way;
            EXPECT_GE(walk.stepped, 2u) << way;
            EXPECT_EQ(walk.airborne, 0u) << way;
            ++crossed;
        }
    });
    EXPECT_GE(crossed, 2u);
}

TEST_P(PlayerCraters, ThroughShallowCratersItGoesOn) {
    std::size_t crossed = 0;
    at_places(kRun, 3, [&](const FloorPlace& place) {
        World shot = world();
        for (int k = 0; k < 4; ++k)
            shot = crater(shot, place.at + place.along * (k * 0.6 - 0.9) + Vec3{0, 0, 0.4}, 0.5, std::uint64_t(k + 1));
        for (const double way : {1.0, -1.0}) {
            Walk walk = stands(shot, place.at - place.along * (way * 1.7));
            for (int k = 0; k < 150 && dot(walk.at() - place.at, place.along) * way < 1.7; ++k)
                walk.go(place.along * (way * 2), 1);
            EXPECT_GE(dot(walk.at() - place.at, place.along) * way, 1.7) << way;  // 102 ticks on flat ground
            EXPECT_TRUE(is_inside(shot, walk));
            ++crossed;
        }
    });
    EXPECT_GE(crossed, 2u);
}

TEST_P(PlayerCraters, ShotAtUnderWayItFallsAndWalksOn) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        Walk walk = stands(world(), place.at - place.along * 1.5);
        std::size_t cuts = 0;
        for (int k = 0; k < 180; ++k) {
            if (k % 30 == 0) {
                const World shot =
                    crater(walk.world, walk.at() + place.along * 0.4 + Vec3{0, 0, 0.2}, 0.4, std::uint64_t(k / 30 + 1));
                cuts += hash_world(shot) != hash_world(walk.world);
                walk.world = shot;
            }
            const double far = dot(walk.at() - place.at, place.along);
            walk.go(place.along * (std::fabs(far) < 1.7 ? (k / 60 % 2 ? -2.0 : 2.0) : far > 0 ? -2.0 : 2.0), 1);
            EXPECT_FALSE(walk.player.stuck) << k;
            EXPECT_TRUE(is_inside(walk.world, walk)) << k;
            EXPECT_LT(length(walk.last.pushed), 0.05) << k;  // nothing came where it was
        }
        EXPECT_GE(cuts, 3u);
    });
}

TEST_P(PlayerCraters, AtTheEdgeOfAFreshHoleItStandsOrFallsAndNothingElse) {
    std::size_t fell = 0, stood = 0;
    at_places(kSquare, 2, [&](const FloorPlace& found) {
        const auto [before, pit, place] = this->pit(found, kSquare, {kHole}, 0.5);
        for (int k = 0; k < 12; ++k) {
            const double far = 0.05 + k * 0.08;
            Walk walk = stands(before, place.at + place.along * far);
            const Vec3 began = walk.at();
            walk.world = pit;
            walk.wait(90);
            EXPECT_TRUE(walk.player.on_ground) << far;
            const bool below = walk.at().z < place.at.z - 0.4;
            (below ? fell : stood)++;
            if (far < 0.29) {
                EXPECT_TRUE(below) << far;
            }
            if (far > 0.6) {
                EXPECT_FALSE(below) << far;
                EXPECT_LT(length(across(walk.at() - began)), 1e-9) << far;
            }
            const Vec3 at = walk.at();
            walk.wait(30);
            EXPECT_EQ(walk.at(), at) << far;
        }
    });
    EXPECT_GE(fell, 2u);
    EXPECT_GE(stood, 2u);
}

TEST_P(PlayerCraters, AFilledPitPutsItOutOnTop) {
    std::size_t filled = 0;
    at_places(kSquare, 2, [&](const FloorPlace& found) {
        const auto [before, pit, place] = this->pit(found, kSquare, {kHole}, 0.5);
        for (const double deep : {0.25, 0.5, 0.75}) {
            Walk walk = stands(pit, place.at - Vec3{0, 0, 0.75});
            walk.world = block_at(pit, place, {-0.6, -0.6, -0.75}, {0.6, 0.6, -0.75 + deep});
            walk.wait(1);
            EXPECT_FALSE(walk.player.stuck) << deep;
            EXPECT_LT(length(walk.last.pushed), deep + 0.35) << deep;
            EXPECT_TRUE(is_inside(walk.world, walk)) << deep;
            walk.wait(60);
            EXPECT_TRUE(walk.player.on_ground) << deep;
            EXPECT_NEAR(walk.at().z, place.at.z - 0.75 + deep + kOffset, 1e-6) << deep;
            ++filled;
        }
    });
    EXPECT_GE(filled, 3u);
}

TEST_P(PlayerCraters, BesideAPitThatIsUndoneItIsNotMoved) {
    std::size_t undone = 0;
    at_places(kSquare, 2, [&](const FloorPlace& found) {
        const auto [before, pit, place] = this->pit(found, kSquare, {kHole}, 0.5);
        for (const double far : {0.61, 0.75, 1.0}) {
            Walk walk = stands(pit, place.at + place.along * far);
            const Vec3 at = walk.at();
            walk.world = before;
            walk.wait(1);
            EXPECT_LT(length(walk.last.pushed), kOffset) << far;
            walk.wait(30);
            EXPECT_LT(length(across(walk.at() - at)), 1e-9) << far;
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << far;
            walk.go(place.along * -2.0, 30);  // over what was the hole
            EXPECT_LT(length(walk.at() - at + place.along), 1e-3) << far;
            ++undone;
        }
    });
    EXPECT_GE(undone, 3u);
}

TEST_P(PlayerCraters, WalledInItStandsUntilAWallIsCut) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        World cell = world();
        for (const auto& [low, high] : {std::pair<Vec3, Vec3>{{-0.75, -0.75, -0.25}, {-0.5, 0.75, 2.5}},
                                        {{0.5, -0.75, -0.25}, {0.75, 0.75, 2.5}},
                                        {{-0.75, -0.75, -0.25}, {0.75, -0.5, 2.5}},
                                        {{-0.75, 0.5, -0.25}, {0.75, 0.75, 2.5}}})
            cell = block_at(cell, place, low, high);
        Walk walk = stands(world(), place.at);
        walk.world = cell;
        for (int k = 0; k < 8; ++k) {
            const SineCosine turn = sine_cosine(k * 45 * kDegree);
            walk.with({.velocity = Vec3{turn.cosine, turn.sine, 0} * 4, .jump = true}, 30);
            EXPECT_FALSE(walk.player.stuck) << k;
            EXPECT_LT(std::fabs(walk.at().x - place.at.x), 0.2) << k;
            EXPECT_LT(std::fabs(walk.at().y - place.at.y), 0.2) << k;
        }
        walk.wait(60);
        walk.world = edited_at(cell, place, box_mesh({0.25, -0.5, 0}, {1, 0.5, 2.25}), CarveKind::kCarve);
        walk.go(place.along * 2, 45);
        EXPECT_GT(dot(walk.at() - place.at, place.along), 0.9);
        EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
    });
}

TEST_P(PlayerCraters, IntoAHoleInAWallAndOutAgainWithItsSpeed) {
    std::size_t entered = 0;
    at_walls(false, [&](const WallPlace& wall) {
        const World hole = niche(world(), wall, 1, 2);
        if (hash_world(hole) == hash_world(world())) return;
        Walk walk = stands(hole, wall.foot + wall.normal * 0.4);
        const Vec3 from = walk.at();
        walk.go(wall.normal * -2.0, 30);
        EXPECT_LT(length(walk.at() - from + wall.normal), 1e-3);
        walk.go(wall.normal * -2.0, 30);
        EXPECT_NEAR(dot(walk.at() - wall.foot, wall.normal), -1 + 0.3 + kOffset, 1e-3);
        EXPECT_TRUE(is_inside(hole, walk));
        walk.go(wall.normal * 2.0, 30);
        EXPECT_NEAR(dot(walk.at() - wall.foot, wall.normal), 0.3, 0.01);
        EXPECT_EQ(walk.airborne, 0u);
        // Askew it is led in by the edge of the hole.
        Walk askew = stands(hole, wall.foot + wall.normal * 0.4 - wall.along * 0.5);
        askew.go(wall.normal * -2.0 + wall.along, 60);
        EXPECT_LT(dot(askew.at() - wall.foot, wall.normal), -0.4);
        // And shut again: back in the room.
        askew.world = world();
        askew.wait(1);
        EXPECT_FALSE(askew.player.stuck);
        EXPECT_TRUE(is_inside(world(), askew));
        EXPECT_GT(dot(askew.at() - wall.foot, wall.normal), 0.29);
        ++entered;
    });
    EXPECT_GE(entered, 1u);
}

TEST_P(PlayerCraters, UnderTheSlabThatALowHoleLeavesItGoesCrouchedAlone) {
    std::size_t entered = 0;
    at_walls(false, [&](const WallPlace& wall) {
        const World hole = niche(world(), wall, 1, 1.25);
        if (hash_world(hole) == hash_world(world())) return;
        Walk walk = stands(hole, wall.foot + wall.normal * 0.5);
        walk.go(wall.normal * -2.0, 30);
        EXPECT_NEAR(dot(walk.at() - wall.foot, wall.normal), 0.3 + kOffset, 1e-4);
        walk.with({.velocity = wall.normal * -2.0, .crouch = true}, 60);
        EXPECT_LT(dot(walk.at() - wall.foot, wall.normal), -0.6);
        walk.wait(10);
        EXPECT_TRUE(walk.player.crouched);  // it cannot stand up there
        walk.with({.jump = true}, 30);
        EXPECT_TRUE(walk.player.crouched);
        EXPECT_LT(walk.at().z, wall.foot.z + 1.25 - walk.shape.height(true) + 0.001);
        walk.wait(30);
        walk.go(wall.normal * 2.0, 75);
        EXPECT_FALSE(walk.player.crouched);
        EXPECT_GT(dot(walk.at() - wall.foot, wall.normal), 0.3);
        ++entered;
    });
    EXPECT_GE(entered, 1u);
}

// The hole is round: a box is held by its corners where a capsule walks on. How far there is room is found on a grid.
TEST_P(PlayerCraters, IntoWhatARocketTearsOutOfAWallAsFarAsThereIsRoomAndOut) {
    std::size_t entered = 0;
    at_walls(false, [&](const WallPlace& wall) {
        const World hole = shot(world(), wall.foot, wall.normal * -1.0, {0.1, 0.5});
        const Vec3 from = wall.foot + wall.normal * kBefore;
        const double room = free_way(hole, from, wall.normal * -1.0, wall.along).reach(2) - kBefore;
        if (room < 0.25) return;  // nothing was cut, or it is too narrow
        Walk walk = stands(hole, from);
        walk.go(wall.normal * -2.0, 90);
        const double deep = -dot(walk.at() - wall.foot, wall.normal);
        EXPECT_GT(deep, room - 0.05);
        EXPECT_TRUE(is_inside(hole, walk));
        for (int k = 0; k < 3; ++k) {
            walk.go(wall.normal * -2.0 + wall.along * (k - 1.0), 20);
            EXPECT_TRUE(is_inside(hole, walk)) << k;
        }
        walk.with({.velocity = wall.normal * 2.0, .jump = true}, 120);
        EXPECT_GT(dot(walk.at() - wall.foot, wall.normal), kBefore);
        ++entered;
    });
    EXPECT_GE(entered, 1u);
}

TEST_P(PlayerCraters, ThroughWhatARocketTearsOutOfAThinWall) {
    std::size_t through = 0;
    at_places(kRun, 2, [&](const FloorPlace& place) {
        const World wall = block_at(world(), place, {-0.125, -0.9, -0.25}, {0.125, 0.9, 2.9});
        const World hole = shot(wall, place.at, place.along, {0});
        EXPECT_LT(free_way(wall, place.at - place.along * 1.25, place.along, side_of(place)).reach(2.5), 1);
        for (const double way : {1.0, -1.0}) {
            const Vec3 ahead = place.along * way, from = place.at - ahead * 1.25;
            if (free_way(hole, from, ahead, side_of(place)).reach(2.5) < 2.5) continue;
            Walk walk = stands(hole, from);
            walk.go(ahead * 2, 105);  // 75 ticks on flat ground
            EXPECT_GT(dot(walk.at() - place.at, ahead), 1.2) << way;
            EXPECT_TRUE(is_inside(hole, walk)) << way;
            ++through;
        }
    });
    EXPECT_GE(through, 1u);
}

// What lay loose and has become ground: the chunks of the blasts, put down as resting_solid() does.
TEST_P(PlayerCraters, OverRubbleThatHasBecomeGroundItClimbsOrStopsAndIsNeverHeld) {
    const std::vector<Chunk>& chunks = blasted_level(kBlastedLevels[level()]).chunks;
    std::size_t put = 0;
    at_places(kRun, 3, [&](const FloorPlace& place) {
        World rubble = world();
        std::size_t here = 0;
        for (const Chunk* chunk : chunks_of_size(chunks, 0.1, 0.6)) {
            if (here == 4) break;
            Pose pose;
            pose.rotation = random_turn(here + 1);
            const Vec3 middle = place.at + place.along * (0.5 * double(here) - 0.75) + Vec3{0, 0, 0.05};
            pose.position = middle - matrix_of(pose.rotation) * chunk->mass.centre;
            const Result<RestingSolid> rests = resting_solid(chunk->solid, pose);
            if (!rests) continue;
            const CarveResult made = fill(rubble, rests.value().cutter, rests.value().pose);
            if (!made.done()) continue;
            rubble = made.world;
            ++here;
        }
        if (here == 0) return;
        put += here;
        for (const double way : {1.0, -1.0}) {
            Walk walk = stands(rubble, place.at - place.along * (way * 1.7));
            for (int k = 0; k < 120 && dot(walk.at() - place.at, place.along) * way < 1.7; ++k)
                walk.move({.velocity = place.along * (way * 2), .jump = k > 60});
            EXPECT_TRUE(is_inside(rubble, walk)) << way;
            const Vec3 in = walk.at();
            walk.go(place.along * (way * -2), 30);
            EXPECT_GT(length(across(walk.at() - in)), 0.3) << way;  // back is the way it came
        }
    });
    EXPECT_GE(put, 2u);
}

}  // namespace
}  // namespace firma::test
