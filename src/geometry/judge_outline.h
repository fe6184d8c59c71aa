// SPDX-License-Identifier: MIT
// What kind of polygon an outline is, by whole numbers of any width: exact, no tolerance.
//
// Coord holds a difference of two coordinates, Wide the products of three such differences, summed over the outline:
// with differences of at most b bits and n corners, 3 b + log2(6 n) + 1 bits.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/convex_loop.h"
#include "geometry/flat_point.h"

namespace firma {

enum class OutlineForm {
    kNoArea,     ///< all corners on one line
    kNotPlanar,  ///< a corner off the plane of the others
    kNotConvex,  ///< planar; a reflex corner, a corner twice, or an outline that winds more than once
    kConvex,     ///< planar, convex, winding once; corners may lie along a side
};

/// An Outline has size() and operator[], whose values have three coordinates by operator[].
template <class Coord, class Wide, class Outline>
class OutlineJudge {
public:
    /// @param outline  points of three coordinates [n >= 1]; a view
    explicit OutlineJudge(const Outline& outline) : outline_(outline), normal_(add_up_normal()) {}

    using Difference = std::array<Coord, 3>;
    using Normal = std::array<Wide, 3>;

    /// Newell's: twice the area long. Zero also for some outlines that cross themselves.
    const Normal& normal() const { return normal_; }
    bool has_normal() const { return normal_[0] != 0 || normal_[1] != 0 || normal_[2] != 0; }

    /// Where the outline runs counter-clockwise: along the axis along which the normal is longest.
    FlatView front_view() const {
        const Wide x = absolute(normal_[0]), y = absolute(normal_[1]), z = absolute(normal_[2]);
        const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        return {axis, normal_[std::size_t(axis)] < 0};
    }

    OutlineForm form() const {
        if (!has_normal()) return on_one_line() ? OutlineForm::kNoArea : OutlineForm::kNotConvex;
        if (!planar()) return OutlineForm::kNotPlanar;
        return convex() ? OutlineForm::kConvex : OutlineForm::kNotConvex;
    }

private:
    static Wide absolute(const Wide& value) { return value < 0 ? Wide(-value) : value; }

    Difference from_first(std::size_t k) const { return difference(0, k); }
    Difference difference(std::size_t from, std::size_t to) const {
        Difference d;
        for (int axis = 0; axis < 3; ++axis) d[axis] = Coord(Coord(outline_[to][axis]) - Coord(outline_[from][axis]));
        return d;
    }
    static bool is_zero(const Difference& d) { return d[0] == 0 && d[1] == 0 && d[2] == 0; }
    static Normal cross(const Difference& a, const Difference& b) {
        return {Wide(Wide(a[1]) * b[2] - Wide(a[2]) * b[1]), Wide(Wide(a[2]) * b[0] - Wide(a[0]) * b[2]),
                Wide(Wide(a[0]) * b[1] - Wide(a[1]) * b[0])};
    }

    Normal add_up_normal() const {
        Normal sum{Wide(0), Wide(0), Wide(0)};
        if (outline_.size() < 3) return sum;
        Difference a = from_first(1);
        for (std::size_t k = 2; k < outline_.size(); ++k) {
            const Difference b = from_first(k);
            const Normal part = cross(a, b);
            for (int axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
            a = b;
        }
        return sum;
    }

    bool on_one_line() const {
        Difference along{Coord(0), Coord(0), Coord(0)};
        for (std::size_t k = 1; k < outline_.size(); ++k) {
            const Difference d = from_first(k);
            if (is_zero(along)) along = d;
            const Normal area = cross(along, d);
            if (area[0] != 0 || area[1] != 0 || area[2] != 0) return false;
        }
        return true;
    }

    bool planar() const {
        if (outline_.size() == 3) return true;
        for (std::size_t k = 1; k < outline_.size(); ++k) {
            const Difference d = from_first(k);
            if (Wide(normal_[0] * d[0] + normal_[1] * d[1] + normal_[2] * d[2]) != 0) return false;
        }
        return true;
    }

    bool convex() const {
        struct Flat {
            Coord u, v;
        };
        const int u = front_view().u(), v = front_view().v();
        return convex_loop<Wide>(outline_.size(), [&](std::size_t k) {
            const auto& corner = outline_[k];
            return Flat{Coord(corner[u]), Coord(corner[v])};
        });
    }

    Outline outline_;
    Normal normal_;
};

}  // namespace firma
