// SPDX-License-Identifier: MIT
// Edit logs: shown, compared with their level, replayed.
#include "cli/verbs.h"

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "cli/anchor_options.h"
#include "cli/atomic_file.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/merge_option.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "cli/write_level.h"
#include "firma/edit_log.h"

namespace firma::cli {

namespace {

struct LogArguments : LevelOutput {
    std::string what, log;
    LevelArguments level;  ///< none: an empty path
    AnchorArguments anchors;
    std::string until, merge_share;
    bool json = false;
};

constexpr const char* kLogFooter =
    R"(A log says what edits were made of a level, in order, as `firma carve --log` and games write it: the level and its log
give the same world on every machine, to the bit. LEVEL must be the one that the log begins from, read with the same
options (--scale, --surfaces, --rooms, --matter), or the same saved as .firma; its hash is compared. Pieces that come loose leave
again where the commands say so; --anchors, --no-hanging and --merge-share must be those that `firma carve` was given. The brushes of
firma_anchor of LEVEL hold pieces where the log was made so, as `firma carve --chunks` makes it.

  firma log show LOG                     what is in it: a line a command
  firma log verify LOG LEVEL             replays it and compares the world with the hashes in it (checkpoints)
  firma log replay LOG LEVEL -o AFTER    replays it and writes the level after it, as `firma carve` does
  firma log compact LOG LEVEL -o NEW     writes a log with a patch in place of the commands, up to --until: quicker to
                                         replay, not smaller; the world after it is the same, ids included

A command: its number, which ascends; carve or fill, with the crater's shape and seed or the cutter's name, its place
(metres) and scale; door, with the portal; group, several of these as one version. A command that came to nothing or is
refused changes nothing, as it did when it was made, and is counted. A log whose bytes are damaged is bad input, with the
byte where that was found; so is, for replay, a checkpoint that does not hold.

--json, show: log, bytes, version (of the format), level_hash, rules_hash (16 hexadecimal digits), level_edits (the number
of the last edit before it), last_number, patched_number or null (of the last edit that a patch stands for), patch_bytes,
command_count, checkpoint_count, commands [{number, kind, cutter, seed or null, position, rotation, scale, material,
chunks {min_volume, density (null: by matter)} or null; of a door portal, open; of a group parts}], checkpoints [{commands, hash}].
--json, compact: as show, of the log written, without commands and checkpoints; seconds.
--json, verify and replay: log, level, holds, fault or null, commands (that were applied), done, nothing, refused,
checkpoints (that hold), hash, seconds (of the replay), per_command_ms, faces, version (of the world), edits, out or null.

Exit codes: 0 done; 1 `verify` found a checkpoint that does not hold; 2 a bad call or bad input, with
`firma: place: reason` on stderr.
)";

int show(const LogArguments& arguments) {
    const LoadedLog loaded = read_edit_log(arguments.log);
    const EditLog& log = loaded.log;
    if (arguments.json) {
        Json json = edit_log_json(arguments.log, loaded);
        json["commands"] = Json::array();
        for (const EditCommand& command : log.commands()) json["commands"].push_back(command_json(command));
        json["checkpoints"] = Json::array();
        for (const LogCheckpoint& checkpoint : log.checkpoints())
            json["checkpoints"].push_back({{"commands", checkpoint.commands}, {"hash", hash_digits(checkpoint.hash)}});
        print(json_text(std::move(json)));
        return 0;
    }
    std::string text = edit_log_text(arguments.log, loaded);
    auto checkpoint = log.checkpoints().begin();
    for (std::size_t k = 0; k <= log.commands().size(); ++k) {
        if (k > 0) text += "  " + command_text(log.commands()[k - 1]) + "\n";
        for (; checkpoint != log.checkpoints().end() && checkpoint->commands == k; ++checkpoint)
            text += "  hash " + hash_digits(checkpoint->hash) + "\n";
    }
    print(text);
    return 0;
}

std::uint32_t last_number_of(const LogArguments& arguments) {
    constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();
    return arguments.until.empty() ? kAll : std::uint32_t(count_option("--until", arguments.until, 0, kAll));
}

struct Replayed {
    ReplayResult result;
    double seconds = 0;
};

Replayed replay_log(const World& level, const EditLog& log, const LogArguments& arguments) {
    ReplayOptions options;
    options.last_number = last_number_of(arguments);
    const auto start = std::chrono::steady_clock::now();
    LogReplay job(level, log, options);
    Progress progress("replaying", job.commands_in_all());
    for (bool finished = false; !finished;) {
        const std::size_t behind = job.commands_behind();
        finished = job.run(50'000);
        progress.add(job.commands_behind() - behind);
    }
    Replayed replayed{job.result(), 0};
    replayed.seconds = seconds_since(start);
    const std::optional<Error>& error = replayed.result.error;
    if (error && error->code != ErrorCode::kMalformed) throw Failure(arguments.log, error->text());
    return replayed;
}

Json replay_json(const LogArguments& arguments, const Replayed& replayed) {
    const ReplayResult& result = replayed.result;
    Json json;
    json["log"] = arguments.log;
    json["level"] = arguments.level.path;
    json["holds"] = result.ok();
    json["fault"] = result.error ? Json(result.error->text()) : Json();
    json["commands"] = result.commands;
    json["done"] = result.done;
    json["nothing"] = result.nothing;
    json["refused"] = result.refused;
    json["checkpoints"] = result.checkpoints;
    json["hash"] = hash_digits(hash_world(result.world));
    json["seconds"] = replayed.seconds;
    json["per_command_ms"] = result.commands > 0 ? 1e3 * replayed.seconds / double(result.commands) : 0;
    json["faces"] = result.world.face_count();
    json["version"] = result.world.version();
    json["edits"] = result.world.solid().edits();
    json["out"] = arguments.out.empty() ? Json() : Json(arguments.out);
    return json;
}

std::string replay_text(const LogArguments& arguments, const Replayed& replayed) {
    const ReplayResult& result = replayed.result;
    if (result.error) return fmt::format("{}: {}\n", arguments.log, result.error->text());
    return fmt::format("{}: {} replayed in {}: {} done, {} nothing, {} refused; {}; hash {}\n", arguments.log,
                       counted(result.commands, "command"), seconds_text(replayed.seconds), grouped(result.done),
                       grouped(result.nothing), grouped(result.refused),
                       result.checkpoints == 0 ? "no checkpoint to compare with"
                                               : counted(result.checkpoints, "checkpoint holds", "checkpoints hold"),
                       hash_digits(hash_world(result.world)));
}

void tell(const LogArguments& arguments, const Replayed& replayed) {
    print(arguments.json ? json_text(replay_json(arguments, replayed)) : replay_text(arguments, replayed));
}

/// The level with the rule that the options give.
LoadedLevel level_of(const LogArguments& arguments) {
    LoadedLevel level = load_level(arguments.level);
    level.world = with_merge_share(level.world, arguments.merge_share);
    return level;
}

int verify(const LogArguments& arguments) {
    const LoadedLog loaded = read_edit_log(arguments.log);
    const Replayed replayed =
        replay_log(anchored_for(loaded.log, level_of(arguments), arguments.anchors), loaded.log, arguments);
    tell(arguments, replayed);
    return replayed.result.ok() ? 0 : 1;
}

int replay_and_write(const LogArguments& arguments) {
    judge_level_output(arguments);
    refuse_json_beside(arguments.json, arguments.out);
    refuse_overwriting(arguments.out, arguments.log);
    refuse_overwriting(arguments.out, arguments.level.path);
    refuse_other_endings(arguments.out);
    const LoadedLog loaded = read_edit_log(arguments.log);
    const LoadedLevel level = level_of(arguments);
    AtomicFile out(arguments.out);
    const Replayed replayed = replay_log(anchored_for(loaded.log, level, arguments.anchors), loaded.log, arguments);
    if (replayed.result.error) throw Failure(arguments.log, replayed.result.error->text());
    write_level(replayed.result.world, level, arguments, out);
    out.commit();
    tell_if_empty(arguments, replayed.result.world);
    if (arguments.json || may_print_beside(arguments.out)) tell(arguments, replayed);
    return 0;
}

int compact(const LogArguments& arguments) {
    if (!arguments.up.empty()) throw Failure("--up", "is for replay");
    if (arguments.castable) throw Failure("--castable", "is for replay");
    if (is_standard_output(arguments.out)) throw Failure("--out", "a log is bytes; name a file");
    refuse_overwriting(arguments.out, arguments.log);
    refuse_overwriting(arguments.out, arguments.level.path);
    const LoadedLog loaded = read_edit_log(arguments.log);
    const LoadedLevel level = level_of(arguments);
    AtomicFile out(arguments.out);
    const auto start = std::chrono::steady_clock::now();
    const Result<EditLog> made =
        compacted(anchored_for(loaded.log, level, arguments.anchors), loaded.log, last_number_of(arguments));
    if (!made) throw Failure(arguments.log, made.error().text());
    write_edit_log(made.value(), out);
    out.commit();
    const double seconds = seconds_since(start);
    const LoadedLog written{made.value(), pack_log(made.value()).size()};
    if (!arguments.json) {
        print(edit_log_text(arguments.out, written));
        return 0;
    }
    Json json = edit_log_json(arguments.out, written);
    json["seconds"] = seconds;
    print(json_text(std::move(json)));
    return 0;
}

int run(const LogArguments& arguments) {
    const bool shows = arguments.what == "show", replays = arguments.what == "replay";
    const bool compacts = arguments.what == "compact";
    if (!shows && !replays && !compacts && arguments.what != "verify")
        throw Failure("log", "'" + arguments.what + "' is none of show, verify, replay, compact");
    if (arguments.log.empty()) throw Failure("log", "LOG is required: firma log " + arguments.what + " LOG");
    if (shows) {
        if (!arguments.level.path.empty()) throw Failure("log", "show takes a log and no level");
        if (!arguments.until.empty()) throw Failure("--until", "is for verify and replay");
        if (arguments.anchors.given())
            throw Failure(arguments.anchors.materials.empty() ? "--no-hanging" : "--anchors",
                          "is for verify, replay and compact");
        if (!arguments.merge_share.empty()) throw Failure("--merge-share", "is for verify, replay and compact");
    } else if (arguments.level.path.empty()) {
        throw Failure("log", "LEVEL is required: firma log " + arguments.what + " LOG LEVEL");
    }
    if ((replays || compacts) && arguments.out.empty())
        throw Failure("log", "--out is required: firma log " + arguments.what + " LOG LEVEL -o FILE");
    if (!replays && !compacts && !arguments.out.empty()) throw Failure("--out", "is for replay and compact");
    if (shows) return show(arguments);
    if (compacts) return compact(arguments);
    return replays ? replay_and_write(arguments) : verify(arguments);
}

}  // namespace

Verb add_log(CLI::App& app) {
    Command command(app, "log", "Shows an edit log, verifies it against its level, replays or compacts it");
    const auto arguments = std::make_shared<LogArguments>();
    command.add_argument("WHAT", arguments->what, "show, verify, replay or compact", true);
    command.add_argument("LOG", arguments->log, "the log, as firma carve --log writes it", false);
    add_level_arguments(command, arguments->level, false);
    add_rooms_option(command, arguments->level);
    add_matter_option(command, arguments->level);
    add_anchor_options(command, arguments->anchors);
    add_merge_option(command, arguments->merge_share);
    command.add_option("--until", arguments->until, "N",
                       "leave out commands with numbers above this one; of compact: they stay commands");
    add_level_output(command, *arguments,
                     "of replay: .obj, .firma or .glb to write, the level after it; of compact: the log", false);
    add_json_flag(command, arguments->json);
    command.set_footer(kLogFooter);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
