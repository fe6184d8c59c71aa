// SPDX-License-Identifier: MIT
// Players in worlds that are cut, filled, undone and shut around them, and in real levels.
#include <algorithm>
#include <cmath>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/brush/depot_level.h"
#include "tests/carve/cutters.h"
#include "tests/openarena_maps.h"
#include "tests/player/player_walk.h"
#include "tests/reference/judge_players.h"
#include "tests/reference/rooms_outside.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma::test {
namespace {

World cut_at(const World& world, CutterShape shape, const Vec3& at, double size, std::uint64_t seed = 1) {
    const CarveResult made = carve(world, make_crater(shape, seed), pose_at(at.x, at.y, at.z, size));
    EXPECT_TRUE(made.done());
    return made.world;
}
World fill_at(const World& world, CutterShape shape, const Vec3& at, double size) {
    const CarveResult made = fill(world, make_crater(shape, 1), pose_at(at.x, at.y, at.z, size));
    EXPECT_TRUE(made.done());
    return made.world;
}

/// Of eight ways, each gone carefully for a fifth of a second.
Walk farthest_of_eight(const Walk& walk) {
    Walk best = walk;
    for (int k = 0; k < 8; ++k) {
        const double angle = k * 0.7853981633974483;
        Walk one = walk;
        one.with({.velocity = Vec3{std::cos(angle), std::sin(angle), 0} * 2, .careful = true}, 12);
        if (length(one.at() - walk.at()) > length(best.at() - walk.at())) best = one;
    }
    return best;
}

class PlayerWorlds : public testing::TestWithParam<int> {
protected:
    Walk walk(const World& world, const Vec3& feet) const {
        return Walk(world, player_shapes()[std::size_t(GetParam())], feet);
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerWorlds, testing::Values(0, 1, 2), name_of_player_shape);

TEST_P(PlayerWorlds, FallsWhenTheGroundIsCutAway) {
    Walk walk = this->walk(course(""), {0, 0, kOffset});
    walk.wait(30);
    walk.world = cut_at(walk.world, CutterShape::kBox, {0, 0, 0}, 2);
    walk.wait(1);
    EXPECT_FALSE(walk.player.on_ground);
    walk.wait(90);
    EXPECT_TRUE(walk.player.on_ground);
    EXPECT_LT(walk.at().z, -1);
}

TEST_P(PlayerWorlds, ThroughCratersAndOverTheirRims) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        // Shallow: its sides can be walked, with steps.
        Walk walk = this->walk(cut_at(course(""), CutterShape::kRocky, {3, 0, 1.7}, 2, seed), {0, 0, kOffset});
        walk.go({4, 0, 0}, 120);
        EXPECT_GT(walk.at().x, 5.5) << seed;
        walk.go({-4, 0, 0}, 120);
        EXPECT_LT(walk.at().x, 0.5) << seed;
    }
}

TEST_P(PlayerWorlds, AlongTheRimOfADeepCraterItNeverSticks) {
    const World world = cut_at(course(""), CutterShape::kRocky, {0, 0, 0}, 3, 5);
    Walk walk = this->walk(world, {-3.6, 0, kOffset});
    walk.wait(2);
    // Around it, always against it. Where a notch of the rim stops who would go down nowhere, one of eight ways is
    // free.
    double round = 0;
    int held = 0;
    for (int k = 0; k < 2400 && round < 6.3; ++k) {
        const Vec3 from = walk.at(), in = across(from) * (-1 / length(across(from)));
        const Vec3 around{-in.y, in.x, 0};
        walk.with({.velocity = around * 2 + in, .careful = true}, 1);
        held = length(walk.at() - from) < 0.005 ? held + 1 : 0;
        if (held == 10) {
            walk = farthest_of_eight(walk);
            EXPECT_GT(length(walk.at() - from), 0.25) << k;
            held = 0;
        }
        round += dot(walk.at() - from, around) / length(across(from));
        if (k % 60 == 59) {
            EXPECT_GT(walk.at().z, -0.7) << k;
        }
    }
    // A box comes to a notch out of which the farthest way leads back.
    EXPECT_GE(round, GetParam() == 1 ? 2 : 6.283) << "radians";
}

