// SPDX-License-Identifier: MIT
// Logs: a level and its log give the same world, in any slices; damaged logs give an error or a sound log.
#include <gtest/gtest.h>

#include <cmath>

#include "save/crc32c.h"
#include "scenes/rng.h"
#include "tests/log/logged_edits.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

TEST(EditLog, GivesTheSameWorld) {
    const World level = two_halls();
    const Logged logged = log_of(level, all_kinds());
    const std::vector<std::byte> bytes = pack_log(logged.log);
    const Result<EditLog> read = unpack_log(bytes, "test");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(pack_log(read.value()), bytes);
    EXPECT_EQ(read.value().checkpoints(), logged.log.checkpoints());
    EXPECT_EQ(read.value().last_number(), logged.log.last_number());
    EXPECT_EQ(read.value().level_hash(), hash_world(level));
    // The level too as a file gives it.
    for (const World& begin : {level, unpack_world(pack_world(level, {.index = false}), "test").value()}) {
        const ReplayResult result = replay(begin, read.value());
        ASSERT_TRUE(result.ok()) << result.error->text();
        EXPECT_EQ(hash_world(result.world), hash_world(logged.world));
        EXPECT_EQ(result.commands, logged.log.commands().size());
        EXPECT_EQ(result.checkpoints, logged.log.checkpoints().size());
        EXPECT_EQ(result.nothing, 1u);
        EXPECT_EQ(result.refused, 2u);
        EXPECT_EQ(result.done + 3, result.commands);
        EXPECT_FALSE(check_world(result.world));
        EXPECT_FALSE(check_solid(result.world));
    }
    EXPECT_EQ(pack_world(replay(level, read.value()).world), pack_world(logged.world));
}

TEST(EditLog, InAnySlices) {
    const World level = two_halls();
    const Logged logged = log_of(level, all_kinds(), 0);
    for (const double slice : {0.0, 50.0, 1e4}) {
        LogReplay job(level, logged.log);
        EXPECT_EQ(job.commands_in_all(), logged.log.commands().size());
        std::size_t calls = 0, behind = 0;
        while (!job.run(slice)) {
            ++calls;
            EXPECT_GE(job.commands_behind(), behind);
            behind = job.commands_behind();
        }
        if (slice == 0) {
            EXPECT_GT(calls, 300u);
        }
        EXPECT_TRUE(job.result().ok());
        EXPECT_EQ(hash_world(job.result().world), hash_world(logged.world));
        EXPECT_EQ(job.commands_behind(), job.commands_in_all());
    }
}

TEST(EditLog, StopsAtANumber) {
    const World level = two_halls();
    const std::vector<EditCommand> commands = all_kinds();
    const Logged logged = log_of(level, commands);
    World world = level;
    for (std::size_t k = 0; k < commands.size(); ++k) {
        ReplayOptions options;
        options.last_number = last_number(commands[k]);
        world = apply(world, commands[k]).world;
        if (k % 6 != 0) continue;
        const ReplayResult result = replay(level, logged.log, options);
        EXPECT_EQ(result.commands, k + 1);
        EXPECT_EQ(hash_world(result.world), hash_world(world));
    }
    EXPECT_EQ(replay(level, logged.log, {.last_number = 0}).commands, 0u);
}

TEST(EditLog, AGroupIsOneVersion) {
    const World level = two_halls();
    const EditCommand group = group_command({cut_command(1, CraterSeed{}, test::pose_at(10, 0, 10, 2)),
                                             cut_command(2, CraterSeed{}, test::pose_at(16, 16, 16)),  // air
                                             door_command(3, 0, false)});
    const CommandResult result = apply(level, group);
    EXPECT_TRUE(result.done());
    EXPECT_EQ(result.world.version(), 1u);
    ASSERT_EQ(result.edits.size(), 2u);
    EXPECT_TRUE(result.edits[0].done());
    EXPECT_EQ(result.edits[1].status, CarveStatus::kNothing);
    EXPECT_FALSE(portal_info(result.world, {0})->open);
    WorldEdit edit(level);
    CarveOptions first;
    first.edit = 1;
    EXPECT_TRUE(edit.carve(make_crater(CutterShape::kRocky, 0), test::pose_at(10, 0, 10, 2), first).done());
    EXPECT_EQ(hash_world(edit.finish()), hash_world(apply(level, group_command({group.parts[0]})).world));
    // Nothing of it: the world itself.
    const CommandResult nothing = apply(level, group_command({group.parts[1], door_command(5, 0, true)}));
    EXPECT_EQ(nothing.status, CarveStatus::kNothing);
    EXPECT_EQ(&nothing.world.data(), &level.data());
    const CommandResult refused = apply(level, group_command({group.parts[1], door_command(5, 9, true)}));
    EXPECT_EQ(refused.status, CarveStatus::kRefused);
    EXPECT_EQ(refused.error.text(), "part 1: portal 9: the world has no such portal");
}

