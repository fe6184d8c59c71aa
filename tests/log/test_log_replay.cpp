// SPDX-License-Identifier: MIT
// A log of the depot gives one world: in any slices, handed from thread to thread, on several threads at a time, with
// files between its commands; and edits that lie apart give one solid in any order.
#include <gtest/gtest.h>

#include <condition_variable>
#include <future>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "firma/brush_world.h"
#include "firma/matter.h"
#include "scenes/rng.h"
#include "tests/log/logged_edits.h"

namespace firma {
namespace {

/// Its bridge hangs between two walls. Made once: tests share it, from all threads.
const World& anchored_depot() {
    static const World world = with_anchors(read_world(FIRMA_ROOT "/levels/depot.map").value());
    return world;
}

/// Commands of all kinds, pieces that come loose, and what craters show of the matter behind.
std::vector<EditCommand> depot_commands() {
    std::vector<EditCommand> commands;
    scenes::Rng rng(16);
    std::uint32_t number = 0;
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = 0.001, .density = 2400};
    const auto crater = [&](CutterShape shape, const Vec3& at, double radius) {
        ++number;
        return crater_command(number, {shape, mix_bits(number)}, at, radius, options);
    };
    const auto mesh = [&](const Cutter& cutter, const Pose& pose, EditKind kind = EditKind::kCarve) {
        EditCommand command = cut_command(++number, cutter, pose, "", kind);
        command.options.chunks = options.chunks;
        return command;
    };
    // The bridge at both ends, and what is left of it; the thin wall between two offices.
    commands.push_back(crater_command(++number, {CutterShape::kRocky, 3}, {14, 2, 3.75}, 2.2, options));
    commands.push_back(crater_command(++number, {CutterShape::kRocky, 3}, {14, 12, 3.75}, 2.2, options));
    commands.push_back(crater(CutterShape::kSpiky, {6.28125, 18, 1.5}, 0.5));
    commands.push_back(door_command(++number, 0, false));
    // The hall's walls, floor and crates, one crater into the other, some of them of their own material.
    for (int k = 0; k < 12; ++k) {
        const double side = k % 2 == 0 ? 0 : 14;
        const Vec3 at{2 + 22 * rng.uniform(), side + rng.uniform(-0.3, 0.3), rng.uniform(0, 4)};
        commands.push_back(crater(CutterShape(k % 5), at, rng.uniform(0.5, 1.4)));
        if (k % 4 == 1) commands.back().options.material = "soot";
    }
    commands.push_back(mesh(ring_cutter(), test::pose_at(8, 14, 3, 0.3)));
    commands.push_back(mesh(solid_cutter(), test::pose_at(18, -0.5, 2, 0.5)));
    commands.push_back(mesh(ring_cutter(), test::pose_at(8, 14.25, 3, 0.25), EditKind::kFill));
    commands.push_back(door_command(++number, 0, true));
    // A pillar in the hall, and a piece out of its middle; a door filled wholly, and opened again by a crater.
    const Cutter pillar = test::box_mesh({-0.4, -0.4, -2}, {0.4, 0.4, 2}).cutter().value();
    commands.push_back(mesh(pillar, test::pose_at(5, 11, 1.5), EditKind::kFill));
    commands.push_back(crater(CutterShape::kBox, {5, 11, 2.75}, 0.5));
    const Cutter plug = test::box_mesh({-1, -2, -2}, {1, 2, 2}).cutter().value();
    commands.push_back(mesh(plug, test::pose_at(26.5, 3.5, 1.75), EditKind::kFill));
    commands.push_back(crater(CutterShape::kRocky, {26.5, 3.5, 1.5}, 1.6));
    // Glass, rock in the cave, air, what is refused, and three as one.
    commands.push_back(crater(CutterShape::kRocky, {8.4, 14.6, 1.7}, 0.8));
    commands.push_back(crater(CutterShape::kRocky, {8, -20, -5}, 1.5));
    commands.push_back(crater(CutterShape::kRocky, {14, 7, 1.5}, 0.3));
    commands.push_back(door_command(++number, 999, true));
    const EditCommand first = crater(CutterShape::kRocky, {14, 7, -0.2}, 1.2);
    const EditCommand second = door_command(++number, 2, false);
    const EditCommand third = crater(CutterShape::kRocky, {14.8, 7, -0.4}, 1);
    commands.push_back(group_command({first, second, third}));
    return commands;
}

/// The world after them in one go, and its hash after each.
struct Straight {
    World world;
    std::vector<std::uint64_t> hashes;
};
const Straight& straight() {
    static const Straight all = [] {
        Straight made{anchored_depot(), {}};
        for (const EditCommand& command : depot_commands()) {
            made.world = apply(made.world, command).world;
            made.hashes.push_back(hash_world(made.world));
        }
        return made;
    }();
    return all;
}

TEST(LogReplay, TheDepotsLogHoldsWhatItSays) {
    World world = anchored_depot();
    std::size_t done = 0, nothing = 0, refused = 0, chunks = 0;
    for (const EditCommand& command : depot_commands()) {
        const CommandResult result = apply(world, command);
        done += result.status == CarveStatus::kDone;
        nothing += result.status == CarveStatus::kNothing;
        refused += result.status == CarveStatus::kRefused;
        for (const CarveResult& edit : result.edits) chunks += edit.chunks.size();
        world = result.world;
    }
    EXPECT_EQ(done + 2, depot_commands().size());
    EXPECT_EQ(nothing, 1u);
    EXPECT_EQ(refused, 1u);
    EXPECT_GE(chunks, 1u);
    EXPECT_GT(portal_count(world), portal_count(anchored_depot()));
    std::set<std::string> insides;
    for (const Face& face : world.faces())
        if (face.source_edit > 0 && world.material_name(face.material).rfind("matter/", 0) == 0)
            insides.insert(world.material_name(face.material));
    EXPECT_GE(insides.size(), 2u);
    EXPECT_FALSE(check_world(world));
    EXPECT_FALSE(check_solid(world));
}

TEST(LogReplay, InAnySlices) {
    const std::vector<EditCommand> commands = depot_commands();
    for (const int way : {0, 1, 2}) {
        scenes::Rng rng(std::uint64_t(way) + 1);
        World world = anchored_depot();
        std::size_t slices = 0;
        for (std::size_t k = 0; k < commands.size(); ++k) {
            CommandJob job(world, commands[k]);
            const auto length = [&] { return way == 0 ? 0 : way == 1 ? 20 : rng.chance(0.5) ? 0 : 300; };
            do ++slices;
            while (!job.run(length()));
            world = job.result().world;
            ASSERT_EQ(hash_world(world), straight().hashes[k]) << "command " << k << ", way " << way;
        }
        EXPECT_GT(slices, commands.size());
    }
}

// A file has neither addresses nor an order of blocks in common with the world, and a new index none of its nodes.
TEST(LogReplay, WithFilesAndNewIndicesBetweenCommands) {
    const std::vector<EditCommand> commands = depot_commands();
    World world = anchored_depot();
    for (std::size_t k = 0; k < commands.size(); ++k) {
        if (k % 6 == 2) world = unpack_world(pack_world(world, {.index = k % 12 == 2}), "test").value();
        if (k % 6 == 5) world = rebuild_index(world, TreeOptions());
        world = apply(world, commands[k]).world;
        ASSERT_EQ(hash_world(world), straight().hashes[k]) << "command " << k;
    }
}

TEST(LogReplay, OnSeveralThreadsAtATime) {
    EditLog log(anchored_depot());
    for (const EditCommand& command : depot_commands()) ASSERT_FALSE(log.append(command));
    log.add_checkpoint(straight().world);
    for (const std::size_t count : {1u, 2u, 4u}) {
        std::vector<ReplayResult> results(count);
        std::vector<std::thread> threads;
        std::promise<void> start;
        const std::shared_future<void> started = start.get_future().share();
        for (std::size_t k = 0; k < count; ++k)
            threads.emplace_back([&, k] {
                started.wait();
                LogReplay job(anchored_depot(), log);
                while (!job.run(100.0 * double(k)));
                results[k] = job.result();
            });
        start.set_value();
        for (std::thread& thread : threads) thread.join();
        for (const ReplayResult& result : results) {
            ASSERT_TRUE(result.ok()) << result.error->text();
            EXPECT_EQ(result.checkpoints, 1u);
            EXPECT_EQ(hash_world(result.world), straight().hashes.back()) << count << " threads";
        }
    }
}

// One job, a slice on each thread in turn.
TEST(LogReplay, HandedFromThreadToThread) {
    const std::vector<EditCommand> commands = depot_commands();
    for (const std::size_t count : {2u, 4u}) {
        World world = anchored_depot();
        std::optional<CommandJob> job;
        std::size_t next = 0;
        bool over = false, wrong = false;
        const auto go_on = [&] {  // one thread at a time
            if (!job) job.emplace(world, commands[next]);
            if (!job->run(200)) return;
            world = job->result().world;
            job.reset();
            wrong = wrong || hash_world(world) != straight().hashes[next];
            over = ++next == commands.size();
        };
        std::size_t turn = 0;
        std::mutex mutex;
        std::condition_variable next_turn;
        std::vector<std::thread> threads;
        for (std::size_t k = 0; k < count; ++k)
            threads.emplace_back([&, k] {
                std::unique_lock lock(mutex);
                for (;;) {
                    next_turn.wait(lock, [&] { return over || turn % count == k; });
                    if (over) return;
                    go_on();
                    ++turn;
                    next_turn.notify_all();
                }
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_FALSE(wrong) << count << " threads";
        EXPECT_EQ(hash_world(world), straight().hashes.back());
        EXPECT_GE(turn, commands.size());
    }
}

TEST(LogReplay, EditsThatLieApartGiveOneSolidInAnyOrder) {
    // Two metres and more from each other: walls, floors, rock, a fill, a ring.
    std::vector<EditCommand> apart;
    const Vec3 places[] = {{2, 0, 1.5}, {7, 0, 1.5}, {12, 14, 1.5}, {20, 14, 5}, {22, 7, 0},
                           {3, 7, 0},   {30, 0, 1},  {30, 14, 1.5}, {36, 7, -1}, {8, -20, -5},
                           {2, 18, 0},  {9, 18, 0},  {16, -8, 0.0}, {4, -6, 0},  {-5, 7, -5}};
    for (const Vec3& at : places) {
        const auto k = std::uint64_t(apart.size());
        apart.push_back(crater_command(1, {CutterShape(k % 5), mix_bits(k)}, at, k % 5 == 2 ? 0.25 : 0.5));
    }
    apart[4].kind = EditKind::kFill;
    apart[6].cutter = ring_cutter();
    apart[6].pose = test::pose_at(30, 0, 1, 0.2);
    const auto in_order = [&](const std::vector<std::size_t>& order) {
        World world = anchored_depot();
        for (std::size_t k = 0; k < order.size(); ++k) {
            EditCommand command = apart[order[k]];
            command.number = std::uint32_t(k) + 1;
            const CommandResult result = apply(world, command);
            EXPECT_TRUE(result.done()) << order[k] << ": " << result.error.text();
            world = result.world;
        }
        return world;
    };
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < apart.size(); ++k) order.push_back(k);
    const World first = in_order(order);
    EXPECT_FALSE(check_solid(first));
    scenes::Rng rng(3);
    for (int shuffle = 0; shuffle < 6; ++shuffle) {
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng.below(std::uint32_t(k))]);
        const World other = in_order(order);
        EXPECT_EQ(hash_solid(other), hash_solid(first)) << shuffle;
        EXPECT_TRUE(same_solid(other.solid(), first.solid())) << shuffle;
    }
    order.pop_back();
    EXPECT_NE(hash_solid(in_order(order)), hash_solid(first)) << "one is missing";
}

}  // namespace
}  // namespace firma