TEST_P(PlayerWorlds, AtTheEdgeOfAFreshHoleItStandsOrFallsAndNothingElse) {
    // A thin floor over a cellar; a hole beside the player.
    const World floor = brush_world(map_text::box({-16, -16, -0.25}, {16, 16, 0}, "rock") +
                                    map_text::box({-16, -16, -8}, {16, 16, -4}, "rock"));
    scenes::Rng rng(7);
    int fell = 0, stood = 0;
    for (int k = 0; k < 40; ++k) {
        Walk walk = this->walk(floor, {0, 0, kOffset});
        walk.wait(5);
        const double far = rng.uniform(0.1, 1.5);
        const Vec3 hole{far, rng.uniform(-0.3, 0.3), 0};
        walk.world = cut_at(floor, CutterShape(k % 2), hole, 1, rng.next());
        walk.wait(150);
        EXPECT_TRUE(walk.player.on_ground) << k;
        // On the floor it is where it was; below it, it fell by the hole, which is where it is.
        const bool below = walk.at().z < -2;
        (below ? fell : stood)++;
        const Vec3 at = walk.at();
        walk.wait(30);
        EXPECT_EQ(walk.at(), at) << k;
        EXPECT_TRUE(below || walk.at().z > -0.45) << k << ' ' << walk.at().z;
        if (below) {
            EXPECT_NEAR(walk.at().z, -4 + kOffset, 1e-4);
        }
    }
    EXPECT_GT(fell, 3);
    EXPECT_GT(stood, 3);
}

TEST_P(PlayerWorlds, OutOfWhatIsFilledInAroundIt) {
    for (const double size : {0.4, 1.0, 2.0}) {
        Walk walk = this->walk(course(""), {0, 0, kOffset});
        walk.wait(5);
        walk.world = fill_at(walk.world, CutterShape::kRocky, {0.1, 0, 0.9}, size);
        walk.wait(1);
        EXPECT_FALSE(walk.player.stuck);
        EXPECT_GT(length(walk.last.pushed), 0.01);
        EXPECT_LT(length(walk.last.pushed), size * 2 + 0.5) << size;
        walk.wait(120);
        EXPECT_TRUE(walk.player.on_ground);
    }
}

TEST_P(PlayerWorlds, AnUndoneTunnelPutsItBackIntoTheRoomItCameFrom) {
    // A room of 8 m in endless rock.
    const World room = make_world(box_level({-4, -4, 0}, {4, 4, 4}, true)).value();
    Walk walk = this->walk(room, {0, 0, kOffset});
    walk.world = cut_at(room, CutterShape::kBox, {4, 0, 1.5}, 2);
    walk.go({4, 0, 0}, 120);
    ASSERT_GT(walk.at().x, 4.5);
    walk.world = room;
    walk.wait(1);
    EXPECT_FALSE(walk.player.stuck);
    EXPECT_LT(walk.at().x, 4 - 0.3);
    EXPECT_GT(length(walk.last.pushed), 0.5);
}

TEST_P(PlayerWorlds, NeverOutOfTheLevelThroughAThinWall) {
    // Walls of 0.2 m around a room: a hole in one is undone while the player stands in it, nearer to the outside.
    const World house = brush_world(
        map_text::box({-4, -4, -1}, {4, 4, 0}, "rock") + map_text::box({-4, -4, 0}, {-3.8, 4, 3}, "rock") +
        map_text::box({3.8, -4, 0}, {4, 4, 3}, "rock") + map_text::box({-3.8, -4, 0}, {3.8, -3.8, 3}, "rock") +
        map_text::box({-3.8, 3.8, 0}, {3.8, 4, 3}, "rock") + map_text::box({-4, -4, 3}, {4, 4, 4}, "rock"));
    ASSERT_EQ(house.room_count(), 2u);
    const World open = cut_at(house, CutterShape::kBox, {4, 0, 1.5}, 1.4);
    for (const double x : {3.55, 3.7, 3.9, 3.98}) {
        Walk walk = this->walk(open, {0, 0, kOffset});
        walk.wait(2);
        walk.player.position = {x, 0, 0.2};
        walk.world = house;
        walk.wait(1);
        EXPECT_FALSE(walk.player.stuck) << x;
        EXPECT_FALSE(reference::rooms_outside(house)[walk.player.room.value]) << x;
        EXPECT_LT(walk.at().x, 3.8 - 0.3) << x;
    }
}