TEST(EditLog, BeginsFromItsWorldAlone) {
    const World level = two_halls();
    const Logged logged = log_of(level, {cut_command(1, CraterSeed{}, test::pose_at(10, 0, 10))});
    const ReplayResult other = replay(logged.world, logged.log);
    ASSERT_FALSE(other.ok());
    EXPECT_EQ(other.error->code, ErrorCode::kInvalid);
    EXPECT_NE(other.error->text().find("the log begins from another world: the hash is "), std::string::npos);
    EXPECT_EQ(hash_world(other.world), hash_world(logged.world));
    CarveRules rules;
    rules.max_cutter_size = 100;
    const ReplayResult ruled = replay(with_rules(level, rules).value(), logged.log);
    ASSERT_FALSE(ruled.ok());
    EXPECT_EQ(ruled.error->text(), "the log was made under other rules for carving, or with other anchors");
    CarveRules merging;
    merging.merge_share = 0.5;
    EXPECT_FALSE(replay(with_rules(level, merging).value(), logged.log).ok());
    EXPECT_FALSE(replay(with_anchors(level), logged.log).ok());
    EXPECT_NE(EditLog(with_anchors(level, {.hanging = false, .sources = {1}})).rules_hash(),
              EditLog(with_anchors(level, {.hanging = false, .sources = {2}})).rules_hash());
    // A log that begins from a world that was edited.
    EditLog on(logged.world);
    EXPECT_EQ(on.level_edits(), 1u);
    EXPECT_EQ(on.next_number(), 2u);
    EXPECT_TRUE(on.append(cut_command(1, CraterSeed{}, Pose())));
    EXPECT_FALSE(on.append(cut_command(2, CraterSeed{}, test::pose_at(20, 0, 10))));
    EXPECT_EQ(replay(logged.world, unpack_log(pack_log(on), "test").value()).done, 1u);
}

TEST(EditLog, ACheckpointThatDoesNotHoldEndsTheReplay) {
    const World level = two_halls();
    EditLog log(level);
    World world = level;
    for (std::uint32_t k = 1; k <= 6; ++k) {
        const EditCommand command = crater_command(k, {CutterShape::kRocky, k}, {4.0 * k, 0, 8}, 1);
        ASSERT_FALSE(log.append(command));
        world = apply(world, command).world;
        log.add_checkpoint(k == 4 ? level : world);
    }
    const ReplayResult result = replay(level, unpack_log(pack_log(log), "test").value());
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error->place, "command 3");
    EXPECT_EQ(result.commands, 4u);
    EXPECT_EQ(result.checkpoints, 3u);
}

TEST(EditLog, ACutterIsThereOnce) {
    const World level = two_halls();
    EditLog log(level);
    std::size_t one = 0;
    for (std::uint32_t k = 1; k <= 50; ++k) {
        // Made anew each time: equal ones are one.
        ASSERT_FALSE(log.append(cut_command(k, ring_cutter(), test::pose_at(double(k), 0, 8))));
        if (k == 1) one = pack_log(log).size();
    }
    const std::size_t all = pack_log(log).size();
    EXPECT_LT(all, one + 49 * 16);
    const EditLog read = unpack_log(pack_log(log), "test").value();
    EXPECT_EQ(std::get<Cutter>(read.commands()[0].cutter).data(), std::get<Cutter>(read.commands()[49].cutter).data());
}

