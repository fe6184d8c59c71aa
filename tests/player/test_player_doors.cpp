// SPDX-License-Identifier: MIT
// Players in the doorways of portals of the blasted depot and of a blasted map, whose doors shut on them and open
// again, with a capsule, a box and spheres.
#include <cmath>

#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

/// Under a portal that stands upright on a flat floor.
struct Doorway {
    PortalId portal;
    std::string name;
    Vec3 at;   ///< in the portal's plane, on the floor
    Vec3 way;  ///< unit, through it
};

class DoorwaySearch {
public:
    explicit DoorwaySearch(const World& level) : world_(level), outside_(reference::rooms_outside(level)) {}

    /// Those with a metre of room on both sides, at most so many.
    std::vector<Doorway> find(std::size_t count) const {
        std::vector<Doorway> found;
        for (std::uint32_t k = 0; k < portal_count(world_) && found.size() < count; ++k) {
            const std::optional<PortalInfo> portal = portal_info(world_, {k});
            if (portal->polygons == 0) continue;
            for (const int axis : {0, 1}) {
                if (portal->bounds.high[axis] != portal->bounds.low[axis]) continue;
                Doorway door{{k}, std::string(portal->name), (portal->bounds.low + portal->bounds.high) * 0.5, {}};
                door.at.z = portal->bounds.low.z;
                door.way[axis] = 1;
                if (is_good(door, *portal)) found.push_back(door);
            }
        }
        return found;
    }

private:
    bool is_good(const Doorway& door, const PortalInfo& portal) const {
        const PlayerShape wide = make_player_box({.radius = 0.35, .height = 1.85}).value();
        for (double far = -1.1; far < 1.15; far += 0.1) {
            const Vec3 feet = door.at + door.way * far;
            const Location middle = locate(world_, feet + Vec3{0, 0, 0.9});
            if (middle.where != Where::kAir || outside_[middle.room.value]) return false;
            if (!player_fits(world_, wide, feet + Vec3{0, 0, 0.002})) return false;
            const Hit floor = cast(world_, Ray{feet + Vec3{0, 0, 0.1}, {0, 0, -0.2}});
            if (!floor || floor.face_normal.z != 1 || std::fabs(floor.point.z - door.at.z) > 1e-9) return false;
        }
        const World shut = *set_portal_open(world_, door.portal, false);
        const Vec3 side{door.way.y, door.way.x, 0};
        for (double up = 0.05; up < 1.9; up += 0.2)
            for (double off = -0.5; off <= 0.5; off += 0.1) {
                const Vec3 from = door.at + side * off + Vec3{0, 0, up} - door.way * 0.2;
                const Hit hit = cast(shut, Ray{from, door.way * 0.4});
                if (std::fabs(off) < 0.35 && (!hit || hit.portal != door.portal)) return false;
            }
        return portal.open;
    }

    const World& world_;
    const std::vector<bool> outside_;
};

