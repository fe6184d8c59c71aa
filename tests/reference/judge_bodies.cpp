// SPDX-License-Identifier: MIT
// Bodies in levels that are cut, judged frame by frame.
#include "tests/reference/judge_bodies.h"

#include <chrono>
#include <cmath>

#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "tests/reference/rooms_outside.h"

namespace firma::reference {
namespace {

using scenes::Rng;

constexpr std::size_t kMaxChunks = 300;
constexpr int kCutsBefore = 40;

Vec3 random_velocity(Rng& rng) {
    const Vec3 way = rng.direction();
    return way * std::pow(10.0, rng.uniform(0, 3));
}

void throw_body(firma::Body& body, Rng& rng) {
    body.velocity = random_velocity(rng);
    const Vec3 axis = rng.direction();
    body.spin = axis * rng.uniform(0, 200);
}

/// A level, the cuts that are made in it, and its bodies.
class BodyGame {
public:
    BodyGame(const World& level, const BodyRun& run)
        : world_(with_anchors(level)), places_(scenes::cut_places(level)), run_(run), rng_(run.seed), depths_(true) {}

    BodyVerdict play() {
        BodyVerdict verdict;
        if (!run_.cut)
            for (int k = 0; k < kCutsBefore; ++k) cut();
        for (std::uint32_t k = 0; k < run_.bodies; ++k) add_body(bodies_, random_body(world_, places_.inside, rng_));
        const int frames = int(run_.seconds * run_.rate), a_cut = int(run_.rate / 2);
        for (int frame = 0; frame < frames && verdict.fault.empty(); ++frame) {
            if (run_.cut && frame % a_cut == 0) cut();
            throw_some();
            const auto start = std::chrono::steady_clock::now();
            verdict.bounces += step(bodies_, world_, 1 / run_.rate).bounces;
            verdict.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            ++verdict.frames;
            if (const std::string fault = depths_.fault(world_, bodies_); !fault.empty())
                verdict.fault = "frame " + std::to_string(frame) + ": " + fault;
        }
        verdict.bodies = run_.bodies;
        verdict.chunks = chunks_;
        verdict.cuts = cuts_;
        for (const firma::Body& body : bodies_.slots) verdict.asleep += body.asleep;
        verdict.looked_at = depths_.looked_at();
        verdict.deepest = depths_.deepest();
        return verdict;
    }

private:
    void cut() {
        const auto orders = scenes::level_cuts(places_, scenes::LevelCuts::kSpread, run_.seed, next_cut_++);
        if (orders.empty()) return;
        CarveOptions options;
        options.chunks = ChunkOptions{};
        const CarveResult made = carve(world_, orders[0].cutter, orders[0].pose, options);
        if (opens_way_out(world_, made.world)) return;
        world_ = made.world;
        cuts_ += made.done();
        for (const Chunk& chunk : made.chunks) {
            if (chunks_ == kMaxChunks) return;
            const Result<firma::Body> body = body_of(chunk, {.max_spheres = 12});
            if (!body) continue;
            add_body(bodies_, body.value());
            ++chunks_;
        }
    }

    void throw_some() {
        constexpr double kEvery = 10;  // seconds
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            if (!rng_.chance(1 / (kEvery * run_.rate))) continue;
            wake_body(bodies_, {slot, bodies_.slots[slot].use});
            throw_body(bodies_.slots[slot], rng_);
        }
    }

    World world_;
    const scenes::CutPlaces places_;
    const BodyRun& run_;
    Rng rng_;
    Bodies bodies_;
    BodyDepths depths_;
    std::uint64_t next_cut_ = 0;
    std::size_t cuts_ = 0, chunks_ = 0;
};

}  // namespace

