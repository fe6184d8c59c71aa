// SPDX-License-Identifier: MIT
// Vertices of a level by their points: for formats whose faces bring their own, though they meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "base/table_key.h"
#include "firma/grid.h"
#include "level/level_builder.h"

namespace firma {

/// One vertex for each point.
class SharedVertices {
public:
    explicit SharedVertices(LevelBuilder& builder) : builder_(builder) {}

    std::uint32_t at(const GridPoint& point) {
        const auto [place, added] = index_.try_emplace(point, 0);
        if (added) place->second = *builder_.add_vertex(to_metres(point));
        return place->second;
    }

private:
    struct Hash {
        std::size_t operator()(const GridPoint& p) const { return std::size_t(point_key(p)); }
    };

    LevelBuilder& builder_;
    std::unordered_map<GridPoint, std::uint32_t, Hash> index_;
};

}  // namespace firma
