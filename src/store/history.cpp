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

void History::push(World world, std::size_t lost, std::vector<World>& undone) {
    FIRMA_ASSERT(undone.capacity() - undone.size() >= size() - at_ - 1, "there is room for what was undone");
    while (at_ + 2 < entries_.size()) undone.push_back(take_newest());
    if (can_redo()) {  // the place of the first that was undone is taken over, as there may be no memory for another
        Entry& next = entries_.back();
        bytes_ -= next.lost;
        std::swap(next.world, world);
        next.lost = lost;
        undone.push_back(std::move(world));
    } else {
        entries_.push_back({std::move(world), lost});
    }
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
