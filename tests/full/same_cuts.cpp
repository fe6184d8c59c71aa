// SPDX-License-Identifier: MIT
// Fires craters of every shape into our level and prints the hashes of what is left: the same from every compiler.
//
//   same_cuts LEVEL.obj CUTS
#include <cstdio>
#include <cstdlib>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "scenes/rng.h"

int main(int count, char** words) {
    using namespace firma;
    if (count != 3) return std::fputs("usage: same_cuts LEVEL.obj CUTS\n", stderr), 2;
    const Result<Level> level = read_level(words[1]);
    if (!level) return std::fprintf(stderr, "%s\n", level.error().text().c_str()), 1;
    World world = make_world(level.value()).value();
    const Box bounds = world.bounds();
    scenes::Rng rng(20031);
    int done = 0, retries = 0;
    for (int cut = 0; cut < std::atoi(words[2]); ++cut) {
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = rng.uniform(bounds.low[axis], bounds.high[axis]);
            // Every third one where vertices of the level lie.
            pose.position[axis] = cut % 3 ? at : double(int(at));
        }
        const std::uint64_t turn = rng.next();
        if (cut % 3) pose.rotation = random_turn(turn);
        pose.scale = rng.uniform(0.5, 3);
        const auto shape = CutterShape(rng.below(5));
        const Cutter cutter = make_crater(shape, rng.next());
        const CarveResult result = rng.chance(0.1) ? fill(world, cutter, pose) : carve(world, cutter, pose);
        done += result.done();
        retries += result.report.retries;
        world = result.world;
    }
    std::printf("done=%d retries=%d faces=%zu world=%016llx solid=%016llx\n", done, retries, world.face_count(),
                static_cast<unsigned long long>(hash_world(world)), static_cast<unsigned long long>(hash_solid(world)));
}
