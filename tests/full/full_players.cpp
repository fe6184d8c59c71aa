// SPDX-License-Identifier: MIT
// A player with random wishes in the depot and two maps of OpenArena, blasted, filled, undone and shut around it, on a
// lift and beside a leaf that swings, judged in each frame. Prints one claim.
//
//   full_players --count 60000 (frames) --seed 1 (which says the level, the shape and the rate) [--maps FOLDER]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "firma/brush_world.h"
#include "tests/full/options.h"
#include "tests/player/player_shapes.h"
#include "tests/reference/judge_players.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    full::Options options;
    std::string maps = "build/openarena";
    if (!full::read_options(count, words, options, {{"--maps", nullptr, &maps}})) {
        std::fprintf(stderr, "full_players [--count N] [--seed N] [--maps FOLDER]\n");
        return 2;
    }
    const std::string levels[] = {"levels/depot.map", maps + "/kaos2.bsp", maps + "/oa_koth1.bsp"};
    const std::string& level = levels[options.seed % 3];
    const Result<BrushLevel> read = read_brush_level(level);
    if (!read) return std::fprintf(stderr, "%s\n", read.error().text().c_str()), 2;
    const Result<World> world = make_world(read.value());
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 2;
    reference::PlayerRun run;
    run.frames = options.count;
    run.rate = options.seed / 9 % 2 ? 30 : 60;
    run.seed = options.seed;
    const std::size_t shape = options.seed / 3 % 3;
    const reference::PlayerVerdict verdict = reference::judge_player(world.value(), test::player_shapes()[shape], run);
    if (!verdict.fault.empty()) std::printf("failure level=%s %s\n", level.c_str(), verdict.fault.c_str());
    const bool pass = verdict.fault.empty() && verdict.tried > options.count / 1000;
    std::printf(
        "claim=player_walks family=total count=%llu seed=%llu level=%s shape=%s rate=%g cuts=%zu fills=%zu undone=%zu "
        "doors=%zu jumps=%zu steps=%zu landings=%zu pushed=%zu ridden=%zu shoved=%zu crushed=%zu stuck=%zu missed=%zu "
        "tried=%zu metres=%.0f us_a_move=%.2f "
        "result=%s\n",
        ull(verdict.frames), ull(options.seed), level.c_str(), test::kPlayerShapeNames[shape], run.rate, verdict.cuts,
        verdict.fills, verdict.undone, verdict.doors, verdict.jumps, verdict.steps, verdict.landings, verdict.pushed,
        verdict.ridden, verdict.shoved, verdict.crushed, verdict.stuck, verdict.missed, verdict.tried,
        verdict.travelled, verdict.seconds * 1e6 / double(std::max<std::uint64_t>(verdict.frames, 1)),
        pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
