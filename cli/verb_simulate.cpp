// SPDX-License-Identifier: MIT
// A game by a script, stepped and recorded.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/anchor_options.h"
#include "cli/atomic_file.h"
#include "cli/csv_reader.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/game_file.h"
#include "cli/game_script.h"
#include "cli/json.h"
#include "cli/level_parts.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "firma/recording.h"

namespace firma::cli {

namespace {

struct SimulateArguments {
    LevelArguments level;
    AnchorArguments anchors;
    std::string script, seconds, rate, out, save;
    bool json = false;
};

constexpr double kMaxSeconds = 86400;

constexpr const char* kSimulateFooter =
    R"(Steps a game in LEVEL by a script and records it: rockets fly and make craters, what comes loose falls, breaks and
rests, players walk, doors and lifts go. LEVEL may be a game that --save wrote: it goes on from there, at its rate.

The recording (.firmarec) holds the game at its start, whole, the script's events, a hash of everything after each tick and
the game at its end. `firma replay` steps it again, on any machine, and tells the first tick that is not the same.
A saved game is a .firma file: other verbs read its world.

)";

constexpr const char* kSimulateJson = R"(
--json: level, script, out, save or null, rate, ticks, first_tick, events, events_after_end, explosions, edits {done,
nothing, refused}, refusal or null, loose, broken, removed, grounded (bodies), hash (of the game at the end), game (as
firma replay tells it), bytes, seconds, tick_ms {mean, max}.
)";

/// What all ticks came to.
struct GameTally {
    std::size_t edits = 0, nothing = 0, refused = 0, loose = 0, broken = 0, removed = 0, grounded = 0;
    std::string refusal;
    double seconds = 0, max_tick = 0;

    void add(const GameReport& report, double tick_seconds) {
        if (refused == 0 && report.refused > 0) refusal = report.refusal.text();
        edits += report.edits;
        nothing += report.nothing;
        refused += report.refused;
        loose += report.loose;
        broken += report.broken;
        removed += report.removed;
        grounded += report.grounded;
        seconds += tick_seconds;
        max_tick = std::max(max_tick, tick_seconds);
    }
};

std::uint32_t rate_of(const SimulateArguments& arguments) {
    return arguments.rate.empty() ? 60
                                  : std::uint32_t(count_option("--hz", arguments.rate, kMinTickRate, kMaxTickRate));
}

GameState game_of(const SimulateArguments& arguments) {
    if (names_saved_world(arguments.level.path)) {
        std::optional<GameState> saved = read_saved_game(arguments.level.path);
        if (saved && !arguments.rate.empty() && rate_of(arguments) != saved->rate)
            throw Failure("--hz",
                          fmt::format("the game was saved at {} ticks a second, and goes on at that", saved->rate));
        if (saved && arguments.anchors.given()) throw Failure("--anchors", "a saved game has its own");
        if (saved) return std::move(*saved);
    }
    LoadedLevel loaded = load_level(arguments.level);
    loaded.world = with_usual_anchors(anchored(loaded, arguments.anchors));
    GameState game = begin_game(loaded.world, rate_of(arguments));
    add_level_parts(arguments.level, loaded, game);
    return game;
}

void judge(const SimulateArguments& arguments) {
    for (const std::string* out : {&arguments.out, &arguments.save}) {
        if (out->empty()) continue;
        if (is_standard_output(*out))
            throw Failure(out == &arguments.out ? "--out" : "--save", "it is bytes; name a file");
        refuse_overwriting(*out, arguments.level.path);
        refuse_overwriting(*out, arguments.script);
    }
    if (!has_ending(arguments.out, ".firmarec")) throw Failure("--out", "the name of a recording ends in .firmarec");
    if (!arguments.save.empty() && !names_saved_world(arguments.save))
        throw Failure("--save", "the name of a saved game ends in .firma");
}

/// @return the ticks in so many seconds, the nearest
std::uint64_t ticks_of(const SimulateArguments& arguments, std::uint32_t rate) {
    const double seconds = number_option("--seconds", arguments.seconds, 0, kMaxSeconds);
    return std::uint64_t(std::floor(seconds * rate + 0.5));
}

GameTally run_ticks(GameRecorder& recorder, std::uint64_t ticks, const std::string& script) {
    GameTally tally;
    Progress progress("simulating", ticks);
    for (std::uint64_t k = 0; k < ticks; ++k) {
        const auto start = std::chrono::steady_clock::now();
        if (const auto error = recorder.step()) throw Failure(script, error->text());
        tally.add(recorder.run().report(), seconds_since(start));
        progress.add(1);
    }
    return tally;
}

