// SPDX-License-Identifier: MIT
// The versions that a store keeps.
#include "store/history.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"

namespace firma {

std::optional<World> History::find(std::uint64_t version) const {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), version,
                                     [](const Entry& entry, std::uint64_t v) { return entry.world.version() < v; });
    if (at == entries_.end() || at->world.version() != version) return {};
    return at->world;
}

void History::push(World world, std::size_t lost) {
    FIRMA_ASSERT(!can_redo(), "a new version follows the newest; take out those that were undone");
    entries_.push_back({std::move(world), lost});
    bytes_ += lost;
    ++at_;
}

World History::take_oldest() {
    FIRMA_ASSERT(can_undo(), "the current version stays");
    World oldest = std::move(entries_.front().world);
    entries_.pop_front();
    --at_;
    bytes_ -= std::exchange(entries_.front().lost, 0);
    return oldest;
}

World History::take_newest() {
    FIRMA_ASSERT(can_redo(), "the current version stays");
    World newest = std::move(entries_.back().world);
    bytes_ -= entries_.back().lost;
    entries_.pop_back();
    return newest;
}

}  // namespace firma
