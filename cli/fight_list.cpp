// SPDX-License-Identifier: MIT
// A list, frame by frame; and the depot's. Where things stand there: tools/depot, 32 units a metre.
#include <cmath>
#include <utility>

#include "cli/fight_plans.h"

namespace firma::cli {

namespace {

constexpr double kThere = 0.2;  // metres

FightShot shot_of(double seconds, const Vec3& from, const Vec3& at, double radius, double into) {
    FightShot shot;
    shot.seconds = seconds;
    shot.from = from;
    shot.at = at;
    shot.radius = radius;
    shot.into = into;
    return shot;
}

/// One that lets what comes loose stay whole.
FightShot cutting(FightShot shot) {
    shot.break_radius = 0;
    return shot;
}

/// One that breaks what lies about.
FightShot breaking(FightShot shot, double radius, std::size_t pieces) {
    shot.break_radius = radius;
    shot.pieces = pieces;
    return shot;
}

/// The bridge, from wall to wall at x 13 to 15, its deck at z 3.5 to 4: both ends, then what lies on the floor. The
/// crane's girder at x 16 to 17.25, z 8.25 to 9.25, on rails along the walls.
void shoot_bridge_and_crane(std::vector<FightShot>& shots) {
    shots.push_back(cutting(shot_of(0.5, {24.5, 1.5, 1.8}, {15, 2, 3.6}, 2.2, 1)));
    shots.push_back(cutting(shot_of(1.6, {24.5, 12.5, 1.8}, {15, 12, 3.6}, 2.2, 1)));
    shots.push_back(breaking(shot_of(4.2, {24.5, 9, 2.4}, {14.6, 7, 0.3}, 0.9, 0.1), 8, 90));
    shots.push_back(cutting(shot_of(5.4, {24, 1.5, 2}, {17.25, 2, 8.7}, 2, 0.7)));
    shots.push_back(cutting(shot_of(6.2, {24, 12.5, 2}, {17.25, 12, 8.7}, 2, 0.7)));
    shots.push_back(breaking(shot_of(9, {25, 8.6, 2.4}, {16.6, 7, 0.8}, 0.8, 0.1), 6, 60));
}

/// All eight, a metre wide, from the floor to the roof at z = 10: the foot, then the head.
void shoot_pillars(std::vector<FightShot>& shots) {
    shots.push_back(cutting(shot_of(7, {25, 4.6, 1.6}, {19, 3.25, 1.3}, 1.2, 0.5)));
    shots.push_back(cutting(shot_of(7.5, {25, 4.6, 3}, {19, 3.25, 8.4}, 1.2, 0.5)));
    shots.push_back(breaking(shot_of(10.5, {25, 4.6, 2.5}, {18, 3.2, 0.4}, 0.8, 0.1), 8, 60));
    shots.push_back(cutting(shot_of(10, {25, 9.4, 1.6}, {19, 10.75, 1.3}, 1.2, 0.5)));
    shots.push_back(cutting(shot_of(10.5, {25, 9.4, 3}, {19, 10.75, 8.4}, 1.2, 0.5)));
    shots.push_back(cutting(shot_of(11, {16.5, 5, 1.6}, {23, 3.25, 1.3}, 1.2, 0.5)));
    shots.push_back(breaking(shot_of(11.4, {16.5, 5, 3}, {23, 3.25, 8.4}, 1.2, 0.5), 12, 60));
    // Those in the west stand beside the gallery's slabs, z 3.5 to 4, and hold on to them.
    for (const double x : {4.75, 7.5}) {
        for (const double y : {3.25, 10.75}) {
            const double seconds = 8.6 + 0.3 * (x - 4.75) + 0.1 * (y - 3.25);
            shots.push_back(cutting(shot_of(seconds, {12.2, 7, 4.6}, {x, y, 4.6}, 1.2, 0.5)));
            shots.push_back(breaking(shot_of(seconds + 0.4, {12.2, 7, 4.6}, {x, y, 8.4}, 1.2, 0.5), 12, 60));
        }
    }
    shots.push_back(cutting(shot_of(11.6, {16.5, 9.4, 1.6}, {23, 10.75, 1.3}, 1.2, 0.5)));
    shots.push_back(breaking(shot_of(12, {16.5, 9.4, 3}, {23, 10.75, 8.4}, 1.2, 0.5), 12, 60));
}

/// What lies about, first from the east side, then from above; and crates.
void shoot_rubble(std::vector<FightShot>& shots) {
    shots.push_back(breaking(shot_of(12.2, {25, 8.6, 2.4}, {14.2, 5, 0.4}, 0.6, 0), 9, 60));
    shots.push_back(breaking(shot_of(12.8, {25, 8.6, 2.4}, {14.2, 9, 0.4}, 0.6, 0), 9, 60));
    shots.push_back(breaking(shot_of(14.2, {25, 9.4, 2.4}, {18.5, 10.5, 0.4}, 0.6, 0), 8, 60));
    shots.push_back(breaking(shot_of(13.4, {25, 4.6, 2.4}, {17.5, 3.2, 0.4}, 0.6, 0), 4, 60));
    const double places[][2] = {{6.2, 7},  {14.4, 7},   {12.8, 3.4}, {13, 11},    {15.2, 5}, {15.4, 9.6}, {17, 7.6},
                                {18.4, 4}, {13.6, 5.6}, {16, 11.4},  {14.6, 8.4}, {22, 10},  {22, 4}};
    for (const auto& [x, y] : places)
        shots.push_back(breaking(shot_of(12.8 + 0.06 * x, {x, 7, 6}, {x, y, 0.4}, 0.6, 0), 12, 60));
    shots.push_back(breaking(shot_of(8.2, {25.5, 6.1, 1.7}, {22.75, 6.1, 1.35}, 0.9, 0.5), 4, 40));
}

}  // namespace

FightOrders ListedFight::next(const FightGame& game) {
    FightOrders orders;
    fired_.resize(list_.shots.size(), false);
    for (std::size_t k = 0; k < list_.shots.size(); ++k) {
        if (fired_[k] || list_.shots[k].seconds > game.seconds()) continue;
        fired_[k] = true;
        orders.fire.push_back(list_.shots[k]);
    }
    if (goal_ == list_.goals.size() || list_.goals[goal_].seconds > game.seconds()) return orders;
    const FightGoal& goal = list_.goals[goal_];
    Vec3 way = goal.to - game.player().position;
    way.z = 0;
    const double far = length(way);
    if (far < kThere) {
        ++goal_;
    } else {
        orders.wish.velocity = way * (goal.speed / far);
    }
    return orders;
}

FightList depot_fight() {
    FightList fight;
    fight.start = {20.4, 9.4, 0.1};
    shoot_bridge_and_crane(fight.shots);
    shoot_pillars(fight.shots);
    shoot_rubble(fight.shots);
    // The wall to the lockers, a metre of brick; through it, about that room, and out by its door.
    FightShot wall = shot_of(3, {}, {20.8, 14, 1.25}, 1.45, 0.5);
    wall.by_player = true;
    fight.shots.push_back(wall);
    fight.goals = {{3.6, {20.8, 12.6, 0}}, {3.6, {20.8, 16.4, 0}}, {6, {24.4, 16.6, 0}},
                   {8, {22.9, 15.6, 0}},   {8, {22.9, 12.6, 0}},   {10, {24.6, 12.4, 0}}};
    for (std::size_t k = 0; k < fight.shots.size(); ++k) fight.shots[k].seed = 3 + k;
    return fight;
}

}  // namespace firma::cli
