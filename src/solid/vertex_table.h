// SPDX-License-Identifier: MIT
// The vertices of a block under way, each position once, numbered in order of first use.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "firma/grid.h"

namespace firma {

class VertexTable {
public:
    /// Empties it and makes room for as many different vertices, at most 2^15.
    void start(std::size_t most) {
        vertices.clear();
        const std::size_t slots = std::bit_ceil(2 * most + 1);
        if (slots_.size() < slots) slots_.resize(slots);
        mask_ = slots - 1;
        std::fill(slots_.begin(), slots_.begin() + std::ptrdiff_t(slots), kFree);
    }

    std::uint16_t index_of(const GridPoint& p) {
        std::uint64_t at = hash(p);
        for (;; ++at) {
            std::uint16_t& slot = slots_[at & mask_];
            if (slot == kFree) {
                slot = std::uint16_t(vertices.size());
                vertices.push_back(p);
                return slot;
            }
            if (vertices[slot] == p) return slot;
        }
    }

    std::vector<GridPoint> vertices;

private:
    static constexpr std::uint16_t kFree = 0xFFFF;

    static std::uint64_t hash(const GridPoint& p) {
        std::uint64_t h = std::uint32_t(p.x) * 0x9E3779B97F4A7C15ull;
        h = (h ^ std::uint32_t(p.y)) * 0xBF58476D1CE4E5B9ull;
        h = (h ^ std::uint32_t(p.z)) * 0x94D049BB133111EBull;
        return h >> 40;
    }

    std::vector<std::uint16_t> slots_;
    std::uint64_t mask_ = 0;
};

}  // namespace firma
