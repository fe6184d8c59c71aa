// SPDX-License-Identifier: MIT
// Cases of our own.
#include "support/family_cases.h"

#include <algorithm>

#include "firma/queries.h"
#include "firma/world.h"
#include "scenes/cast_families.h"
#include "scenes/room_grid.h"
#include "scenes/terrain.h"
#include "tests/source_of.h"

namespace firma::bench {
namespace {

/// How deep the sphere would have got in a face, had it gone on: looked for in steps.
double margin_of(const scenes::CastQuery& move, const std::vector<Vec3>& face) {
    constexpr int kSteps = 256;
    double nearest = INFINITY;
    for (int step = 0; step <= kSteps; ++step) {
        const Vec3 centre = move.sphere.centre + move.path * (double(step) / kSteps);
        nearest = std::min(nearest, closest_point(centre, face).distance);
    }
    return std::max(0.0, move.sphere.radius - nearest);
}

ExactCase judged(std::string name, const scenes::CastScene& scene) {
    ExactCase exact;
    exact.name = std::move(name);
    exact.level = scenes::level_of(scene.polygons);
    exact.casts = scene.casts;
    const World world = make_world(exact.level).value();
    for (const scenes::GridPolygon& polygon : scene.polygons) exact.faces.push_back(scenes::to_metres(polygon));
    for (const scenes::CastQuery& move : exact.casts) {
        const Hit hit = cast(world, move.sphere, move.path);
        Expected expected;
        expected.status = hit.status;
        expected.fraction = hit.fraction;
        if (hit.touched()) {
            const std::uint32_t face = source_of(world, hit);
            expected.faces = {face};
            expected.margin = expected.first_margin = margin_of(move, exact.faces[face]);
        }
        exact.expected.push_back(expected);
    }
    return exact;
}

ExactCase unjudged(Level level, std::vector<scenes::CastQuery> first, const std::vector<scenes::CastQuery>& second) {
    ExactCase exact;
    exact.level = std::move(level);
    exact.casts = std::move(first);
    exact.casts.insert(exact.casts.end(), second.begin(), second.end());
    exact.faces.resize(exact.level.source_faces);
    for (const LevelFace& face : exact.level.faces)
        for (std::uint32_t c = 0; c < face.corner_count; ++c)
            exact.faces[face.source].push_back(
                firma::to_metres(exact.level.vertices[exact.level.corners[face.first_corner + c]]));
    return exact;
}

}  // namespace

std::vector<ExactCase> ordinary_cases(std::size_t casts_each) {
    using namespace scenes;
    const RoomGrid room{1, 1, 1, 0.15, 1};
    const Terrain ground{24, 3};
    Level land = terrain(ground);
    std::vector<CastQuery> spheres = casts_over_terrain(ground, land, kShortSpheres, casts_each, 1);
    const std::vector<CastQuery> rays = casts_over_terrain(ground, land, kShortRays, casts_each, 2);
    std::vector<ExactCase> cases;
    cases.push_back(unjudged(room_grid(room), casts_in_rooms(room, kShortSpheres, casts_each, 3),
                             casts_in_rooms(room, kShortRays, casts_each, 4)));
    cases.push_back(unjudged(std::move(land), std::move(spheres), rays));
    return cases;
}

std::vector<ExactCase> family_cases(std::size_t scenes_each) {
    std::vector<ExactCase> cases;
    for (const scenes::CastFamily& family : scenes::cast_families())
        for (std::size_t k = 0; k < scenes_each; ++k)
            cases.push_back(judged(std::string(family.name), scenes::make_cast_scene(family, 1, k)));
    return cases;
}

}  // namespace firma::bench
