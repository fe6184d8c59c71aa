// SPDX-License-Identifier: MIT
// Edits of a game's world.
#include "game/game_edits.h"

#include <utility>

#include "base/assert.h"

namespace firma {

void keep_edit(GameState& game, EditCommand command, CarveStatus status, const Error& error, GameReport& report) {
    report.edits += status == CarveStatus::kDone;
    report.nothing += status == CarveStatus::kNothing;
    if (status == CarveStatus::kRefused && report.refused++ == 0) report.refusal = error;
    if (status != CarveStatus::kDone) return;
    [[maybe_unused]] const std::optional<Error> refused = game.log.append(std::move(command));
    FIRMA_ASSERT(!refused, "an edit that was done is one that a log takes");
}

EditCommand numbered(const GameState& game, EditCommand command) {
    std::uint32_t next = game.log.next_number();
    command.number = next;
    for (EditCommand& part : command.parts) part.number = next++;
    return command;
}

void do_edit(GameState& game, EditCommand command, GameReport& report) {
    command = numbered(game, std::move(command));
    if (command.kind == EditKind::kCarve) command.options.chunks = game.rules.chunks;
    for (EditCommand& part : command.parts)
        if (part.kind == EditKind::kCarve) part.options.chunks = game.rules.chunks;
    const CommandResult result = apply(game.world, command);
    game.world = result.world;
    keep_edit(game, std::move(command), result.status, result.error, report);
    for (const CarveResult& edit : result.edits)
        for (const Chunk& chunk : edit.chunks) report.loose += add_debris(game.bodies, game.debris, chunk).ok();
}

}  // namespace firma
