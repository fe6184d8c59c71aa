// SPDX-License-Identifier: MIT
// Commands as bytes and back, to the bit; poses on their grids; what is refused.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "save/little_endian.h"
#include "scenes/rng.h"
#include "tests/log/logged_edits.h"

namespace firma {
namespace {

std::vector<std::byte> bytes_of(const EditCommand& command) {
    const Result<std::vector<std::byte>> packed = pack_command(command);
    EXPECT_TRUE(packed) << packed.error().text();
    return packed.value();
}

std::array<std::uint64_t, 8> bits_of(const Pose& pose) {
    std::array<std::uint64_t, 8> bits;
    for (std::size_t k = 0; k < 3; ++k) bits[k] = std::bit_cast<std::uint64_t>(pose.position[int(k)]);
    for (std::size_t k = 0; k < 4; ++k) bits[3 + k] = std::bit_cast<std::uint64_t>(pose.rotation[k]);
    bits[7] = std::bit_cast<std::uint64_t>(pose.scale);
    return bits;
}

/// Poses of every kind: on grids and off, turned and not, near and far.
Pose any_pose(scenes::Rng& rng) {
    Pose pose;
    for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(-1, 1) * (rng.next() % 2 ? 8000 : 10);
    if (rng.next() % 4 != 0) pose.rotation = random_turn(rng.next());
    if (rng.next() % 4 == 0)
        for (double& part : pose.rotation) part *= 17;
    if (rng.next() % 3 != 0) pose.scale = rng.uniform(0.01, 5);
    return rng.next() % 2 ? quantised(pose) : pose;
}

bool same_chunks(const CarveOptions& a, const CarveOptions& b) {
    if (!a.chunks || !b.chunks) return a.chunks.has_value() == b.chunks.has_value();
    return a.chunks->min_volume == b.chunks->min_volume && a.chunks->density == b.chunks->density;
}

TEST(CommandBytes, PosesComeBackToTheBit) {
    scenes::Rng rng(1);
    for (int k = 0; k < 2000; ++k) {
        const CraterSeed crater{CutterShape(rng.next() % 5), rng.next() >> rng.next() % 64};
        const std::uint64_t number = 1 + rng.next() % kMaxEditNumber;
        EditCommand command = cut_command(std::uint32_t(number), crater, any_pose(rng), k % 2 ? "brick" : "");
        if (k % 5 == 0) command.pose.rotation = random_turn(crater.seed);
        if (k % 7 == 0) command.kind = EditKind::kFill;
        if (k % 3 == 0) command.options.from = any_pose(rng).position;
        if (k % 4 == 0) command.options.chunks = ChunkOptions{};
        if (k % 8 == 0) command.options.chunks->min_volume = k % 16 == 0 ? 0 : rng.uniform(0, 10);
        if (k % 12 == 0) command.options.chunks->density = rng.uniform(0.1, 8000);
        const std::vector<std::byte> bytes = bytes_of(command);
        const EditCommand read = unpack_command(bytes, "test").value();
        EXPECT_EQ(bits_of(read.pose), bits_of(command.pose));
        EXPECT_EQ(read.number, command.number);
        EXPECT_EQ(read.kind, command.kind);
        EXPECT_EQ(std::get<CraterSeed>(read.cutter), crater);
        EXPECT_EQ(read.options.material, command.options.material);
        EXPECT_EQ(read.options.from, command.options.from);
        EXPECT_TRUE(same_chunks(read.options, command.options));
        EXPECT_EQ(bytes_of(read), bytes);
    }
}

TEST(CommandBytes, OddPosesComeBackToo) {
    for (const double odd : {-0.0, 0.5, 1e300, -1e-300, 8191.9999, -8192.0, 16383.9999, 16384.0, 0x1p-13})
        for (int which = 0; which < 8; ++which) {
            Pose pose;
            if (which < 3) pose.position[which] = odd;
            if (which >= 3 && which < 7) pose.rotation[std::size_t(which - 3)] = odd;
            if (which == 7) pose.scale = odd;
            const EditCommand command = cut_command(1, CraterSeed{}, pose);
            EXPECT_EQ(bits_of(unpack_command(bytes_of(command), "test").value().pose), bits_of(pose)) << odd << which;
        }
}

TEST(CommandBytes, QuantisedPosesLieNearAndStay) {
    scenes::Rng rng(2);
    for (int k = 0; k < 2000; ++k) {
        Pose pose = any_pose(rng);
        pose.rotation = random_turn(rng.next());
        const Pose made = quantised(pose);
        EXPECT_EQ(bits_of(quantised(made)), bits_of(made));
        EXPECT_LE(max_abs(made.position - pose.position), 1.0 / 8192);
        EXPECT_LE(std::fabs(made.scale - pose.scale), 1.0 / 8192);
        // The angle between the two turns, by the length of the difference.
        double square = 0, size = 0;
        for (const double part : made.rotation) size += part * part;
        for (std::size_t q = 0; q < 4; ++q) {
            const double apart = made.rotation[q] / std::sqrt(size) - pose.rotation[q];
            square += apart * apart;
        }
        EXPECT_LE(2 * std::sqrt(square), 1.0 / 16000);
        EXPECT_LE(bytes_of(cut_command(1, ring_cutter(), made)).size(),
                  bytes_of(cut_command(1, ring_cutter(), pose)).size());
    }
    Pose stays;
    stays.position = {INFINITY, 1, 1e9};
    stays.rotation = {0, 0, 0, 0};
    stays.scale = 1e-9;
    EXPECT_EQ(bits_of(quantised(stays)), bits_of(stays));
    stays.rotation = {NAN, 0, 0, 0};
    EXPECT_TRUE(std::isnan(quantised(stays).rotation[0]));
}

TEST(CommandBytes, ACraterTakesFew) {
    scenes::Rng rng(3);
    std::size_t longest = 0;
    for (int k = 0; k < 2000; ++k) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(-8000, 8000);
        const EditCommand command = crater_command(kMaxEditNumber, {CutterShape::kRocky, rng.next()}, at,
                                                   rng.uniform(0.1, 6), {"concrete", at + Vec3{0.1, 2, 0.3}});
        EXPECT_EQ(bits_of(command.pose), bits_of(quantised(command).pose));
        EXPECT_EQ(command.pose.rotation, random_turn(std::get<CraterSeed>(command.cutter).seed));
        longest = std::max(longest, bytes_of(command).size());
    }
    EXPECT_EQ(longest,
              1u + 1 + 3 + 1 + 8 + 12 + 3 + 2 + 8 + 2 + 12);  // version, head, number, form, seed, place, scale,
                                                              // material, where the shot came from
    EXPECT_LT(longest, 64u);
}

TEST(CommandBytes, EveryKindComesBack) {
    World world = two_halls(), again = world;
    for (const EditCommand& command : all_kinds()) {
        const std::vector<std::byte> bytes = bytes_of(command);
        const Result<EditCommand> read = unpack_command(bytes, "test");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(bytes_of(read.value()), bytes);
        const CommandResult one = apply(world, command), two = apply(again, read.value());
        EXPECT_EQ(one.status, two.status);
        EXPECT_EQ(one.error.text(), two.error.text());
        EXPECT_EQ(hash_world(one.world), hash_world(two.world));
        world = one.world;
        again = two.world;
    }
}

TEST(CommandBytes, WhatCannotBeIsRefused) {
    const auto reason = [](const EditCommand& command) {
        const auto packed = pack_command(command);
        return packed ? std::string() : packed.error().text();
    };
    const EditCommand sound = cut_command(2, CraterSeed{}, Pose());
    EXPECT_EQ(reason(sound), "");
    EXPECT_EQ(reason(cut_command(0, CraterSeed{}, Pose())), "edit 0 does not come after edit 0");
    EXPECT_EQ(reason(cut_command(kMaxEditNumber + 1, CraterSeed{}, Pose())),
              "an edit cannot have the number 2097152; the last one is 2097151");
    EXPECT_EQ(reason(cut_command(1, Cutter(), Pose())), "an empty cutter");
    EXPECT_EQ(reason(cut_command(1, CraterSeed{CutterShape(5), 0}, Pose())), "a shape that is none");
    EXPECT_EQ(reason(cut_command(1, CraterSeed{}, test::pose_at(NAN, 0, 0))), "the pose is not finite");
    EXPECT_EQ(reason(cut_command(1, CraterSeed{}, test::pose_at(0, 0, 0, INFINITY))), "the pose is not finite");
    const auto with_chunks = [&](double min_volume, double density) {
        EditCommand command = sound;
        command.options.chunks = ChunkOptions{.min_volume = min_volume, .density = density};
        return command;
    };
    EXPECT_EQ(reason(with_chunks(0, 1e-9)), "");
    EXPECT_EQ(reason(with_chunks(NAN, 1)), "the options of chunks are not finite");
    EXPECT_EQ(reason(with_chunks(1, INFINITY)), "the options of chunks are not finite");
    EXPECT_EQ(reason(with_chunks(-1, 1)), "chunks of less than no volume or density");
    EXPECT_EQ(reason(with_chunks(-0.0, 1)), "chunks of less than no volume or density");
    EXPECT_EQ(reason(with_chunks(1, -0.0)), "chunks of less than no volume or density");
    EXPECT_EQ(reason(group_command({with_chunks(1, -2)})), "part 0: chunks of less than no volume or density");
    EXPECT_EQ(reason(group_command({})), "a group without parts");
    EXPECT_EQ(reason(group_command({sound, sound})), "part 1: edit 2 does not come after edit 2");
    EXPECT_EQ(reason(group_command({group_command({sound})})), "part 0: edit 0 does not come after edit 0");
    EXPECT_EQ(reason(door_command(1, PortalId().value, true)), "a door of no portal");
}

/// The field of chunks is the last of these bytes: a key, a length, and two numbers unless they are the usual ones.
TEST(CommandBytes, HostileOptionsOfChunksAreRefused) {
    EditCommand command = cut_command(1, CraterSeed{}, Pose());
    const std::size_t bare = bytes_of(command).size();
    command.options.chunks = ChunkOptions{};
    EXPECT_EQ(bytes_of(command).size(), bare + 2);
    command.options.chunks = ChunkOptions{.min_volume = 0.25, .density = 1000};
    const std::vector<std::byte> sound = bytes_of(command);
    ASSERT_EQ(sound.size(), bare + 18);
    ASSERT_TRUE(unpack_command(sound, "test"));
    const auto reason = [&](double min_volume, double density, unsigned key = 7, std::size_t length = 16) {
        ByteWriter out;
        for (std::size_t k = 0; k < bare; ++k) out.u8(std::uint8_t(sound[k]));
        out.u8(std::uint8_t(key));
        out.u8(std::uint8_t(length));
        out.f64(min_volume);
        out.f64(density);
        std::vector<std::byte> bytes = out.bytes();
        bytes.resize(bare + 2 + length);
        const auto read = unpack_command(bytes, "t");
        return read ? std::string() : read.error().reason;
    };
    EXPECT_EQ(reason(0.25, 1000), "");
    EXPECT_EQ(reason(NAN, 1000), "a number is not finite");
    EXPECT_EQ(reason(0.25, INFINITY), "a number is not finite");
    EXPECT_EQ(reason(-0.25, 1000), "chunks of less than no volume or density");
    EXPECT_EQ(reason(-0.0, 1000), "chunks of less than no volume or density");
    EXPECT_EQ(reason(0.25, -1000), "chunks of less than no volume or density");
    EXPECT_EQ(reason(0.25, -0.0), "chunks of less than no volume or density");
    EXPECT_EQ(reason(ChunkOptions().min_volume, ChunkOptions().density), "an option that is what it is by default");
    EXPECT_EQ(reason(0.25, 1000, 7, 8), "options of chunks that are not 16 bytes long");
    EXPECT_EQ(reason(0.25, 1000, 7, 17), "options of chunks that are not 16 bytes long");
    EXPECT_EQ(reason(0.25, 1000, 6), "an option that is needed does not say so");
}

TEST(CommandBytes, EveryTruncationAndFlippedByte) {
    std::vector<EditCommand> commands = all_kinds();
    std::size_t read_back = 0;
    for (const EditCommand& command : commands) {
        std::vector<std::byte> bytes = bytes_of(command);
        const std::size_t step = bytes.size() > 500 ? 37 : 1;
        for (std::size_t length = 0; length < bytes.size(); length += step) {
            const Result<EditCommand> read = unpack_command(std::span(bytes).first(length), "test");
            // A command whose options are cut away whole is another command.
            if (read) {
                EXPECT_FALSE(read.value().options.material == command.options.material &&
                             same_chunks(read.value().options, command.options))
                    << length;
            }
            if (!read) {
                EXPECT_EQ(read.error().place.rfind("test: byte ", 0), 0u) << read.error().text();
            }
        }
        for (std::size_t k = 0; k < bytes.size(); k += step)
            for (const unsigned flip : {1u, 2u, 0x10u, 0x80u, 0xFFu}) {
                bytes[k] ^= std::byte(flip);
                const Result<EditCommand> read = unpack_command(bytes, "test");
                if (read) {
                    // A grid's pose that is stored whole comes back shorter.
                    const std::vector<std::byte> packed = bytes_of(read.value());
                    EXPECT_LE(packed.size(), bytes.size());
                    EXPECT_TRUE(bytes_of(unpack_command(packed, "test").value()) == packed) << "byte " << k;
                    ++read_back;
                }
                bytes[k] ^= std::byte(flip);
            }
    }
    EXPECT_GT(read_back, 100u) << "seeds and places may be any";
}

TEST(CommandBytes, GroupsInGroupsDoNotPileUp) {
    std::vector<std::byte> bytes{std::byte(1)};
    // Each: a group of one part, whose length is said to be all that follows.
    for (int k = 0; k < 100'000; ++k)
        for (const unsigned byte : {3u, 1u, 127u}) bytes.push_back(std::byte(byte));
    const Result<EditCommand> read = unpack_command(bytes, "test");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().text(), "test: byte 5: a group in a group");
}

}  // namespace
}  // namespace firma
