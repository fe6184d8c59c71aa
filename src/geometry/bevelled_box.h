// SPDX-License-Identifier: MIT
// Points enclosed more tightly than by a box: by planes aslant at its corners and edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/grid_box.h"

namespace firma {

/// A box with its 8 corners and 12 edges cut off as far as its points allow. What is round fills half of its box, and
/// more than four fifths of this.
class BevelledBox {
public:
    BevelledBox() = default;  ///< around the origin alone
    /// @param box            around all points
    /// @param point_count    at least 1
    /// @param point(k)       a GridPoint
    template <class Point>
    BevelledBox(const GridBox& box, std::size_t point_count, const Point& point);

    /// Whether the hull of some points lies in front of one of the planes, by so much that it still does when either
    /// they or those enclosed move by up to `steps` along each axis. Asks only the planes of the octant that the middle
    /// of their box lies in: false says nothing.
    ///
    /// @param box  around them
    template <class Point>
    bool clear_of(const GridBox& box, std::size_t point_count, const Point& point, std::int32_t steps) const;
    /// Whether the other call would say so of whatever lies in a box: so what is asked of many at once ends in what is
    /// asked of each. False for a box in several octants.
    bool clear_of(const GridBox& box, std::int32_t steps) const;

    /// Calls function(outward, bound) for its 20 slanted planes: a point p lies behind one moved out for steps, as
    /// above, when outward * p <= bound, in surface steps; each coordinate of `outward` is -1, 0 or 1.
    template <class Function>
    void for_each_plane(std::int32_t steps, const Function& function) const;

private:
    static constexpr int kOctants = 8, kPlanes = 4;

    /// How far out a point lies, from the middle: to a corner, and to the three edges that end there.
    using Reach = std::array<std::int64_t, kPlanes>;
    Reach reach_of(int octant, const GridPoint& p) const {
        const auto along = [&](int axis) {
            const std::int64_t d = std::int64_t(p[axis]) - middle_[axis];
            return (octant >> axis & 1) != 0 ? d : -d;
        };
        const std::int64_t x = along(0), y = along(1), z = along(2);
        return {x + y + z, y + z, z + x, x + y};
    }
    int octant_of(const GridBox& box) const {
        const GridPoint middle = middle_of(box);
        int octant = 0;
        for (int axis = 0; axis < 3; ++axis) octant |= int(middle[axis] >= middle_[axis]) << axis;
        return octant;
    }
    bool beyond(int octant, const Reach& least, std::int32_t steps) const {
        const Reach& most = reach_[std::size_t(octant)];
        for (std::size_t plane = 0; plane < kPlanes; ++plane)
            if (least[plane] > grown(plane, most[plane], steps)) return true;
        return false;
    }
    static GridPoint middle_of(const GridBox& box) {
        GridPoint middle;
        for (int axis = 0; axis < 3; ++axis)
            middle[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) >> 1);
        return middle;
    }

    static std::int64_t grown(std::size_t plane, std::int64_t reach, std::int32_t steps) {
        return reach + std::int64_t(plane == 0 ? 3 : 2) * steps;
    }

    GridPoint middle_;
    std::array<Reach, kOctants> reach_{};
};

template <class Point>
BevelledBox::BevelledBox(const GridBox& box, std::size_t point_count, const Point& point) : middle_(middle_of(box)) {
    for (int octant = 0; octant < kOctants; ++octant) reach_[std::size_t(octant)].fill(INT64_MIN);
    for (std::size_t k = 0; k < point_count; ++k)
        for (int octant = 0; octant < kOctants; ++octant) {
            const Reach out = reach_of(octant, point(k));
            Reach& most = reach_[std::size_t(octant)];
            for (std::size_t plane = 0; plane < kPlanes; ++plane) most[plane] = std::max(most[plane], out[plane]);
        }
}

template <class Point>
bool BevelledBox::clear_of(const GridBox& box, std::size_t point_count, const Point& point, std::int32_t steps) const {
    const int octant = octant_of(box);
    Reach least;
    least.fill(INT64_MAX);
    for (std::size_t k = 0; k < point_count; ++k) {
        const Reach out = reach_of(octant, point(k));
        for (std::size_t plane = 0; plane < kPlanes; ++plane) least[plane] = std::min(least[plane], out[plane]);
    }
    return beyond(octant, least, steps);
}

inline bool BevelledBox::clear_of(const GridBox& box, std::int32_t steps) const {
    for (int axis = 0; axis < 3; ++axis)
        if (box.low[axis] < middle_[axis] && box.high[axis] >= middle_[axis]) return false;
    const int octant = octant_of(box);
    GridPoint nearest;
    for (int axis = 0; axis < 3; ++axis) nearest[axis] = (octant >> axis & 1) != 0 ? box.low[axis] : box.high[axis];
    return beyond(octant, reach_of(octant, nearest), steps);
}

template <class Function>
void BevelledBox::for_each_plane(std::int32_t steps, const Function& function) const {
    for (int octant = 0; octant < kOctants; ++octant)
        for (std::size_t plane = 0; plane < kPlanes; ++plane) {
            const int across = int(plane) - 1;                         // the axis that the edge runs along
            if (across >= 0 && (octant >> across & 1) != 0) continue;  // two octants share it
            GridPoint outward;
            std::int64_t bound = grown(plane, reach_[std::size_t(octant)][plane], steps);
            for (int axis = 0; axis < 3; ++axis) {
                if (axis == across) continue;
                outward[axis] = (octant >> axis & 1) != 0 ? 1 : -1;
                bound += std::int64_t(outward[axis]) * middle_[axis];
            }
            function(outward, bound);
        }
}

}  // namespace firma
