// SPDX-License-Identifier: MIT
// Bumpy open ground of any size.
#include "scenes/terrain.h"

#include <algorithm>
#include <cmath>

#include "scenes/rng.h"

namespace firma::scenes {
namespace {

double lattice_value(std::int64_t x, std::int64_t y, std::uint64_t seed) {
    const std::uint64_t key = std::uint64_t(x) * 73856093ull ^ std::uint64_t(y) * 19349663ull ^ (seed << 40);
    return Rng(key).uniform();
}

double value_noise(double x, double y, std::uint64_t seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    const auto ix = std::int64_t(fx), iy = std::int64_t(fy);
    double u = x - fx, v = y - fy;
    u = u * u * (3 - 2 * u);
    v = v * v * (3 - 2 * v);
    const double near = lattice_value(ix, iy, seed) * (1 - u) + lattice_value(ix + 1, iy, seed) * u;
    const double far = lattice_value(ix, iy + 1, seed) * (1 - u) + lattice_value(ix + 1, iy + 1, seed) * u;
    return near * (1 - v) + far * v;
}

double height(double x, double y, std::uint64_t seed) {
    double sum = 0, amplitude = 40, frequency = 1.0 / 128;
    for (std::uint64_t octave = 0; octave < 7; ++octave) {
        sum += amplitude * value_noise(x * frequency, y * frequency, seed + octave);
        amplitude /= 2;
        frequency *= 2;
    }
    return sum;
}

std::int32_t steps(double metres) {
    return std::int32_t(std::lround(metres * kInputSteps)) * kSurfacePerInput;
}

void add_triangle(Level& level, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    LevelFace face;
    face.first_corner = std::uint32_t(level.corners.size());
    face.corner_count = 3;
    face.source = std::uint32_t(level.faces.size());
    level.corners.insert(level.corners.end(), {a, b, c});
    level.faces.push_back(face);
}

/// The highest ground within `reach` of a point of the plane: nothing below a ball over it can touch that ball's side.
double highest_around(const Terrain& ground, const Level& level, double x, double y, double reach) {
    const auto clamped = [&](double at) { return std::clamp(int(at), 0, ground.squares); };
    double highest = -INFINITY;
    for (int j = clamped(std::floor(y - reach)); j <= clamped(std::ceil(y + reach)); ++j)
        for (int i = clamped(std::floor(x - reach)); i <= clamped(std::ceil(x + reach)); ++i) {
            const std::size_t vertex = std::size_t(j) * (std::size_t(ground.squares) + 1) + std::size_t(i);
            highest = std::max(highest, to_metres(level.vertices[vertex]).z);
        }
    return highest;
}

}  // namespace

Level terrain(const Terrain& ground) {
    Level level;
    level.name = "terrain";
    level.materials = {""};
    level.groups = {""};
    const auto row = std::uint32_t(ground.squares) + 1;
    for (int y = 0; y <= ground.squares; ++y)
        for (int x = 0; x <= ground.squares; ++x)
            level.vertices.push_back({steps(x), steps(y), steps(height(x, y, ground.seed))});
    for (std::uint32_t y = 0; y + 1 < row; ++y)
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t a = y * row + x, b = a + 1, c = a + row, d = c + 1;
            add_triangle(level, a, b, d);
            add_triangle(level, a, d, c);
        }
    level.source_faces = std::uint32_t(level.faces.size());
    return level;
}

std::vector<CastQuery> casts_over_terrain(const Terrain& ground, const Level& level, const CastRange& range,
                                          std::size_t count, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<CastQuery> moves(count);
    for (CastQuery& move : moves) {
        move.sphere.radius = rng.uniform(range.radius_low, range.radius_high);
        const double x = rng.uniform(1, ground.squares - 1), y = rng.uniform(1, ground.squares - 1);
        const double over = rng.chance(0.5) ? rng.uniform(0.001, 0.3) : rng.uniform(0.3, 6);
        const double lowest = highest_around(ground, level, x, y, move.sphere.radius);
        move.sphere.centre = {x, y, lowest + move.sphere.radius + over};
        const Vec3 direction = rng.direction();  // one draw a statement: compilers order operands differently
        move.path = direction * rng.uniform(range.length_low, range.length_high);
    }
    return moves;
}

}  // namespace firma::scenes