firma::Body random_body(const World& world, const Level& walls, Rng& rng) {
    SphereSet spheres;
    const std::uint32_t many = rng.chance(0.1) ? 200 : 40, few = 1 + rng.below(8);
    const std::uint32_t count = rng.chance(0.1) ? many : few;
    const double size = rng.uniform(0.05, 0.3);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Vec3 way = rng.direction();
        const double far = count == 1 ? 0 : rng.uniform(0, size);
        spheres.push_back({way * far, size * rng.uniform(0.15, 0.5)});
    }
    const Vec3 half{size, size * rng.uniform(0.3, 1), size};
    const double density = std::pow(10.0, rng.uniform(2, 4));
    const BodyShape shape = make_body_shape(spheres, mass_of_box(half, density)).value();
    const std::vector<bool> outside = rooms_outside(world);
    constexpr double kWide = 0.5;  // no shape reaches so far
    for (;;) {
        const LevelFace& face = walls.faces[rng.below(std::uint32_t(walls.faces.size()))];
        const auto corner = [&](std::uint32_t k) {
            return to_metres(walls.vertices[walls.corners[face.first_corner + k]]);
        };
        const Vec3 a = corner(0), b = corner(1), c = corner(2), across = cross(b - a, c - a);
        const double i = rng.uniform(0, 1), j = rng.uniform(0, 1 - i), out = rng.uniform(kWide, 4);
        Pose pose;
        pose.position = a + (b - a) * i + (c - a) * j + across * (out / length(across));
        pose.rotation = random_turn(rng.next());
        const Location at = locate(world, pose.position);
        if (at.where != Where::kAir || outside[at.room.value] || closest(world, pose.position, kWide)) continue;
        firma::Body body = body_at(shape, pose);
        throw_body(body, rng);
        body.restitution = rng.uniform(0, 0.9);
        return body;
    }
}

std::string BodyDepths::fault(const World& world, const Bodies& bodies) {
    slept_.resize(bodies.slots.size(), false);
    if (kept_in_ && version_ != world.version()) outside_ = rooms_outside(world);
    for (std::size_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const firma::Body& body = bodies.slots[slot];
        if (!body.shape.valid() || (body.asleep && slept_[slot] && version_ == world.version())) continue;
        slept_[slot] = body.asleep;
        if (const std::string fault = fault_of(world, body); !fault.empty())
            return "body " + std::to_string(slot) + ": " + fault;
    }
    version_ = world.version();
    return "";
}

/// Of a sphere's centre: the centre of mass need not be in any sphere, and may lie beyond a thin wall.
bool BodyDepths::is_lost(const World& world, const Vec3& centre) const {
    const Location at = locate(world, centre);
    return at.where == Where::kUnknown || (at.where == Where::kAir && outside_[at.room.value]);
}

/// Metres, into the nearest of the faces that bound solid; 0 where none is touched. Others may be nearer.
double BodyDepths::depth_in_solid(const World& world, const Sphere& sphere) const {
    double depth = 0;
    overlap_each(world, sphere, [&](const Overlap& overlap) {
        if (overlap.face.valid() && world.face_info(overlap.face)->solid)
            depth = std::max(depth, sphere.radius - overlap.distance);
        return true;
    });
    return depth;
}

std::string BodyDepths::fault_of(const World& world, const firma::Body& body) {
    const double skin = world.tolerance().contact_offset;
    const Pose pose = pose_of(body);
    const TurnMatrix turn = matrix_of(pose.rotation);
    for (const Sphere& sphere : body.shape.spheres()) {
        ++looked_at_;
        const Vec3 centre = pose.position + turn * sphere.centre;
        if (locate(world.solid(), centre) == Where::kSolid) return "a centre in solid";
        if (kept_in_ && is_lost(world, centre)) return "lost";
        const double depth = depth_in_solid(world, {centre, sphere.radius});
        deepest_ = std::max(deepest_, depth);
        if (depth > skin * 1.001) return "a sphere " + std::to_string(depth) + " m deep";
    }
    return "";
}

BodyVerdict judge_bodies(const World& level, const BodyRun& run) {
    return BodyGame(level, run).play();
}

}  // namespace firma::reference
