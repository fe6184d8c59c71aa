// SPDX-License-Identifier: MIT
// What judges a fire fight finds each fault that it is there for.
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "cli/fight_judge.h"
#include "cli/fight_plans.h"
#include "firma/level.h"
#include "firma/queries.h"

namespace firma::cli {
namespace {

/// Stands there, and fires once.
class OneShot : public FightPlan {
public:
    FightOrders next(const FightGame& game) override {
        FightOrders orders;
        if (game.figures().frames > 0) return orders;
        FightShot shot;
        shot.at = {35, 29, 0};
        shot.by_player = true;
        orders.fire.push_back(shot);
        return orders;
    }
};

World first_hall() {
    return make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
}

class FightJudgeFinds : public testing::Test {
protected:
    FightJudgeFinds() : game(first_hall(), {30, 22, 0.2}, 1) {
        OneShot plan;
        for (int frame = 0; frame < 60; ++frame) game.advance(plan.next(game));
        state = game.state();
        Pose pose;
        pose.position = game.middle() + Vec3{0, 0, 3};
        const Sphere ball{{}, 0.2};
        body = add_body(state.bodies,
                        body_at(make_body_shape(std::span(&ball, 1), mass_of_ball(0.2, 1000)).value(), pose));
    }

    std::string fault(std::size_t escaped = 0) {
        FightJudge judge(game);
        return judge.fault(state, escaped);
    }

    FightGame game;
    FightState state;
    BodyId body;
};

TEST_F(FightJudgeFinds, NothingWhereAllHolds) {
    EXPECT_EQ(game.figures().craters, 1u);
    EXPECT_EQ(fault(), "");
}

TEST_F(FightJudgeFinds, ASphereThatIsTooDeep) {
    Body& ball = *state.bodies.find(body);
    const NearFace floor = closest(state.world, {ball.position.x, ball.position.y, 0.1});
    ball.position.z = floor.point.z + 0.2 - 0.0009;
    EXPECT_EQ(fault(), "");
    ball.position.z = floor.point.z + 0.2 - 0.0012;
    EXPECT_NE(fault().find("a sphere is 1.2"), std::string::npos) << fault();
}

TEST_F(FightJudgeFinds, ACentreInSolid) {
    state.bodies.find(body)->position.z = -0.1;
    EXPECT_NE(fault().find("centre is in solid"), std::string::npos) << fault();
}

TEST_F(FightJudgeFinds, ABodyThatIsLost) {
    state.bodies.find(body)->position.z = -1000;
    EXPECT_NE(fault(), "");
}

TEST_F(FightJudgeFinds, APlayerInSolidOrStuck) {
    state.player.position.z -= 0.01;
    EXPECT_NE(fault().find("overlaps"), std::string::npos) << fault();
    state.player.position.z -= 1.5;
    EXPECT_NE(fault().find("is in solid"), std::string::npos) << fault();
    state.player = game.player();
    state.player.stuck = true;
    EXPECT_NE(fault().find("is stuck"), std::string::npos) << fault();
}

TEST_F(FightJudgeFinds, RaysThatEscapeFromAClosedLevel) {
    EXPECT_EQ(fault(3).find("rays out of the level") != std::string::npos, game.kept_in()) << fault(3);
}

TEST_F(FightJudgeFinds, OfASleeperOnlyThatItWasRight) {
    Body& ball = *state.bodies.find(body);
    FightJudge judge(game);
    ball.asleep = true;
    EXPECT_EQ(judge.fault(state, 0), "");
    const std::uint64_t judged = judge.spheres();
    EXPECT_EQ(judge.fault(state, 0), "");
    EXPECT_LT(judge.spheres() - judged, judged);
}

}  // namespace
}  // namespace firma::cli
