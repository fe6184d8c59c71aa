// SPDX-License-Identifier: MIT
// What kind of polygon an outline is, by whole numbers of any width: exact, no tolerance.
//
// Coord holds a difference of two coordinates, Wide the products of three such differences, summed over the outline:
// with differences of at most b bits and n corners, 3 b + log2(6 n) + 1 bits.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace firma {

enum class OutlineForm {
    kNoArea,     ///< all corners on one line
    kNotPlanar,  ///< a corner off the plane of the others
    kNotConvex,  ///< planar; a reflex corner, a corner twice, or an outline that winds more than once
    kConvex,     ///< planar, convex, winding once; corners may lie along a side
};

template <class Coord, class Wide, class Point>
class OutlineJudge {
public:
    /// @param outline  points of three coordinates [n >= 1]; a view
    explicit OutlineJudge(std::span<const Point> outline) : outline_(outline), normal_(add_up_normal()) {}

    using Difference = std::array<Coord, 3>;
    using Normal = std::array<Wide, 3>;

    /// Newell's: twice the area long. Zero also for some outlines that cross themselves.
    const Normal& normal() const { return normal_; }
    bool has_normal() const { return normal_[0] != 0 || normal_[1] != 0 || normal_[2] != 0; }

    /// The axis along which the normal is longest.
    int dominant_axis() const {
        const Wide x = absolute(normal_[0]), y = absolute(normal_[1]), z = absolute(normal_[2]);
        if (x >= y && x >= z) return 0;
        return y >= z ? 1 : 2;
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

    /// Every turn is to the left and below half a turn, and the sides come round once: the outline of a planar polygon
    /// is convex then, and meets no point twice.
    bool convex() const {
        const int axis = dominant_axis();
        int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (normal_[axis] < 0) {
            const int kept = u;
            u = v;
            v = kept;
        }
        const std::size_t count = outline_.size();
        int rounds = 0;
        Difference before = difference(count - 1, 0);
        for (std::size_t k = 0; k < count; ++k) {
            const Difference side = difference(k, k + 1 < count ? k + 1 : 0);
            if (side[u] == 0 && side[v] == 0) return false;  // a corner twice in a row
            const Wide turn = Wide(before[u]) * side[v] - Wide(before[v]) * side[u];
            if (turn < 0) return false;
            if (turn == 0 && Wide(Wide(before[u]) * side[u] + Wide(before[v]) * side[v]) < 0)
                return false;  // turns back
            rounds += !upward(before[u], before[v]) && upward(side[u], side[v]);
            if (rounds > 1) return false;
            before = side;
        }
        return rounds == 1;
    }
    /// Whether a direction lies in the half turn that begins at +u.
    static bool upward(const Coord& u, const Coord& v) { return v > 0 || (v == 0 && u > 0); }

    std::span<const Point> outline_;
    Normal normal_;
};

}  // namespace firma
