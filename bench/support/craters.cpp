// SPDX-License-Identifier: MIT
// Levels to be carved and craters to carve them with.
#include "support/craters.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "scenes/cut_levels.h"
#include "support/race.h"

namespace firma::bench {
namespace {

constexpr double kRoom = 12, kHeight = 6, kSpacing = 13.5;  // as scenes::bumpy_rooms has them
constexpr int kPanels = 18;
constexpr double kRadius = 1.6;

}  // namespace

Level crater_level(int rooms) {
    scenes::Rng rng(7);
    return scenes::level_of(scenes::bumpy_rooms(rng, rooms, kPanels, {}).faces);
}

Vec3 floor_of_room(int a, int b) {
    return {a * kSpacing + kRoom / 2, b * kSpacing + kRoom / 2, 0};
}

Cutter crater() {
    return make_crater(CutterShape::kRocky, 3);
}

Pose crater_pose(int rooms, CraterPlaces places, std::size_t k) {
    scenes::Rng rng(0x9E3779B97F4A7C15ull * (k + 1) + (places == CraterPlaces::kCorner));
    const bool corner = places == CraterPlaces::kCorner;
    const auto a = int(rng.below(std::uint32_t(rooms)));
    const auto b = int(rng.below(std::uint32_t(rooms)));
    const Vec3 low = corner ? Vec3{} : Vec3{a * kSpacing, b * kSpacing, 0};
    const Vec3 size{kRoom, kRoom, kHeight};
    const auto axis = int(rng.below(3));
    const bool high = rng.chance(0.5) && !corner;
    const double out = rng.uniform(-0.7, 0.3);  // of the wall, into the air
    Pose pose;
    for (int i = 0; i < 3; ++i) {
        const double along = rng.uniform() * (corner ? 0.35 : 1);
        if (i == axis)
            pose.position[i] = high ? low[i] + size[i] - out : low[i] + out;
        else
            pose.position[i] = low[i] + size[i] * along;
    }
    pose.rotation = random_turn(rng.next());
    pose.scale = kRadius;
    return pose;
}

World carvable_world(const Level& level) {
    Result<World> world = make_world(level);
    if (world) return std::move(world).value();
    std::fprintf(stderr, "%s\n", world.error().text().c_str());
    std::exit(1);
}

CutCost cut_crater(World& world, const Cutter& cutter, const Pose& pose) {
    using Clock = std::chrono::steady_clock;
    CutCost cost;
    const Clock::time_point start = Clock::now();
    const double before = thread_seconds();
    {
        CarveResult result = carve(world, cutter, pose);
        world = std::move(result.world);
        cost.status = result.status;
        cost.report = result.report;
    }
    cost.cpu = (thread_seconds() - before) * 1e3;
    cost.wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return cost;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto index = std::min(values.size() - 1, std::size_t(double(values.size()) * share));
    const auto at = values.begin() + std::ptrdiff_t(index);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace firma::bench
