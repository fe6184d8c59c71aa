// SPDX-License-Identifier: MIT
// Casting against the usual alternative: test the position wanted, and halve the path while it is in the way.
#include "article/questions.h"

#include <cmath>
#include <cstdio>

#include "firma/queries.h"
#include "scenes/rng.h"
#include "support/race.h"
#include "support/sets.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using scenes::CastQuery;

/// Intersection testing: whether a ball touches anything, by the tree.
class Tester {
public:
    explicit Tester(const World& world) : world_(world) {}

    bool touches(const Sphere& sphere) {
        ++tests;
        return overlap(world_, sphere, found_) == Status::kInitialOverlap;
    }

    /// The fraction of the path that binary subdivision allows.
    double go(const CastQuery& move, int halvings) {
        const auto at = [&](double fraction) {
            return Sphere{move.sphere.centre + move.path * fraction, move.sphere.radius};
        };
        if (!touches(at(1))) return 1;
        double valid = 0, invalid = 1;
        for (int k = 0; k < halvings; ++k) {
            const double middle = (valid + invalid) / 2;
            (touches(at(middle)) ? invalid : valid) = middle;
        }
        return valid;
    }

    std::size_t tests = 0;

private:
    const World& world_;
    std::vector<Overlap> found_;
};

// ------------------------------------------------------------------------------------------------------- tunnelling

/// A wall 5 cm thick, 4 m square, of a closed box.
Level thin_wall() {
    Level level;
    level.name = "thin_wall";
    level.materials = {""};
    level.groups = {""};
    const auto steps = [](double metres) { return std::int32_t(std::lround(metres * kInputSteps)) * kSurfacePerInput; };
    for (int k = 0; k < 8; ++k)
        level.vertices.push_back({steps(k & 1 ? 0.05 : 0), steps(k & 2 ? 2 : -2), steps(k & 4 ? 2 : -2)});
    const std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& corners : faces) {
        LevelFace face;
        face.first_corner = std::uint32_t(level.corners.size());
        face.corner_count = 4;
        face.source = std::uint32_t(level.faces.size());
        level.corners.insert(level.corners.end(), corners, corners + 4);
        level.faces.push_back(face);
    }
    level.source_faces = 6;
    return level;
}

/// Balls somewhere before the wall, a frame's move straight or aslant at it that ends beyond the wall's front.
std::vector<CastQuery> moves_at_wall(double radius, double speed, std::size_t count) {
    scenes::Rng rng(std::uint64_t(speed * 1000) + 7);
    std::vector<CastQuery> moves;
    while (moves.size() < count) {
        const Vec3 target{0, rng.uniform(-1, 1), rng.uniform(-1, 1)};
        Vec3 way = rng.direction();
        if (way.x < 0.7) continue;
        const double travel = speed / 60;
        const double before = rng.uniform() * travel;  // where in its frame the ball meets the wall
        moves.push_back({{target - way * before - Vec3{radius, 0, 0}, radius}, way * travel});
    }
    return moves;
}

bool measure_tunnelling(const Settings& settings) {
    Table table("tunnelling", {"speed m/s", "path a frame m", "tunnels, one test at the end",
                               "tunnels, 4 tests on the way", "tunnels, 16 tests on the way", "tunnels, casting"});
    const World world = world_of(thin_wall());
    Tester tester(world);
    const double radius = 0.1;
    bool sound = true;
    for (const double speed : {3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0}) {
        const std::vector<CastQuery> moves = moves_at_wall(radius, speed, settings.few(20000));
        std::size_t through[4] = {};
        for (const CastQuery& move : moves) {
            const int pieces[3] = {1, 4, 16};
            for (int way = 0; way < 3; ++way) {
                bool stopped = false;
                for (int k = 1; k <= pieces[way] && !stopped; ++k)
                    stopped = tester.touches({move.sphere.centre + move.path * (double(k) / pieces[way]), radius});
                through[way] += !stopped;
            }
            through[3] += !cast(world, move.sphere, move.path).touched();
        }
        sound = sound && through[3] == 0;
        std::vector<std::string> row{number(speed), number(speed / 60)};
        for (const std::size_t count : through) row.push_back(percent(double(count) / double(moves.size())));
        table.add(row);
    }
    return table.finish(settings.csv) && sound;
}

// ------------------------------------------------------------------------------------------------------------- cost

struct Ends {
    double worst = 0;        ///< metres between where two ways end
    std::size_t passed = 0;  ///< went on where the cast stops
};

Ends compare(const World& world, Tester& tester, const std::vector<CastQuery>& moves, int halvings) {
    Ends ends;
    for (const CastQuery& move : moves) {
        CastOptions options;
        options.sides = Sides::kBoth;  // an intersection test knows no sides
        const Hit hit = cast(world, move.sphere, move.path, options);
        const double exact = hit.touched() ? hit.fraction : 1, other = tester.go(move, halvings);
        const double apart = (other - exact) * length(move.path);
        // The end of the bisection may lie a hair beyond a graze; what is farther than its step went through.
        const double step = length(move.path) * std::exp2(-halvings);
        ends.passed += apart > step + 1e-9;
        if (std::fabs(apart) <= step + 1e-9) {
            ends.worst = std::max(ends.worst, std::fabs(apart));
        }
    }
    return ends;
}

void measure_cost(const Settings& settings, const Scene& scene, const CastSet& set, Table& table) {
    const World world = world_of(scene.level);
    Tester tester(world);
    std::vector<Contender> contenders{{"cast", [&] {
                                           for (const CastQuery& move : set.moves)
                                               keep(cast(world, move.sphere, move.path).fraction);
                                       }}};
    const std::vector<int> halvings{4, 8, 16, 24};
    for (const int count : halvings)
        contenders.push_back({std::to_string(count) + " halvings", [&, count] {
                                  for (const CastQuery& move : set.moves) keep(tester.go(move, count));
                              }});
    const std::vector<Lap> laps = race(contenders, settings.rounds);
    const double n = double(set.moves.size());
    for (std::size_t k = 0; k < laps.size(); ++k) {
        Ends ends;
        tester.tests = 0;
        if (k > 0) ends = compare(world, tester, set.moves, halvings[k - 1]);
        const bool is_cast = k == 0;
        table.add({scene.name + ", " + set.name, contenders[k].name, is_cast ? "-" : number(double(tester.tests) / n),
                   number(laps[k].seconds / n * 1e9), times(laps[k].ratio), is_cast ? "0" : number(ends.worst),
                   is_cast ? "0%" : percent(double(ends.passed) / n)});
    }
}

bool measure_costs(const Settings& settings) {
    Table table("subdivision_cost",
                {"moves", "way", "tests a move", "ns a move", "to casting", "worst error m", "went through something"});
    const Scene scene = rooms_scene(settings.quick ? 1000 : 50000, settings.few(5000));
    measure_cost(settings, scene, scene.sets[0], table);
    const scenes::CastRange fast{0.05, 0.1, 0.5, 5};
    const scenes::RoomGrid grid = scenes::room_grid_of(settings.quick ? 1000 : 50000);
    measure_cost(settings, scene, {"small and fast", casts_in_rooms(grid, fast, settings.few(5000), 9)}, table);
    return table.finish(settings.csv);
}

}  // namespace

int measure_subdivision(const Settings& settings) {
    const bool tunnelling = measure_tunnelling(settings);
    return measure_costs(settings) && tunnelling ? 0 : 1;
}

}  // namespace firma::bench
