// SPDX-License-Identifier: MIT
// The scenes and casts of bench_scale.
#include "scale/work.h"

#include <cmath>

#include "firma/queries.h"
#include "scenes/rng.h"

namespace firma::bench {
namespace {

constexpr double kDepth = 10;  // metres of rock below height 0, which no ground reaches

std::int32_t steps_of(double metres) {
    return std::int32_t(std::lround(metres * kInputSteps)) * kSurfacePerInput;
}

void add_face(Level& level, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    LevelFace face;
    face.first_corner = std::uint32_t(level.corners.size());
    face.corner_count = 3;
    face.source = std::uint32_t(level.faces.size());
    level.corners.insert(level.corners.end(), {a, b, c});
    level.faces.push_back(face);
}

/// The rim's corners below themselves: number x, y of a square lattice of which only the rim is there.
class LowRim {
public:
    LowRim(Level& level, std::uint32_t squares) : row_(squares + 1), first_(std::uint32_t(level.vertices.size())) {
        for (std::uint32_t y = 0; y < row_; ++y)
            for (std::uint32_t x = 0; x < row_; ++x) {
                if (!on_rim(x, y)) continue;
                GridPoint below = level.vertices[std::size_t(y) * row_ + x];
                below.z = steps_of(-kDepth);
                level.vertices.push_back(below);
            }
    }
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y) const {
        if (y == 0) return first_ + x;
        const std::uint32_t before = row_ + 2 * (y - 1);
        return first_ + before + (y + 1 == row_ ? x : x == 0 ? 0 : 1);
    }

private:
    bool on_rim(std::uint32_t x, std::uint32_t y) const { return x == 0 || y == 0 || x + 1 == row_ || y + 1 == row_; }

    std::uint32_t row_, first_;
};

/// Walls down from the rim of open ground, and strips for the bottom.
void close_below(Level& level, std::uint32_t squares) {
    const LowRim low(level, squares);
    const auto high = [&](std::uint32_t x, std::uint32_t y) { return y * (squares + 1) + x; };
    // One square of a wall, the air on the right of the way from a to b.
    const auto wall = [&](std::uint32_t ax, std::uint32_t ay, std::uint32_t bx, std::uint32_t by) {
        add_face(level, high(ax, ay), low(ax, ay), low(bx, by));
        add_face(level, high(ax, ay), low(bx, by), high(bx, by));
    };
    const std::uint32_t n = squares;
    for (std::uint32_t k = 0; k < n; ++k) {
        wall(k, 0, k + 1, 0);
        wall(n, k, n, k + 1);
        wall(k + 1, n, k, n);
        wall(0, k + 1, 0, k);
    }
    for (std::uint32_t x = 0; x < n; ++x) {
        add_face(level, low(0, 1), low(x + 1, 0), low(x, 0));
        add_face(level, low(0, n - 1), low(x, n), low(x + 1, n));
    }
    add_face(level, low(0, 1), low(n, 1), low(n, 0));
    add_face(level, low(0, n - 1), low(n, n), low(n, n - 1));
    for (std::uint32_t y = 1; y + 1 < n; ++y) {
        add_face(level, low(0, y), low(n, y + 1), low(n, y));
        add_face(level, low(0, y), low(0, y + 1), low(n, y + 1));
    }
    level.source_faces = std::uint32_t(level.faces.size());
}

FloatCast rounded(const Vec3& start, const Vec3& path, double radius) {
    FloatCast cast;
    for (int axis = 0; axis < 3; ++axis) {
        cast.start[axis] = float(start[axis]);
        cast.path[axis] = float(path[axis]);
    }
    cast.radius = float(radius);
    return cast;
}

std::vector<scenes::CastQuery> queries(const ScaleScene& scene, const scenes::CastRange& range, std::size_t count,
                                       std::uint64_t seed) {
    return scene.is_ground() ? scenes::casts_over_terrain(scene.ground, scene.level, range, count, seed)
                             : scenes::casts_in_rooms(scene.rooms, range, count, seed);
}

/// Whether a path that starts in the air must meet something: it ends below the ground, or beyond all that the air is
/// closed in by.
bool must_hit(const ScaleScene& scene, const World& world, const Vec3& end) {
    const Box bounds = world.bounds();
    bool within = true;
    for (int axis = 0; axis < 3; ++axis) within &= bounds.low[axis] < end[axis] && end[axis] < bounds.high[axis];
    if (!scene.is_ground()) return !within;
    if (!within) return false;
    const Vec3 above{end.x, end.y, bounds.high.z + 1};
    const Hit ground = cast(world, Ray{above, {0, 0, 2 * (bounds.low.z - above.z)}}, {.sides = Sides::kBoth});
    return ground.touched() && ground.point.z > end.z + 0.01;
}

/// From the grid, at a corner of the face that another ray meets, or at the middle between two: all of it is exact in
/// float, so the ray goes through that very point.
std::vector<FloatCast> rays_at_edges(const ScaleScene& scene, const World& world, std::size_t count) {
    std::vector<FloatCast> casts;
    scenes::Rng rng(29);
    for (std::uint64_t seed = 31; casts.size() < count; ++seed) {
        for (const scenes::CastQuery& query : queries(scene, {0, 0, 20, 20}, count, seed)) {
            if (casts.size() == count) break;
            Vec3 start;
            for (int axis = 0; axis < 3; ++axis)
                start[axis] = std::round(query.sphere.centre[axis] * kInputSteps) / kInputSteps;
            const Hit hit = cast(world, Ray{start, query.path}, {.sides = Sides::kBoth});
            if (!hit.touched() || hit.fraction == 0) continue;
            const std::vector<Vec3> corners = world.face(hit.face)->corners;
            const std::uint32_t corner = rng.below(std::uint32_t(corners.size()));
            Vec3 target = corners[corner];
            if (rng.chance(0.5)) target = (target + corners[(corner + 1) % corners.size()]) * 0.5;
            Vec3 path = target - start;
            for (int doubled = 0; doubled < 12; ++doubled) {
                path = path * 2;
                if (!must_hit(scene, world, start + path)) continue;
                casts.push_back(rounded(start, path, 0));
                break;
            }
        }
    }
    return casts;
}

}  // namespace

