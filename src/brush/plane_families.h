// SPDX-License-Identifier: MIT
// Finds planes that were meant to be one: the same but for rounding, seen from either side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "brush/winding.h"

namespace firma {

class PlaneFamilies {
public:
    struct Match {
        std::uint32_t family = 0;
        bool flipped = false;  ///< seen from the other side than the family's plane
    };

    /// The first family whose plane is nearly parallel and near to all these corners.
    std::optional<Match> find(const FloatPlane& plane, std::span<const Vec3> corners) const;

    /// A new family; they are numbered in order.
    std::uint32_t add(const FloatPlane& plane);

    const FloatPlane& plane(std::uint32_t family) const { return planes_[family]; }
    std::size_t size() const { return planes_.size(); }

private:
    using Cell = std::array<std::int64_t, 4>;
    struct Hash {
        std::size_t operator()(const Cell& cell) const;
    };

    void search(const Cell& cell, const FloatPlane& plane, std::span<const Vec3> corners, bool flipped,
                std::optional<Match>& best) const;

    std::vector<FloatPlane> planes_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

}  // namespace firma
