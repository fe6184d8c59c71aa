// SPDX-License-Identifier: MIT
// Games and recordings as bytes: the same game comes back, and damage is an error with its place or the same game.
#include <gtest/gtest.h>

#include "firma/save.h"
#include "game/game_sections.h"
#include "tests/game/small_games.h"
#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

using test::depot_events;
using test::depot_game;
using test::small_events;
using test::small_game;
using test::small_game_after;

GameState loaded(const GameState& game) {
    const Result<std::vector<std::byte>> bytes = pack_game(game);
    EXPECT_TRUE(bytes.ok()) << bytes.error().text();
    Result<GameState> read = unpack_game(bytes.value(), "a.firma");
    EXPECT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(pack_game(read.value()).value(), bytes.value());
    return std::move(read).value();
}

TEST(GameBytes, OneOfEverythingComesBack) {
    const GameState game = small_game_after(24);
    ASSERT_EQ(game.players.size(), 1u);
    ASSERT_EQ(game.parts.size(), 2u);
    ASSERT_GT(game.log.commands().size(), 2u);
    ASSERT_FALSE(game.shots[2].projectiles.empty());  // the grenade
    ASSERT_FALSE(game.bodies.contacts.empty());
    const GameState read = loaded(game);
    EXPECT_EQ(hash_game_items(read), hash_game_items(game));
    EXPECT_EQ(hash_game(read), hash_game_items(game).whole);
    EXPECT_EQ(read.log.commands().size(), game.log.commands().size());
    EXPECT_EQ(read.parts[0].name, "leaf");
    EXPECT_EQ(hash_bodies(read.bodies), hash_bodies(game.bodies));
    EXPECT_EQ(hash_debris(read.debris), hash_debris(game.debris));
}

/// Both go on with the same events, compared after each tick.
void expect_same_on(GameState a, GameState b, const std::vector<GameEvent>& events, int ticks) {
    GameRun one(std::move(a), events), other(std::move(b), events);
    for (int k = 0; k < ticks; ++k) {
        ASSERT_FALSE(one.step());
        ASSERT_FALSE(other.step());
        ASSERT_EQ(hash_game_items(one.game()), hash_game_items(other.game())) << k;
    }
}

/// The events from a tick on.
std::vector<GameEvent> later(std::vector<GameEvent> events, std::uint64_t tick) {
    std::erase_if(events, [&](const GameEvent& event) { return event.tick < tick; });
    return events;
}

TEST(GameBytes, LoadedItGoesOnAsNeverSaved) {
    for (const std::uint64_t tick : {0, 1, 5, 9, 25}) {
        const GameState game = small_game_after(tick);
        expect_same_on(game, loaded(game), later(small_events(), tick), 60);
    }
}

TEST(GameBytes, AWorldsReaderReadsItsWorld) {
    const GameState game = small_game_after(12);
    const std::vector<std::byte> bytes = pack_game(game).value();
    const Result<World> world = unpack_world(bytes, "a.firma");
    ASSERT_TRUE(world.ok());
    EXPECT_EQ(hash_world(world.value()), hash_world(game.world));
    EXPECT_TRUE(is_game_file(bytes));
    EXPECT_FALSE(is_recording(bytes));
    const std::vector<std::byte> alone = pack_world(game.world);
    EXPECT_FALSE(is_game_file(alone));
    EXPECT_EQ(unpack_game(alone, "w.firma").error().text(), "w.firma: it holds a world and no game");
}

TEST(GameBytes, TheLogMakesItsWorld) {
    const GameState game = small_game_after(30);
    const ReplayResult replayed = replay(with_anchors(room_world()), game.log);
    ASSERT_TRUE(replayed.ok()) << replayed.error->text();
    EXPECT_EQ(hash_world(replayed.world), hash_world(game.world));
    EXPECT_EQ(replayed.done, game.log.commands().size());
}

TEST(GameBytes, EveryByteFlipped) {
    std::vector<std::byte> bytes = pack_game(small_game_after(10)).value();
    const std::uint64_t hash = hash_game(unpack_game(bytes, "test").value());
    std::size_t refused = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        bytes[k] ^= std::byte(0x81);
        const Result<GameState> read = unpack_game(bytes, "test");
        bytes[k] ^= std::byte(0x81);
        if (read) {
            EXPECT_EQ(hash_game(read.value()), hash) << "byte " << k;
        } else {
            ++refused;
            EXPECT_EQ(read.error().place.rfind("test", 0), 0u) << read.error().text();
        }
    }
    EXPECT_EQ(refused, bytes.size());
}

TEST(GameBytes, EveryTruncation) {
    const std::vector<std::byte> bytes = pack_game(small_game_after(10)).value();
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(unpack_game(std::span(bytes).first(length), "test")) << length;
}

/// Whether a section belongs to the game, not to its world: that is tested in tests/save.
bool is_of_games(SectionType type) {
    return type == kGameSection || type == kGameLogSection || type == kGamePartsSection ||
           type == kGamePlayersSection || type == kGameShotsSection || type == kGameBodiesSection ||
           type == kGameDebrisSection;
}

