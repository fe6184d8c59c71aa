// SPDX-License-Identifier: MIT
// Numbers for points, in order of first use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/flat_map.h"
#include "firma/grid.h"

namespace firma {

class PointNumbers {
public:
    std::uint32_t number(const GridPoint& p) {
        for (std::uint64_t key = point_key(p);; key = next_key(key)) {
            std::uint32_t& known = map_.at(key);
            if (known == FlatMap::kNone) {
                known = std::uint32_t(points_.size());
                points_.push_back(p);
            }
            if (points_[known] == p) return known;
        }
    }
    const GridPoint& point(std::uint32_t number) const { return points_[number]; }
    std::size_t count() const { return points_.size(); }

private:
    FlatMap map_;
    std::vector<GridPoint> points_;
};

}  // namespace firma
