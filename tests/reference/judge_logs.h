// SPDX-License-Identifier: MIT
// Judges edit logs of random commands: repaired after losses, replayed in slices and on threads, in another order where
// edits are disjoint, with all checks after each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/edit_log.h"
#include "scenes/rng.h"

namespace firma::reference {

struct LogTally {
    std::uint64_t commands = 0, done = 0, refused = 0, nothing = 0;
    std::uint64_t logs = 0, failed = 0;
    std::uint64_t lost = 0, repairs = 0, whole_lists = 0, bytes = 0, lies = 0, lies_refused = 0;
    std::uint64_t replays = 0, checkpoints = 0, log_bytes = 0;
    std::uint64_t orders = 0, rooms_made = 0, portals_made = 0;
    std::vector<std::string> failures;

    void add(const LogTally& other);
    void fail(const std::string& where, const std::string& what);
};

/// Craters by their seeds, other cutters as meshes, fills, doors, groups, commands that do nothing, some with loose
/// pieces that leave; poses on the grid and off it; numbers with gaps.
std::vector<EditCommand> random_commands(const World& world, std::size_t count, scenes::Rng& rng);
/// Craters so far apart that no cutter meets another's box.
std::vector<EditCommand> disjoint_commands(const World& world, std::size_t count, scenes::Rng& rng);

/// One peer loses a hundredth of the commands, at least one, and is repaired by regions: the worlds are equal then, and
/// go on alike. Patches made for lists that lie give the same world or none.
LogTally judge_repair(const World& level, const std::string& where, scenes::Rng& rng, std::size_t count);
/// The log as bytes and back, replayed in several slices by one, two and four threads at a time, and compacted.
LogTally judge_replay(const World& level, const std::string& where, scenes::Rng& rng, std::size_t count);
/// Disjoint edits in several orders: one hash_solid().
LogTally judge_disjoint(const World& level, const std::string& where, scenes::Rng& rng, std::size_t count);
/// check_world() and check_solid() after each command.
LogTally judge_sequence(const World& level, const std::string& where, scenes::Rng& rng, std::size_t count);

}  // namespace firma::reference
