// SPDX-License-Identifier: MIT
// How far from a wall a mover stops, at speeds over nine decades: kept along the normal, against a fudge in time.
#include "article/questions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "firma/queries.h"
#include "scenes/rng.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

constexpr double kSkin = 0.001;
constexpr double kTimeFudge = 0.01;  // of the frame: what "based strictly on time" means

/// A square face of 16 m, tilted: z = x / 2 - 2 y.
Level tilted_wall() {
    Level level;
    level.name = "tilted_wall";
    level.materials = {""};
    level.groups = {""};
    for (const auto& [x, y] : {std::pair(-8, -8), std::pair(8, -8), std::pair(8, 8), std::pair(-8, 8)}) {
        const auto steps = [](double metres) { return std::int32_t(metres * kSurfaceSteps); };
        level.vertices.push_back({steps(x), steps(y), steps(x / 2.0 - 2 * y)});
        level.corners.push_back(std::uint32_t(level.corners.size()));
    }
    LevelFace face;
    face.corner_count = 4;
    level.faces.push_back(face);
    level.source_faces = 1;
    return level;
}

/// What is left between ball and wall, metres: smallest and largest over all moves.
struct Kept {
    double least = INFINITY, most = -INFINITY;
    void add(double distance) {
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    std::string text() const { return number(least * 1000) + " to " + number(most * 1000); }
};

struct Row {
    Kept firma, by_time;
    double deviation = 0;  ///< of Firma's from the contact offset, metres
};

/// Moves of one length that meet the wall: straight on, aslant, down to 3 degrees above it.
Row measure(const World& world, double length_of_path, std::size_t count) {
    const Face wall = world.faces()[0];
    const Vec3 normal = wall.normal, side = wall.corners[1] - wall.corners[0];
    const Vec3 along = side * (1 / length(side)), across = cross(normal, along);
    scenes::Rng rng(21);
    Row row;
    for (std::size_t k = 0; k < count; ++k) {
        const double radius = rng.chance(0.5) ? 0.25 : rng.uniform(0.01, 1);
        const Vec3 target = along * rng.uniform(-2, 2) + across * rng.uniform(-2, 2);
        // The wall is met within the first half of the move; what comes closer than the contact offset at once is
        // another matter.
        const double steepness = rng.uniform(0.05, 1), turn = rng.uniform(-1, 1);
        const double flat = std::sqrt(1 - steepness * steepness), other = std::sqrt(1 - turn * turn);
        const Vec3 way = along * (flat * turn) + across * (flat * other) - normal * steepness;
        const double before = std::min(rng.uniform(0.1, 0.5) * length_of_path, 100.0);
        if (before * steepness <= kSkin) continue;
        const scenes::CastQuery move{{target + normal * radius - way * before, radius}, way * length_of_path};
        const Hit hit = cast(world, move.sphere, move.path);
        if (hit.status != Status::kHit || hit.feature != Feature::kFace) continue;
        const auto left_at = [&](double fraction) {
            const Vec3 centre = move.sphere.centre + move.path * fraction;
            return dot(centre - wall.corners[0], normal) - radius;
        };
        const double kept = left_at(hit.safe_fraction);
        row.firma.add(kept);
        row.deviation = std::max(row.deviation, std::fabs(kept - kSkin));
        row.by_time.add(left_at(std::max(0.0, hit.fraction - kTimeFudge)));
    }
    return row;
}

}  // namespace

int measure_stop_distance(const Settings& settings) {
    Table table("stop_distance", {"path a frame m", "speed at 60 Hz m/s", "kept by safe_fraction mm",
                                  "largest deviation from the skin m", "kept by 1% of the frame's time mm"});
    WorldOptions options;
    options.tolerance.contact_offset = kSkin;
    const World world = make_world(tilted_wall(), options).value();
    bool even = true;
    for (const double path : {0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6}) {
        const Row row = measure(world, path, settings.few(20000));
        table.add({number(path), number(path * 60), row.firma.text(), number(row.deviation), row.by_time.text()});
        even = even && row.deviation < 1e-6;
    }
    return table.finish(settings.csv) && even ? 0 : 1;
}

}  // namespace firma::bench
