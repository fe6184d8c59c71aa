// SPDX-License-Identifier: MIT
// A patch in place of a log's beginning.
#include <utility>

#include "firma/edit_log.h"
#include "firma/world_patch.h"

namespace firma {
namespace {

/// The patch from one world to another, tried. Where only the rooms of some faces differ, no hash of a region says so:
/// then all faces are compared.
Result<std::vector<std::byte>> tried_patch(const World& from, const World& to) {
    std::vector<std::byte> patch = make_patch(from, to);
    if (apply_patch(from, patch, "patch")) return patch;
    std::vector<RegionHash> all = hash_regions(from);
    const std::vector<RegionHash> more = hash_regions(to);
    all.insert(all.end(), more.begin(), more.end());
    std::vector<Region> regions;
    for (const RegionHash& region : all) regions.push_back(region.region);
    Result<std::vector<std::byte>> whole = make_patch(to, list_faces(from, regions), "list");
    if (!whole) return whole;
    const Result<World> made = apply_patch(from, whole.value(), "patch");
    if (!made) return made.error();
    return whole;
}

}  // namespace

Result<EditLog> compacted(const World& level, const EditLog& log, std::uint32_t number) {
    ReplayOptions options;
    options.last_number = number;
    const ReplayResult begun = replay(level, log, options);
    if (!begun.ok()) return *begun.error;
    Result<std::vector<std::byte>> patch = tried_patch(level, begun.world);
    if (!patch) return patch.error();
    EditLog made(level);
    made.patch_ = std::move(patch).value();
    made.patched_number_ = made.last_number_ =
        begun.commands > 0 ? firma::last_number(log.commands_[begun.commands - 1]) : log.patched_number_;
    if (made.patched_number_ == 0) made.patched_number_ = made.last_number_ = made.level_edits_;
    made.commands_.assign(log.commands_.begin() + std::ptrdiff_t(begun.commands), log.commands_.end());
    if (!made.commands_.empty()) made.last_number_ = log.last_number_;
    for (const LogCheckpoint& checkpoint : log.checkpoints_)
        if (checkpoint.commands >= begun.commands)
            made.checkpoints_.push_back({checkpoint.commands - begun.commands, checkpoint.hash});
    return made;
}

}  // namespace firma
