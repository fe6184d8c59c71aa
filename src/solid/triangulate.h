// SPDX-License-Identifier: MIT
// Divides a flat face with holes into triangles: bridges to the holes, then ears.
//
// Source: G. H. Meisters, Polygons have ears, 1975; J. O'Rourke, Computational Geometry in C, 1998, section 1.4;
// D. Eberly, Triangulation by Ear Clipping, 2002 (bridges; theirs are found by a ray, ours by exact visibility).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "solid/flat_point.h"
#include "solid/lowest_key.h"

namespace firma {

/// Side k of the triangles runs from corner k to the next of its triangle, k / 3.
struct Triangles {
    static constexpr std::uint32_t kNoTwin = UINT32_MAX;

    std::vector<std::uint32_t> corners;  ///< three a triangle, counter-clockwise, indices into the points
    std::vector<std::uint32_t> twins;    ///< the same diagonal seen from the other triangle; kNoTwin along a loop
};

/// Every corner is used, also those along sides; no triangle is without area in the projection. Of several ears the one
/// with the shortest third side goes first, so that no corner gathers them all. Keeps its scratch from call to call.
class Triangulator {
public:
    /// @param points, flat  corners of all loops in a row, in space (lengths are measured there) and projected
    /// @param loop_ends     end of each loop; LoopChecker must have found them simple
    /// @return false when the outer loop is not counter-clockwise, a hole not clockwise, or not directly inside the
    ///         outer loop; `triangles` is then of no meaning
    bool make(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
              std::span<const std::uint32_t> loop_ends, Triangles& triangles);

private:
    /// A corner, and the edge from it to the next. Ends of bridges are there twice.
    struct Node {
        FlatPoint at;
        std::uint32_t point = 0;
        std::uint32_t before = 0, after = 0;
        std::uint32_t twin = Triangles::kNoTwin;  ///< side of the triangle beyond the edge, once that exists
        std::uint32_t partner = UINT32_MAX;       ///< node whose edge is the same bridge, the other way
        bool gone = false;
        bool left = false;  ///< a left turn, neither straight nor right
    };
    struct Rim {
        double length = 0;  ///< square of the bridge
        std::uint32_t node = 0;
        /// Heaps give the largest first, so the best comes last here.
        friend bool operator<(const Rim& a, const Rim& b) {
            return a.length != b.length ? a.length > b.length : a.node > b.node;
        }
    };
    struct Inward {
        FlatPoint at;
        std::uint32_t node = 0;
    };

    bool link_loops(std::span<const FlatPoint> flat, std::span<const std::uint32_t> loop_ends);
    bool join_holes();
    bool join(std::uint32_t hole);
    bool visible(std::uint32_t from, std::uint32_t to) const;
    bool opens_to(const Node& node, const FlatPoint& target) const;
    void splice(std::uint32_t rim, std::uint32_t hole);

    bool clip(Triangles& triangles);
    void judge(std::uint32_t node);
    bool blocked(std::uint32_t node) const;
    void emit(std::uint32_t ear, Triangles& triangles);
    void use_edge(std::uint32_t node, std::uint32_t side, Triangles& triangles);

    std::span<const GridPoint> points_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> holes_;  ///< the lowest corner of each, by u, then v
    std::vector<Rim> rims_;             ///< a heap of corners that a hole may be joined to
    LowestKey ears_;                    ///< squares of third sides; left turns not yet found to be blocked
    std::vector<Inward> inward_;  ///< corners that were no left turns at first, by u: only such can stand in an ear
};

}  // namespace firma
