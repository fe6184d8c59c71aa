// SPDX-License-Identifier: MIT
// The program of docs/game_loop.md: fixed steps, a player, craters carved in slices of time, particles.
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "firma/firma.h"

using firma::Hit, firma::Vec3, firma::World;

constexpr double kStep = 1.0 / 60;    // seconds a frame
constexpr double kSlice = 500;        // microseconds a frame for carving
constexpr int kFramesForCrater = 10;  // from its first slice until it is there, on every machine

struct Input {
    int frames;  // for so long
    Vec3 walk;   // metres a second
    Vec3 shot;   // fired in the first of the frames, unless it is zero
};
const std::vector<Input> kScript = {
    {80, {-1.5, -2.5, 0}, {}}, {40, {}, {20, 0, -20}}, {40, {}, {20, 0, -20}},
    {40, {}, {20, 0, -40}},    {100, {2, 0, 0}, {}},
};

struct Particle {
    Vec3 position, velocity;
    int frames;  // left
};

struct Crater {
    Hit hit;
    World before;
    firma::CarveJob job;
    int due;  // the frame in which it is published
};

// Moves the ball along a path, then along what it meets. Returns whether it stands on something.
bool slide(const World& world, firma::Sphere& ball, Vec3 path) {
    bool stands = false;
    for (int k = 0; k < 4; ++k) {
        const Hit hit = cast(world, ball, path, {.mask = firma::kStopsWalk});
        ball.centre = ball.centre + path * hit.safe_fraction;
        if (!hit) break;
        stands = stands || hit.normal.z > 0.7;
        path = path * (1 - hit.safe_fraction);
        path = path - hit.normal * dot(path, hit.normal);
    }
    return stands;
}

// Moves all particles by one batch of casts. They bounce, and lose half of their speed.
void move(const World& world, std::vector<Particle>& particles) {
    std::erase_if(particles, [](Particle& one) { return one.frames-- == 0; });
    std::vector<firma::CastInput> inputs;
    for (Particle& one : particles) {
        one.velocity.z -= 9.81 * kStep;
        inputs.push_back({{one.position, 0}, one.velocity * kStep});
    }
    std::vector<Hit> hits(inputs.size());
    if (!cast_batch(world, inputs, hits, {.mask = firma::kStopsShots})) return;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        Particle& one = particles[k];
        one.position = one.position + inputs[k].path * hits[k].safe_fraction;
        const Vec3& n = hits[k].normal;
        if (hits[k]) one.velocity = (one.velocity - n * (2 * dot(one.velocity, n))) * 0.5;
    }
}

int main() {
    const firma::Result<firma::BrushLevel> level = firma::read_brush_level("levels/depot.map");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::Result<World> made = make_world(level.value());
    if (!made) return std::puts(made.error().text().c_str()), 1;
    firma::WorldStore store(made.value(), {.history_bytes = 8 << 20});

    firma::Sphere ball{.centre = {}, .radius = 0.5};
    for (const firma::Entity& entity : level.value().entities)
        if (entity.value("classname") == "info_player_start")
            ball.centre = entity_origin(level.value(), entity).value_or(Vec3{});
    const firma::Cutter rocky = firma::make_crater(firma::CutterShape::kRocky, 1);
    std::deque<Hit> shots;         // whose craters are not begun
    std::optional<Crater> crater;  // the one that is being carved
    std::vector<Particle> particles;
    double fall = 0;
    std::size_t casts = 0;
    int frame = 0;
    for (const Input& input : kScript)
        for (int k = 0; k < input.frames; ++k, ++frame) {
            const World world = store.current();  // one handle for the whole frame
            fall -= 9.81 * kStep;
            if (slide(world, ball, (input.walk + Vec3{0, 0, fall}) * kStep)) fall = 0;
            if (k == 0 && !(input.shot == Vec3{}))
                if (const Hit hit = cast(world, {ball.centre, input.shot}, {.mask = firma::kStopsShots}))
                    shots.push_back(hit);

            if (!crater && !shots.empty()) {
                const firma::Pose pose{shots[0].point, firma::random_turn(world.version()), 1.6};
                crater = Crater{shots[0], world, firma::CarveJob(world, rocky, pose), frame + kFramesForCrater};
                shots.pop_front();
            }
            if (crater) crater->job.run(frame == crater->due ? INFINITY : kSlice);
            if (crater && frame == crater->due) {
                const firma::CarveResult result = crater->job.result();
                if (!result.done())
                    std::printf("frame %3d: no crater: %s\n", frame, result.error.text().c_str());
                else if (store.publish(crater->before, result.world) == firma::PublishStatus::kDone)
                    std::printf("frame %3d: version %" PRIu64 ", %.2f m3 carved\n", frame, result.world.version(),
                                result.report.volume);
                for (std::uint64_t seed = 0; seed < 100; ++seed) {
                    const firma::Quaternion turn = firma::random_turn(seed);
                    const Vec3 start = crater->hit.point + crater->hit.normal * 0.05;
                    particles.push_back({start, Vec3{turn[0], turn[1], turn[2]} * 6, 90});
                }
                crater.reset();
            }
            move(world, particles);
            casts += particles.size();
            if (k + 1 == input.frames)
                std::printf("frame %3d: at (%.3f, %.3f, %.3f), %zu particles\n", frame, ball.centre.x, ball.centre.y,
                            ball.centre.z, particles.size());
        }
    std::printf("%d frames, %zu casts of particles, hash %016" PRIx64 "\n", frame, casts, hash_world(store.current()));
}