/// Right checksums over wrong content: what is read can be stepped on and packed again.
TEST(GameBytes, EveryByteFlippedUnderRightChecksums) {
    const std::vector<std::byte> bytes = pack_game(small_game_after(10)).value();
    std::size_t read_anyway = 0, refused = 0;
    for (const SectionPlace& place : section_places(bytes)) {
        if (!is_of_games(place.type)) continue;
        // Most of the parts' bytes are those of their worlds.
        const std::size_t stride = place.type == kGamePartsSection ? 7 : 2;
        for (std::size_t k = place.first; k < place.first + place.length; k += stride) {
            for (const unsigned flip : {1u, 0x40u}) {
                std::vector<std::byte> damaged = bytes;
                damaged[k] ^= std::byte(flip);
                fix_checksums(damaged);
                Result<GameState> read = unpack_game(damaged, "test");
                read ? ++read_anyway : ++refused;
                if (!read) {
                    EXPECT_EQ(read.error().place.rfind("test", 0), 0u) << read.error().text();
                } else if (k % 3 == 0) {
                    GameState game = std::move(read).value();
                    EXPECT_TRUE(pack_game(game).ok());
                    for (int tick = 0; tick < 2; ++tick) static_cast<void>(step_game(game));
                }
            }
        }
    }
    EXPECT_GT(read_anyway, 300u);  // numbers of all kinds
    EXPECT_GT(refused, 100u);
}

TEST(GameBytes, EveryTruncationOfASectionUnderRightChecksums) {
    const GameState game = small_game_after(10);
    const std::vector<std::byte> bytes = pack_game(game).value();
    std::vector<Section> sections = read_container(bytes, "test").value();
    for (std::size_t which = 0; which < sections.size(); ++which) {
        if (!is_of_games(sections[which].type)) continue;
        for (std::size_t length = 0; length < sections[which].bytes.size(); length += 1 + length / 16) {
            std::vector<NewSection> cut;
            for (std::size_t k = 0; k < sections.size(); ++k) {
                ByteWriter content;
                for (const std::byte byte : sections[k].bytes.first(k == which ? length : sections[k].bytes.size()))
                    content.u8(std::uint8_t(byte));
                cut.push_back({sections[k].type, sections[k].flags, std::move(content)});
            }
            const Result<GameState> read = unpack_game(write_container(cut, version_of_container(bytes)), "test");
            ASSERT_FALSE(read) << section_name(sections[which].type) << " cut to " << length;
        }
    }
}

TEST(GameBytes, WhatCannotBeReadIsNotWritten) {
    GameState game = small_game_after(10);
    game.bodies.slots[0].velocity.x = NAN;
    EXPECT_EQ(pack_game(game).error().text(), "body 0: a body has a number that is not finite");
    game = small_game_after(10);
    game.players[0].player.position.y = INFINITY;
    EXPECT_EQ(pack_game(game).error().text(), "player 0: a player has a number that is not finite");
    game = small_game_after(10);
    game.drives.pop_back();
    EXPECT_EQ(pack_game(game).error().text(), "it has not as many drives as parts");
}

TEST(GameBytes, WhatCameOffAPartComesBackAsThat) {
    GameState game = small_game_after(10);
    DebrisPiece piece;
    piece.solid = test::box_world({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}).solid();
    piece.matter = 3;
    const BodyId id =
        add_debris(game.bodies, game.debris, test::body_here(test::box_body({0.25, 0.25, 0.25}), {1, 1, 1}), piece);
    const std::vector<std::byte> of_level = pack_game(game).value();
    const GameHashes hashes = hash_game_items(game);
    EXPECT_FALSE(loaded(game).debris.slots[id.slot].of_part);
    game.debris.slots[id.slot].of_part = true;
    EXPECT_NE(hash_game_items(game), hashes);
    const GameState read = loaded(game);
    EXPECT_TRUE(read.debris.slots[id.slot].of_part);
    EXPECT_EQ(hash_game_items(read), hash_game_items(game));
    // A bit of the flags that were there before: files of before have it as 0, and are read as they were.
    const std::vector<std::byte> of_part = pack_game(game).value();
    ASSERT_EQ(of_part.size(), of_level.size());
    std::size_t other = 0;
    for (const SectionPlace& place : section_places(of_part))
        if (place.type == kGameDebrisSection)
            for (std::size_t k = place.first; k < place.first + place.length; ++k) other += of_part[k] != of_level[k];
    EXPECT_EQ(other, 1u);
}

TEST(GameBytes, DebrisAndPartsAfterBlastsComeBack) {
    const std::vector<GameEvent> events = depot_events();
    GameRun run(depot_game(), events);
    for (int k = 0; k < 130; ++k) ASSERT_FALSE(run.step());
    std::size_t debris = 0;
    for (const DebrisPiece& piece : run.game().debris.slots) debris += piece.solid.face_count() > 0;
    ASSERT_GT(debris, 2u);
    expect_same_on(run.game(), loaded(run.game()), later(events, 130), 120);
}

}  // namespace
}  // namespace firma
