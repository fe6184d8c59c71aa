// SPDX-License-Identifier: MIT
// Bodies beside Bullet's in one run: time a step, bodies lost, depth, energy that comes from nowhere, time to rest.
//
//   bench_bodies [--quick] [--csv DIR] [FOLDER]
//
// Into FOLDER go the scenes, for bench/node/bench_bodies.mjs; nothing is run then.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bodies/body_peer.h"
#include "bodies/body_scenes.h"
#include "bodies/write_scenes.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

struct Figures {
    std::vector<double> steps;  ///< seconds each
    std::size_t lost = 0;       ///< at the end: a centre in solid, or out of the level
    double deepest = 0;         ///< metres, of all looks
    double gained = 0;          ///< joules: the most above an earlier energy
    double spent = 0;           ///< joules from start to end
    double rest = INFINITY;     ///< seconds until 95 of 100 sleep
    std::size_t awake = 0;      ///< at the end
    double toppled = 0;         ///< metres: how much lower the highest body is at the end
};

double energy_of(const std::vector<Body>& bodies) {
    double sum = 0;
    for (const Body& body : bodies)
        sum += kinetic_energy(body) - body.shape.mass() * dot(StepOptions().gravity, body.position);
    return sum;
}

/// Of spheres that are not in solid as a whole: how deep the deepest is. Counts bodies with a centre in solid.
void look(const World& world, const std::vector<Body>& bodies, Figures& figures) {
    const Box box = world.bounds();
    figures.lost = 0;
    for (const Body& body : bodies) {
        bool lost = body.position.z < box.low.z;
        const Pose pose = pose_of(body);
        const TurnMatrix turn = matrix_of(pose.rotation);
        for (const Sphere& sphere : body.shape.spheres()) {
            const Vec3 centre = pose.position + turn * sphere.centre;
            if (lost || locate(world.solid(), centre) == Where::kSolid) {
                lost = true;
                break;
            }
            const NearFace near = closest(world, centre, sphere.radius);
            if (near && world.face_info(near.face)->solid)
                figures.deepest = std::max(figures.deepest, sphere.radius - near.distance);
        }
        figures.lost += lost;
    }
}

double top_of(const std::vector<Body>& bodies) {
    double top = -INFINITY;
    for (const Body& body : bodies) top = std::max(top, body.position.z);
    return top;
}

Figures run(BodyPeer& peer, const BodyScene& scene) {
    constexpr int kLookEvery = 6;  // steps
    Figures figures;
    std::vector<Body> bodies = scene.bodies;
    peer.start(scene);
    const double first = energy_of(bodies), top = top_of(bodies);
    double least = first;
    const int steps = int(scene.seconds * 60);
    for (int k = 1; k <= steps; ++k) {
        const double before = thread_seconds();
        peer.step();
        figures.steps.push_back(thread_seconds() - before);
        peer.read(bodies);
        const double energy = energy_of(bodies);
        figures.gained = std::max(figures.gained, energy - least);
        least = std::min(least, energy);
        figures.awake =
            std::size_t(std::count_if(bodies.begin(), bodies.end(), [](const Body& body) { return !body.asleep; }));
        if (figures.rest == INFINITY && figures.awake * 20 <= bodies.size()) figures.rest = k / 60.0;
        if (k % kLookEvery == 0 || k == steps) look(scene.world, bodies, figures);
    }
    figures.spent = first - energy_of(bodies);
    figures.toppled = top - top_of(bodies);
    return figures;
}

std::vector<std::string> row(const BodyScene& scene, const BodyPeer& peer, const Figures& figures, double beside) {
    double sum = 0, worst = 0;
    for (const double step : figures.steps) sum += step, worst = std::max(worst, step);
    const double mean = sum / double(figures.steps.size());
    return {scene.name,
            peer.name(),
            count(scene.bodies.size()),
            number(mean * 1e3),
            number(worst * 1e3),
            number(double(scene.bodies.size()) / (mean * 1e3)),
            beside > 0 ? times(mean / beside) : "",
            count(figures.lost),
            number(figures.deepest * 1e3),
            percent(figures.gained / std::max(figures.spent, 1e-9)),
            figures.rest < INFINITY ? number(figures.rest) : "no",
            count(figures.awake)};
}

int write_all(const Settings& settings) {
    const std::string fault = write_scenes(body_scenes(settings.repository, settings.quick), settings.rest);
    if (!fault.empty()) std::fprintf(stderr, "bench_bodies: %s\n", fault.c_str());
    return fault.empty() ? 0 : 1;
}

int run_all(const Settings& settings) {
    std::vector<std::unique_ptr<BodyPeer> (*)()> peers{make_firma_bodies};
#ifdef FIRMA_WITH_BULLET
    peers.push_back(make_bullet_bodies);
    peers.push_back(make_bullet_bodies_with_margin);
#endif
    for (const auto& make : peers) std::printf("%s\n", make()->describe().c_str());
    Table table("bodies", {"scene", "library", "bodies", "ms a step", "worst ms", "bodies a ms", "of Firma's", "lost",
                           "deepest mm", "energy gained", "at rest after s", "awake at the end"});
    for (const BodyScene& scene : body_scenes(settings.repository, settings.quick)) {
        std::printf("%s: %s\n", scene.name.c_str(), scene.what.c_str());
        double first = 0;
        for (const auto& make : peers) {
            const std::unique_ptr<BodyPeer> peer = make();
            const Figures figures = run(*peer, scene);
            table.add(row(scene, *peer, figures, first));
            if (first == 0) {
                for (const double step : figures.steps) first += step;
                first /= double(figures.steps.size());
            }
        }
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    const firma::bench::Settings settings = firma::bench::read_settings(
        argc, argv,
        "bodies: rubble, bodies thrown through levels and stacks, beside Bullet where it is found; with a folder as "
        "argument writes the scenes there for bench/node, and runs nothing");
    return settings.rest.empty() ? firma::bench::run_all(settings) : firma::bench::write_all(settings);
}
