// SPDX-License-Identifier: MIT
// Games recorded and replayed: where a game began, what happened to it, its hashes tick by tick, where it ended. A
// replay steps the same game again and tells the first tick at which it is another one, and what differs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/game.h"
#include "firma/result.h"

namespace firma {

/// Hashes of a game tick by tick, as bytes: of each tick those alone that are not as in the tick before. What sleeps
/// takes none.
class HashTrack {
public:
    /// Of the next tick. Costs the hashes.
    FIRMA_EXPORT void append(const GameHashes& hashes);
    std::uint64_t size() const { return count_; }  ///< ticks
    const std::vector<std::byte>& bytes() const { return bytes_; }

    /// The track of such bytes, all of which are read.
    /// @param name  for messages
    /// @return kMalformed with the byte where it was found
    [[nodiscard]] FIRMA_EXPORT static Result<HashTrack> from_bytes(std::span<const std::byte> bytes,
                                                                   const std::string& name);

    /// Goes through a track from its first tick on.
    class Reader {
    public:
        explicit Reader(const HashTrack& track) : track_(&track) {}
        bool at_end() const { return at_ == track_->bytes_.size(); }
        /// Of the next tick; good until the next call. Not at the end. Costs what is not as in the tick before.
        FIRMA_EXPORT const GameHashes& next();

    private:
        const HashTrack* track_;
        std::size_t at_ = 0;
        GameHashes now_;
    };

private:
    std::vector<std::byte> bytes_;
    std::uint64_t count_ = 0;
    GameHashes last_;
};

/// A game from one tick to another.
struct Recording {
    std::string level;              ///< what it was read from, for people
    std::uint64_t level_hash = 0;   ///< hash_world() of the world that its log begins from
    GameState start;                ///< whole: a replay needs nothing else
    std::vector<GameEvent> events;  ///< by tick; those of one tick in this order
    HashTrack hashes;               ///< after each tick
    GameState end;
};

/// Steps a game tick by tick, and records it or compares it.
class GameRun {
public:
    /// @param events  by tick, those before game.tick are in vain: judge_events()
    FIRMA_EXPORT GameRun(GameState game, std::span<const GameEvent> events);

    /// The events of this tick, then the tick. The report is of both.
    /// @return the error of apply_event(), with "event 3" as its place, or of step_game(): then it is over
    [[nodiscard]] FIRMA_EXPORT std::optional<Error> step();
    const GameState& game() const { return game_; }
    GameState take_game() { return std::move(game_); }
    const GameReport& report() const { return report_; }

private:
    GameState game_;
    std::span<const GameEvent> events_;
    std::size_t next_ = 0;
    GameReport report_;
};

/// What can be said of events before they happen.
/// @return kInvalid, naming the event by its index: ticks that do not ascend or are before the game's, and what
///         apply_event() would refuse: a weapon, player or part that is not there by then, numbers that are not finite
[[nodiscard]] FIRMA_EXPORT std::optional<Error> judge_events(const GameState& game, std::span<const GameEvent> events);

/// Steps a game and records it, tick by tick.
class GameRecorder {
public:
    /// Costs a copy of the game.
    /// @param level  for people
    FIRMA_EXPORT GameRecorder(GameState start, std::vector<GameEvent> events, std::string level = "");
    GameRecorder(const GameRecorder&) = delete;
    GameRecorder& operator=(const GameRecorder&) = delete;

    /// @return the error of judge_events() first of all, or of GameRun::step(), with "tick 7" as its place: then this
    ///         tick is not in the recording, and it is over
    /// Costs the tick, and hash_game_items().
    [[nodiscard]] FIRMA_EXPORT std::optional<Error> step();
    const GameRun& run() const { return run_; }
    /// What was recorded so far. Leaves nothing behind.
    [[nodiscard]] FIRMA_EXPORT Recording finish();

private:
    Recording recording_;
    GameRun run_;
    bool judged_ = false;
};

/// The same for so many ticks in one go.
/// @param level  for people
/// @return the errors of judge_events() and of GameRun::step(), with "tick 7" as its place
/// Costs the ticks, and hash_game_items() a tick.
[[nodiscard]] FIRMA_EXPORT Result<Recording> record_game(GameState start, std::vector<GameEvent> events,
                                                         std::uint64_t ticks, std::string level = "");

/// What is not as it was recorded.
struct GameDifference {
    std::uint64_t tick = 0;          ///< so many ticks were behind when it was seen
    std::uint64_t hash = 0;          ///< hash_game() of the replay
    std::uint64_t recorded = 0;      ///< and of the recording
    bool at_end = false;             ///< all ticks are as recorded, and Recording::end is another game
    std::vector<std::string> items;  ///< "the world", "part 0 (door)", "player 1", "body 5": up to kMaxNamedItems
    std::size_t unnamed = 0;         ///< how many more
    /// "tick 7: the hash is ..., recorded ...; other: body 5, player 0"
    [[nodiscard]] FIRMA_EXPORT std::string text() const;
};
inline constexpr std::size_t kMaxNamedItems = 8;

struct [[nodiscard]] GameReplay {
    std::uint64_t ticks = 0;  ///< that are as they were recorded
    GameState game;           ///< after the last tick that was stepped
    std::optional<GameDifference> difference;
    std::optional<Error> error;  ///< of an event or a tick that could not be done; or of the level's hash

    bool ok() const { return !difference && !error; }
};

/// Replays a recording, in slices of whole ticks; ends at the first difference.
class GameReplayJob {
public:
    FIRMA_EXPORT explicit GameReplayJob(const Recording& recording);  ///< outlives this
    /// One tick. @return true once it is finished
    FIRMA_EXPORT bool step();
    bool finished() const { return finished_; }
    /// After the last tick that was stepped, and what that one did.
    const GameState& game() const { return finished_ ? replay_.game : run_.game(); }
    const GameReport& report() const { return run_.report(); }
    const GameReplay& result() const& { return replay_; }
    GameReplay result() && { return std::move(replay_); }

private:
    void compare(const GameHashes& recorded);

    const Recording& recording_;
    HashTrack::Reader hashes_;
    GameRun run_;
    GameReplay replay_;
    bool finished_ = false;
};

/// The same in one go.
/// Costs what recording cost.
FIRMA_EXPORT GameReplay replay_game(const Recording& recording);

/// What pack_recording() writes and unpack_recording() reads.
inline constexpr std::uint32_t kRecordingVersion = 1;

/// A recording as bytes. docs/formats.md has the layout.
/// @return the errors of pack_game(), and of events that cannot be kept, naming them
/// Costs pack_game() twice, and the bytes of the hashes.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<std::byte>> pack_recording(const Recording& recording);

/// The recording of such bytes, taken as hostile: as unpack_game().
[[nodiscard]] FIRMA_EXPORT Result<Recording> unpack_recording(std::span<const std::byte> bytes, std::string name);

/// Whether bytes begin as those of a recording do. Reads the head and the table of sections.
[[nodiscard]] FIRMA_EXPORT bool is_recording(std::span<const std::byte> bytes);

}  // namespace firma