class PlayerDoors : public InPlayerLevels {
protected:
    /// At each of four doorways: the door, and the level with that shut.
    template <class Judge>
    void at_doors(const Judge& judge) const {
        static std::map<int, std::vector<Doorway>> all;
        const auto [found, is_new] = all.try_emplace(level());
        if (is_new) found->second = DoorwaySearch(world()).find(4);
        ASSERT_GE(found->second.size(), 2u);
        for (const Doorway& door : found->second) {
            SCOPED_TRACE("door " + std::to_string(door.portal.value) + ' ' + door.name);
            judge(door, *set_portal_open(world(), door.portal, false));
        }
    }
    static double beyond(const Doorway& door, const Walk& walk) { return dot(walk.at() - door.at, door.way); }
    static bool met_door(const Doorway& door, const Walk& walk) {
        const auto contacts = walk.last.contacts();
        return std::any_of(contacts.begin(), contacts.end(),
                           [&](const PlayerContact& contact) { return contact.portal == door.portal; });
    }
    /// A metre beyond, from where it is.
    static void goes_through(const Doorway& door, Walk& walk, double side) {
        for (int k = 0; k < 90 && beyond(door, walk) * side < 0.95; ++k) walk.go(door.way * (side * 2), 1);
        EXPECT_GE(beyond(door, walk) * side, 0.95);
        EXPECT_TRUE(is_inside(walk.world, walk));
    }
};
// In oa_koth1 portals are surfaces of water.
INSTANTIATE_TEST_SUITE_P(, PlayerDoors, testing::Combine(testing::Range(0, 2), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerDoors, OneThatShutsOnItPutsItToTheNearerSideAndOpensAgain) {
    at_doors([&](const Doorway& door, const World& shut) {
        for (const double off : {-0.29, -0.2, -0.05, 0.05, 0.2, 0.29}) {
            SCOPED_TRACE(std::to_string(off) + " m beyond");
            const double side = off < 0 ? -1 : 1;
            Walk walk = stands(world(), door.at + door.way * off);
            walk.world = shut;
            walk.wait(1);
            EXPECT_FALSE(walk.player.stuck);
            EXPECT_NEAR(beyond(door, walk), side * (0.3 + kOffset), 1e-6);
            EXPECT_NEAR(length(walk.last.pushed), 0.3 + kOffset - std::fabs(off), 1e-6);
            EXPECT_TRUE(is_inside(shut, walk));
            EXPECT_EQ(walk.player.room, locate(shut, door.at + door.way * (side * 0.1) + Vec3{0, 0, 0.9}).room);
            // It holds, whoever runs or jumps against it.
            for (int k = 0; k < 60; ++k) {
                walk.move({.velocity = door.way * (side * -4), .jump = k % 20 == 10});
                EXPECT_NEAR(beyond(door, walk), side * (0.3 + kOffset), kOffset / 2) << k;
                EXPECT_TRUE(met_door(door, walk)) << k;
            }
            walk.world = world();
            goes_through(door, walk, -side);
        }
    });
}

TEST_P(PlayerDoors, WhoMayNotBePutThatFarIsStuckUntilItOpens) {
    at_doors([&](const Doorway& door, const World& shut) {
        Walk walk = stands(world(), door.at);
        walk.rules.max_push = 0.25;
        const Vec3 at = walk.at();
        walk.world = shut;
        for (int k = 0; k < 30; ++k) {
            walk.move({.velocity = door.way * (k < 15 ? 2.0 : -2.0), .jump = k % 10 == 5});
            EXPECT_TRUE(walk.player.stuck) << k;
            EXPECT_EQ(walk.at(), at) << k;
            EXPECT_EQ(walk.player.velocity, Vec3()) << k;
        }
        EXPECT_FALSE(player_fits(shut, walk.shape, walk.at()));
        walk.world = world();
        walk.wait(1);
        EXPECT_FALSE(walk.player.stuck);
        EXPECT_LT(length(across(walk.at() - at)), 1e-9);
        goes_through(door, walk, 1);
    });
}

// Rock before and behind it, so that there is no room beside the door: it comes out beyond the rock.
TEST_P(PlayerDoors, OneThatShutsBetweenRockPutsItWhereThereIsRoom) {
    at_doors([&](const Doorway& door, const World&) {
        World rock = world();
        for (const double side : {1.0, -1.0}) {
            const FloorPlace place{door.at, door.way, 1};
            rock = block_at(rock, place, {side < 0 ? -0.5 : 0.35, -0.9, -0.25}, {side < 0 ? -0.35 : 0.5, 0.9, 2});
        }
        Walk walk = stands(rock, door.at);
        walk.go(door.way * 2, 20);
        EXPECT_LT(beyond(door, walk), 0.06);
        walk.world = *set_portal_open(rock, door.portal, false);
        walk.wait(1);
        EXPECT_FALSE(walk.player.stuck);
        EXPECT_GT(length(walk.last.pushed), 0.3);
        EXPECT_LT(length(walk.last.pushed), 2.5);
        EXPECT_TRUE(is_inside(walk.world, walk));
        walk.wait(60);
        EXPECT_TRUE(walk.player.on_ground);
        EXPECT_TRUE(is_inside(walk.world, walk));
    });
}

TEST_P(PlayerDoors, OneThatOpensAndShutsUnderWayLetsItThroughInTheEnd) {
    at_doors([&](const Doorway& door, const World& shut) {
        std::size_t pushed = 0;
        for (const int ticks : {2, 3, 5, 8, 13})
            for (const double side : {1.0, -1.0}) {
                SCOPED_TRACE(std::to_string(ticks) + " ticks, way " + std::to_string(side));
                Walk walk = stands(world(), door.at - door.way * side);
                for (int k = 0; k < 60; ++k) {
                    walk.world = k / ticks % 2 ? shut : world();
                    walk.go(door.way * (side * 3), 1);
                    EXPECT_FALSE(walk.player.stuck) << k;
                    EXPECT_TRUE(is_inside(walk.world, walk)) << k;
                    EXPECT_LT(length(walk.last.pushed), 0.31) << k;
                    pushed += length(walk.last.pushed) > 0.01;
                    if (std::fabs(beyond(door, walk)) > 1) break;
                }
                walk.world = world();
                goes_through(door, walk, side);
            }
        EXPECT_GE(pushed, 3u);
    });
}

}  // namespace
}  // namespace firma::test
