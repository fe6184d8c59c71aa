// SPDX-License-Identifier: MIT
// Things that belong together, by pairs. The lowest number of a set stands for it.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace firma {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    /// One more, a set of its own.
    std::uint32_t add() {
        parent_.push_back(std::uint32_t(parent_.size()));
        return parent_.back();
    }

    std::uint32_t find(std::uint32_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a < b) {
            parent_[b] = a;
        } else {
            parent_[a] = b;
        }
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace firma