// A hollow in rock, as far away and as large as said, in a direction at random.
TEST_P(PlayerWorlds, DeepInRockItIsPutIntoAHollowWhereverThatIs) {
    const World rock = brush_world(map_text::box({-16, -16, -16}, {16, 16, 16}, "rock"));
    scenes::Rng rng(5);
    for (int k = 0; k < 60; ++k) {
        const double far = rng.uniform(1, 3.2);
        const Vec3 hollow = rng.direction() * far;
        const TriangleMesh room = box_mesh({-0.4, -0.4, -0.1}, {0.4, 0.4, 1.9});
        const CarveResult made = carve(rock, room.cutter().value(), pose_at(hollow.x, hollow.y, hollow.z, 1));
        ASSERT_TRUE(made.done());
        Walk walk = this->walk(made.world, {0, 0, 0});
        walk.wait(1);
        EXPECT_FALSE(walk.player.stuck) << k << ": " << hollow.x << ' ' << hollow.y << ' ' << hollow.z;
        EXPECT_LT(length(walk.at() - hollow), 0.3) << k;
        EXPECT_LE(length(walk.last.pushed), walk.rules.max_push) << k;
    }
}

TEST_P(PlayerWorlds, TooDeepInItIsStuckUntilThereIsRoom) {
    const World before = course("");
    Walk walk = this->walk(before, {0, 0, kOffset});
    walk.wait(2);
    World under = before;
    for (int k = 0; k < 8; ++k)
        under = fill_at(under, CutterShape::kBox, {(k % 2) * 8.0 - 4, (k / 2 % 2) * 8.0 - 4, (k / 4) * 8.0 + 3}, 5);
    walk.world = under;
    walk.rules.max_push = 1;
    const Vec3 at = walk.at();
    walk.go({3, 0, 0}, 30);
    EXPECT_TRUE(walk.player.stuck);
    EXPECT_EQ(walk.at(), at);
    walk.world = before;
    walk.go({3, 0, 0}, 30);
    EXPECT_FALSE(walk.player.stuck);
    EXPECT_GT(walk.at().x, 1);
}

TEST_P(PlayerWorlds, AShutDoorHoldsItAndOneThatShutsOnItPutsItAside) {
    LevelPortal door;
    door.polygons.emplace_back();
    for (const Vec3& corner : {Vec3{0, -2, 0}, Vec3{0, 2, 0}, Vec3{0, 2, 4}, Vec3{0, -2, 4}})
        door.polygons[0].push_back(*snap(corner));
    const World open = make_divided_world(box_level({-4, -2, 0}, {4, 2, 4}, true), {&door, 1}).value();
    const World shut = *set_portal_open(open, {0}, false);
    Walk walk = this->walk(shut, {-2, 0, kOffset});
    walk.go({3, 0, 0}, 60);
    EXPECT_NEAR(walk.at().x, -0.3 - kOffset, 1e-4);
    ASSERT_TRUE(walk.met(ContactKind::kWall));
    walk.world = open;
    walk.go({3, 0, 0}, 10);
    EXPECT_GT(walk.at().x, -0.2);
    EXPECT_LT(walk.at().x, 0.3);
    walk.world = shut;
    walk.wait(1);
    EXPECT_FALSE(walk.player.stuck);
    EXPECT_GE(std::fabs(walk.at().x), 0.3);
}

