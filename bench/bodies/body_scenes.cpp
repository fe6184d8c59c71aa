// SPDX-License-Identifier: MIT
// Scenes of bodies, made by seeds.
#include "bodies/body_scenes.h"

#include <cmath>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "scenes/level_cuts.h"
#include "scenes/rng.h"
#include "tests/reference/judge_bodies.h"

namespace firma::bench {
namespace {

using scenes::Rng;

World level_of(const std::string& file) {
    const Result<BrushLevel> level = read_brush_level(file);
    if (!level) return {};
    const Result<World> world = make_world(level.value());
    return world ? with_anchors(world.value()) : World();
}

/// Cut all over; what comes loose becomes bodies.
BodyScene rubble(World world, std::size_t most) {
    BodyScene scene{"rubble", "chunks of blasts, at most 12 spheres each, where they came loose", {}, {}, 10};
    const scenes::CutPlaces places = scenes::cut_places(world);
    CarveOptions options;
    options.chunks = ChunkOptions{};
    for (std::uint64_t index = 0; index < 200 && scene.bodies.size() < most; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, 7, index)) {
            Pose pose = order.pose;
            pose.scale *= 2;
            CarveResult cut = carve(world, order.cutter, pose, options);
            world = cut.world;
            for (const Chunk& chunk : cut.chunks)
                if (const Result<Body> body = body_of(chunk, {.max_spheres = 12}); body && scene.bodies.size() < most)
                    scene.bodies.push_back(body.value());
        }
    scene.world = world;
    return scene;
}

/// As judge_bodies() throws them, at speeds from `least` to `most`.
BodyScene thrown(std::string name, const World& world, std::size_t count, double least, double most) {
    BodyScene scene{std::move(name), "bodies of 1 to 200 spheres", world, {}, 10};
    scene.what += ", " + std::to_string(int(least)) + " to " + std::to_string(int(most)) + " m/s";
    const Level walls = scenes::cut_places(world).inside;
    Rng rng(5);
    while (scene.bodies.size() < count) {
        Body body = reference::random_body(world, walls, rng);
        const Vec3 way = rng.direction();
        body.velocity = way * (least * std::pow(most / least, rng.uniform(0, 1)));
        body.spin = body.spin * 0.1;
        body.restitution = 0.3;
        scene.bodies.push_back(body);
    }
    return scene;
}

BodyShape box_shape(double half, double density) {
    SphereSet spheres;
    for (int corner = 0; corner < 8; ++corner) {
        Sphere sphere{{half / 2, half / 2, half / 2}, half / 2};
        for (int axis = 0; axis < 3; ++axis)
            if (corner >> axis & 1) sphere.centre[axis] = -sphere.centre[axis];
        spheres.push_back(sphere);
    }
    return make_body_shape(spheres, mass_of_box({half, half, half}, density)).value();
}

/// @param top  density of the highest box of a stack, the others' is 1000
BodyScene stacks(std::string name, int count, int height, double top) {
    const std::string slab =
        "{\n\"classname\" \"worldspawn\"\n{\n( -4096 -4096 0 ) ( -4096 4096 0 ) ( 4096 -4096 0 ) rock 0 0 0 1 1\n"
        "( -4096 -4096 -128 ) ( 4096 -4096 -128 ) ( -4096 4096 -128 ) rock 0 0 0 1 1\n"
        "( -4096 -4096 -128 ) ( -4096 4096 -128 ) ( -4096 -4096 0 ) rock 0 0 0 1 1\n"
        "( 4096 -4096 -128 ) ( 4096 -4096 0 ) ( 4096 4096 -128 ) rock 0 0 0 1 1\n"
        "( -4096 -4096 -128 ) ( -4096 -4096 0 ) ( 4096 -4096 -128 ) rock 0 0 0 1 1\n"
        "( -4096 4096 -128 ) ( 4096 4096 -128 ) ( -4096 4096 0 ) rock 0 0 0 1 1\n}\n}\n";
    BodyScene scene{std::move(name), "", make_world(read_map(slab, "slab.map").value()).value(), {}, 10};
    scene.what = std::to_string(count) + " stacks of " + std::to_string(height) + " boxes";
    if (top != 1000) scene.what += ", the highest " + std::to_string(int(top / 1000)) + " times as heavy";
    scene.half = 0.25;
    const BodyShape box = box_shape(0.25, 1000), highest = box_shape(0.25, top);
    for (int stack = 0; stack < count; ++stack)
        for (int k = 0; k < height; ++k) {
            Pose pose;
            pose.position = {stack * 2.0, 0, 0.25 + 0.5 * k};
            scene.bodies.push_back(body_at(k + 1 == height ? highest : box, pose));
        }
    return scene;
}

}  // namespace

std::vector<BodyScene> body_scenes(const std::string& repository, bool quick) {
    const std::size_t share = quick ? 50 : 1;
    std::vector<BodyScene> scenes;
    const World depot = level_of(repository + "/levels/depot.map");
    scenes.push_back(rubble(depot, 200 / share));
    scenes.push_back(thrown("thrown, depot", depot, 1000 / share, 1, 30));
    scenes.push_back(thrown("fast, depot", depot, 500 / share, 100, 1000));
    if (const Result<World> small = read_world(repository + "/levels/first.obj"))  // of 9,680 triangles
        scenes.push_back(thrown("thrown, first.obj", small.value(), 500 / share, 1, 30));
    for (const char* map : {"kaos2", "oa_koth1"})
        if (const World world = level_of(repository + "/build/openarena/" + map + ".bsp"); world.face_count() > 0)
            scenes.push_back(thrown(std::string("thrown, ") + map, world, 500 / share, 1, 30));
    scenes.push_back(stacks("stacks", quick ? 1 : 20, 10, 1000));
    scenes.push_back(stacks("heavy on light", quick ? 1 : 20, 4, 1'000'000));
    if (quick)
        for (BodyScene& scene : scenes) scene.seconds = 0.5;
    return scenes;
}

}  // namespace firma::bench
