// SPDX-License-Identifier: MIT
// The versions that a store keeps, in a row, one of them the current one, and what they hold beside the newest. Knows
// no threads.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "firma/world.h"

namespace firma {

class History {
public:
    explicit History(World first) { entries_.push_back({std::move(first), 0}); }

    const World& current() const { return entries_[at_].world; }
    const World& oldest() const { return entries_.front().world; }
    const World& newest() const { return entries_.back().world; }
    std::size_t size() const { return entries_.size(); }
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < entries_.size(); }
    /// What the versions lose on the way to the newest, whichever is the current one.
    std::size_t bytes() const { return bytes_; }
    std::optional<World> find(std::uint64_t version) const;

    /// One more after the current one, which becomes the current one itself, in place of those that were undone.
    /// Without the memory for it nothing changes.
    /// @param lost    bytes that the one before holds and this does not
    /// @param undone  gets those that were undone, to be freed by the caller; has room for them
    void push(World world, std::size_t lost, std::vector<World>& undone);
    void undo() { --at_; }
    void redo() { ++at_; }
    /// Takes out one that is not the current one. To be freed by the caller.
    World take_oldest();
    World take_newest();

private:
    struct Entry {
        World world;
        std::size_t lost;  ///< on the way here from the entry before
    };

    std::deque<Entry> entries_;
    std::size_t at_ = 0;
    std::size_t bytes_ = 0;  // sum of what was lost
};

}  // namespace firma
