// SPDX-License-Identifier: MIT
// Judges edit logs of random commands.
#include "tests/reference/judge_logs.h"

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "firma/chunk.h"
#include "firma/rooms.h"
#include "firma/world_patch.h"
#include "scenes/blasts.h"
#include "tests/save/changed_patches.h"

namespace firma::reference {
namespace {

using scenes::Rng;

constexpr std::array kLoggedShapes{CutterShape::kRocky, CutterShape::kRocky, CutterShape::kSpiky,
                                   CutterShape::kDrill, CutterShape::kWedge, CutterShape::kBox};
constexpr std::array<const char*, 4> kLoggedMaterials{"crater", "soot", "", "rubble"};

CarveOptions some_options(Rng& rng, const std::optional<Vec3>& from) {
    CarveOptions options{kLoggedMaterials[rng.next() % 4]};
    if (rng.next() % 2) options.from = from;
    if (rng.next() % 10 == 0) options.chunks = ChunkOptions{};
    return options;
}

EditCommand command_of(const scenes::RoomBlast& blast, std::uint32_t number, Rng& rng) {
    EditCommand command;
    command.number = number;
    command.kind = blast.cut.kind == CarveKind::kFill ? EditKind::kFill : EditKind::kCarve;
    command.pose = blast.cut.pose;
    if (rng.next() % 4 == 0)
        command.cutter = blast.cut.cutter;
    else
        command.cutter = CraterSeed{kLoggedShapes[rng.next() % kLoggedShapes.size()], rng.next()};
    command.options = some_options(rng, blast.from);
    return rng.next() % 3 == 0 ? command : quantised(std::move(command));
}

EditCommand door_of(const World& world, std::uint32_t number, Rng& rng) {
    EditCommand command;
    command.number = number;
    command.kind = EditKind::kDoor;
    command.portal = {std::uint32_t(rng.next() % (world.data().cells.portal_count() + 1))};  // the last is not there
    command.open = rng.next() % 2;
    return command;
}

void count_result(const CommandResult& result, LogTally& tally) {
    ++tally.commands;
    (result.status == CarveStatus::kDone      ? tally.done
     : result.status == CarveStatus::kRefused ? tally.refused
                                              : tally.nothing)++;
}

/// Why two worlds that ought to be one are not; empty where they are.
std::string difference(const World& one, const World& two) {
    if (hash_world(one) != hash_world(two)) return "other worlds";
    if (hash_solid(one) != hash_solid(two)) return "other solids";
    if (hash_regions(one) != hash_regions(two)) return "other regions";
    return {};
}

std::string fault_of(const World& world) {
    if (const auto fault = check_world(world)) return fault->what;
    if (const auto fault = check_solid(world)) return fault->what;
    return {};
}

/// The command after which a world is no longer sound, for messages.
std::string first_fault(const World& level, const std::vector<EditCommand>& commands) {
    World world = level;
    for (std::size_t k = 0; k < commands.size(); ++k) {
        world = apply(world, commands[k]).world;
        if (const std::string fault = fault_of(world); !fault.empty())
            return "command " + std::to_string(k) + ": " + fault;
    }
    return {};
}

std::vector<Region> all_regions(const World& one, const World& two) {
    std::vector<Region> all = differing_regions(hash_regions(one), {});
    const std::vector<Region> more = differing_regions(hash_regions(two), {});
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// By regions that differ; where these say nothing, as only rooms of faces differ, by all.
std::optional<Error> repair(World& broken, const World& sound, LogTally& tally) {
    std::optional<Error> error;
    for (const bool whole : {false, true}) {
        const std::vector<RegionHash> heard = hash_regions(sound);
        const auto regions = whole ? all_regions(broken, sound) : differing_regions(hash_regions(broken), heard);
        const std::vector<std::byte> list = list_faces(broken, regions);
        const auto patch = make_patch(sound, list, "list");
        if (!patch) return patch.error();
        tally.bytes += 28 * heard.size() + list.size() + patch.value().size();
        tally.whole_lists += whole;
        const Result<World> made = apply_patch(broken, patch.value(), "patch");
        if (made) {
            broken = made.value();
            return {};
        }
        error = made.error();
    }
    return error;
}

ReplayResult replayed(const World& level, const EditLog& log, double slice) {
    LogReplay job(level, log);
    while (!job.run(slice)) {
    }
    return job.result();
}

}  // namespace

void LogTally::add(const LogTally& other) {
    for (const auto field :
         {&LogTally::commands, &LogTally::done, &LogTally::refused, &LogTally::nothing, &LogTally::logs,
          &LogTally::failed, &LogTally::lost, &LogTally::repairs, &LogTally::whole_lists, &LogTally::bytes,
          &LogTally::lies, &LogTally::lies_refused, &LogTally::replays, &LogTally::checkpoints, &LogTally::log_bytes,
          &LogTally::orders, &LogTally::rooms_made, &LogTally::portals_made})
        this->*field += other.*field;
    failures.insert(failures.end(), other.failures.begin(), other.failures.end());
}

void LogTally::fail(const std::string& where, const std::string& what) {
    ++failed;
    failures.push_back(where + ": " + what);
}

std::vector<EditCommand> random_commands(const World& world, std::size_t count, Rng& rng) {
    const auto blasts = scenes::room_blasts(scenes::blast_places(world), count, rng);
    std::vector<EditCommand> commands;
    std::uint32_t number = world.solid().edits();
    for (std::size_t k = 0; k < blasts.size(); ++k) {
        number += 1 + (rng.next() % 8 == 0);
        const std::uint64_t kind = rng.next() % 16;
        if (kind == 0) {
            commands.push_back(door_of(world, number, rng));
        } else if (kind == 1) {
            EditCommand group;
            group.kind = EditKind::kGroup;
            group.parts = {command_of(blasts[k], number, rng), door_of(world, number + 1, rng),
                           command_of(blasts[rng.next() % blasts.size()], number + 2, rng)};
            number += 2;
            commands.push_back(std::move(group));
        } else {
            commands.push_back(command_of(blasts[k], number, rng));
        }
    }
    return commands;
}

std::vector<EditCommand> disjoint_commands(const World& world, std::size_t count, Rng& rng) {
    std::vector<EditCommand> commands;
    std::vector<Box> taken;
    const auto apart = [](const Box& a, const Box& b) {
        constexpr double kGap = 1.0 / 1024;
        for (int axis = 0; axis < 3; ++axis)
            if (a.high[axis] + kGap < b.low[axis] || b.high[axis] + kGap < a.low[axis]) return true;
        return false;
    };
    for (int tries = 0; tries < 20 && commands.size() < count; ++tries)
        for (const scenes::RoomBlast& blast : scenes::room_blasts(scenes::blast_places(world), count, rng)) {
            if (commands.size() == count) break;
            EditCommand command = command_of(blast, 0, rng);
            command.options.chunks.reset();  // what comes loose may be held by what another edit takes
            command.options.from.reset();
            command.kind = blast.cut.kind == CarveKind::kFill ? EditKind::kFill : EditKind::kCarve;
            Cutter cutter;
            if (const auto* crater = std::get_if<CraterSeed>(&command.cutter))
                cutter = make_crater(crater->shape, crater->seed);
            else
                cutter = std::get<Cutter>(command.cutter);
            // Around it however it is turned.
            double reach = 0;
            for (const Vec3& vertex : cutter.vertices()) reach = std::max(reach, length(vertex));
            reach *= command.pose.scale;
            const Vec3 size{reach, reach, reach};
            const Box box{command.pose.position - size, command.pose.position + size};
            if (!std::all_of(taken.begin(), taken.end(), [&](const Box& other) { return apart(box, other); })) continue;
            taken.push_back(box);
            commands.push_back(std::move(command));
        }
    return commands;
}

LogTally judge_repair(const World& level, const std::string& where, Rng& rng, std::size_t count) {
    LogTally tally;
    tally.logs = 1;
    const std::vector<EditCommand> commands = random_commands(level, count, rng);
    std::vector<bool> lost(commands.size());
    for (std::size_t k = 0; k < std::max<std::size_t>(commands.size() / 100, 1); ++k)
        lost[rng.next() % commands.size()] = true;
    World all = level, some = level;
    for (std::size_t k = 0; k < commands.size(); ++k) {
        const CommandResult result = apply(all, commands[k]);
        count_result(result, tally);
        tally.rooms_made += result.world.room_count() - all.room_count();
        tally.portals_made += result.world.data().cells.portal_count() - all.data().cells.portal_count();
        all = result.world;
        if (lost[k])
            ++tally.lost;
        else
            some = apply(some, commands[k]).world;
    }
    if (!fault_of(all).empty()) {
        tally.fail(where, first_fault(level, commands));
        return tally;
    }
    if (hash_world(some) == hash_world(all)) return tally;  // what was lost had done nothing
    for (std::size_t k = 0; k < 4; ++k) {
        const auto patch = make_patch(all, lying_list(some, all, rng, 1 + k), "list");
        if (!patch) continue;
        const Result<World> made = apply_patch(some, patch.value(), "patch");
        ++tally.lies;
        tally.lies_refused += !made;
        if (made && hash_world(made.value()) != hash_world(all))
            tally.fail(where, "a list that lies made another world");
        if (made)
            if (const std::string fault = fault_of(made.value()); !fault.empty()) tally.fail(where, "lie: " + fault);
    }
    ++tally.repairs;
    if (const auto error = repair(some, all, tally)) {
        tally.fail(where, "repair: " + error->text());
        return tally;
    }
    if (const std::string text = difference(some, all); !text.empty()) tally.fail(where, "repair: " + text);
    if (!firma::same_solid(some, all)) tally.fail(where, "repair: not the same solid");
    if (const std::string fault = fault_of(some); !fault.empty()) tally.fail(where, "repair: " + fault);
    std::uint32_t number = last_number(commands.back());
    for (EditCommand command : random_commands(level, 4, rng)) {
        if (command.kind == EditKind::kGroup) continue;
        command.number = ++number;
        all = apply(all, command).world;
        some = apply(some, command).world;
        if (const std::string text = difference(some, all); !text.empty()) tally.fail(where, "after a repair: " + text);
    }
    return tally;
}

LogTally judge_replay(const World& level, const std::string& where, Rng& rng, std::size_t count) {
    LogTally tally;
    tally.logs = 1;
    EditLog log(level);
    World world = level;
    for (EditCommand& command : random_commands(level, count, rng)) {
        const CommandResult result = apply(world, command);
        count_result(result, tally);
        world = result.world;
        if (const auto error = log.append(std::move(command))) tally.fail(where, error->text());
        if (rng.next() % 10 == 0) log.add_checkpoint(world);
    }
    log.add_checkpoint(world);
    const std::vector<std::byte> bytes = pack_log(log);
    tally.log_bytes += bytes.size();
    const Result<EditLog> read = unpack_log(bytes, "log");
    if (!read) {
        tally.fail(where, read.error().text());
        return tally;
    }
    const auto judge = [&](const ReplayResult& result, const std::string& how) {
        ++tally.replays;
        tally.checkpoints += result.checkpoints;
        if (!result.ok()) return tally.fail(where, how + ": " + result.error->text());
        if (const std::string text = difference(result.world, world); !text.empty())
            tally.fail(where, how + ": " + text);
    };
    constexpr std::array kSlices{1e9, 0.0, 100.0, 5000.0};
    for (const std::size_t threads : {1, 2, 4}) {
        std::vector<ReplayResult> results(threads);
        std::vector<std::thread> running;
        for (std::size_t k = 0; k < threads; ++k)
            running.emplace_back(
                [&, k] { results[k] = replayed(level, read.value(), kSlices[(k + threads) % kSlices.size()]); });
        for (std::thread& thread : running) thread.join();
        for (const ReplayResult& result : results) judge(result, std::to_string(threads) + " threads");
    }
    const auto& commands = log.commands();
    const std::uint32_t until = last_number(commands[rng.next() % commands.size()]);
    const Result<EditLog> short_log = compacted(level, read.value(), until);
    if (!short_log)
        tally.fail(where, "compacted: " + short_log.error().text());
    else
        judge(replayed(level, short_log.value(), 1e9), "compacted");
    return tally;
}

LogTally judge_disjoint(const World& level, const std::string& where, Rng& rng, std::size_t count) {
    LogTally tally;
    tally.logs = 1;
    std::vector<EditCommand> commands = disjoint_commands(level, count, rng);
    World first = level;
    for (std::size_t order = 0; order < 4; ++order) {
        World world = level;
        std::uint32_t number = level.solid().edits();
        for (EditCommand command : commands) {
            command.number = ++number;
            const CommandResult result = apply(world, command);
            if (order == 0) count_result(result, tally);
            world = result.world;
        }
        ++tally.orders;
        if (order == 0) first = world;
        if (hash_solid(world) != hash_solid(first) || !firma::same_solid(world, first))
            tally.fail(where, "another solid in order " + std::to_string(order));
        for (std::size_t k = commands.size(); k > 1; --k) std::swap(commands[k - 1], commands[rng.next() % k]);
    }
    return tally;
}

LogTally judge_sequence(const World& level, const std::string& where, Rng& rng, std::size_t count) {
    LogTally tally;
    tally.logs = 1;
    World world = level;
    for (const EditCommand& command : random_commands(level, count, rng)) {
        const CommandResult result = apply(world, command);
        count_result(result, tally);
        if (!result.done() && hash_world(result.world) != hash_world(world))
            tally.fail(where, "an edit that did nothing made another world");
        tally.rooms_made += result.world.room_count() - world.room_count();
        tally.portals_made += result.world.data().cells.portal_count() - world.data().cells.portal_count();
        world = result.world;
        if (const std::string fault = fault_of(world); !fault.empty()) {
            tally.fail(where, "command " + std::to_string(last_number(command)) + ": " + fault);
            return tally;
        }
    }
    return tally;
}

}  // namespace firma::reference