TEST(EditLog, ACompactedOneGivesTheSameWorld) {
    const World level = two_halls();
    const std::vector<EditCommand> commands = all_kinds();
    const Logged logged = log_of(level, commands);
    for (const std::size_t kept : {commands.size(), commands.size() - 4, std::size_t(9), std::size_t(0)}) {
        const std::uint32_t number = kept < commands.size() ? last_number(commands[commands.size() - 1 - kept]) : 0;
        const Result<EditLog> made = compacted(level, logged.log, number);
        ASSERT_TRUE(made) << made.error().text();
        EXPECT_EQ(made.value().commands().size(), kept);
        EXPECT_EQ(made.value().last_number(), logged.log.last_number());
        EXPECT_EQ(made.value().patched_number(), number);
        const std::vector<std::byte> bytes = pack_log(made.value());
        const Result<EditLog> read = unpack_log(bytes, "test");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(pack_log(read.value()), bytes);
        const ReplayResult result = replay(level, read.value());
        ASSERT_TRUE(result.ok()) << result.error->text();
        EXPECT_EQ(hash_world(result.world), hash_world(logged.world));
        EXPECT_EQ(result.commands, kept);
        EXPECT_EQ(result.checkpoints, kept + (kept < commands.size())) << "that of the patch, and one a command";
        EXPECT_FALSE(check_world(result.world));
        EXPECT_FALSE(check_solid(result.world));
        // Once more, further.
        const Result<EditLog> again = compacted(level, read.value(), logged.log.last_number());
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(hash_world(replay(level, again.value()).world), hash_world(logged.world));
        EXPECT_TRUE(again.value().commands().empty());
        if (number > 0) {
            EXPECT_FALSE(compacted(level, read.value(), number - 1));
        }
    }
    EXPECT_FALSE(compacted(logged.world, logged.log, 1));
}

CarveOptions looking_for_chunks(double min_volume = 0.001) {
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = min_volume, .density = 2400};
    return options;
}

/// A bridge shot at both ends; a platform that is filled in, shot in two, joined to a wall and shot again.
std::vector<EditCommand> falling_pieces() {
    std::vector<EditCommand> commands;
    const auto box = [&](const Vec3& low, const Vec3& high, EditKind kind) {
        EditCommand command = cut_command(std::uint32_t(commands.size()) + 1,
                                          test::box_mesh(low, high).cutter().value(), Pose(), "", kind);
        command.options = looking_for_chunks(commands.size() == 8 ? 100 : 0.001);
        commands.push_back(command);
    };
    box({0, 5, 4}, {20, 6, 4.5}, EditKind::kFill);
    box({1, 4, 3}, {2, 7, 5}, EditKind::kCarve);
    box({17, 4, 3}, {18, 7, 5}, EditKind::kCarve);
    box({5, 8, 3}, {9, 9, 4}, EditKind::kFill);
    box({6, 7, 2}, {7, 10, 5}, EditKind::kCarve);             // it stays in the air
    box({9, 8.25, 3.25}, {20, 8.75, 3.75}, EditKind::kFill);  // a part of it joined to the wall
    box({18, 7, 2}, {19, 10, 5}, EditKind::kCarve);           // stays, by what the fourth put there
    box({10, 7, 2}, {11, 10, 5}, EditKind::kCarve);           // what the sixth put there falls
    box({0, 10, 0}, {0.5, 11, 8}, EditKind::kFill);
    box({0, 9, 3}, {1, 12, 4}, EditKind::kCarve);
    commands.push_back(crater_command(11, {CutterShape::kRocky, 5}, {12, 0, 3}, 1.3, looking_for_chunks()));
    return commands;
}

TEST(EditLog, LoosePiecesLeaveInAReplayAsWell) {
    const World hall = make_world(test::box_level({0, 0, 0}, {20, 12, 8}, true)).value();
    const std::vector<EditCommand> commands = falling_pieces();
    for (const World& level : {hall, with_anchors(hall)}) {
        World world = level;
        std::vector<Chunk> chunks;
        for (const EditCommand& command : commands) {
            const CommandResult result = apply(world, command);
            ASSERT_TRUE(result.done()) << result.error.text();
            for (const CarveResult& edit : result.edits)
                chunks.insert(chunks.end(), edit.chunks.begin(), edit.chunks.end());
            world = result.world;
        }
        ASSERT_EQ(chunks.size(), 2u);
        EXPECT_EQ(chunks[0].mass.volume, 7.5);
        EXPECT_EQ(chunks[0].mass.mass, 7.5 * 2400);
        EXPECT_EQ(locate(world.solid(), {5.5, 8.5, 3.5}), Where::kSolid);
        const Logged logged = log_of(level, commands);
        EXPECT_EQ(hash_world(logged.world), hash_world(world));
        const EditLog read = unpack_log(pack_log(logged.log), "test").value();
        const ReplayResult replayed = replay(level, read);
        ASSERT_TRUE(replayed.ok()) << replayed.error->text();
        EXPECT_EQ(replayed.checkpoints, commands.size());
        EXPECT_EQ(pack_world(replayed.world), pack_world(world)) << "what holds pieces included";
        // A patch in place of any beginning holds the same pieces.
        for (std::uint32_t number = 0; number <= commands.size(); ++number) {
            const EditLog made = compacted(level, read, number).value();
            const ReplayResult result = replay(level, unpack_log(pack_log(made), "test").value());
            ASSERT_TRUE(result.ok()) << result.error->text();
            EXPECT_EQ(pack_world(result.world, {.index = false}), pack_world(world, {.index = false})) << number;
        }
    }
}

