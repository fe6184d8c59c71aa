// SPDX-License-Identifier: MIT
// Games and recordings behind handles.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bindings/c/calls.h"
#include "bindings/c/handles.h"
#include "firma/recording.h"

namespace firma::c {

/// A game that its caller plays, recorded or not, or the replay of a recording.
struct GameObject final : Object {
    static constexpr Kind kKind = Kind::kGame;
    static constexpr const char* kNoun = "game";
    GameObject() = default;
    explicit GameObject(GameState of) : own(std::move(of)) {}

    GameState own;                            ///< not of a replay
    GameReport own_report;                    ///< likewise
    bool ticked = false;                      ///< that report is of a tick that is over
    std::optional<Recording> recording;       ///< what was recorded of it, but for its end
    std::shared_ptr<const Recording> played;  ///< of a replay
    std::unique_ptr<GameReplayJob> replay;    ///< of `played`
    std::string text;                         ///< what differs in it, once that was asked for
    bool broken = false;                      ///< memory ran out within a call that changed it

    const GameState& game() const { return replay ? replay->game() : own; }
    const GameReport& report() const { return replay ? replay->report() : own_report; }

    /// Does what changes it: work(report) returns why it was not done. Where memory runs out within it, it is lost.
    template <class Work>
    std::optional<Error> change(const Work& work) {
        broken = true;
        GameReport next;
        std::optional<Error> error = work(ticked ? next : own_report);
        if (!error && ticked) own_report = std::move(next);
        if (!error) ticked = false;
        broken = false;
        return error;
    }
};

struct RecordingObject final : Object {
    static constexpr Kind kKind = Kind::kRecording;
    static constexpr const char* kNoun = "recording";
    explicit RecordingObject(Recording of) : recording(std::make_shared<const Recording>(std::move(of))) {}
    const std::shared_ptr<const Recording> recording;
};

/// That of a handle; null with the code of why not.
GameObject* find_game(firma_game game, firma_code& code, const char* function);
/// One that its caller may change: no replay.
GameObject* find_played(firma_game game, firma_code& code, const char* function);
/// One that may be changed by other means than events: no replay, and not recorded.
GameObject* find_unrecorded(firma_game game, firma_code& code, const char* function);

firma_code give_game(GameState made, firma_game* out, const char* function);
/// An error that may have no place of its own.
firma_code fail_in(const char* function, const Error& error);

/// A charge as a caller has it, of a shape that there is. Null may not be.
firma_code read_charge(const firma_charge* given, Charge& charge, const char* function);
firma_code read_game_player(const firma_game_player* given, GamePlayer& player, const char* function);
firma_game_player game_player_told(const GamePlayer& from);

}  // namespace firma::c
