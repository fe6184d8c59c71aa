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

void History::push(World world, const BytesApart& apart) {
    FIRMA_ASSERT(!can_redo(), "a new version follows the newest; take out those that were undone");
    entries_.push_back({std::move(world), apart});
    most_ += entries_.back().most();
    gone_before_ += apart.gone;
    ++at_;
}

void History::undo() {
    const BytesApart& apart = entries_[at_--].apart;
    gone_before_ -= apart.gone;
    come_after_ += apart.come;
}

void History::redo() {
    const BytesApart& apart = entries_[++at_].apart;
    gone_before_ += apart.gone;
    come_after_ -= apart.come;
}

World History::take_oldest() {
    FIRMA_ASSERT(can_undo(), "the current version stays");
    World oldest = std::move(entries_.front().world);
    entries_.pop_front();
    --at_;
    Entry& first = entries_.front();
    gone_before_ -= first.apart.gone;
    most_ -= first.most();
    first.apart = {};
    return oldest;
}

World History::take_newest() {
    FIRMA_ASSERT(can_redo(), "the current version stays");
    Entry& last = entries_.back();
    come_after_ -= last.apart.come;
    most_ -= last.most();
    World newest = std::move(last.world);
    entries_.pop_back();
    return newest;
}

}  // namespace firma
