// SPDX-License-Identifier: MIT
// Work whose instructions are counted: the same casts and craters in the same scenes each time. run.py runs it under
// valgrind's callgrind and compares with bounds.json; by itself it only does the work.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "firma/capsule.h"
#include "firma/carve.h"
#include "firma/hull.h"
#include "firma/queries.h"
#include "firma/world.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"

namespace {

using namespace firma;

constexpr std::size_t kCasts = 4000, kCuts = 30;
constexpr scenes::Terrain kGround{150, 3};

struct KindOfWork {
    const char* name;
    scenes::CastRange range;
};

constexpr KindOfWork kCastKinds[] = {
    {"a ray of 1-2 m", scenes::kShortRays},
    {"a ray of 5-100 m", scenes::kLongRays},
    {"a sphere over 0.1-2 m", scenes::kShortSpheres},
    {"a sphere over 50 m", scenes::kLongSpheres},
};

/// Counts `work` under a name, so many units of it.
template <class Work>
void count_work(const std::string& name, std::size_t units, const Work& work) {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    const double result = work();
    const std::string title = name + " / " + std::to_string(units);
    CALLGRIND_DUMP_STATS_AT(title.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
    std::printf("%s: %.17g\n", title.c_str(), result);
}

/// A sum over all answers: that nothing of them can be left out.
/// @param cast_one  (query) returns a Hit
template <class CastOne>
double sum_of(const std::vector<scenes::CastQuery>& casts, const CastOne& cast_one) {
    double sum = 0;
    for (const scenes::CastQuery& c : casts) {
        const Hit hit = cast_one(c);
        sum += hit.fraction + hit.normal.x;
    }
    return sum;
}
double cast_all_of(const World& world, const std::vector<scenes::CastQuery>& casts) {
    return sum_of(casts, [&](const scenes::CastQuery& c) { return cast(world, c.sphere, c.path); });
}

/// Where spheres of 0.3 to 0.5 m go: capsules of 1.2 to 2 m, boxes, and hulls of twelve corners.
void count_shapes(const World& world, const std::vector<scenes::CastQuery>& casts) {
    count_work("a capsule over 0.1-2 m, rooms", casts.size(), [&] {
        return sum_of(casts, [&](const scenes::CastQuery& c) {
            const Vec3 up{0, 0, c.sphere.radius};
            return cast(world, Capsule(c.sphere.centre - up, c.sphere.centre + up, c.sphere.radius), c.path);
        });
    });
    constexpr double kGolden = 1.618;
    std::vector<Vec3> corners;
    for (const double one : {-1.0, 1.0})
        for (const double other : {-kGolden, kGolden}) {
            corners.push_back(Vec3{0, one, other} * 0.2);
            corners.push_back(Vec3{one, other, 0} * 0.2);
            corners.push_back(Vec3{other, 0, one} * 0.2);
        }
    const Hull box = make_box({0.3, 0.25, 0.2}).value(), hull = make_hull(corners).value();
    const auto cast_hull = [&](const char* name, const Hull& shape) {
        count_work(name, casts.size(), [&] {
            return sum_of(casts,
                          [&](const scenes::CastQuery& c) { return cast(world, shape, c.sphere.centre, c.path); });
        });
    };
    cast_hull("a box over 0.1-2 m, rooms", box);
    cast_hull("a hull over 0.1-2 m, rooms", hull);
}

/// Near the walls of rooms, where casts of spheres start.
double cut_all_of(World world, const std::vector<scenes::CastQuery>& places, const Cutter& cutter) {
    double taken = 0;
    scenes::Rng rng(5);
    for (const scenes::CastQuery& place : places) {
        Pose pose;
        pose.position = closest(world, place.sphere.centre).point;
        pose.rotation = random_turn(rng.next());
        CarveResult result = carve(world, cutter, pose);
        taken += result.report.volume;
        world = std::move(result.world);
    }
    return taken;
}

World world_of_level(const Level& level) {
    Result<World> world = make_world(level);
    if (world) return std::move(world).value();
    std::fprintf(stderr, "%s\n", world.error().text().c_str());
    std::exit(1);
}

}  // namespace

int main() {
    const scenes::RoomGrid grid = scenes::room_grid_of(45'000);
    const Level rooms = scenes::room_grid(grid), ground = scenes::terrain(kGround);
    World open;
    count_work("a face of open ground made ready to cast", ground.faces.size(), [&] {
        open = world_of_level(ground);
        return double(open.face_count());
    });
    const World closed = world_of_level(rooms);
    std::uint64_t seed = 1;
    for (const KindOfWork& kind : kCastKinds) {
        const auto in_rooms = scenes::casts_in_rooms(grid, kind.range, kCasts, seed++);
        count_work(std::string(kind.name) + ", rooms", kCasts, [&] { return cast_all_of(closed, in_rooms); });
        const auto outside = scenes::casts_over_terrain(kGround, ground, kind.range, kCasts, seed++);
        count_work(std::string(kind.name) + ", open ground", kCasts, [&] { return cast_all_of(open, outside); });
    }
    count_shapes(closed, scenes::casts_in_rooms(grid, scenes::kShortSpheres, kCasts, seed++));
    const auto places = scenes::casts_in_rooms(grid, scenes::kShortSpheres, kCuts, seed);
    const Cutter cutter = make_crater(CutterShape::kRocky, 3);
    count_work("a crater in rooms", kCuts, [&] { return cut_all_of(closed, places, cutter); });
}
