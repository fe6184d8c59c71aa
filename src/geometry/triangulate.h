// SPDX-License-Identifier: MIT
// Divides a flat face with holes into triangles: bridges to the holes, then ears.
//
// Source: D. Eberly, Triangulation by Ear Clipping, 2002 (whose bridges are found by a ray, ours by exact visibility).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "geometry/clip_ears.h"
#include "geometry/flat_point.h"

namespace firma {

/// Every corner is used, also those along sides; no triangle is without area in the projection. Keeps its scratch from
/// call to call.
class Triangulator {
public:
    /// @param points, flat  corners of all loops in a row, in space (lengths are measured there) and projected
    /// @param loop_ends     end of each loop; LoopChecker must have found them simple
    /// @return false when the outer loop is not counter-clockwise, a hole not clockwise, or not directly inside the
    ///         outer loop; `triangles` is then of no meaning
    bool make(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
              std::span<const std::uint32_t> loop_ends, Triangles& triangles);

    /// Loops that may touch, cross, or run the wrong way around: triangles that lie over each other or have no area,
    /// but whose sides cancel but for the loops'.
    void make_any(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
                  std::span<const std::uint32_t> loop_ends, Triangles& triangles);

private:
    struct Rim {
        double length = 0;  ///< square of the bridge
        std::uint32_t corner = 0;
        /// Heaps give the largest first, so the best comes last here.
        friend bool operator<(const Rim& a, const Rim& b) {
            return a.length != b.length ? a.length > b.length : a.corner > b.corner;
        }
    };

    bool link_loops(std::span<const FlatPoint> flat, std::span<const std::uint32_t> loop_ends);
    bool join_holes();
    bool join(std::uint32_t hole);
    void join_anyhow(std::uint32_t hole);
    void mark_joined(std::uint32_t hole);
    bool visible(std::uint32_t from, std::uint32_t to) const;
    bool opens_to(const RingCorner& corner, const FlatPoint& target) const;
    void splice(std::uint32_t rim, std::uint32_t hole);

    std::span<const GridPoint> points_;
    std::vector<RingCorner> ring_;      ///< ends of bridges are there twice
    std::vector<std::uint32_t> holes_;  ///< the lowest corner of each, by u, then v
    std::vector<std::uint8_t>
        joined_;             ///< a corner of the ring each: whether it is part of the outline, for make_any()
    std::vector<Rim> rims_;  ///< a heap of corners that a hole may be joined to
    EarClipper clipper_;
};

}  // namespace firma
