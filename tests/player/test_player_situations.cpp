// SPDX-License-Identifier: MIT
// Players on foot in the blasted depot and in blasted maps, each situation at places that are found there, with a
// capsule, a box and spheres.
#include <cmath>

#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerSituations : public InPlayerLevels {};
INSTANTIATE_TEST_SUITE_P(, PlayerSituations, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerSituations, OverSeamsItArrivesWhereAStraightWalkDoes) {
    std::size_t most = 0;
    at_places(kSquare, 4, [&](const FloorPlace& place) {
        most = std::max(most, place.faces);
        for (int k = 0; k < 8; ++k) {
            const SineCosine turn = sine_cosine(k * 45 * kDegree);
            const Vec3 way{turn.cosine, turn.sine, 0};
            Walk walk = stands(world(), place.at);
            const Vec3 from = walk.at();
            walk.go(way * 2, 30);
            EXPECT_LT(length(walk.at() - (from + way)), 1e-6) << k;
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << k;
            EXPECT_EQ(walk.airborne, 0u) << k;
            walk.wait(1);
            const Vec3 rests = walk.at();
            walk.wait(30);
            EXPECT_EQ(walk.at(), rests) << k;
        }
    });
    EXPECT_GE(most, 2u) << "none has a seam";
}

TEST_P(PlayerSituations, AlongAWallItSlidesByTheShareOfTheAngle) {
    at_walls(false, [&](const WallPlace& place) {
        for (int degrees = 10; degrees <= 80; degrees += 10)
            for (const double side : {1.0, -1.0}) {
                const SineCosine turn = sine_cosine(degrees * kDegree);
                const Vec3 along = place.along * side, wish = (along * turn.cosine - place.normal * turn.sine) * 2;
                Walk walk = stands(world(), place.foot + place.normal * 0.4 - along * 0.7);
                walk.go(place.normal * -2.0, 10);
                walk.go(wish, 2);
                for (int k = 0; k < 36; ++k) {
                    const double from = dot(walk.at(), along);
                    walk.go(wish, 1);
                    const double share = 2 * turn.cosine / 60, gap = dot(walk.at() - place.foot, place.normal) - 0.3;
                    EXPECT_NEAR(dot(walk.at(), along) - from, share, 0.01 * share) << degrees << ' ' << k;
                    EXPECT_GT(gap, 0) << degrees << ' ' << k;
                    EXPECT_LT(gap, kOffset * 1.05) << degrees << ' ' << k;
                }
                EXPECT_EQ(walk.airborne, 0u) << degrees;
            }
    });
}

TEST_P(PlayerSituations, InACornerOfTwoWallsItStandsAndLeavesIt) {
    at_walls(true, [&](const WallPlace& place) {
        const Vec3 out = place.normal + place.along;
        Walk walk = stands(world(), place.foot + out * 0.6);
        walk.go(out * -2.0, 40);
        const Vec3 in = walk.at();
        EXPECT_NEAR(dot(in - place.foot, place.normal), 0.3 + kOffset, 1e-4);
        EXPECT_NEAR(dot(in - place.foot, place.along), 0.3 + kOffset, 1e-4);
        for (int k = 0; k < 120; ++k) {
            walk.go(place.normal * -3.0 - place.along * (0.5 + k * 0.05), 1);
            EXPECT_LT(length(walk.at() - in), 1e-6) << k;
        }
        walk.go(place.along, 30);
        EXPECT_NEAR(dot(walk.at() - in, place.along), 0.5, 0.01);
    });
}

TEST_P(PlayerSituations, InACornerOfThreePlanesItStands) {
    at_walls(true, [&](const WallPlace& place) {
        // What fills the corner up to a plane that leans back by 20 degrees.
        const Vec3 flat = (place.normal + place.along) * std::sqrt(0.5);
        const SineCosine lean = sine_cosine(20 * kDegree);
        const Vec3 normal = flat * lean.cosine + Vec3{0, 0, lean.sine}, across = cross({0, 0, 1}, flat);
        const TurnMatrix turn = matrix_of(turn_of_axes(normal * -1.0, across, cross(normal * -1.0, across)));
        TriangleMesh mesh = box_mesh({0, -0.6, -0.5}, {0.5, 0.6, 0.5});
        for (Vec3& v : mesh.vertices) v = turn * v;
        const World filled = edited_at(world(), {place.foot + flat * 0.25, {1, 0, 0}, 1}, mesh, CarveKind::kFill);
        for (const bool first : {true, false}) {
            const Vec3 wall = first ? place.normal : place.along, along = first ? place.along : place.normal;
            Walk walk = stands(filled, place.foot + wall * 0.36 + along * 1.05);
            walk.go(along * -2.0 - wall, 100);
            const Vec3 in = walk.at();
            EXPECT_NEAR(in.z, place.foot.z + kOffset, 1e-3);
            EXPECT_LT(dot(in - place.foot, along), 1.0);
            for (int k = 0; k < 60; ++k) {
                walk.go(along * -2.0 - wall * (0.5 + k * 0.02), 1);
                EXPECT_LT(length(walk.at() - in), 1e-5) << first << ' ' << k;
            }
            walk.go(along * 2, 6);
            EXPECT_GT(dot(walk.at() - in, along), 0.15) << first;
        }
    });
}

