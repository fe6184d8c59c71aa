// SPDX-License-Identifier: MIT
// Triangles of a convex polygon, cut off from a first edge on, to the left or to the right.
//
// Left of the chord from corner `left` to corner `right` lies what is not divided yet: right, right + 1, ..., left,
// going around. The triangle of the chord and of the next corner on either side has area, as a chord through the inside
// meets the rim in its ends alone. What remains has area as long as some corner between its ends is a turn; where one
// of the two ways would leave none, the other one does not.
#include "geometry/triangulate_convex.h"

#include "geometry/exact_integer.h"

namespace firma {
namespace {

bool in_line(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    // Differences have 33 bits, products 66.
    const auto apart = [](std::int32_t from, std::int32_t to) { return Int128(to) - from; };
    const Int128 ux = apart(a.x, b.x), uy = apart(a.y, b.y), uz = apart(a.z, b.z);
    const Int128 vx = apart(b.x, c.x), vy = apart(b.y, c.y), vz = apart(b.z, c.z);
    return uy * vz == uz * vy && uz * vx == ux * vz && ux * vy == uy * vx;
}

/// Which corners are turns, counted from a first one around.
class Turns {
public:
    explicit Turns(std::span<const GridPoint> corners) : is_turn_(corners.size()) {
        const std::size_t count = corners.size();
        for (std::size_t k = 0; k < count; ++k)
            is_turn_[k] = !in_line(corners[(k + count - 1) % count], corners[k], corners[(k + 1) % count]);
    }
    bool is_turn(std::uint32_t corner) const { return is_turn_[corner]; }

    void count_from(std::uint32_t first) {
        before_.assign(1, 0);
        for (std::size_t k = 0; k < is_turn_.size(); ++k)
            before_.push_back(before_.back() + is_turn_[(first + k) % is_turn_.size()]);
    }
    /// Whether some corner strictly between two, numbered from the first on, is a turn.
    bool any_between(std::uint32_t a, std::uint32_t b) const { return before_[b] > before_[a + 1]; }

private:
    std::vector<bool> is_turn_;
    std::vector<std::uint32_t> before_;
};

}  // namespace

void triangulate_convex(std::span<const GridPoint> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const auto count = std::uint32_t(corners.size());
    if (count == 3) {
        if (!in_line(corners[0], corners[1], corners[2])) triangles.push_back({0, 1, 2});
        return;
    }
    // From a turn on, whose two sides make a first triangle with area; what it leaves must have some too.
    Turns turns(corners);
    std::uint32_t first = 0;
    for (; first < count; ++first) {
        if (!turns.is_turn(first)) continue;
        turns.count_from(first);
        if (turns.any_between(1, count - 1)) break;
    }
    if (first == count) return;
    const auto corner = [&](std::uint32_t k) { return (first + k) % count; };
    triangles.push_back({corner(count - 1), corner(0), corner(1)});
    std::uint32_t right = 1, left = count - 1;
    while (left - right > 1) {
        const bool last = left - right == 2, by_right = last || turns.any_between(right + 1, left);
        const std::uint32_t next = by_right ? right + 1 : left - 1;
        triangles.push_back({corner(left), corner(right), corner(next)});
        (by_right ? right : left) = next;
    }
}

}  // namespace firma
