// SPDX-License-Identifier: MIT
// Ear clipping in a plane of whole numbers: exact, for any outline whatever.
//
// Source: G. H. Meisters, Polygons have ears, 1975; J. O'Rourke, Computational Geometry in C, 1998, section 1.4.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "firma/grid.h"

namespace firma {

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
/// neighbour goes, as no other can turn into an ear (O'Rourke).
class EarClipper {
public:
    /// @param outline  corners [n >= 3]; a view
    /// @param axis, flip  the plane is seen along this axis, or against it, so that the outline runs counter-clockwise
    EarClipper(std::span<const GridPoint> outline, int axis, bool flip);

    /// The next corner between its neighbours; nothing at the end. Judged by the projection alone: a triangle without
    /// area there may have some in space.
    std::optional<std::array<std::uint32_t, 3>> next();

private:
    __extension__ using Wide = __int128;

    enum class Kind : std::uint8_t { kSpike, kEar, kFlat, kBlocked, kRight };

    struct Corner {
        std::int64_t u = 0, v = 0;
        std::uint32_t before = 0, after = 0;
        std::uint32_t judged = 0;  ///< how often; older entries of the queue do not count
        bool gone = false;
        bool left = false;  ///< a left turn
    };
    struct Candidate {
        Kind kind = Kind::kRight;
        Wide length = 0;  ///< square of the third side
        std::uint32_t corner = 0;
        std::uint32_t judged = 0;
        /// The queue gives the largest first, so that one comes last here.
        friend bool operator<(const Candidate& a, const Candidate& b) {
            if (a.kind != b.kind) return a.kind > b.kind;
            if (a.length != b.length) return a.length > b.length;
            return a.corner > b.corner;
        }
    };

    void judge(std::uint32_t corner);
    Kind kind_of(std::uint32_t corner);
    bool blocked(std::uint32_t corner) const;
    bool enters(std::uint32_t other, const std::array<std::uint32_t, 3>& triangle) const;
    int side(std::uint32_t from, std::uint32_t to, std::uint32_t point) const;
    Wide third_side(std::uint32_t corner) const;

    std::span<const GridPoint> outline_;
    std::vector<Corner> corners_;
    /// Corners that were no left turns at first, by u: only such can stand in an ear.
    std::vector<std::uint32_t> inward_;
    std::priority_queue<Candidate> queue_;
    std::size_t remaining_ = 0;
};

}  // namespace firma