TEST_P(PlayerSituations, AJumpReachesItsHeightAndLandsAsHighAsItBegan) {
    at_places(kRun, 3, [&](const FloorPlace& place) {
        for (const double speed : {0.0, 1.5, -1.5}) {
            Walk walk = stands(world(), place.at - place.along * (speed * 0.45));
            walk.move({.velocity = place.along * speed, .jump = true});
            const Vec3 from = place.at - place.along * (speed * 0.45);
            double top = 0, landed = 0;
            int ticks = 1;
            for (; ticks < 120 && !walk.player.on_ground; ++ticks) {
                landed = walk.move({.velocity = place.along * speed}).landed_speed;
                top = std::max(top, walk.at().z - place.at.z);
            }
            EXPECT_NEAR(top, 4.4 * 4.4 / (2 * 9.81), 0.01) << speed;
            EXPECT_NEAR(ticks, 60 * 2 * 4.4 / 9.81, 1.5) << speed;
            EXPECT_NEAR(landed, 4.4, 0.2) << speed;
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << speed;
            EXPECT_NEAR(dot(walk.at() - from, place.along), speed * ticks / 60, 0.03) << speed;
        }
    });
}

TEST_P(PlayerSituations, UnderALowSlabItStaysCrouchedAndStandsUpBeyond) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        const World low = block_at(world(), place, {-0.5, -0.875, 1.375}, {0.5, 0.875, 2});
        Walk walk = stands(low, place.at - place.along * 1.5);
        walk.go(place.along * 2, 60);
        EXPECT_LT(dot(walk.at() - place.at, place.along), -0.79);  // upright it does not go below
        walk.with({.velocity = place.along * 2, .crouch = true}, 48);
        EXPECT_NEAR(dot(walk.at() - place.at, place.along), 0, 0.08);
        for (int k = 0; k < 20; ++k) {
            walk.wait(1);
            EXPECT_TRUE(walk.player.crouched) << k;
        }
        walk.go(place.along * 2, 60);
        EXPECT_GT(dot(walk.at() - place.at, place.along), 0.79);
        EXPECT_FALSE(walk.player.crouched);
        EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
    });
}

TEST_P(PlayerSituations, AStepOfACratesHeightIsClimbedAHigherOneNot) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        for (const double height : {0.25, 0.4375, 0.5}) {
            const World step = block_at(world(), place, {0, -0.875, -0.25}, {2, 0.875, height});
            Walk walk = stands(step, place.at - place.along);
            walk.go(place.along * 2, 60);
            const bool is_low = height < 0.45;
            EXPECT_EQ(walk.stepped > 0, is_low) << height;
            EXPECT_NEAR(walk.at().z, place.at.z + (is_low ? height : 0) + kOffset, 1e-6) << height;
            EXPECT_NEAR(dot(walk.at() - place.at, place.along), is_low ? 1 : -0.3 - kOffset,
                        is_low ? 0.025 : 1e-4);  // round feet go up around the edge
            walk.go(place.along * -2.0, 60);
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << height;
            EXPECT_EQ(walk.airborne, 0u) << height;
        }
    });
}

TEST_P(PlayerSituations, UpAStairAndDownAgain) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        World stair = world();
        for (int k = 0; k < 4; ++k)
            stair = block_at(stair, place, {k * 0.375 - 0.75, -0.875, -0.25}, {2.125, 0.875, (k + 1) * 0.25});
        Walk walk = stands(stair, place.at - place.along * 1.25);
        walk.go(place.along * 2, 75);
        EXPECT_NEAR(walk.at().z, place.at.z + 1 + kOffset, 1e-6);
        EXPECT_NEAR(dot(walk.at() - place.at, place.along), 1.25, 0.1);
        walk.go(place.along * -2.0, 80);
        EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
        EXPECT_EQ(walk.airborne, 0u);
    });
}

