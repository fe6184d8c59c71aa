// SPDX-License-Identifier: MIT
// A hole in a wall, and what stands straight over it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "carve/place_cutter.h"
#include "carve/wall_section.h"
#include "firma/vec.h"

namespace firma {

/// What an outline encloses, with its corners on the input grid: of corners within an input step of a line between
/// others that line is left. Divided into triangles; where so small an outline meets itself, into trapezoids, which
/// cover it whatever it does.
class WallHole {
public:
    /// Holds nothing.
    WallHole() = default;
    WallHole(const WallOutlines& outlines, const WallPlane& wall);

    bool empty() const { return parts_.empty(); }
    /// Whether it takes of a convex polygon in the wall's plane more than a strip a quarter of an input step wide.
    bool takes_of(std::span<const Vec3> polygon) const;
    /// Whether any of a convex polygon may stand straight over it: false only where it is at least 4 input steps
    /// beside it, or wholly behind the prisms' lower ends.
    bool may_be_over(std::span<const Vec3> polygon) const;
    /// Prisms that reach from a little under the wall (2 mm; 8 mm of a slanted one) straight out: one, or of an outline
    /// that meets itself one over each trapezoid, an input step wider on all sides. None of what would reach out of the
    /// world.
    ///
    /// @param height  metres
    std::vector<PlacedCutter> raise(double height) const;

private:
    /// In the plane, seen along the axis that is nearest to its normal; metres.
    struct Flat {
        double u = 0, v = 0;
    };
    /// Convex, corners counter-clockwise seen from the front.
    struct Part {
        std::uint32_t first = 0, count = 0;  ///< in corners_
    };

    Flat flat(const Vec3& p) const;
    void snap(const WallOutlines& outlines);
    bool divide_into_triangles();
    bool add_outline(std::size_t outer, std::span<const std::size_t> holes);
    void divide_into_trapezoids();
    void add_part(std::span<const Vec3> corners);
    std::optional<PlacedCutter> raise_whole(const Vec3& under, const Vec3& over) const;
    std::optional<PlacedCutter> raise_part(const Part& part, const Vec3& under, const Vec3& over) const;
    static double gap(std::span<const Flat> a, std::span<const Flat> b);

    WallPlane wall_;
    int axis_ = 2;
    WallOutlines outlines_;            ///< on the input grid
    std::vector<Flat> flat_outlines_;  ///< all points of these
    Flat low_, high_;                  ///< around them
    std::vector<Vec3> corners_;        ///< of the parts
    std::vector<Part> parts_;
    bool whole_ = false;  ///< parts are triangles of the outlines' corners, side by side
};

}  // namespace firma
