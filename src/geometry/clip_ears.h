// SPDX-License-Identifier: MIT
// Ear clipping in a plane of whole numbers: exact, for any outline whatever.
//
// Source: G. H. Meisters, Polygons have ears, 1975; J. O'Rourke, Computational Geometry in C, 1998, section 1.4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/lowest_key.h"
#include "firma/grid.h"
#include "geometry/flat_point.h"

namespace firma {

/// Side k of the triangles runs from corner k to the next of its triangle, k / 3.
struct Triangles {
    static constexpr std::uint32_t kNoTwin = UINT32_MAX;

    std::vector<std::uint32_t> corners;  ///< three a triangle, counter-clockwise, indices into the points
    std::vector<std::uint32_t> twins;    ///< the same diagonal seen from the other triangle; kNoTwin along a loop

    void clear() {
        corners.clear();
        twins.clear();
    }
};

/// A corner of an outline, and the edge from it to the next.
struct RingCorner {
    FlatPoint at;
    std::uint32_t point = 0;
    std::uint32_t before = 0, after = 0;
    std::uint32_t twin = Triangles::kNoTwin;  ///< side of the triangle beyond the edge, once that exists
    std::uint32_t partner = UINT32_MAX;       ///< corner whose edge is the same one, the other way
    bool gone = false;
    bool left = false;  ///< a left turn, neither straight nor right
};

/// Makes a ring of the points from `first` to `end`, with the same numbers.
void link_ring(std::span<const FlatPoint> flat, std::uint32_t first, std::uint32_t end, std::span<RingCorner> ring);

/// Takes corners off an outline, one at a time, until nothing is left. Which one is next:
///
///  1. a spike: a corner that repeats a neighbour, or whose two sides run back over each other; nothing is lost with it
///  2. an ear: a left turn whose triangle no other part of the outline enters, and whose third side none touches
///  3. a corner along a side
///  4. any left turn
///  5. any right turn
///
/// An outline that does not meet itself always has an ear, however many of its corners lie along its sides, and without
/// that ear it still does not meet itself; so 3 to 5 are for other outlines only. Of several corners the one goes whose
/// third side is shortest: pieces stay compact, and no corner gathers them all. A corner is judged again only when a
/// neighbour goes, as no other can turn into an ear (O'Rourke). Keeps its scratch from call to call.
class EarClipper {
public:
    enum class Takes : std::uint8_t {
        kEars,     ///< nothing else: no triangle is without area in the projection
        kAnything  ///< also of outlines that meet themselves. Triangles may face the other way, or have no area
    };

    /// @param points     in space: lengths are measured there
    /// @param ring       the outline, counter-clockwise; edges that are partners lie on each other. Used up
    /// @param triangles  those found are added: the corner between its neighbours, from the one before
    /// @return false when it met a ring without ears, and takes nothing else
    bool clip(std::span<const GridPoint> points, std::span<RingCorner> ring, Takes takes, Triangles& triangles);

private:
    struct Inward {
        FlatPoint at;
        std::uint32_t corner = 0;
    };

    void judge(std::uint32_t corner);
    void defer_blocked(std::uint32_t corner);
    double third_side(const RingCorner& corner) const;
    bool blocked(std::uint32_t corner) const;
    bool enters(const RingCorner& other, const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) const;
    void emit(std::uint32_t corner, Triangles& triangles);
    void use_edge(std::uint32_t corner, std::uint32_t side, Triangles& triangles);

    std::span<const GridPoint> points_;
    std::span<RingCorner> ring_;
    bool takes_anything_ = false;
    LowestKey next_;              ///< squares of third sides, times what the kind of the corner counts
    std::vector<Inward> inward_;  ///< corners that were no left turns at first, by u: only such can stand in an ear
};

}  // namespace firma
