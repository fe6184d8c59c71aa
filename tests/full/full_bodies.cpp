// SPDX-License-Identifier: MIT
// Bodies thrown through the depot and two maps of OpenArena for a minute, at 30 and at 60 steps a second, through
// levels cut before or while they fly, judged in each frame. Prints one claim.
//
//   full_bodies --count 1000 (bodies at once) --seed 1 (which says the level, the rate and when it is cut)
//               [--seconds 60] [--maps FOLDER]
#include <cstdio>
#include <cstdlib>
#include <string>

#include "firma/brush_world.h"
#include "tests/full/options.h"
#include "tests/reference/judge_bodies.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    full::Options options;
    std::uint64_t seconds = 60;
    std::string maps = "build/openarena";
    if (!full::read_options(count, words, options, {{"--seconds", &seconds, nullptr}, {"--maps", nullptr, &maps}})) {
        std::fprintf(stderr, "full_bodies [--count N] [--seed N] [--seconds N] [--maps FOLDER]\n");
        return 2;
    }
    const std::string levels[] = {"levels/depot.map", maps + "/kaos2.bsp", maps + "/oa_koth1.bsp"};
    const std::string& level = levels[options.seed % 3];
    const Result<BrushLevel> read = read_brush_level(level);
    if (!read) return std::fprintf(stderr, "%s\n", read.error().text().c_str()), 2;
    const Result<World> world = make_world(read.value());
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 2;
    reference::BodyRun run;
    run.bodies = std::uint32_t(options.count);
    run.seconds = double(seconds);
    run.rate = options.seed / 3 % 2 ? 30 : 60;
    run.cut = options.seed / 6 % 2;
    run.seed = options.seed;
    const reference::BodyVerdict verdict = reference::judge_bodies(world.value(), run);
    if (!verdict.fault.empty()) std::printf("failure level=%s %s\n", level.c_str(), verdict.fault.c_str());
    const bool pass = verdict.fault.empty() && verdict.bounces > verdict.bodies;
    std::printf(
        "claim=never_through family=total count=%llu seed=%llu level=%s rate=%g cut=%s frames=%zu chunks=%zu "
        "cuts=%zu bounces=%zu asleep=%zu spheres=%llu deepest_mm=%.3f ms_a_step=%.3f result=%s\n",
        ull(options.count), ull(options.seed), level.c_str(), run.rate, run.cut ? "meanwhile" : "before",
        verdict.frames, verdict.chunks, verdict.cuts, verdict.bounces, verdict.asleep, ull(verdict.looked_at),
        verdict.deepest * 1000, verdict.seconds * 1000 / double(std::max<std::size_t>(verdict.frames, 1)),
        pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
