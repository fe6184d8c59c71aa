// SPDX-License-Identifier: MIT
// Games stepped with their events, recorded and compared.
#include <algorithm>
#include <utility>

#include "firma/recording.h"
#include "game/judge_event.h"

namespace firma {
namespace {

std::string hex(std::uint64_t hash) {
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15];
    return text;
}

Error at_place(std::string place, const Error& error) {
    return {error.code, std::move(place) + (error.place.empty() ? "" : ": ") + error.place, error.reason};
}

/// A projectile by its weapon and its index there.
std::string name_of_projectile(const GameState& game, std::size_t index) {
    for (const GameShots& shots : game.shots) {
        if (index < shots.projectiles.size()) return "projectile " + std::to_string(index) + " of " + shots.weapon.name;
        index -= shots.projectiles.size();
    }
    return "a projectile that is not there";
}

/// @param game  the replay's
std::string name_of_item(const GameState& game, GameItem item, std::size_t index) {
    const std::string number = std::to_string(index);
    switch (item) {
        case GameItem::kWorld:
            return "the world";
        case GameItem::kPart:
            if (index >= game.parts.size() || game.parts[index].name.empty()) return "part " + number;
            return "part " + number + " (" + game.parts[index].name + ")";
        case GameItem::kPlayer:
            return "player " + number;
        case GameItem::kProjectile:
            return name_of_projectile(game, index);
        case GameItem::kBody:
            return "body " + number;
        case GameItem::kDebris:
            return "the solid of body " + number;
        case GameItem::kRest:
            break;
    }
    return "counters, contacts of bodies, rules or the log";
}

GameDifference difference_of(const GameState& game, const GameHashes& now, const GameHashes& recorded) {
    GameDifference difference;
    difference.tick = game.tick;
    difference.hash = now.whole;
    difference.recorded = recorded.whole;
    for (std::size_t kind = 0; kind < kGameItems; ++kind) {
        const std::vector<std::uint32_t>&a = now.items[kind], &b = recorded.items[kind];
        for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
            if (k < a.size() && k < b.size() && a[k] == b[k]) continue;
            if (difference.items.size() == kMaxNamedItems)
                ++difference.unnamed;
            else
                difference.items.push_back(name_of_item(game, GameItem(kind), k));
        }
    }
    return difference;
}

}  // namespace

GameRun::GameRun(GameState game, std::span<const GameEvent> events) : game_(std::move(game)), events_(events) {}

std::optional<Error> GameRun::step() {
    report_ = {};
    for (; next_ < events_.size() && events_[next_].tick <= game_.tick; ++next_)
        if (const auto error = apply_event(game_, events_[next_], &report_))
            return at_place("event " + std::to_string(next_), *error);
    return step_game(game_, &report_);
}

std::optional<Error> judge_events(const GameState& game, std::span<const GameEvent> events) {
    GameCounts counts{game.shots.size(), game.players.size(), game.parts.size()};
    std::uint64_t last = game.tick;
    for (std::size_t k = 0; k < events.size(); ++k) {
        const std::string place = "event " + std::to_string(k);
        if (events[k].tick < last)
            return Error{ErrorCode::kInvalid, place,
                         k == 0 ? "it is before the game begins" : "it is before the event before it"};
        last = events[k].tick;
        if (const auto error = judge_event(events[k], counts)) return at_place(place, *error);
        counts.players += std::holds_alternative<PlayerEvent>(events[k].what);
    }
    return std::nullopt;
}

GameRecorder::GameRecorder(GameState start, std::vector<GameEvent> events, std::string level)
    : recording_{std::move(level), start.log.level_hash(), start, std::move(events), {}, {}},
      run_(std::move(start), recording_.events) {}

std::optional<Error> GameRecorder::step() {
    if (!judged_)
        if (auto error = judge_events(run_.game(), recording_.events)) return error;
    judged_ = true;
    const std::uint64_t tick = run_.game().tick;
    if (const auto error = run_.step()) return at_place("tick " + std::to_string(tick), *error);
    recording_.hashes.append(hash_game_items(run_.game()));
    return std::nullopt;
}

Recording GameRecorder::finish() {
    recording_.end = run_.take_game();
    return std::move(recording_);
}

Result<Recording> record_game(GameState start, std::vector<GameEvent> events, std::uint64_t ticks, std::string level) {
    if (auto error = judge_events(start, events)) return *error;
    GameRecorder recorder(std::move(start), std::move(events), std::move(level));
    for (std::uint64_t k = 0; k < ticks; ++k)
        if (auto error = recorder.step()) return *error;
    return recorder.finish();
}

std::string GameDifference::text() const {
    std::string text = "tick " + std::to_string(tick) + ": " + (at_end ? "the game that it ended with: " : "") +
                       "the hash is " + hex(hash) + ", recorded is " + hex(recorded);
    if (items.empty()) return text + "; all things in it have their recorded hashes";
    text += "; not as recorded: ";
    for (std::size_t k = 0; k < items.size(); ++k) text += (k > 0 ? ", " : "") + items[k];
    return unnamed > 0 ? text + " and " + std::to_string(unnamed) + " more" : text;
}

GameReplayJob::GameReplayJob(const Recording& recording)
    : recording_(recording), hashes_(recording.hashes), run_(recording.start, recording.events) {
    if (recording.level_hash != recording.start.log.level_hash()) {
        replay_.error = Error{ErrorCode::kMalformed, recording.level, "it was recorded in another level than it has"};
        finished_ = true;
    } else if (auto error = judge_events(recording.start, recording.events)) {
        replay_.error = std::move(error);
        finished_ = true;
    }
    if (finished_) replay_.game = run_.take_game();
}

void GameReplayJob::compare(const GameHashes& recorded) {
    const GameHashes now = hash_game_items(run_.game());
    if (now == recorded)
        ++replay_.ticks;
    else
        replay_.difference = difference_of(run_.game(), now, recorded);
}

bool GameReplayJob::step() {
    if (finished_) return true;
    if (!hashes_.at_end()) {
        if (auto error = run_.step())
            replay_.error = at_place("tick " + std::to_string(run_.game().tick), *error);
        else
            compare(hashes_.next());
    } else {
        const GameHashes now = hash_game_items(run_.game()), end = hash_game_items(recording_.end);
        if (!(now == end)) {
            replay_.difference = difference_of(run_.game(), now, end);
            replay_.difference->at_end = true;
        }
        finished_ = true;
    }
    finished_ = finished_ || !replay_.ok();
    if (finished_) replay_.game = run_.take_game();
    return finished_;
}

GameReplay replay_game(const Recording& recording) {
    GameReplayJob job(recording);
    while (!job.step()) continue;
    return std::move(job).result();
}

}  // namespace firma
