// SPDX-License-Identifier: MIT
// A hash map from 64 bits to 32, for scratch: open addressing, emptied in no time, its memory kept.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/table_key.h"

namespace firma {

/// Never walked in order, so results cannot depend on where entries lie.
class FlatMap {
public:
    static constexpr std::uint32_t kNone = ~0u;

    void clear() {
        if (++round_ == 0) {  // marks of rounds long gone would count again
            for (Entry& entry : entries_) entry.round = 0;
            round_ = 1;
        }
        count_ = 0;
    }

    /// The value of a key; kNone when there is none.
    std::uint32_t find(std::uint64_t key) const {
        if (entries_.empty()) return kNone;
        for (std::size_t at = place(key);; at = (at + 1) & (entries_.size() - 1)) {
            const Entry& entry = entries_[at];
            if (entry.round != round_) return kNone;
            if (entry.key == key) return entry.value;
        }
    }

    /// The place for the value of a key: holds kNone when the key is new. Good until the next call.
    std::uint32_t& at(std::uint64_t key) {
        if (2 * (count_ + 1) > entries_.size()) grow();
        std::size_t at = place(key);
        for (; entries_[at].round == round_; at = (at + 1) & (entries_.size() - 1))
            if (entries_[at].key == key) return entries_[at].value;
        entries_[at] = {key, kNone, round_};
        ++count_;
        return entries_[at].value;
    }

    std::size_t size() const { return count_; }

    /// How far the farthest entry lies from its place: what the slowest call looks at. For tests; looks at all.
    std::size_t longest_search() const {
        std::size_t longest = 0;
        for (std::size_t at = 0; at < entries_.size(); ++at)
            if (entries_[at].round == round_)
                longest = std::max(longest, (at - place(entries_[at].key)) & (entries_.size() - 1));
        return longest;
    }

    /// Makes room for as many entries, before the first.
    void reserve(std::size_t count) {
        const std::size_t places = std::bit_ceil(2 * (count + 1));
        if (count_ == 0 && places > entries_.size()) entries_.assign(places, Entry{});
    }

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t value = kNone;
        std::uint32_t round = 0;
    };

    std::size_t place(std::uint64_t key) const {
        return std::size_t(mix_bits(key ^ table_seed())) & (entries_.size() - 1);
    }

    void grow() {
        std::vector<Entry> old(entries_.empty() ? 64 : 2 * entries_.size());
        old.swap(entries_);
        for (const Entry& entry : old) {
            if (entry.round != round_) continue;
            std::size_t at = place(entry.key);
            while (entries_[at].round == round_) at = (at + 1) & (entries_.size() - 1);
            entries_[at] = entry;
        }
    }

    std::vector<Entry> entries_;
    std::size_t count_ = 0;
    std::uint32_t round_ = 1;
};

}  // namespace firma
