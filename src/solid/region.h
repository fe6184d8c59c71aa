// SPDX-License-Identifier: MIT
// Regions: the cubes of 32 m that hashes are kept by, and sums kept by such numbers.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "base/persistent_map.h"
#include "firma/grid.h"
#include "firma/solid.h"

namespace firma {

inline constexpr int kRegionBits = 23;  ///< surface steps a region, as a power of two: 32 m
inline constexpr int kRegionAxisBits = 9;
static_assert((1 << kRegionBits) == int(32 * kSurfaceSteps));

/// The number of the region that a point lies in: the bits of its three coordinates in turn, so that numbers of regions
/// side by side are near each other too.
inline std::uint32_t region_of(const GridPoint& point) {
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = std::uint32_t((point[axis] >> kRegionBits) + (1 << (kRegionAxisBits - 1)));
        for (int bit = 0; bit < kRegionAxisBits; ++bit) key |= (at >> bit & 1) << (3 * bit + axis);
    }
    return key;
}

/// Where a region lies: its lowest corner / 32 m.
inline Region place_of_region(std::uint32_t key) {
    std::int32_t place[3];
    for (int axis = 0; axis < 3; ++axis) {
        std::int32_t at = 0;
        for (int bit = 0; bit < kRegionAxisBits; ++bit) at |= std::int32_t(key >> (3 * bit + axis) & 1) << bit;
        place[axis] = at - (1 << (kRegionAxisBits - 1));
    }
    return {place[0], place[1], place[2]};
}

/// Finds the region of one point after another; most lie where the last one did.
class RegionFinder {
public:
    std::uint32_t operator()(const GridPoint& point) {
        const std::int32_t x = point.x >> kRegionBits, y = point.y >> kRegionBits, z = point.z >> kRegionBits;
        if (x != x_ || y != y_ || z != z_) {
            x_ = x;
            y_ = y;
            z_ = z;
            last_ = region_of(point);
        }
        return last_;
    }

private:
    std::int32_t x_ = INT32_MIN, y_ = 0, z_ = 0;
    std::uint32_t last_ = 0;
};

/// Sums by number, modulo 2^64.
class SumsByKey {
public:
    void add(std::uint32_t key, std::uint64_t value) {
        if (last_ < sums_.size() && sums_[last_].first == key) {
            sums_[last_].second += value;
            return;
        }
        std::uint32_t& at = place_of_.at(key);
        if (at == FlatMap::kNone) {
            at = std::uint32_t(sums_.size());
            sums_.emplace_back(key, 0);
        }
        last_ = at;
        sums_[at].second += value;
    }
    /// In order of first use.
    const std::vector<std::pair<std::uint32_t, std::uint64_t>>& sums() const { return sums_; }

    void add_to(PersistentMap<std::uint64_t>& map) const {
        for (const auto& [key, sum] : sums_) {
            if (sum == 0) continue;
            const std::uint64_t* before = map.find(key);
            map.set(key, (before ? *before : 0) + sum);
        }
    }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const auto& [key, value] : sums_) sum += value;
        return sum;
    }

private:
    FlatMap place_of_;
    std::vector<std::pair<std::uint32_t, std::uint64_t>> sums_;
    std::size_t last_ = 0;
};

}  // namespace firma
