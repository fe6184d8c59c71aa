// SPDX-License-Identifier: MIT
// How much a cut took.
#include "carve/cut_volume.h"

#include <algorithm>
#include <bit>

#include "geometry/double_double.h"
#include "geometry/flat_loop.h"

namespace firma {
namespace {

// Each face with the middle o of the cutter makes a cone; what the cones of faces that go hold more than those of faces
// that come is what was taken. Six times a cone's volume is
//  - of a face with all corners on the grid an integer, a sum of (a - o) . (b - o) x (c - o);
//  - else -d S / n[k], as in solid/measure_boundary.cpp: n . p + d = 0 is the face's plane about o, k its dominant
//    axis, S twice its area as seen along k. The corners are quotients of integers of 186 bits, and S is summed in
//    double-double: where cones of wide faces nearly cancel, the difference still has all the digits of a double.

/// A corner about o, input steps.
struct Arm {
    DoubleDouble at[3];
};

/// The leading 106 bits.
DoubleDouble leading(const Int256& value) {
    const bool negative = value.sign() < 0;
    const Int256 magnitude = negative ? -value : value;
    Unsigned128 top = magnitude.high(), rest = magnitude.low();
    int exponent = 128;
    if (top == 0) {
        top = rest;
        rest = 0;
        exponent = 0;
    }
    if (top == 0) return {};
    const auto upper = std::uint64_t(top >> 64);
    const int shift = upper != 0 ? std::countl_zero(upper) : 64 + std::countl_zero(std::uint64_t(top));
    if (shift > 0) top = top << shift | rest >> (128 - shift);
    exponent -= shift;
    // top has its first bit set and counts 2^exponent: its upper 53 bits, and the next 53.
    constexpr std::uint64_t kBits53 = (std::uint64_t(1) << 53) - 1;
    const auto power_of_two = [](int e) { return std::bit_cast<double>(std::uint64_t(1023 + e) << 52); };
    const double high = double(std::uint64_t(top >> 75)) * power_of_two(exponent + 75);
    const double low = double(std::uint64_t(top >> 22) & kBits53) * power_of_two(exponent + 22);
    const DoubleDouble sum = quick_two_sum(high, low);
    return negative ? -sum : sum;
}

class ConeSum {
public:
    explicit ConeSum(const CutView& view) : view_(view) {
        for (int axis = 0; axis < 3; ++axis)
            o_[axis] = std::int32_t((std::int64_t(view.cutter().box.low[axis]) + view.cutter().box.high[axis]) / 2 /
                                    kSurfacePerInput);
    }

    /// @param ends   of the loops in `uses`
    /// @param factor 1: the face goes; -1: it comes
    void add(const Plane& plane, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends, int factor) {
        corners_.clear();
        bool on_grid = true;
        for (const PatchUse& use : uses.first(ends.back())) {
            corners_.push_back(view_.from(use));
            on_grid = on_grid && view_.point(corners_.back()).on_grid();
        }
        if (on_grid)
            whole_ += factor * of_grid(ends);
        else if (plane.valid())
            rest_ = factor > 0 ? rest_ + of_plane(plane, ends) : rest_ - of_plane(plane, ends);
    }

    double cubic_metres() const {
        const DoubleDouble sixths = leading(Int256(whole_)) + rest_;
        return rounded(sixths / DoubleDouble(6)) / (kInputSteps * kInputSteps * kInputSteps);
    }

private:
    /// Differences have 27 bits, the sum a few more than 83.
    Int128 of_grid(std::span<const std::uint32_t> ends) const {
        struct {
            std::int64_t x, y, z;
        } a, b, c;
        const auto arm = [&](std::uint32_t k, auto& to) {
            const InputPoint p = view_.point(corners_[k]).grid();
            to = {p.x - std::int64_t(o_.x), p.y - std::int64_t(o_.y), p.z - std::int64_t(o_.z)};
        };
        Int128 sum = 0;
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends) {
            arm(first, a);
            arm(first + 1, b);
            for (std::uint32_t k = first + 2; k < end; ++k) {
                arm(k, c);
                sum += Int128(a.x) * (b.y * c.z - b.z * c.y) + Int128(a.y) * (b.z * c.x - b.x * c.z) +
                       Int128(a.z) * (b.x * c.y - b.y * c.x);
                b = c;
            }
            first = end;
        }
        return sum;
    }

    DoubleDouble of_plane(const Plane& plane, std::span<const std::uint32_t> ends) {
        const int k = plane.dominant_axis(), u = FlatView{k}.u(), v = FlatView{k}.v();
        struct Flat {
            DoubleDouble u, v;
        };
        const auto corner = [&](std::uint32_t number) {
            const Arm& at = arm(corners_[number]);
            return Flat{at.at[u], at.at[v]};
        };
        DoubleDouble twice_area;
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends) {
            add_twice_area(first, end, corner, twice_area);
            first = end;
        }
        Int128 d = plane.offset();
        for (int axis = 0; axis < 3; ++axis) d += Int128(plane.normal[axis]) * o_[axis];
        return -(leading(Int256(d)) * twice_area) / DoubleDouble(double(plane.normal[k]));
    }

    /// Good until the next one.
    const Arm& arm(std::uint32_t vertex) {
        std::uint32_t& known = number_.at(vertex);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(arms_.size());
            arms_.push_back(new_arm(view_.point(vertex)));
        }
        return arms_[known];
    }

    Arm new_arm(const ExactPoint& point) const {
        Arm made;
        if (point.on_grid()) {
            const InputPoint grid = point.grid();
            for (int axis = 0; axis < 3; ++axis) made.at[axis] = double(std::int64_t(grid[axis]) - o_[axis]);
            return made;
        }
        const Meet m = meet(*point.plane(0), *point.plane(1), *point.plane(2));
        const DoubleDouble share = DoubleDouble(1) / leading(m.w);
        const Int256* const numerators[3] = {&m.x, &m.y, &m.z};
        for (int axis = 0; axis < 3; ++axis)
            made.at[axis] = leading(*numerators[axis] - m.w * std::int64_t(o_[axis])) * share;
        return made;
    }

    const CutView& view_;
    InputPoint o_;
    Int128 whole_ = 0;   ///< of faces on the grid
    DoubleDouble rest_;  ///< of the others
    std::vector<std::uint32_t> corners_;
    std::vector<Arm> arms_;
    FlatMap number_;  ///< in arms_, by vertex
};

}  // namespace

double volume_taken(const CutView& view, const NewLoops& loops) {
    const SolidPatch& patch = view.patch();
    ConeSum sum(view);
    for (const std::uint32_t index : loops.gone) {
        const PatchFace& face = patch.faces[index];
        sum.add(face.plane->plane, patch.uses(face), patch.ends(face), 1);
    }
    for (const NewFace& face : loops.faces) sum.add(face.plane->plane, loops.uses(face), loops.ends(face), -1);
    return sum.cubic_metres();
}

}  // namespace firma