TEST_P(PlayerSituations, UpASlopeAndDownAgainWithTheWishedSpeed) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        for (const double height : {0.5, 1.0, 2.0}) {  // over 1.5 m: 18, 34 and 53 degrees
            TriangleMesh wedge = box_mesh({-0.75, -0.875, -0.25}, {0.75, 0.875, height});
            for (Vec3& v : wedge.vertices)
                if (v.x < 0 && v.z > 0) v.z = 0;
            Walk walk = stands(edited_at(world(), place, wedge, CarveKind::kFill), place.at - place.along * 1.5);
            walk.go(place.along * 2, 36);
            if (height > 1.5) {
                EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 0.01);
                EXPECT_LT(dot(walk.at() - place.at, place.along), -0.7);
                continue;
            }
            const Vec3 from = walk.at();
            walk.go(place.along * 2, 15);
            EXPECT_NEAR(length(walk.at() - from), 0.5, 1e-6) << height;
            EXPECT_NEAR((walk.at().z - from.z) * 1.5, dot(walk.at() - from, place.along) * height, 1e-3) << height;
            walk.go(place.along * -2.0, 75);
            EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6) << height;
            EXPECT_EQ(walk.airborne, 0u) << height;
        }
    });
}

TEST_P(PlayerSituations, OffALedgeItFliesAndLands) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        const World ledge = block_at(world(), place, {-2, -0.875, -0.25}, {-0.5, 0.875, 1});
        Walk walk = stands(ledge, place.at - place.along * 1.5 + Vec3{0, 0, 1});
        double landed = 0, left = 0, down = 0;
        for (int k = 0; k < 90; ++k) {
            const bool stood = walk.player.on_ground;
            walk.go(place.along * 2, 1);
            const double x = dot(walk.at() - place.at, place.along);
            if (stood && !walk.player.on_ground) left = x;
            if (walk.last.landed_speed > 0) landed = walk.last.landed_speed, down = x;
            if (landed > 0) break;
        }
        EXPECT_GT(left, -0.5);  // its middle is beyond the edge by then
        EXPECT_LT(left, -0.1);
        EXPECT_NEAR(landed, std::sqrt(2 * 9.81 * 1), 0.4);
        EXPECT_NEAR(down - left, 2 * std::sqrt(2 / 9.81), 0.2);
        EXPECT_NEAR(walk.at().z, place.at.z + kOffset, 1e-6);
    });
}

TEST_P(PlayerSituations, ACarefulOneStaysOnALedgeOnAllSides) {
    at_places(kSquare, 2, [&](const FloorPlace& place) {
        const World ledge = block_at(world(), place, {-0.75, -0.75, -0.25}, {0.75, 0.75, 1});
        for (int k = 0; k < 8; ++k) {
            const SineCosine turn = sine_cosine(k * 45 * kDegree);
            const Vec3 way{turn.cosine, turn.sine, 0};
            Walk walk = stands(ledge, place.at + Vec3{0, 0, 1});
            walk.with({.velocity = way * 2, .careful = true}, 90);
            EXPECT_TRUE(walk.player.on_ground) << k;
            EXPECT_GT(walk.at().z, place.at.z + 0.85) << k;
            EXPECT_GT(std::max(std::fabs(walk.at().x - place.at.x), std::fabs(walk.at().y - place.at.y)), 0.7) << k;
            walk.go(way * 2, 60);
            EXPECT_LT(walk.at().z, place.at.z + 0.5) << k;  // and goes off, where it need not care
        }
    });
}

TEST_P(PlayerSituations, ThroughADoorwayThatIsHardlyWider) {
    at_places(kRun, 2, [&](const FloorPlace& place) {
        World doorway = block_at(world(), place, {-0.125, 0.3125, -0.25}, {0.125, 1.5, 2.5});
        doorway = block_at(doorway, place, {-0.125, -1.5, -0.25}, {0.125, -0.3125, 2.5});
        Walk walk = stands(doorway, place.at - place.along);
        walk.go(place.along * 2, 60);
        EXPECT_NEAR(dot(walk.at() - place.at, place.along), 1, 1e-3);
        EXPECT_EQ(walk.airborne, 0u);
        // Askew it comes to the jamb 10 cm beside the opening, and slides in.
        Walk askew = stands(doorway, place.at - place.along + side_of(place) * 0.25);
        askew.go(place.along * 2 - side_of(place) * 0.5, 75);
        EXPECT_GT(dot(askew.at() - place.at, place.along), 0.4);
    });
}

}  // namespace
}  // namespace firma::test
