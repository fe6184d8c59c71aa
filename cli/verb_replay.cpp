// SPDX-License-Identifier: MIT
// A recording stepped again and compared, tick by tick.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "cli/atomic_file.h"
#include "cli/csv_reader.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/game_file.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "firma/recording.h"

namespace firma::cli {

namespace {

struct ReplayArguments {
    std::string recording, save;
    bool json = false;
};

constexpr const char* kReplayFooter =
    R"(Steps the game of a recording again, as `firma simulate` wrote it, and compares hashes of everything in it after each
tick: the world, each part, player, projectile and body. It stops at the first tick that is not as recorded and names
what differs. The recording holds the level; nothing else is read. Every machine and every build comes to the same hashes.

--json: recording, level (its name), level_hash, bytes, rate, first_tick, ticks (recorded), same (ticks that are as
recorded), events, holds, tick or null (the first that differs), items [what differs], fault or null, hash and game (after
the last tick stepped: tick, seconds, explosions, edits, players [{position, velocity, on_ground, stuck}], parts, projectiles,
bodies, asleep, debris), seconds.

Exit codes: 0 all ticks are as recorded; 1 a tick is not; 2 a bad call or bad input, with `firma: place: reason` on stderr.
)";

Json replay_json(const ReplayArguments& arguments, const Recording& recording, const GameReplay& replay,
                 std::size_t bytes, double seconds) {
    Json json;
    json["recording"] = arguments.recording;
    json["level"] = recording.level;
    json["level_hash"] = hash_digits(recording.level_hash);
    json["bytes"] = bytes;
    json["rate"] = recording.start.rate;
    json["first_tick"] = recording.start.tick;
    json["ticks"] = recording.hashes.size();
    json["same"] = replay.ticks;
    json["events"] = recording.events.size();
    json["holds"] = replay.ok();
    json["tick"] = replay.difference ? Json(replay.difference->tick) : Json();
    json["items"] = replay.difference ? Json(replay.difference->items) : Json::array();
    json["fault"] = replay.difference ? Json(replay.difference->text())
                    : replay.error    ? Json(replay.error->text())
                                      : Json();
    json["hash"] = hash_digits(hash_game(replay.game));
    json["game"] = game_json(replay.game);
    json["seconds"] = seconds;
    return json;
}

std::string replay_text(const ReplayArguments& arguments, const Recording& recording, const GameReplay& replay,
                        double seconds) {
    if (replay.error) return fmt::format("{}: {}\n", arguments.recording, replay.error->text());
    if (replay.difference) return fmt::format("{}: {}\n", arguments.recording, replay.difference->text());
    return fmt::format("{}: {} of a game in {}, all as recorded, in {}; hash {}\n  {}\n", arguments.recording,
                       counted(recording.hashes.size(), "tick"), recording.level, seconds_text(seconds),
                       hash_digits(hash_game(replay.game)), game_text(replay.game));
}

int run(const ReplayArguments& arguments) {
    if (!arguments.save.empty()) {
        if (!names_saved_world(arguments.save)) throw Failure("--save", "the name of a saved game ends in .firma");
        refuse_overwriting(arguments.save, arguments.recording);
    }
    const std::string text = read_file(arguments.recording);
    const Recording recording = take(unpack_recording(std::as_bytes(std::span(text)), arguments.recording));
    std::optional<AtomicFile> save;
    if (!arguments.save.empty()) save.emplace(arguments.save);
    const auto start = std::chrono::steady_clock::now();
    GameReplayJob job(recording);
    {
        Progress progress("replaying", recording.hashes.size());
        while (!job.step()) progress.add(1);
    }
    const double seconds = seconds_since(start);
    const GameReplay& replay = job.result();
    if (save) {
        write_bytes(take(pack_game(replay.game)), *save);
        save->commit();
    }
    print(arguments.json ? json_text(replay_json(arguments, recording, replay, text.size(), seconds))
                         : replay_text(arguments, recording, replay, seconds));
    return replay.ok() ? 0 : 1;
}

}  // namespace

Verb add_replay(CLI::App& app) {
    Command command(app, "replay", "Replays a recording of a game and compares it with what was recorded");
    const auto arguments = std::make_shared<ReplayArguments>();
    command.add_argument("RECORDING", arguments->recording, "a .firmarec, as firma simulate writes it", true);
    command.add_option("--save", arguments->save, "FILE",
                       ".firma to write: the game after the last tick that was stepped");
    add_json_flag(command, arguments->json);
    command.set_footer(kReplayFooter);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
