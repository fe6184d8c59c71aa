// SPDX-License-Identifier: MIT
// Players on foot: flat ground, slopes, steps, walls and corners, edges.
#include "tests/player/player_walk.h"

namespace firma::test {
namespace {

class PlayerWalks : public testing::TestWithParam<int> {
protected:
    Walk walk(const World& world, const Vec3& feet) const {
        return Walk(world, player_shapes()[std::size_t(GetParam())], feet);
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerWalks, testing::Values(0, 1, 2), name_of_player_shape);

TEST_P(PlayerWalks, FallsLandsAndStands) {
    Walk walk = this->walk(course(""), {0, 0, 5});
    double landed = 0;
    for (int k = 0; k < 90; ++k) landed = std::max(landed, walk.move({}).landed_speed);
    EXPECT_NEAR(landed, std::sqrt(2 * 9.81 * 5), 0.1);
    EXPECT_TRUE(walk.player.on_ground);
    EXPECT_NEAR(walk.at().z, kOffset, 1e-9);
    const Vec3 at = walk.at();
    walk.wait(60);
    EXPECT_EQ(walk.at(), at);
}

TEST_P(PlayerWalks, ReachesTheWishedSpeedAndKeepsIt) {
    Walk walk = this->walk(course(""), {0, 0, kOffset});
    walk.go({6, 0, 0}, 30);
    const Vec3 from = walk.at();
    walk.go({6, 0, 0}, 60);
    EXPECT_NEAR(walk.at().x - from.x, 6, 1e-9);
    EXPECT_EQ(walk.at().y, 0);
    EXPECT_NEAR(walk.at().z, kOffset, 1e-9);
    EXPECT_EQ(walk.airborne, 0u);
    walk.wait(30);
    EXPECT_EQ(walk.player.velocity, Vec3());
}

TEST_P(PlayerWalks, ALowerFrameRateGoesTheSameWay) {
    Walk fine = walk(course(""), {0, 0, kOffset}), coarse = fine;
    fine.rules.ground_acceleration = coarse.rules.ground_acceleration = 1e6;
    fine.wait(1);
    coarse.wait(1);
    coarse.seconds = 0.1;
    fine.go({3, 1, 0}, 60);
    coarse.go({3, 1, 0}, 10);
    EXPECT_NEAR(length(fine.at() - coarse.at()), 0, 1e-9);
}

TEST_P(PlayerWalks, UpAndDownASlopeWithTheWishedSpeedAlongIt) {
    for (const double height : {1.0, 2.0, 3.5}) {  // over 4 m: 14, 27 and 41 degrees
        Walk walk = this->walk(course(ramp(2, 6, height) + map_text::box({6, -4, -1}, {10, 4, height}, "rock")),
                               {0, 0, kOffset});
        walk.go({4, 0, 0}, 40);  // on the ramp by then
        const Vec3 from = walk.at();
        walk.go({4, 0, 0}, 15);
        EXPECT_NEAR(length(walk.at() - from), 1, 1e-6) << height;
        walk.go({4, 0, 0}, 75);
        EXPECT_NEAR(walk.at().z, height + kOffset, 1e-6) << height;
        walk.go({-4, 0, 0}, 130);
        EXPECT_NEAR(walk.at().z, kOffset, 2e-7) << height;
        EXPECT_EQ(walk.airborne, 0u) << height;
    }
}

TEST_P(PlayerWalks, StandsStillOnASlope) {
    Walk walk = this->walk(course(ramp(2, 10, 7)), {6, 0, 4});
    walk.wait(60);
    ASSERT_TRUE(walk.player.on_ground);
    const Vec3 at = walk.at();
    walk.wait(600);
    EXPECT_EQ(walk.at(), at);
}

TEST_P(PlayerWalks, ASteepSlopeIsAWall) {
    Walk walk = this->walk(course(ramp(2, 4, 3)), {0, 0, kOffset});  // 56 degrees
    walk.go({5, 0, 0}, 120);
    EXPECT_LT(walk.at().x, 2);
    EXPECT_LT(walk.at().z, 0.01);
    const double x = walk.at().x;
    walk.go({5, 2, 0}, 60);  // along its foot
    EXPECT_NEAR(walk.at().x, x, 1e-6);
    EXPECT_NEAR(walk.at().y, 2, 0.2);
}

TEST_P(PlayerWalks, SlidesDownASteepSlope) {
    Walk walk = this->walk(course(ramp(2, 6, 6)), {5, 0, 6});
    for (int k = 0; k < 240 && walk.at().z > 0.1; ++k) walk.move({.velocity = {5, 0, 0}});
    EXPECT_LT(walk.at().x, 2.2);
    EXPECT_LT(walk.at().z, 0.1);
}

TEST_P(PlayerWalks, JumpsAtASteepSlopeDoNotClimbIt) {
    Walk walk = this->walk(course(ramp(2, 6, 6)), {0, 0, kOffset});
    double highest = 0;
    for (int k = 0; k < 900; ++k) {
        walk.move({.velocity = {5, 0, 0}, .jump = true});
        highest = std::max(highest, walk.at().z);
    }
    EXPECT_LT(highest, 4.4 * 4.4 / 2 / 9.81 + 0.05);  // a jump from the ground
    EXPECT_LT(walk.at().x, 3);
}

TEST_P(PlayerWalks, UpStairsAtFullSpeedAndDownAgain) {
    for (const double height : {0.125, 0.1875, 0.3125, 0.4375}) {
        Walk walk = this->walk(course(stairs(2, 10, 0.4, height)), {0, 0, kOffset});
        walk.go({3, 0, 0}, 150);
        EXPECT_NEAR(walk.at().z, 10 * height + kOffset, 1e-6) << height;
        EXPECT_GT(walk.at().x, 6) << height;
        EXPECT_GE(walk.stepped, 4u) << height;
        walk.go({-3, 0, 0}, 160);
        EXPECT_NEAR(walk.at().z, kOffset, 2e-7) << height;
        EXPECT_EQ(walk.airborne, 0u) << height;
    }
}

// A sill under a lintel: raised by a whole step its head would meet that.
TEST_P(PlayerWalks, OverASillUnderALintelItGoesThrough) {
    for (const double sill : {0.03, 0.1, 0.2, 0.3, 0.4}) {
        for (const double room : {0.05, 0.1, 0.3}) {
            SCOPED_TRACE(std::to_string(sill) + " m, " + std::to_string(room) + " m over its head");
            const World door = course(map_text::box({0, -4, -1}, {0.5, 4, sill}, "rock") +
                                      map_text::box({0, -4, sill + 1.8 + room}, {0.5, 4, 4}, "rock"));
            for (const double askew : {0.0, 0.6}) {
                Walk walk = this->walk(door, {-1, 0, kOffset});
                walk.wait(5);
                walk.airborne = 0;
                walk.go({2, askew * 2, 0}, 75);
                EXPECT_GT(walk.at().x, 1) << askew;
                EXPECT_NEAR(walk.at().z, kOffset, 1e-6) << askew;
                EXPECT_EQ(walk.airborne, 0u) << askew;
            }
        }
        const World shut = course(map_text::box({0, -4, -1}, {0.5, 4, sill}, "rock") +
                                  map_text::box({0, -4, sill + 1.79}, {0.5, 4, 4}, "rock"));
        Walk walk = this->walk(shut, {-1, 0, kOffset});
        walk.go({2, 0, 0}, 75);
        EXPECT_LT(walk.at().x, 0) << sill;  // too low by a centimetre
    }
}

TEST_P(PlayerWalks, UpStairsAtAnySpeed) {
    for (const double speed : {0.05, 0.5, 10.0, 40.0}) {
        Walk walk = this->walk(course(stairs(1, 6, 0.3125, 0.3125)), {0, 0, kOffset});
        walk.rules.ground_acceleration = 1000;
        walk.go({speed, 0, 0}, int(3.5 / speed * 60) + 5);
        EXPECT_NEAR(walk.at().z, 1.875 + kOffset, 1e-6) << speed;
    }
}

TEST_P(PlayerWalks, UpStairsBesideAWallThatItPushesAgainst) {
    Walk walk = this->walk(course(stairs(2, 10, 0.4, 0.3125) + map_text::box({-4, 1, -1}, {12, 2, 8}, "rock")),
                           {0, 0.5, kOffset});
    walk.go({3, 1.5, 0}, 170);
    EXPECT_NEAR(walk.at().z, 3.125 + kOffset, 1e-6);
}

TEST_P(PlayerWalks, UpStairsThatRunAcross) {
    Walk walk = this->walk(course(stairs(2, 10, 0.4, 0.3125, 30)), {0, 0, kOffset});
    walk.go({2, 2, 0}, 260);
    EXPECT_NEAR(walk.at().z, 3.125 + kOffset, 1e-6);
}

TEST_P(PlayerWalks, AStepTooHighIsAWall) {
    Walk walk = this->walk(course(map_text::box({2, -4, -1}, {4, 4, 0.453125}, "rock")), {0, 0, kOffset});
    walk.go({4, 0, 0}, 120);
    EXPECT_LT(walk.at().x, 1.7);
    EXPECT_NEAR(walk.at().z, kOffset, 2e-7);
    EXPECT_TRUE(walk.met(ContactKind::kWall));
    walk.rules.step_height = 0.454;
    walk.go({4, 0, 0}, 30);
    EXPECT_NEAR(walk.at().z, 0.453125 + kOffset, 1e-6);
}

TEST_P(PlayerWalks, AStepUnderALowCeilingIsAWall) {
    Walk walk = this->walk(
        course(map_text::box({2, -4, -1}, {6, 4, 0.3}, "rock") + map_text::box({1, -4, 2}, {6, 4, 3}, "rock")),
        {0, 0, kOffset});
    walk.go({4, 0, 0}, 120);
    EXPECT_LT(walk.at().x, 2);
    EXPECT_LT(walk.at().z, 0.2);
    walk.go({-4, 0, 0}, 30);
    EXPECT_NEAR(walk.at().z, kOffset, 2e-7);
}

TEST_P(PlayerWalks, SlidesAlongAWallWithWhatIsLeft) {
    Walk walk = this->walk(course(map_text::box({2, -30, -1}, {3, 30, 4}, "rock")), {1.6, 0, kOffset});
    walk.go({3, 3, 0}, 30);
    const Vec3 from = walk.at();
    walk.go({3, 3, 0}, 60);
    EXPECT_NEAR(walk.at().y - from.y, 3, 1e-6);
    EXPECT_NEAR(walk.at().x, 2 - 0.3 - kOffset, 1e-5);
}

// Rapier's #627, with #418 and #611: characters got stuck at upright walls that they were walked against at an angle,
// and came nearer than their offset.
TEST_P(PlayerWalks, AgainstAWallAtAnyAngleItSlidesOnAndKeepsItsOffset) {
    for (int turned = 0; turned < 3; ++turned) {
        // The wall's way is no round number but for the first.
        const double lean = 0.37 * turned, size = std::sqrt(1 + lean * lean);
        const Vec3 normal = Vec3{-1, lean, 0} * (1 / size), along{normal.y, -normal.x, 0};
        const std::string wall = map_text::plane_brush(
            {{normal, -2}, {normal * -1.0, 3}, {along, 28}, {along * -1.0, 28}, {{0, 0, 1}, 4}, {{0, 0, -1}, 1}},
            "rock");
        for (const double degrees : {0.01, 1.0, 7.0, 20.0, 45.0, 70.0, 89.0}) {
            const double angle = degrees * 3.14159265358979 / 180;
            const Vec3 wish = (along * std::cos(angle) - normal * std::sin(angle)) * 4;
            Walk walk = this->walk(course(wall), normal * -1.0 + along * -8 + Vec3{0, 0, kOffset});
            const bool is_box = GetParam() == 1;
            const double reach = 0.3 * (is_box ? std::fabs(normal.x) + std::fabs(normal.y) : 1.0);
            walk.go(normal * -4.0, 60);
            walk.go(wish, 20);
            for (int k = 0; k < 120; ++k) {
                const double from = dot(walk.at(), along);
                walk.go(wish, 1);
                const double wished = 4 * std::cos(angle) / 60, gap = dot(walk.at(), normal) + 2 - reach;
                EXPECT_NEAR(dot(walk.at(), along) - from, wished, 0.01 * wished) << degrees << ' ' << k;
                // Less than the offset where it comes on by less than that in a tick, until it backs off; never none.
                EXPECT_GT(gap, 0) << degrees << ' ' << k;
                EXPECT_LT(gap, kOffset * 1.05) << degrees << ' ' << k;
            }
        }
    }
}

// A way shorter than the contact offset does not lead to the wall in a tick: it was gone, and backed off from again.
TEST_P(PlayerWalks, TowardAWallSlowerThanTheOffsetATickItStandsStillOrSlides) {
    const World world = course(map_text::box({2, -8, -1}, {3, 8, 4}, "rock"));
    for (const double speed : {1e-4, 0.01, 0.03, 0.059, 0.06, 0.1})
        for (const double angle : {0.0, 0.8, 1.4}) {
            Walk walk = this->walk(world, {1.6, 0, kOffset});
            walk.go({1, 0, 0}, 30);
            walk.go({speed, 0, 0}, 1);
            const Vec3 from = walk.at();
            EXPECT_NEAR(from.x, 2 - 0.3 - kOffset, 1e-6);
            for (int k = 1; k <= 120; ++k) {
                walk.go({speed * std::cos(angle), speed * std::sin(angle), 0}, 1);
                EXPECT_NEAR(walk.at().x, from.x, 1e-12) << speed << ' ' << angle << ' ' << k;
                EXPECT_NEAR(walk.at().y - from.y, speed * std::sin(angle) * k / 60, 1e-9) << speed << ' ' << angle;
            }
        }
}

TEST_P(PlayerWalks, TowardAWallSlowerThanTheOffsetATickItComesToTheOffset) {
    const World world = course(map_text::box({2, -8, -1}, {3, 8, 4}, "rock"));
    for (const double speed : {0.01, 0.03, 0.05}) {
        Walk walk = this->walk(world, {1.69, 0, kOffset});
        double last = walk.at().x;
        for (int k = 0; k < int(0.01 / speed * 60) + 30; ++k) {
            walk.go({speed, 0, 0}, 1);
            EXPECT_GE(walk.at().x, last) << speed << ' ' << k;
            last = walk.at().x;
        }
        EXPECT_NEAR(last, 2 - 0.3 - kOffset, 1e-9) << speed;
    }
}

TEST_P(PlayerWalks, IntoACornerItStopsStill) {
    Walk walk = this->walk(
        course(map_text::box({2, -8, -1}, {3, 8, 4}, "rock") + map_text::box({-8, 2, -1}, {2, 3, 4}, "rock")),
        {0, 0, kOffset});
    walk.go({4, 4, 0}, 120);
    const Vec3 at = walk.at();
    for (int k = 0; k < 300; ++k) walk.move({.velocity = {4, 3 + k * 0.01, 0}});
    EXPECT_LT(length(walk.at() - at), 1e-6);  // no jitter
    walk.go({-4, -4, 0}, 30);
    EXPECT_LT(walk.at().x, at.x - 1);
}

TEST_P(PlayerWalks, OutOfASharpCornerAlongEitherWall) {
    // Two walls that meet at 20 degrees: x and a plane through the same line.
    const double slope = std::tan(20 * 3.14159265358979 / 180);
    const Vec3 normal = Vec3{slope, -1, 0} * (1 / length(Vec3{slope, -1, 0}));
    const std::string wedge = map_text::plane_brush(
        {{normal, -normal.x * 0}, {{0, 0, 1}, 4}, {{0, 0, -1}, 1}, {{1, 0, 0}, 12}, {{-1, 0, 0}, 0}, {{0, 1, 0}, 8}},
        "rock");
    Walk walk = this->walk(course(wedge + map_text::box({-1, -1, -1}, {12, 0, 4}, "rock")), {8, 1.2, kOffset});
    walk.go({-4, 0, 0}, 240);
    const Vec3 in = walk.at();
    walk.go({-4, -0.1, 0}, 60);
    EXPECT_LT(length(walk.at() - in), 1e-3);
    walk.go({4, 0, 0}, 60);
    EXPECT_GT(walk.at().x, in.x + 3);
}

TEST_P(PlayerWalks, NoSeamBetweenFlatFacesHoldsIt) {
    std::string tiles;
    for (int x = 0; x < 12; ++x)
        for (int y = -2; y < 2; ++y)
            tiles += map_text::box({x * 0.7, y * 0.9, -1}, {(x + 1) * 0.7, (y + 1) * 0.9, 0.25}, "rock");
    Walk walk = this->walk(course(tiles), {0.4, 0, 0.25 + kOffset});
    walk.rules.step_height = 0.4;
    walk.go({5, 0.3, 0}, 20);
    const double x = walk.at().x;
    walk.go({5, 0.3, 0}, 60);
    EXPECT_NEAR(walk.at().x - x, 5, 1e-9);
    EXPECT_NEAR(walk.at().z, 0.25 + kOffset, 1e-9);
}

// Jolt's #1860: jitter where a slope and a floor meet, over the crest here, and in the fold below.
TEST_P(PlayerWalks, FromASlopeOntoAFloorWithoutJitter) {
    Walk walk = this->walk(course(ramp(2, 6, 2) + map_text::box({6, -4, -1}, {12, 4, 2}, "rock")), {5.8, 0, 2.5});
    walk.wait(60);
    walk.airborne = 0;
    double last = walk.at().z;
    for (int k = 0; k < 240; ++k) {  // slowly over the crest: it rises or stays, and never hops
        walk.go({0.5, 0, 0}, 1);
        EXPECT_GE(walk.at().z, last - 1e-6) << k;
        last = walk.at().z;
    }
    EXPECT_NEAR(walk.at().z, 2 + kOffset, 1e-6);
    EXPECT_EQ(walk.airborne, 0u);
    const Vec3 at = walk.at();
    walk.wait(120);
    EXPECT_LT(length(walk.at() - at), 1e-9);
}

TEST_P(PlayerWalks, WhereAFloorMeetsASlopeItGoesBothWaysWithoutJitter) {
    for (const double speed : {0.2, 1.0, 4.0}) {
        Walk walk = this->walk(course(ramp(2, 6, 2)), {1.2, 0, kOffset});
        walk.wait(30);
        for (const double way : {1.0, -1.0, 1.0, -1.0}) {
            walk.airborne = 0;
            const int ticks = int(1.6 / speed * 60);
            double last = walk.at().z;
            for (int k = 0; k < ticks; ++k) {
                walk.go({way * speed, 0, 0}, 1);
                // Up going there, down coming back, never the other way.
                if (k > 10) {  // it has turned round by then
                    EXPECT_GE((walk.at().z - last) * way, -1e-6) << speed << ' ' << way << ' ' << k;
                }
                last = walk.at().z;
            }
            EXPECT_EQ(walk.airborne, 0u) << speed;
        }
        // In the fold it stands still.
        walk.go({1, 0, 0}, int((2 - walk.shape.radius() * 0.4 - walk.at().x) * 60));
        walk.wait(20);
        const Vec3 at = walk.at();
        walk.wait(120);
        EXPECT_LT(length(walk.at() - at), 1e-9);
    }
}

TEST_P(PlayerWalks, OverTheEdgeOfALedgeItFalls) {
    Walk walk = this->walk(course(map_text::box({-4, -4, -1}, {2, 4, 4}, "rock")), {0, 0, 4 + kOffset});
    walk.go({2, 0, 0}, 200);
    EXPECT_GT(walk.at().x, 2.3);
    EXPECT_NEAR(walk.at().z, kOffset, 2e-7);
    EXPECT_GT(walk.airborne, 20u);
}

TEST_P(PlayerWalks, ACarefulPlayerStaysOnALedgeAndWalksAlongIt) {
    Walk walk = this->walk(course(map_text::box({-4, -20, -1}, {2, 20, 4}, "rock")), {0, 0, 4 + kOffset});
    walk.with({.velocity = {2, 1, 0}, .careful = true}, 300);
    EXPECT_NEAR(walk.at().z, 4 + kOffset, 0.3);
    EXPECT_GT(walk.at().y, 3);
    EXPECT_LT(walk.at().x, 2.3);
    walk.with({.velocity = {2, 1, 0}}, 60);
    EXPECT_LT(walk.at().z, 3);
}

}  // namespace
}  // namespace firma::test