void tell(const SimulateArguments& arguments, const Recording& recording, const GameScript& script,
          const GameTally& tally, std::size_t bytes) {
    const std::uint64_t ticks = recording.hashes.size();
    const double mean = ticks > 0 ? 1e3 * tally.seconds / double(ticks) : 0;
    const GameState& end = recording.end;
    const std::uint64_t explosions = end.explosions - recording.start.explosions;
    if (arguments.json) {
        Json json;
        json["level"] = arguments.level.path;
        json["script"] = arguments.script;
        json["out"] = arguments.out;
        json["save"] = arguments.save.empty() ? Json() : Json(arguments.save);
        json["rate"] = end.rate;
        json["ticks"] = ticks;
        json["first_tick"] = recording.start.tick;
        json["events"] = recording.events.size();
        json["events_after_end"] = script.after_end;
        json["explosions"] = explosions;
        json["edits"] = {{"done", tally.edits}, {"nothing", tally.nothing}, {"refused", tally.refused}};
        json["refusal"] = tally.refused > 0 ? Json(tally.refusal) : Json();
        json["loose"] = tally.loose;
        json["broken"] = tally.broken;
        json["removed"] = tally.removed;
        json["grounded"] = tally.grounded;
        json["hash"] = hash_digits(hash_game(end));
        json["game"] = game_json(end);
        json["bytes"] = bytes;
        json["seconds"] = tally.seconds;
        json["tick_ms"] = {{"mean", mean}, {"max", 1e3 * tally.max_tick}};
        print(json_text(std::move(json)));
        return;
    }
    std::string text = fmt::format("{}: {} at {} a second, {}; {}, {:.2f} ms a tick, {:.1f} ms at most\n",
                                   arguments.out, counted(ticks, "tick"), end.rate, bytes_text(bytes),
                                   counted(recording.events.size(), "event"), mean, 1e3 * tally.max_tick);
    text += fmt::format("  {}; {} done, {} nothing, {} refused{}\n", counted(explosions, "explosion"),
                        counted(tally.edits, "edit"), tally.nothing, tally.refused,
                        tally.refused > 0 ? " (first: " + tally.refusal + ")" : "");
    text += fmt::format("  {} came loose, {} broke, {} removed, {} became ground\n",
                        counted(tally.loose, "body", "bodies"), tally.broken, tally.removed, tally.grounded);
    text += "  " + game_text(end) + "\n";
    if (script.after_end > 0)
        text +=
            fmt::format("  {} of the script after the end\n", counted(script.after_end, "event lies", "events lie"));
    print(text);
}

int run(const SimulateArguments& arguments) {
    judge(arguments);
    GameState game = game_of(arguments);
    const std::uint64_t ticks = ticks_of(arguments, game.rate);
    GameScript script = read_game_script(arguments.script, game, ticks);
    AtomicFile out(arguments.out);
    std::optional<AtomicFile> save;
    if (!arguments.save.empty()) save.emplace(arguments.save);
    GameRecorder recorder(std::move(game), script.events, short_name(arguments.level.path));
    const GameTally tally = run_ticks(recorder, ticks, arguments.script);
    const Recording recording = recorder.finish();
    const std::vector<std::byte> bytes = take(pack_recording(recording));
    write_bytes(bytes, out);
    out.finish();
    if (save) {
        write_bytes(take(pack_game(recording.end)), *save);
        save->finish();
        save->commit();
    }
    out.commit();
    tell(arguments, recording, script, tally, bytes.size());
    return 0;
}

}  // namespace

Verb add_simulate(CLI::App& app) {
    Command command(app, "simulate", "Steps a game in a level by a script, and records it");
    const auto arguments = std::make_shared<SimulateArguments>();
    add_level_arguments(command, arguments->level);
    add_rooms_option(command, arguments->level);
    add_matter_option(command, arguments->level);
    add_anchor_options(command, arguments->anchors);
    command.add_option("--script", arguments->script, "FILE", "JSON: what happens when, see below", true);
    command.add_option("--seconds", arguments->seconds, "T", "how long, 0 to 86400", true);
    command.add_option("--hz", arguments->rate, "N", "ticks a second, 4 to 1000 (default 60)");
    add_out_option(command, arguments->out, ".firmarec to write: the recording", true);
    command.add_option("--save", arguments->save, "FILE", ".firma to write: the game at the end, to go on from");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kSimulateFooter) + kScriptHelp + kSimulateJson + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
