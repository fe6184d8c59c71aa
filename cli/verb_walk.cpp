// SPDX-License-Identifier: MIT
// Arguments, frames, rows; bounce.h holds the walk itself.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "cli/atomic_file.h"
#include "cli/bounce.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/progress.h"

namespace firma::cli {

namespace {

struct WalkArguments {
    LevelArguments level;
    std::string start, radius, frames, seed, out;
    bool json = false;
};

constexpr std::uint64_t kMostFrames = 1000000000;

constexpr const char* kWalkFooter =
    R"(Rows: frame,px,py,pz: the place of the centre in metres, with 17 significant digits. Row 0 is the start itself,
then one row a frame: N + 1 rows. Each frame is one straight move, found by a cast; along the straight line from
row to row the sphere is never nearer to a face than its radius less 1e-6 m. It meets faces from both sides. The
same arguments give the same bytes on every machine. More frames make shorter moves and denser rows.

A start nearer to a face than the radius, a sphere outside of the level, or a level that is not closed is an
error; a start that exactly touches is not. The file appears whole or not at all; `-` writes standard output.

--json: level, frames, seed, radius, start, end, length (metres flown), low and high (corners of the box around
all places), still (frames without a move, for lack of room), out.
)";

/// What is told about a walk that was made.
struct Summary {
    double length = 0;
    Box bounds;
    std::uint64_t still = 0;
    Vec3 end;
};

void write_row(AtomicFile& out, std::string& row, std::uint64_t frame, const Vec3& place) {
    row = std::to_string(frame);
    for (int axis = 0; axis < 3; ++axis) {
        row += ',';
        append_17(row, place[axis]);
    }
    row += '\n';
    out.write(row);
}

Summary walk(Bouncer& bouncer, std::uint64_t frames, AtomicFile& out) {
    Progress progress("walking", frames);
    Summary summary;
    std::string row;
    out.write("frame,px,py,pz\n");
    Vec3 before = bouncer.place();
    write_row(out, row, 0, before);
    summary.bounds.add(before);
    for (std::uint64_t frame = 1; frame <= frames; ++frame) {
        bouncer.step();
        const Vec3 place = bouncer.place();
        write_row(out, row, frame, place);
        summary.bounds.add(place);
        summary.length += length(place - before);
        summary.still += place == before;
        before = place;
        if (frame % 256 == 0) progress.add(256);
    }
    summary.end = before;
    return summary;
}

int run(const WalkArguments& arguments) {
    Sphere sphere;
    sphere.centre = point_option("--start", arguments.start);
    sphere.radius = number_option("--radius", arguments.radius, 0, INFINITY);
    const std::uint64_t frames = count_option("--frames", arguments.frames, 0, kMostFrames);
    const std::uint64_t seed = count_option("--seed", arguments.seed, 0, std::numeric_limits<std::uint64_t>::max());
    refuse_json_beside(arguments.json, arguments.out);
    refuse_overwriting(arguments.out, arguments.level.path);
    const LoadedLevel loaded = load_level(arguments.level);
    Bouncer bouncer(loaded.world, sphere, frames, seed);

    AtomicFile out(arguments.out);
    const Summary summary = walk(bouncer, frames, out);
    out.commit();
    if (arguments.json) {
        Json json;
        json["level"] = arguments.level.path;
        json["frames"] = frames;
        json["seed"] = seed;
        json["radius"] = sphere.radius;
        json["start"] = sphere.centre;
        json["end"] = summary.end;
        json["length"] = summary.length;
        json["low"] = summary.bounds.low;
        json["high"] = summary.bounds.high;
        json["still"] = summary.still;
        json["out"] = arguments.out;
        print(json_text(std::move(json)));
    } else if (may_print_beside(arguments.out)) {
        print(fmt::format("{}: {} frames, {:.1f} m flown; {} without a move\n", arguments.out, grouped(frames),
                          summary.length, grouped(summary.still)));
    }
    return 0;
}

}  // namespace

Verb add_walk(CLI::App& app) {
    Command command(app, "walk", "Lets a sphere bounce about a closed room and writes where it was");
    const auto arguments = std::make_shared<WalkArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    command.add_option("--start", arguments->start, "X,Y,Z", "place of the centre in frame 0, metres", true);
    command.add_option("--radius", arguments->radius, "R", "of the sphere, metres, 0 or more; 0 is a particle", true);
    command.add_option("--frames", arguments->frames, "N", "moves to make, 0 .. 1000000000", true);
    command.add_option("--seed", arguments->seed, "S", "of the random numbers, 0 .. 2^64 - 1", true);
    add_out_option(command, arguments->out, "csv to write, see below", true);
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kWalkFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
