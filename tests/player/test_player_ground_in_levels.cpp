// SPDX-License-Identifier: MIT
// Players on the steps, stairs, slopes, ledges, in the gaps and under the ceilings that the blasted depot and blasted
// maps have, with a capsule, a box and spheres.
#include <cmath>

#include "tests/player/player_levels.h"

namespace firma::test {
namespace {

class PlayerGround : public InPlayerLevels {
protected:
    /// On a slope, so far along it from its middle.
    Walk stands_on(const Feature& slope, double far) const {
        const Vec3 over{0, 0, (far + 0.3) * slope.size + 0.01};
        return stands(world(), slope.at + slope.way * far + over, 30);
    }
};
INSTANTIATE_TEST_SUITE_P(, PlayerGround, testing::Combine(testing::Range(0, 3), testing::Range(0, 3)),
                         name_of_player_level);

TEST_P(PlayerGround, UpAStepOfTheLevelAndDownAgain) {
    at_features(FeatureKind::kStep, 3, [&](const Feature& step) {
        for (const double speed : {0.5, 2.0, 6.0})
            for (const double askew : {0.0, 0.4}) {
                const Vec3 side{-step.way.y, step.way.x, 0};
                const Vec3 wish = (step.way + side * askew) * speed;
                Walk walk = stands(world(), step.at - step.way * 0.6 - side * (0.6 * askew));
                walk.go(wish, int(1.2 / speed * 60));
                EXPECT_GE(walk.stepped, 1u) << speed;
                EXPECT_NEAR(walk.at().z, step.at.z + step.size + kOffset, 1e-6) << speed;
                EXPECT_GT(dot(walk.at() - step.at, step.way), 0.4) << speed;
                walk.go(wish * -1.0, int(1.3 / speed * 60));
                EXPECT_NEAR(walk.at().z, step.at.z + kOffset, 1e-6) << speed;
                EXPECT_EQ(walk.airborne, 0u) << speed;
            }
    });
}

TEST_P(PlayerGround, UpAndDownTheStairsOfTheLevelWithoutLeavingTheGround) {
    // kaos2 has single steps alone.
    const bool has_stairs = level() != 1;
    at_features(has_stairs ? FeatureKind::kStairs : FeatureKind::kStep, 3, [&](const Feature& stairs) {
        for (const double speed : {1.0, 4.0}) {
            const double far = has_stairs ? 1.5 * stairs.deep : 0.6;  // on the middle of a tread
            Walk walk = stands(world(), stairs.at - stairs.way * far + Vec3{0, 0, stairs.size}, 20);
            walk.airborne = 0;
            const double began = walk.at().z;
            for (const double way : {1.0, -1.0}) {
                double last = walk.at().z;
                int ticks = 0;
                for (; ticks < 90 && dot(walk.at() - stairs.at, stairs.way) * way < far; ++ticks) {
                    walk.go(stairs.way * (speed * way), 1);
                    EXPECT_GE((walk.at().z - last) * way, -1e-6) << speed << ' ' << ticks;
                    last = walk.at().z;
                }
                EXPECT_LT(ticks, int(2.2 * far / speed * 60) + 5) << speed;  // round feet go up around the edges
                // Round feet stand on the edge above as well, and lower at the ends of a stair.
                const double whole = way > 0 ? (has_stairs ? 3 : 1) * stairs.size : 0;
                EXPECT_NEAR(last - began, whole, is_box() ? 1e-6 : stairs.size * 0.75) << speed;
                walk.go({}, 1);
            }
            EXPECT_EQ(walk.airborne, 0u) << speed;
        }
    });
}

TEST_P(PlayerGround, UpASlopeOfTheLevelWithTheWishedSpeedAndStandsOnIt) {
    at_features(FeatureKind::kSlope, 3, [&](const Feature& slope) {
        Walk walk = stands_on(slope, -0.5);
        const Vec3 from = walk.at();
        for (int k = 0; k < 45; ++k) {
            const Vec3 before = walk.at();
            walk.go(slope.way, 1);
            EXPECT_NEAR(length(walk.at() - before), 1.0 / 60, 1e-6) << k;
        }
        EXPECT_NEAR(walk.at().z - from.z, dot(walk.at() - from, slope.way) * slope.size, 1e-4);
        walk.wait(1);
        const Vec3 at = walk.at();
        walk.wait(60);
        EXPECT_EQ(walk.at(), at);  // and does not slide down
        walk.go(slope.way * -1.0, 45);
        EXPECT_NEAR(length(walk.at() - at), 0.75, 1e-6);
        EXPECT_EQ(walk.airborne, 0u);
    });
}

TEST_P(PlayerGround, AcrossASlopeOfTheLevelItKeepsItsHeight) {
    at_features(FeatureKind::kSlope, 3, [&](const Feature& slope) {
        const Vec3 side{-slope.way.y, slope.way.x, 0};
        for (const double way : {1.0, -1.0}) {
            Walk walk = stands_on(slope, 0);
            const Vec3 from = walk.at();
            walk.go(side * way, 20);
            EXPECT_LT(length(walk.at() - from - side * (way / 3)), 1e-6);
            EXPECT_EQ(walk.airborne, 0u);
        }
    });
}

TEST_P(PlayerGround, ASlopeOfTheLevelThatIsTooSteepIsNotClimbedByWalksNorJumps) {
    at_features(FeatureKind::kSteep, 3, [&](const Feature& slope) {
        const Vec3 normal = Vec3{slope.way.x * -slope.size, slope.way.y * -slope.size, 1} *
                            (1 / std::sqrt(1 + slope.size * slope.size));
        // Just over its plane, whatever the shape.
        Walk walk(world(), shape(), slope.at + Vec3{0, 0, 0.3 * slope.size + 0.01});
        ASSERT_TRUE(is_inside(world(), walk));
        const double began = walk.at().z;
        bool stood_on_it = false;
        double ground = -INFINITY;
        for (int k = 0; k < 120; ++k) {
            walk.move({.velocity = slope.way * 3, .jump = k > 30});
            stood_on_it |= walk.player.on_ground && dot(walk.player.ground_normal, normal) > 1 - 1e-6;
            if (walk.player.on_ground) ground = std::max(ground, walk.at().z);
            EXPECT_LT(walk.at().z, std::max(began, ground + 4.4 * 4.4 / 2 / 9.81 + 0.01)) << k;
        }
        EXPECT_FALSE(stood_on_it);
    });
}

TEST_P(PlayerGround, ACarefulOneStopsAtTheEdgeOfALedgeAndGoesAlongIt) {
    at_features(FeatureKind::kLedge, 3, [&](const Feature& ledge) {
        const Vec3 side{-ledge.way.y, ledge.way.x, 0};
        Walk walk = stands(world(), ledge.at - ledge.way * 0.6);
        walk.with({.velocity = ledge.way * 2, .careful = true}, 60);
        EXPECT_TRUE(walk.player.on_ground);
        EXPECT_GT(walk.at().z, ledge.at.z - 0.3);  // round feet sink a bit
        const double out = dot(walk.at() - ledge.at, ledge.way);
        EXPECT_GT(out, -0.05);
        EXPECT_LT(out, 0.31);
        for (const double way : {1.0, -1.0}) {
            const Vec3 from = walk.at();
            walk.with({.velocity = ledge.way * 2 + side * (way * 2), .careful = true}, 4);
            EXPECT_NEAR(dot(walk.at() - from, side) * way, 2.0 / 15, 0.01) << way;
            walk.with({.velocity = side * (way * -2), .careful = true}, 4);
        }
        walk.go(ledge.way * 2, 12);
        EXPECT_FALSE(walk.player.on_ground);
    });
}

TEST_P(PlayerGround, OffALedgeItFliesByItsSpeedAndLandsByTheDepth) {
    at_features(FeatureKind::kLedge, 3, [&](const Feature& ledge) {
        Walk walk = stands(world(), ledge.at - ledge.way * 0.6);
        double landed = 0, left = 0, down = 0;
        for (int k = 0; k < 150 && landed == 0; ++k) {
            const bool stood = walk.player.on_ground;
            // No farther than the floor below is known to be.
            const double x = dot(walk.at() - ledge.at, ledge.way);
            walk.go(ledge.way * (x < 0.3 ? 2 : 0), 1);
            if (stood && !walk.player.on_ground) left = x;
            landed = walk.last.landed_speed;
            down = dot(walk.at() - ledge.at, ledge.way);
        }
        EXPECT_GT(left, -0.05);
        EXPECT_LT(left, 0.31);
        EXPECT_GT(down, 0.3);
        EXPECT_NEAR(landed, std::sqrt(2 * 9.81 * ledge.size), 0.5);
        EXPECT_NEAR(walk.at().z, ledge.at.z - ledge.size + kOffset, 1e-6);
    });
}

// Round feet by PlayerRules::overhang, 0.7 radii: 0.21 m.
TEST_P(PlayerGround, BeyondTheEdgeOfALedgeItStandsAsFarAsTheRulesSay) {
    at_features(FeatureKind::kLedge, 3, [&](const Feature& ledge) {
        // What is under a box holds it until it is wholly beyond.
        const double most = is_box() ? 0.3 : 0.21;
        for (const double out : {-0.1, 0.1, 0.19, 0.23, 0.28, 0.32}) {
            Walk walk(world(), shape(), ledge.at + ledge.way * out + Vec3{0, 0, 0.002});
            walk.wait(60);
            EXPECT_EQ(walk.at().z > ledge.at.z - 0.3, out < most) << out;
            if (out < most) {
                EXPECT_TRUE(walk.player.on_ground) << out;
                const Vec3 at = walk.at();
                walk.wait(30);
                EXPECT_EQ(walk.at(), at) << out;
            }
        }
    });
}

TEST_P(PlayerGround, AJumpUnderALowCeilingEndsAtIt) {
    at_features(FeatureKind::kLowCeiling, 3, [&](const Feature& ceiling) {
        const double room = ceiling.size - 1.8 - kOffset, free = 4.4 * 4.4 / 2 / 9.81;
        for (const double speed : {0.0, 1.0}) {
            Walk walk = stands(world(), ceiling.at - ceiling.way * (speed * 0.4));
            walk.move({.velocity = ceiling.way * speed, .jump = true});
            double top = walk.at().z - ceiling.at.z;
            bool met = walk.met(ContactKind::kCeiling);
            for (int k = 0; k < 90 && !walk.player.on_ground; ++k) {
                walk.go(ceiling.way * speed, 1);
                top = std::max(top, walk.at().z - ceiling.at.z);
                met |= walk.met(ContactKind::kCeiling);
            }
            EXPECT_TRUE(met) << speed;
            EXPECT_LT(room, free);
            EXPECT_NEAR(top, room, kOffset) << speed;
            EXPECT_NEAR(walk.at().z, ceiling.at.z + kOffset, 1e-6) << speed;
        }
    });
}

TEST_P(PlayerGround, ThroughANarrowGapWithItsSpeed) {
    at_features(FeatureKind::kGap, 3, [&](const Feature& gap) {
        const Vec3 side{-gap.way.y, gap.way.x, 0};
        Walk walk = stands(world(), gap.at - gap.way * 0.45);
        const Vec3 from = walk.at();
        walk.go(gap.way * 2, 27);
        EXPECT_LT(length(walk.at() - from - gap.way * 0.9), 1e-6);
        // Along either wall.
        for (const double way : {1.0, -1.0}) {
            Walk along = stands(world(), gap.at - gap.way * 0.4);
            along.go(side * way, int((gap.size / 2 - 0.3) * 60) + 4);
            const double began = dot(along.at(), gap.way);
            along.go(gap.way + side * way, 45);
            EXPECT_NEAR(dot(along.at(), gap.way) - began, 0.75, 1e-3) << way;
            EXPECT_NEAR(dot(along.at() - gap.at, side) * way, gap.size / 2 - 0.3 - kOffset, kOffset) << way;
        }
    });
}

TEST_P(PlayerGround, InANarrowGapItTurnsOnTheSpotAndIsNotHeld) {
    at_features(FeatureKind::kGap, 3, [&](const Feature& gap) {
        Walk walk = stands(world(), gap.at);
        // Round and round against both walls: along the gap it goes to and fro, across no farther than these.
        const Vec3 side{-gap.way.y, gap.way.x, 0};
        double most = 0;
        for (int k = 0; k < 240; ++k) {
            const SineCosine turn = sine_cosine(k * 6 * kDegree);
            walk.go((gap.way * turn.cosine + side * turn.sine) * 2, 1);
            most = std::max(most, std::fabs(dot(walk.at() - gap.at, side)));
        }
        EXPECT_LT(most, gap.size / 2 - 0.3 + 1e-9);
        EXPECT_NEAR(dot(walk.at() - gap.at, gap.way), 0, 0.02);  // four whole turns
        EXPECT_EQ(walk.airborne, 0u);
        const Vec3 from = walk.at();
        walk.go(gap.way, 24);
        EXPECT_NEAR(dot(walk.at() - from, gap.way), 0.4, 1e-3);
    });
}

TEST_P(PlayerGround, OverAStepWithARunningJumpItLandsOnTop) {
    at_features(FeatureKind::kStep, 3, [&](const Feature& step) {
        Walk walk = stands(world(), step.at - step.way * 0.9);
        walk.move({.velocity = step.way * 1.8, .jump = true});
        int ticks = 1;
        for (; ticks < 90 && !walk.player.on_ground; ++ticks) walk.go(step.way * 1.8, 1);
        EXPECT_NEAR(walk.at().z, step.at.z + step.size + kOffset, 0.06);  // an edge lifts round feet less
        walk.go(step.way, 15);
        EXPECT_NEAR(walk.at().z, step.at.z + step.size + kOffset, 1e-6);
        // Up and down by the parabola.
        const double top = std::sqrt(2 * 9.81 * (4.4 * 4.4 / 2 / 9.81 - step.size));
        EXPECT_NEAR(ticks, 60 * (4.4 + top) / 9.81, 2);
    });
}

}  // namespace
}  // namespace firma::test
