// SPDX-License-Identifier: MIT
// Which cube of a grid over the world a face belongs to: that of its lowest corner.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "firma/grid.h"
#include "firma/region_meshes.h"
#include "geometry/grid_box.h"
#include "solid/block.h"

namespace firma {

/// A size that regions of meshes may have, in steps of the surface grid.
class TileGrid {
public:
    /// Nothing for a size that is none.
    static std::optional<TileGrid> make(double size) {
        const double parts = size / kMinTileSize;
        if (!(size >= kMinRegionSize && size <= kMaxRegionSize) || parts != std::floor(parts)) return {};
        return TileGrid(std::int64_t(size * kSurfaceSteps));
    }

    Tile tile_of(const GridPoint& point) const {
        Tile tile;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t at = point[axis];
            tile[std::size_t(axis)] = std::int32_t(at >= 0 ? at / steps_ : -((steps_ - 1 - at) / steps_));
        }
        return tile;
    }
    Tile tile_of(const FacetPlace& face) const { return tile_of(lowest_corner(*face.block, face.record())); }

    /// What of the world a cube holds; nothing for one outside.
    std::optional<GridBox> box_of(const Tile& tile) const {
        GridBox box;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t low = tile[std::size_t(axis)] * steps_, high = low + steps_ - 1;
            if (high < INT32_MIN || low > INT32_MAX) return {};
            box.low[axis] = std::int32_t(std::max<std::int64_t>(low, INT32_MIN));
            box.high[axis] = std::int32_t(std::min<std::int64_t>(high, INT32_MAX));
        }
        return box;
    }

private:
    explicit TileGrid(std::int64_t steps) : steps_(steps) {}

    std::int64_t steps_;
};

}  // namespace firma
