// SPDX-License-Identifier: MIT
// Recordings: the same bytes from the same game, replays that are the same, and differences that are named.
#include <gtest/gtest.h>

#include "firma/recording.h"
#include "game/game_sections.h"
#include "tests/game/small_games.h"
#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

using test::depot_events;
using test::depot_game;
using test::small_events;
using test::small_game;

Recording small_recording(std::uint64_t ticks = 40) {
    Result<Recording> recorded = record_game(small_game(), small_events(), ticks, "room");
    EXPECT_TRUE(recorded.ok()) << recorded.error().text();
    return std::move(recorded).value();
}

TEST(Recording, TwiceTheSameBytesAndReplaysTheSame) {
    const std::vector<std::byte> bytes = pack_recording(small_recording()).value();
    EXPECT_EQ(pack_recording(small_recording()).value(), bytes);
    EXPECT_TRUE(is_recording(bytes));
    EXPECT_FALSE(is_game_file(bytes));
    const Result<Recording> read = unpack_recording(bytes, "a.firmarec");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(pack_recording(read.value()).value(), bytes);
    EXPECT_EQ(read.value().level, "room");
    const GameReplay replay = replay_game(read.value());
    EXPECT_TRUE(replay.ok()) << (replay.difference ? replay.difference->text() : replay.error->text());
    EXPECT_EQ(replay.ticks, 40u);
    EXPECT_EQ(hash_game(replay.game), hash_game(read.value().end));
}

TEST(Recording, TheTrackGivesAllHashesBack) {
    const std::vector<GameEvent> events = small_events();
    GameRun run(small_game(), events);
    HashTrack track;
    std::vector<GameHashes> all;
    for (int k = 0; k < 30; ++k) {
        ASSERT_FALSE(run.step());
        all.push_back(hash_game_items(run.game()));
        track.append(all.back());
    }
    const Result<HashTrack> again = HashTrack::from_bytes(track.bytes(), "track");
    ASSERT_TRUE(again.ok()) << again.error().text();
    ASSERT_EQ(again.value().size(), 30u);
    HashTrack::Reader reader(again.value());
    for (const GameHashes& hashes : all) EXPECT_EQ(reader.next(), hashes);
    EXPECT_TRUE(reader.at_end());
    for (std::size_t length = 1; length < track.bytes().size(); ++length) {
        const auto cut = HashTrack::from_bytes(std::span(track.bytes()).first(length), "track");
        if (cut) {
            EXPECT_LT(cut.value().size(), 30u);
        }
    }
}

/// The bytes of a recording with one byte of a section changed, its checksums right.
std::vector<std::byte> changed(const std::vector<std::byte>& bytes, SectionType type, std::size_t at) {
    std::vector<std::byte> other = bytes;
    for (const SectionPlace& place : section_places(bytes))
        if (place.type == type) other[place.first + at] ^= std::byte(4);
    fix_checksums(other);
    return other;
}

TEST(Recording, AChangedHashIsToldAtItsTick) {
    const Recording recording = small_recording();
    // Where the hash of each tick begins.
    std::vector<std::size_t> places;
    HashTrack so_far;
    HashTrack::Reader reader(recording.hashes);
    while (!reader.at_end()) {
        places.push_back(so_far.bytes().size());
        so_far.append(reader.next());
    }
    const std::vector<std::byte> bytes = pack_recording(recording).value();
    for (const std::uint64_t tick : {0, 1, 17, 39}) {
        const auto damaged = changed(bytes, kRecordedHashesSection, places[tick] + 3);
        const GameReplay replay = replay_game(unpack_recording(damaged, "a").value());
        ASSERT_TRUE(replay.difference);
        EXPECT_EQ(replay.difference->tick, tick + 1);
        EXPECT_EQ(replay.ticks, tick);
        EXPECT_EQ(replay.difference->hash ^ replay.difference->recorded, std::uint64_t(4) << 24);
        EXPECT_TRUE(replay.difference->items.empty());
    }
    // Without the checksum it does not come so far.
    std::vector<std::byte> damaged = bytes;
    damaged[section_places(bytes)[3].first + 3] ^= std::byte(4);
    EXPECT_EQ(unpack_recording(damaged, "a").error().text(), "a: section TICK: is damaged: wrong checksum");
}

TEST(Recording, AChangedEventIsToldWithWhatDiffers) {
    const Recording recording = small_recording();
    const auto difference_with = [&](std::size_t event, const auto& change) {
        Recording other = recording;
        change(other.events[event]);
        const GameReplay replay = replay_game(other);
        EXPECT_TRUE(replay.difference);
        return replay.difference.value_or(GameDifference());
    };
    // Another wish: the player alone, in the tick after it.
    GameDifference told =
        difference_with(2, [](GameEvent& event) { std::get<WishEvent>(event.what).wish.velocity.x = 2; });
    EXPECT_EQ(told.tick, 3u);
    EXPECT_EQ(told.items, std::vector<std::string>{"player 0"});
    EXPECT_NE(told.text().find("tick 3: the hash is "), std::string::npos);
    EXPECT_NE(told.text().find("; not as recorded: player 0"), std::string::npos);
    // Another rocket.
    told = difference_with(4, [](GameEvent& event) { std::get<FireEvent>(event.what).velocity.z = 1; });
    EXPECT_EQ(told.tick, 6u);
    EXPECT_EQ(told.items, std::vector<std::string>{"projectile 0 of rocket"});
    // The door sets off a tick later.
    told = difference_with(3, [](GameEvent& event) { event.tick = 5; });
    EXPECT_EQ(told.tick, 5u);
    EXPECT_EQ(told.items, std::vector<std::string>{"part 0 (leaf)"});
    // A larger crater.
    told = difference_with(7, [](GameEvent& event) { std::get<BlastEvent>(event.what).charge.crater = 0.6; });
    EXPECT_EQ(told.tick, 9u);
    EXPECT_EQ(told.items.front(), "the world");
    // A body elsewhere.
    told = difference_with(1, [](GameEvent& event) { std::get<BodyEvent>(event.what).body.position.x += 0.5; });
    EXPECT_EQ(told.tick, 1u);
    EXPECT_EQ(told.items, (std::vector<std::string>{"body 0", "counters, contacts of bodies, rules or the log"}));
}