std::vector<std::byte> small_log() {
    const World level = two_halls();
    const test::TriangleMesh box = test::box_mesh({-1, -1, -1}, {1, 1, 1});
    return pack_log(
        log_of(level, {crater_command(1, {CutterShape::kRocky, 7}, {10, 0, 10}, 1, {"crater"}),
                       cut_command(2, box.cutter().value(), test::pose_at(20.1, 0, 10)), door_command(3, 0, false),
                       group_command({cut_command(5, box.cutter().value(), test::pose_at(24.1, 0, 10)),
                                      door_command(6, 0, true)})})
            .log);
}

/// Makes the checksum at the end right again.
void mend_checksum(std::vector<std::byte>& bytes) {
    const std::size_t at = bytes.size() - 4;
    put_u32(bytes, at, crc32c(std::span<const std::byte>(bytes).first(at)));
}

TEST(EditLog, EveryTruncationIsRefused) {
    const std::vector<std::byte> bytes = small_log();
    ASSERT_TRUE(unpack_log(bytes, "test"));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto read = unpack_log(std::span(bytes).first(length), "test");
        ASSERT_FALSE(read) << length;
        EXPECT_EQ(read.error().place.rfind("test: byte ", 0), 0u) << read.error().text();
    }
    std::vector<std::byte> longer = bytes;
    longer.push_back(std::byte(0));
    EXPECT_FALSE(unpack_log(longer, "test"));
}

TEST(EditLog, EveryFlippedByteIsRefusedByTheChecksum) {
    std::vector<std::byte> bytes = small_log();
    for (std::size_t k = 0; k < bytes.size(); ++k)
        for (const unsigned flip : {1u, 0x80u, 0xFFu}) {
            bytes[k] ^= std::byte(flip);
            EXPECT_FALSE(unpack_log(bytes, "test")) << k;
            bytes[k] ^= std::byte(flip);
        }
}

TEST(EditLog, EveryFlippedByteBeyondTheChecksumIsAnErrorOrASoundLog) {
    std::vector<std::byte> bytes = small_log();
    const World level = two_halls();
    std::size_t refused = 0, read_back = 0, replayed = 0;
    for (std::size_t k = 0; k + 4 < bytes.size(); ++k)
        for (const unsigned flip : {1u, 4u, 0x80u}) {
            std::vector<std::byte> flipped = bytes;
            flipped[k] ^= std::byte(flip);
            mend_checksum(flipped);
            const Result<EditLog> read = unpack_log(flipped, "test");
            if (!read) {
                ++refused;
                EXPECT_EQ(read.error().place.rfind("test: byte ", 0), 0u) << read.error().text();
                continue;
            }
            ++read_back;
            const std::vector<std::byte> packed = pack_log(read.value());
            EXPECT_TRUE(pack_log(unpack_log(packed, "test").value()) == packed) << "byte " << k;
            const ReplayResult result = replay(level, read.value());
            replayed += result.ok();
            if (result.commands > 0 && k % 8 == 0) {
                EXPECT_FALSE(check_world(result.world));
                EXPECT_FALSE(check_solid(result.world));
            }
        }
    EXPECT_GT(refused, 100u);
    EXPECT_GT(read_back, 100u);
    EXPECT_GT(replayed, 0u);
}

TEST(EditLog, OtherVersionsAndRecords) {
    const std::vector<std::byte> sound = small_log();
    std::vector<std::byte> bytes = sound;
    bytes[8] = std::byte(2);
    EXPECT_EQ(unpack_log(bytes, "test").error().text(),
              "test: byte 8: it is of version 2 of the format; this Firma reads version 1");
    // A record of another kind before the end.
    for (const bool optional : {false, true}) {
        bytes.assign(sound.begin(), sound.end() - 5);
        bytes.push_back(std::byte(optional ? 0x84 : 0x64));
        for (const unsigned byte : {2u, 1u, 1u, 0u}) bytes.push_back(std::byte(byte));
        bytes.resize(bytes.size() + 4);
        mend_checksum(bytes);
        const Result<EditLog> read = unpack_log(bytes, "test");
        EXPECT_EQ(bool(read), optional);
        if (!read) {
            EXPECT_EQ(read.error().code, ErrorCode::kUnsupported);
        }
        if (read) {
            EXPECT_EQ(pack_log(read.value()), sound);
        }
    }
}

}  // namespace
}  // namespace firma
