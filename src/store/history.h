// SPDX-License-Identifier: MIT
// The versions that a store keeps, in a row, one of them the current one, and what they hold beside it. Knows no
// threads.
#pragma once

#include <deque>
#include <optional>

#include "store/bytes_apart.h"

namespace firma {

class History {
public:
    explicit History(World first) { entries_.push_back({std::move(first), {}}); }

    const World& current() const { return entries_[at_].world; }
    const World& oldest() const { return entries_.front().world; }
    const World& newest() const { return entries_.back().world; }
    std::size_t size() const { return entries_.size(); }
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < entries_.size(); }
    /// Bytes beside the current version: what the versions before it lose on the way to it, and what those after it
    /// gain.
    std::size_t bytes() const { return gone_before_ + come_after_; }
    /// No less than bytes(), whichever version is the current one.
    std::size_t most_bytes() const { return most_; }
    std::optional<World> find(std::uint64_t version) const;

    /// One more, which becomes the current one; nothing may stand after the one before it.
    void push(World world, const BytesApart& apart);
    void undo();
    void redo();
    /// Takes out one that is not the current one. To be freed by the caller.
    World take_oldest();
    World take_newest();

private:
    struct Entry {
        World world;
        BytesApart apart;  ///< from the entry before
        std::size_t most() const { return apart.gone > apart.come ? apart.gone : apart.come; }
    };

    std::deque<Entry> entries_;
    std::size_t at_ = 0;
    std::size_t gone_before_ = 0, come_after_ = 0, most_ = 0;  // sums over the entries up to `at_`, after it, over all
};

}  // namespace firma