TEST(Recording, ItsEndIsCompared) {
    Recording recording = small_recording();
    recording.end.players[0].player.velocity.x += 1;
    const GameReplay replay = replay_game(recording);
    ASSERT_TRUE(replay.difference);
    EXPECT_TRUE(replay.difference->at_end);
    EXPECT_EQ(replay.ticks, 40u);
    EXPECT_EQ(replay.difference->items, std::vector<std::string>{"player 0"});
}

TEST(Recording, EventsThatCannotBeAreRefused) {
    const auto refusal = [](GameEvent event) {
        const Result<Recording> recorded = record_game(small_game(), {std::move(event)}, 1, "");
        return recorded ? "recorded" : recorded.error().text();
    };
    EXPECT_EQ(refusal({0, WishEvent{0, {}}}), "event 0: there is no player 0");
    EXPECT_EQ(refusal({0, FireEvent{3, {}, {}}}), "event 0: there is no weapon 3");
    EXPECT_EQ(refusal({0, PartEvent{2}}), "event 0: there is no part 2");
    EXPECT_EQ(refusal({0, BlastEvent{{NAN, 0, 0}, {}}}),
              "event 0: the place of a blast has a number that is not finite");
    EXPECT_EQ(refusal({0, BlastEvent{{}, {.crater = -1}}}), "event 0: a charge's crater is not 0 to 8192 m");
    EXPECT_EQ(refusal({0, BodyEvent{}}), "event 0: a body has no shape");
    EXPECT_EQ(refusal({0, PlayerEvent{}}), "event 0: a player has no shape");
    EditCommand empty;
    empty.cutter = Cutter();
    EXPECT_EQ(refusal({0, EditEvent{empty}}), "event 0: an empty cutter");
    GameState game = small_game();
    game.tick = 5;
    EXPECT_EQ(record_game(game, {{4, PartEvent{0}}}, 1).error().text(), "event 0: it is before the game begins");
    EXPECT_EQ(record_game(game, {{9, PartEvent{0}}, {8, PartEvent{0}}}, 1).error().text(),
              "event 1: it is before the event before it");
}

TEST(Recording, EveryByteFlippedUnderRightChecksums) {
    const std::vector<std::byte> bytes = pack_recording(small_recording(12)).value();
    std::size_t read_anyway = 0, refused = 0;
    for (const SectionPlace& place : section_places(bytes)) {
        if (place.type == kRecordedStartSection || place.type == kRecordedEndSection) continue;  // GameBytes.*
        for (std::size_t k = place.first; k < place.first + place.length; k += 3) {
            std::vector<std::byte> damaged = bytes;
            damaged[k] ^= std::byte(k % 2 ? 0x41 : 0x80);
            EXPECT_FALSE(unpack_recording(damaged, "test"));
            fix_checksums(damaged);
            const Result<Recording> read = unpack_recording(damaged, "test");
            read ? ++read_anyway : ++refused;
            if (!read) {
                EXPECT_EQ(read.error().place.rfind("test", 0), 0u) << read.error().text();
            } else if (place.type != kRecordedEventsSection || k % 7 == 0) {
                static_cast<void>(replay_game(read.value()));
            }
        }
    }
    EXPECT_GT(read_anyway, 100u);
    EXPECT_GT(refused, 100u);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 64)
        ASSERT_FALSE(unpack_recording(std::span(bytes).first(length), "test")) << length;
}

TEST(Recording, TenSecondsOfTheDepot) {
    const Result<Recording> recorded = record_game(depot_game(), depot_events(), 600, "depot.map");
    ASSERT_TRUE(recorded.ok()) << recorded.error().text();
    const GameState& end = recorded.value().end;
    EXPECT_GE(end.explosions, 9u);
    EXPECT_GT(end.log.commands().size(), 6u);
    std::size_t bodies = 0;
    for (const Body& body : end.bodies.slots) bodies += body.shape.valid();
    EXPECT_GT(bodies, 20u);
    EXPECT_FALSE(check_world(end.world));
    const std::vector<std::byte> bytes = pack_recording(recorded.value()).value();
    const Result<Recording> read = unpack_recording(bytes, "depot.firmarec");
    ASSERT_TRUE(read.ok()) << read.error().text();
    const GameReplay again = replay_game(read.value());
    EXPECT_TRUE(again.ok()) << (again.difference ? again.difference->text() : again.error->text());
    EXPECT_EQ(again.ticks, 600u);
    const ReplayResult world = replay(depot_game().world, end.log);
    ASSERT_TRUE(world.ok()) << world.error->text();
    EXPECT_EQ(hash_world(world.world), hash_world(end.world));
}

}  // namespace
}  // namespace firma
