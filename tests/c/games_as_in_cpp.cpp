// SPDX-License-Identifier: MIT
// Games of the C API beside those of the C++ library: given the same, they have the same hashes after each tick, the
// same bytes and the same recordings; what differs in a changed recording is told alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "firma/firma_c.h"
#include "firma/recording.h"
#include "tests/game/small_games.h"

namespace firma {
namespace {

#define OK(call) ASSERT_EQ(call, FIRMA_OK) << firma_error_message()

void put(const Vec3& v, double (&out)[3]) {
    for (int axis = 0; axis < 3; ++axis) out[axis] = v[axis];
}

std::span<const std::byte> bytes_of(firma_bytes bytes) {
    const void* data = nullptr;
    std::size_t length = 0;
    EXPECT_EQ(firma_bytes_get_view(bytes, &data, &length), FIRMA_OK);
    return {static_cast<const std::byte*>(data), length};
}

/// Does what an event of C++ says by the C API.
class EventInC {
public:
    explicit EventInC(firma_game game) : game_(game) {}

    void operator()(const EditEvent& event) const {
        const std::vector<std::byte> packed = pack_command(event.command).value();
        firma_command command{};
        OK(firma_command_unpack(packed.data(), packed.size(), nullptr, &command));
        OK(firma_game_edit(game_, command, nullptr));
        OK(firma_command_release(command));
    }
    void operator()(const BlastEvent& event) const {
        firma_charge charge;
        firma_charge_defaults(&charge);
        charge.crater = event.charge.crater;
        charge.radius = event.charge.radius;
        charge.impulse = event.charge.impulse;
        double at[3];
        put(event.at, at);
        OK(firma_game_explode(game_, at, &charge));
    }
    void operator()(const FireEvent& event) const {
        double position[3], velocity[3];
        put(event.position, position);
        put(event.velocity, velocity);
        OK(firma_game_fire(game_, event.weapon, position, velocity));
    }
    void operator()(const BodyEvent& event) const {
        std::vector<double> spheres;
        for (const Sphere& sphere : event.body.shape.spheres())
            spheres.insert(spheres.end(), {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius});
        firma_mass mass{};
        const double half[3] = {0.25, 0.25, 0.25};
        firma_body_shape shape{};
        OK(firma_mass_of_box(half, 1000, &mass));
        OK(firma_body_shape_spheres(spheres.data(), spheres.size() / 4, &mass, &shape));
        firma_pose pose{{0, 0, 0}, {0, 0, 0, 1}, 1};
        put(event.body.position, pose.position);
        OK(firma_game_add_body(game_, shape, &pose, nullptr, nullptr));
        OK(firma_body_shape_release(shape));
    }
    void operator()(const PlayerEvent& event) const {
        firma_game_player player;
        firma_game_player_defaults(&player);
        OK(firma_player_shape_capsule(nullptr, &player.shape));
        put(event.player.player.position, player.player.position);
        OK(firma_game_add_player(game_, &player, nullptr));
        OK(firma_player_shape_release(player.shape));
    }
    void operator()(const WishEvent& event) const {
        firma_player_wish wish{};
        wish.size = sizeof wish;
        wish.jump = event.wish.jump;
        put(event.wish.velocity, wish.velocity);
        OK(firma_game_wish(game_, event.player, &wish));
    }
    void operator()(const PartEvent& event) const { OK(firma_game_set_off(game_, event.part)); }

private:
    firma_game game_;
};

firma_world world_in_c(const World& world) {
    const std::vector<std::byte> bytes = pack_world(world);
    firma_world made{};
    EXPECT_EQ(firma_world_unpack(bytes.data(), bytes.size(), nullptr, &made), FIRMA_OK) << firma_error_message();
    return made;
}

/// small_game(), by calls of the C API.
firma_game small_game_in_c(const GameState& as) {
    firma_game game{};
    const firma_world level = world_in_c(as.world);
    EXPECT_EQ(firma_game_begin(level, as.rate, &game), FIRMA_OK);
    EXPECT_EQ(firma_world_release(level), FIRMA_OK);
    for (std::size_t k = 0; k < as.parts.size(); ++k) {
        std::vector<firma_part_stop> stops;
        for (const PartStop& stop : as.drives[k].path.stops) {
            firma_part_stop& made = stops.emplace_back();
            put(stop.position, made.position);
            made.wait = stop.wait;
            made.seconds = stop.seconds;
        }
        firma_part_path path;
        firma_part_path_defaults(&path);
        path.stops = stops.data();
        path.stop_count = stops.size();
        path.spin = as.drives[k].path.spin;
        firma_game_part part;
        firma_game_part_defaults(&part);
        part.world = world_in_c(as.parts[k].world());
        part.path = &path;
        part.name = as.parts[k].name.c_str();
        part.waits = as.drives[k].waits;
        EXPECT_EQ(firma_game_add_part(game, &part, nullptr), FIRMA_OK) << firma_error_message();
        EXPECT_EQ(firma_world_release(part.world), FIRMA_OK);
    }
    return game;
}

class GamesAsInCpp : public testing::Test {
protected:
    ~GamesAsInCpp() override { EXPECT_EQ(firma_live_handles(), 0u); }
};

TEST_F(GamesAsInCpp, TheSameHashesAndTheSameBytes) {
    constexpr std::uint64_t kTicks = 90;
    const GameState start = test::small_game();
    const std::vector<GameEvent> events = test::small_events();
    GameRun run(start, events);
    const firma_game game = small_game_in_c(start);
    OK(firma_game_record(game, "room"));
    std::uint64_t hash = 0;
    OK(firma_game_hash(game, &hash));
    EXPECT_EQ(hash, hash_game(start));
    std::size_t next = 0;
    for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
        for (; next < events.size() && events[next].tick == tick; ++next) std::visit(EventInC(game), events[next].what);
        OK(firma_game_step(game));
        ASSERT_FALSE(run.step());
        OK(firma_game_hash(game, &hash));
        ASSERT_EQ(hash, hash_game(run.game())) << tick;
        firma_game_report report{};
        report.size = sizeof report;
        OK(firma_game_get_report(game, &report));
        EXPECT_EQ(report.blasts, run.report().blasts.size());
        EXPECT_EQ(report.shot_events, run.report().shot_events.size());
        EXPECT_EQ(report.loose, run.report().loose);
        EXPECT_EQ(report.edits, run.report().edits);
        EXPECT_EQ(report.bodies.contacts, run.report().bodies.contacts);
    }
    EXPECT_EQ(next, events.size());
    firma_bytes packed{};
    OK(firma_game_pack(game, &packed));
    const std::vector<std::byte> expected = pack_game(run.game()).value();
    EXPECT_TRUE(std::ranges::equal(bytes_of(packed), expected));
    OK(firma_bytes_release(packed));

