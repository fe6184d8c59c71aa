// SPDX-License-Identifier: MIT
// Levels to be carved and craters to carve them with, as the benchmarks of carving want them.
#pragma once

#include <string>
#include <vector>

#include "firma/carve.h"
#include "firma/level.h"
#include "scenes/rng.h"

namespace firma::bench {

/// Rooms of 12 x 12 x 6 m with bumpy walls in a block of rock, so many each way; 2592 triangles a room.
Level crater_level(int rooms);

/// The middle of one room's floor, metres.
Vec3 floor_of_room(int a, int b);

/// Where craters go.
enum class CraterPlaces { kSpread, kCorner };

/// The crater that everything is carved with: rocky, of 180 triangles.
Cutter crater();

/// Crater number k, of radius 1.6 m: turned at random, its middle 0.7 m behind to 0.3 m before a wall, floor or ceiling
/// of any room, or within 4.2 m of one corner of the first one.
Pose crater_pose(int rooms, CraterPlaces places, std::size_t k);

/// A level's world; ends the program when there is none.
World carvable_world(const Level& level);

/// What one cut cost with everything: the cut itself, dropping its result and the world before.
struct CutCost {
    double cpu = 0, wall = 0;  ///< milliseconds
    CarveStatus status = CarveStatus::kNothing;
    CarveReport report;
};

/// Replaces the world by the one after the cut.
CutCost cut_crater(World& world, const Cutter& cutter, const Pose& pose);

/// The value that a share of all does not exceed.
double quantile(std::vector<double> values, double share);

}  // namespace firma::bench