// PhysX's #400: a capsule stuck in small pits between the humps of a detailed mesh.
TEST_P(PlayerWorlds, OverPitsAndHumpsOfADetailedMesh) {
    // Ground of small triangles, up and down by 12 cm every 20 cm, at random: steeper than can be walked.
    Level level = empty_level();
    scenes::Rng rng(11);
    constexpr int kSide = 40;
    constexpr double kCell = 0.2;
    std::vector<Vec3> grid;
    for (int x = 0; x <= kSide; ++x)
        for (int y = 0; y <= kSide; ++y) {
            const bool rim = x == 0 || y == 0 || x == kSide || y == kSide;
            grid.push_back({x * kCell, (y - kSide / 2) * kCell, rim ? 0 : rng.uniform(-0.12, 0.12)});
        }
    const auto at = [&](int x, int y) { return grid[std::size_t(x * (kSide + 1) + y)]; };
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y) {
            add_polygon(level, {at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            add_polygon(level, {at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    const World world = make_world(level).value();
    Walk walk = this->walk(world, {1, 0, 0.3});
    walk.wait(60);
    const double from = walk.at().x;
    walk.go({3, 0, 0}, 100);
    EXPECT_GT(walk.at().x, from + 4);  // 5 m would be on flat ground
}

// docs/players.md: what moves along a one-sided face passes its rim.
TEST_P(PlayerWorlds, LevelIntoTheRimOfASheetItGoesOn) {
    Level level = empty_level();
    add_polygon(level, {{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}});
    add_polygon(level, {{1, -2, 0.6}, {3, -2, 0.6}, {3, 2, 0.6}, {1, 2, 0.6}});
    const World world = make_world(level).value();
    const PlayerShape shape = player_shapes()[std::size_t(GetParam())];
    Player player;
    player.position = {0, 0, kOffset};
    for (int k = 0; k < 60; ++k) player = move_player(world, shape, player, {.velocity = {2, 0, 0}}, 1.0 / 60).player;
    EXPECT_GT(player.position.x, 1.5);
    EXPECT_FALSE(player_fits(world, shape, player.position));
}

// docs/players.md: through one-sided faces from behind; half through it meets edges of those that its way leads into.
TEST_P(PlayerWorlds, ThroughASheetFromBehindItGoesOn) {
    Level level = empty_level();
    add_polygon(level, {{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}});
    for (const double side : {-1, 0}) {  // folded along x = 1, y = 0; its front is toward +x
        const Vec3 from{side < 0 ? 1.4 : 1, side * 4, 0}, to{side < 0 ? 1 : 1.4, side * 4 + 4, 0}, up{0, 0, 3};
        add_polygon(level, {from, to, to + up, from + up});
    }
    Walk walk = this->walk(make_world(level).value(), {0.3, -1, kOffset});
    walk.passes_sheets = true;
    while (walk.at().x < 0.85) walk.go({2, 0, 0}, 1);
    walk.player.velocity = {};
    walk.go({0, 2, 0}, 60);
    const bool is_box = GetParam() == 1;
    EXPECT_NEAR(walk.at().y, is_box ? -0.3 : 0.9, 0.2);  // a box is held by the fold, what is round goes around it
    walk.go({2, 0, 0}, 60);
    EXPECT_GT(walk.at().x, 2);
    walk.go({-2, 0, 0}, 120);
    EXPECT_GT(walk.at().x, 1.3);
}

TEST_P(PlayerWorlds, AtAnySpeedItPassesNoWall) {
    const World room = make_world(box_level({-4, -4, 0}, {4, 4, 4}, true)).value();
    scenes::Rng rng(3);
    for (int k = 0; k < 200; ++k) {
        Walk walk = this->walk(room, {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.1, 2)});
        const double speed = std::pow(10.0, rng.uniform(1, 4));
        walk.player.velocity = rng.direction() * speed;
        walk.wait(3);
        EXPECT_FALSE(walk.player.stuck);
    }
}

TEST_P(PlayerWorlds, InTheDepotAndMapsWithRandomWishesWhileTheyAreBlasted) {
    const auto judge = [&](const World& world, std::uint64_t seed) {
        reference::PlayerRun run;
        run.frames = sample(3000);
        run.seed = seed;
        const PlayerShape shape = player_shapes()[std::size_t(GetParam())];
        const reference::PlayerVerdict verdict = reference::judge_player(world, shape, run);
        EXPECT_EQ(verdict.fault, "");
        EXPECT_GT(verdict.cuts + verdict.fills, sample(3000) == 3000 ? 3u : 0u);
        EXPECT_GT(verdict.travelled, 10);
        EXPECT_GT(verdict.tried, 3u);
    };
    judge(make_world(depot_level()).value(), 21);
    for (const auto& map : openarena_maps())
        if (map.stem() == "kaos2" || map.stem() == "oa_koth1")
            judge(make_world(read_brush_level(map.string()).value()).value(), 22);
}

/// Where players begin in a level.
std::vector<Vec3> spawns(const BrushLevel& level) {
    std::vector<Vec3> places;
    for (const Entity& entity : level.entities)
        for (const auto& [key, value] : entity.keys)
            if (key == "classname" && value.rfind("info_player", 0) == 0)
                if (const auto origin = entity_origin(level, entity)) places.push_back(*origin);
    return places;
}

void walk_from_spawns(const BrushLevel& level, std::size_t most) {
    const World world = make_world(level).value();
    const PlayerShape shape = make_player_capsule().value();
    std::size_t walked = 0;
    for (const Vec3& place : spawns(level)) {
        if (walked == most) break;
        Walk walk(world, shape, place + Vec3{0, 0, -0.7});
        walk.wait(90);
        ASSERT_FALSE(walk.player.stuck) << level.name << ' ' << place.x << ' ' << place.y << ' ' << place.z;
        EXPECT_TRUE(walk.player.on_ground) << level.name << ' ' << place.x << ' ' << place.y << ' ' << place.z;
        const Player begun = walk.player;
        int far = 0;
        for (const Vec3& way : {Vec3{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.7, 0.7, 0}, {-0.7, 0.7, 0}}) {
            walk.player = begun;
            walk.go(way * 5, 120);
            far += length(walk.at() - begun.position) > 1.5;
        }
        EXPECT_GE(far, 2) << level.name << ' ' << place.x << ' ' << place.y << ' ' << place.z;
        ++walked;
    }
    EXPECT_GT(walked, 0u) << level.name;
}

TEST(PlayerLevels, FromTheDepotsStarts) {
    walk_from_spawns(depot_level(), 10);
}

TEST(PlayerLevels, FromStartsOfMaps) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    if (maps.empty()) GTEST_SKIP() << kNoOpenArena;
    for (const auto& map : maps)
        if (std::find(std::begin(kRoomMaps), std::end(kRoomMaps), map.stem().string()) != std::end(kRoomMaps))
            walk_from_spawns(read_brush_level(map.string()).value(), 4);
}

TEST(PlayerReplay, TheSameBitsFromACopyAtAnyPoint) {
    const World world = cut_at(course(stairs(2, 6, 0.4, 0.3)), CutterShape::kRocky, {0, 2, 0}, 1.5);
    Walk walk(world, make_player_capsule().value(), {0, 0, kOffset});
    const auto wish = [](int k) {
        PlayerWish w;
        w.velocity = {k % 90 < 60 ? 3.0 : -4.0, k % 50 < 20 ? 2.5 : -1.5, 0};
        w.jump = k % 37 == 0;
        w.crouch = k % 100 < 20;
        return w;
    };
    std::vector<Player> states;
    for (int k = 0; k < 400; ++k) {
        states.push_back(walk.player);
        walk.move(wish(k));
    }
    Player again = states[150];
    for (int k = 150; k < 400; ++k) {
        EXPECT_EQ(again.position, states[std::size_t(k)].position);
        EXPECT_EQ(again.velocity, states[std::size_t(k)].velocity);
        again = move_player(world, walk.shape, again, wish(k), 1.0 / 60).player;
    }
    EXPECT_EQ(again.position, walk.at());
}

}  // namespace
}  // namespace firma::test