    firma_recording recording{};
    OK(firma_game_recording(game, &recording));
    OK(firma_recording_pack(recording, &packed));
    const std::vector<std::byte> recorded = pack_recording(record_game(start, events, kTicks, "room").value()).value();
    EXPECT_TRUE(std::ranges::equal(bytes_of(packed), recorded));
    OK(firma_bytes_release(packed));
    OK(firma_recording_release(recording));
    OK(firma_game_release(game));
}

/// What the C API's replay of a recording ends with.
struct ReplayInC {
    firma_game_replay told{};
    std::string text;

    explicit ReplayInC(const Recording& recording) {
        const std::vector<std::byte> bytes = pack_recording(recording).value();
        firma_recording read{};
        firma_game game{};
        EXPECT_EQ(firma_recording_unpack(bytes.data(), bytes.size(), nullptr, &read), FIRMA_OK);
        EXPECT_EQ(firma_recording_replay(read, &game), FIRMA_OK);
        for (told.size = sizeof told; !told.finished;) {
            EXPECT_EQ(firma_game_step(game), FIRMA_OK) << firma_error_message();
            EXPECT_EQ(firma_game_get_replay(game, &told), FIRMA_OK);
        }
        text = told.text;
        EXPECT_EQ(firma_game_step(game), FIRMA_ERROR_BAD_CALL);
        EXPECT_EQ(firma_game_release(game), FIRMA_OK);
        EXPECT_EQ(firma_recording_release(read), FIRMA_OK);
    }
};

TEST_F(GamesAsInCpp, WhatDiffersIsNamedAlike) {
    const Recording recording = record_game(test::small_game(), test::small_events(), 40, "room").value();
    for (const std::size_t event : {2u, 4u, 7u}) {
        Recording other = recording;
        if (event == 2) std::get<WishEvent>(other.events[event].what).wish.velocity.x = 2;
        if (event == 4) std::get<FireEvent>(other.events[event].what).velocity.z = 1;
        if (event == 7) std::get<BlastEvent>(other.events[event].what).charge.crater = 0.4;
        const GameReplay expected = replay_game(other);
        ASSERT_TRUE(expected.difference);
        const ReplayInC replay(other);
        EXPECT_EQ(replay.told.differs, 1u);
        EXPECT_EQ(replay.told.at_end, 0u);
        EXPECT_EQ(replay.told.ticks, expected.ticks);
        EXPECT_EQ(replay.told.ticks_in_all, 40u);
        EXPECT_EQ(replay.told.tick, expected.difference->tick);
        EXPECT_EQ(replay.told.hash, expected.difference->hash);
        EXPECT_EQ(replay.told.recorded, expected.difference->recorded);
        EXPECT_EQ(replay.text, expected.difference->text());
    }
    // All ticks are as recorded, and the end is another.
    Recording other = recording;
    other.end.players[0].player.velocity.x += 1;
    const ReplayInC replay(other);
    EXPECT_EQ(replay.told.differs, 1u);
    EXPECT_EQ(replay.told.at_end, 1u);
    EXPECT_EQ(replay.told.ticks, 40u);
    EXPECT_NE(replay.text.find("the game that it ended with"), std::string::npos);
    EXPECT_NE(replay.text.find("player 0"), std::string::npos);
    const ReplayInC same(recording);
    EXPECT_EQ(same.told.differs, 0u);
    EXPECT_EQ(same.told.ticks, 40u);
    EXPECT_EQ(same.text, "");
}

}  // namespace
}  // namespace firma