ScaleScene ground_scene(std::size_t triangles) {
    ScaleScene scene;
    scene.name = "ground";
    scene.ground = {int(std::sqrt(double(triangles) / 2)), 3};
    scene.level = scenes::terrain(scene.ground);
    scene.mesh = mesh_of_level(scene.level);
    return scene;
}

ScaleScene rooms_scene_of(std::size_t triangles) {
    ScaleScene scene;
    scene.name = "rooms";
    scene.rooms = scenes::room_grid_of(triangles);
    scene.level = scenes::room_grid(scene.rooms);
    scene.mesh = mesh_of_level(scene.level);
    return scene;
}

TriangleMesh mesh_of_level(const Level& level) {
    TriangleMesh mesh;
    mesh.positions.reserve(3 * level.vertices.size());
    for (const GridPoint& vertex : level.vertices) {
        const Vec3 at = to_metres(vertex);
        for (int axis = 0; axis < 3; ++axis) mesh.positions.push_back(float(at[axis]));
    }
    mesh.corners = level.corners;  // all faces are triangles, in order
    return mesh;
}

Level closed_level(const ScaleScene& scene) {
    Level level = scene.level;
    if (scene.is_ground()) close_below(level, std::uint32_t(scene.ground.squares));
    return level;
}

Level castable_only(const Level& level) {
    Level both = level;
    for (LevelFace& face : both.faces) face.two_sided = true;
    return both;
}

std::vector<FloatCast> casts_of(const ScaleScene& scene, const KindOfCast& kind, const World& world,
                                std::size_t count) {
    if (kind.at_edges) return rays_at_edges(scene, world, count);
    std::vector<FloatCast> casts;
    const auto seed = std::uint64_t(&kind - kKinds) + 1;
    for (const scenes::CastQuery& query : queries(scene, kind.range, count, seed))
        casts.push_back(rounded(query.sphere.centre, query.path, query.sphere.radius));
    return casts;
}

}  // namespace firma::bench
