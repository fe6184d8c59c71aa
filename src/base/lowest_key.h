// SPDX-License-Identifier: MIT
// Finds the lowest of many numbers that change one at a time: a row of blocks with the lowest of each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace firma {

/// For tens of numbers faster than a heap, as nothing moves and few branches are hard to foretell; a change costs a
/// block, a search a block and n / 16. Keeps its memory.
class LowestKey {
public:
    /// No number there: never the lowest.
    static constexpr double kNone = std::numeric_limits<double>::infinity();

    void reset(std::size_t count) {
        const std::size_t blocks = (count + kBlock - 1) / kBlock;
        keys_.assign(blocks * kBlock, kNone);
        lowest_.assign(blocks, kNone);
    }

    void set(std::uint32_t index, double key) {
        const std::size_t block = index / kBlock;
        const double old = keys_[index];
        keys_[index] = key;
        if (key <= lowest_[block])
            lowest_[block] = key;
        else if (old == lowest_[block])
            lowest_[block] = lowest_in(block);
    }

    /// The lowest number's index; of equals the first. UINT32_MAX when there is none.
    std::uint32_t find() const {
        double best = kNone;
        std::size_t block = 0;
        for (std::size_t k = 0; k < lowest_.size(); ++k)
            if (lowest_[k] < best) {
                best = lowest_[k];
                block = k;
            }
        if (best == kNone) return UINT32_MAX;
        std::size_t index = block * kBlock;
        while (keys_[index] != best) ++index;
        return std::uint32_t(index);
    }

private:
    static constexpr std::size_t kBlock = 16;

    /// Four at once, so that no comparison waits for the one before.
    double lowest_in(std::size_t block) const {
        const double* key = &keys_[block * kBlock];
        std::array<double, 4> low{key[0], key[1], key[2], key[3]};
        for (std::size_t k = 4; k < kBlock; k += 4)
            for (std::size_t i = 0; i < 4; ++i) low[i] = key[k + i] < low[i] ? key[k + i] : low[i];
        const double a = low[0] < low[1] ? low[0] : low[1], b = low[2] < low[3] ? low[2] : low[3];
        return a < b ? a : b;
    }

    std::vector<double> keys_;
    std::vector<double> lowest_;  ///< per block
};

}  // namespace firma
