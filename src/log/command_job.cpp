// SPDX-License-Identifier: MIT
// Commands applied: one part after the other, each in slices.
#include <chrono>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "firma/edit_log.h"
#include "firma/rooms.h"
#include "world/one_version.h"

namespace firma {

struct CommandJob::State {
    const World before;
    const EditCommand command;
    CommandResult made;    ///< `world`: as edited so far
    std::size_t next = 0;  ///< part
    std::optional<CarveJob> cut;
    bool any_done = false, any_refused = false;
    bool finished = false;
    bool broken = false;  ///< true while work is done, and for good when an exception leaves it

    State(World world, EditCommand given) : before(std::move(world)), command(std::move(given)) { made.world = before; }

    bool is_group() const { return command.kind == EditKind::kGroup; }
    std::size_t part_count() const { return is_group() ? command.parts.size() : 1; }
    const EditCommand& part() const { return is_group() ? command.parts[next] : command; }

    /// Goes on with the part at hand, for about this long.
    void work(double microseconds) {
        if (next == part_count()) return finish();
        if (!cut && !begin()) {
            ++next;
            return;
        }
        if (!cut->run(microseconds)) return;
        CarveResult result = cut->result();
        cut.reset();
        note(result.status, result.error);
        made.world = result.world;
        made.edits.push_back(std::move(result));
        ++next;
    }

    /// @return whether there is a cut to be made: a door is opened or closed at once
    bool begin() {
        const EditCommand& edit = part();
        if (edit.kind == EditKind::kCarve || edit.kind == EditKind::kFill) {
            const auto* crater = std::get_if<CraterSeed>(&edit.cutter);
            Cutter cutter = crater ? make_crater(crater->shape, crater->seed) : std::get<Cutter>(edit.cutter);
            CarveOptions options = edit.options;
            options.edit = edit.number;
            if (options.edit == 0) {
                note(CarveStatus::kRefused, {ErrorCode::kInvalid, "", "a command without a number"});
                return false;
            }
            cut.emplace(made.world, std::move(cutter), edit.pose, options,
                        edit.kind == EditKind::kFill ? CarveKind::kFill : CarveKind::kCarve);
            return true;
        }
        if (edit.kind != EditKind::kDoor) {
            note(CarveStatus::kRefused, {ErrorCode::kInvalid, "", "a group in a group"});
            return false;
        }
        const std::optional<PortalInfo> portal = portal_info(made.world, edit.portal);
        if (!portal) {
            note(CarveStatus::kRefused,
                 {ErrorCode::kInvalid, "portal " + std::to_string(edit.portal.value), "the world has no such portal"});
        } else if (portal->open == edit.open || portal->polygons == 0) {
            note(CarveStatus::kNothing, {});
        } else {
            made.world = *set_portal_open(made.world, edit.portal, edit.open);
            note(CarveStatus::kDone, {});
        }
        return false;
    }

    void note(CarveStatus status, const Error& error) {
        any_done |= status == CarveStatus::kDone;
        if (status != CarveStatus::kRefused || any_refused) return;
        any_refused = true;
        made.error = error;
        if (is_group())
            made.error.place = "part " + std::to_string(next) + (error.place.empty() ? "" : ": ") + error.place;
    }

    void finish() {
        finished = true;
        made.status = any_done ? CarveStatus::kDone : any_refused ? CarveStatus::kRefused : CarveStatus::kNothing;
        made.world = any_done ? as_one_version(before, made.world) : before;
    }
};

CommandJob::CommandJob(World world, EditCommand command) : state_(new State(std::move(world), std::move(command))) {}
CommandJob::~CommandJob() = default;
CommandJob::CommandJob(CommandJob&&) noexcept = default;
CommandJob& CommandJob::operator=(CommandJob&&) noexcept = default;

bool CommandJob::run(double microseconds) {
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

bool CommandJob::finished() const {
    return !state_ || state_->finished || state_->broken;
}

CommandResult CommandJob::result() const {
    FIRMA_ASSERT(finished(), "a command has no result yet: call run() until it returns true");
    if (state_ && state_->finished) return state_->made;
    CommandResult result;
    if (!state_) {
        result.error = {ErrorCode::kInvalid, "", "the job was moved away"};
        return result;
    }
    result.world = state_->before;
    result.error = state_->broken ? Error{ErrorCode::kNoMemory, "", "memory ran out in the middle of the edit"}
                                  : Error{ErrorCode::kInvalid, "", "the edit is not finished"};
    return result;
}

CommandResult apply(const World& world, const EditCommand& command) {
    CommandJob job(world, command);
    job.run(INFINITY);
    return job.result();
}

}  // namespace firma
