// SPDX-License-Identifier: MIT
// A log applied to its level, command by command.
#include <chrono>
#include <cmath>
#include <utility>

#include "firma/edit_log.h"
#include "firma/world_patch.h"

namespace firma {
namespace {

std::string hash_in_hex(std::uint64_t hash) {
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15];
    return text;
}

/// Why a log cannot be replayed on a level.
std::optional<Error> judge_level(const EditLog& own, const EditLog& log) {
    if (own.level_hash() != log.level_hash())
        return Error{ErrorCode::kInvalid, "",
                     "the log begins from another world: the hash is " + hash_in_hex(own.level_hash()) +
                         ", that of the log " + hash_in_hex(log.level_hash())};
    if (own.rules_hash() != log.rules_hash())
        return Error{ErrorCode::kInvalid, "", "the log was made under other rules for carving, or with other anchors"};
    if (own.level_edits() != log.level_edits())
        return Error{ErrorCode::kInvalid, "", "the log begins after another edit than its world does"};
    return {};
}

}  // namespace

struct LogReplay::State {
    const EditLog log;
    const std::uint32_t last_number;
    ReplayResult made;
    std::size_t in_all = 0;
    std::size_t next_checkpoint = 0;
    bool patched = false;  ///< or nothing to be patched
    std::optional<CommandJob> job;
    bool finished = false;
    bool broken = false;  ///< true while work is done, and for good when an exception leaves it

    State(World level, EditLog given, const ReplayOptions& options)
        : log(std::move(given)), last_number(options.last_number) {
        made.error = judge_level(EditLog(level), log);
        made.world = std::move(level);
        while (in_all < log.commands().size() && firma::last_number(log.commands()[in_all]) <= last_number) ++in_all;
        if (!made.error && last_number < log.patched_number())
            made.error = Error{ErrorCode::kInvalid, "",
                               "the log was compacted up to edit " + std::to_string(log.patched_number())};
        finished = made.error.has_value();
        patched = log.patch().empty();
        if (!finished && patched) compare();
    }

    /// What stands for the beginning, in one piece.
    void apply_start() {
        patched = true;
        Result<World> begun = apply_patch(made.world, log.patch(), "patch");
        if (!begun) {
            made.error = begun.error();
            finished = true;
            return;
        }
        made.world = std::move(begun).value();
        if (made.world.solid().edits() > log.patched_number()) {
            made.error = Error{ErrorCode::kMalformed, "patch", "it stands for later edits than it says"};
            finished = true;
            return;
        }
        compare();
    }

    void work(double microseconds) {
        if (!patched) return apply_start();
        if (made.commands == in_all) {
            finished = true;
            return;
        }
        if (!job) job.emplace(made.world, log.commands()[made.commands]);
        if (!job->run(microseconds)) return;
        const CommandResult result = job->result();
        job.reset();
        made.world = result.world;
        made.done += result.done();
        made.nothing += result.status == CarveStatus::kNothing;
        made.refused += result.status == CarveStatus::kRefused;
        ++made.commands;
        compare();
    }

    void compare() {
        const std::vector<LogCheckpoint>& all = log.checkpoints();
        if (next_checkpoint == all.size() || all[next_checkpoint].commands != made.commands) return;
        const std::uint64_t hash = hash_world(made.world), expected = all[next_checkpoint++].hash;
        if (hash == expected) {
            ++made.checkpoints;
            return;
        }
        const std::string where = made.commands == 0 ? "the beginning" : "command " + std::to_string(made.commands - 1);
        made.error =
            Error{ErrorCode::kMalformed, where,
                  "the world's hash is " + hash_in_hex(hash) + ", by the checkpoint after it " + hash_in_hex(expected)};
        finished = true;
    }
};

LogReplay::LogReplay(World level, EditLog log, const ReplayOptions& options)
    : state_(new State(std::move(level), std::move(log), options)) {}
LogReplay::~LogReplay() = default;
LogReplay::LogReplay(LogReplay&&) noexcept = default;
LogReplay& LogReplay::operator=(LogReplay&&) noexcept = default;

bool LogReplay::run(double microseconds) {
    const auto start = std::chrono::steady_clock::now();
    double left = microseconds;
    while (!finished()) {
        state_->broken = true;
        state_->work(left);
        state_->broken = false;
        if (microseconds == INFINITY) continue;
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
        left = microseconds - spent.count();
        if (!(left > 0)) break;
    }
    return finished();
}

bool LogReplay::finished() const {
    return !state_ || state_->finished || state_->broken;
}

std::size_t LogReplay::commands_behind() const {
    return state_ ? state_->made.commands : 0;
}

std::size_t LogReplay::commands_in_all() const {
    return state_ ? state_->in_all : 0;
}

ReplayResult LogReplay::result() const {
    ReplayResult result;
    if (state_) result = state_->made;
    if (!state_) result.error = Error{ErrorCode::kInvalid, "", "the replay was moved away"};
    if (state_ && state_->broken)
        result.error = Error{ErrorCode::kNoMemory, "", "memory ran out in the middle of the replay"};
    return result;
}

ReplayResult replay(const World& level, const EditLog& log, const ReplayOptions& options) {
    LogReplay job(level, log, options);
    job.run(INFINITY);
    return job.result();
}

}  // namespace firma
