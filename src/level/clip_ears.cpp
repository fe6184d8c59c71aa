// SPDX-License-Identifier: MIT
// Ear clipping in a plane of whole numbers.
#include "level/clip_ears.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {

EarClipper::EarClipper(std::span<const GridPoint> outline, int axis, bool flip)
    : outline_(outline), corners_(outline.size()), remaining_(outline.size()) {
    const int u = (axis + (flip ? 2 : 1)) % 3, v = (axis + (flip ? 1 : 2)) % 3;
    const auto count = std::uint32_t(outline.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        corners_[k].u = outline[k][u];
        corners_[k].v = outline[k][v];
        corners_[k].before = k ? k - 1 : count - 1;
        corners_[k].after = k + 1 < count ? k + 1 : 0;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        corners_[k].left = side(corners_[k].before, k, corners_[k].after) > 0;
        if (!corners_[k].left) inward_.push_back(k);
    }
    sort_range(inward_, [&](std::uint32_t a, std::uint32_t b) {
        return corners_[a].u != corners_[b].u ? corners_[a].u < corners_[b].u : a < b;
    });
    for (std::uint32_t k = 0; k < count; ++k) judge(k);
}

std::optional<std::array<std::uint32_t, 3>> EarClipper::next() {
    while (remaining_ > 2 && !queue_.empty()) {
        const Candidate best = queue_.top();
        queue_.pop();
        Corner& corner = corners_[best.corner];
        if (corner.gone || corner.judged != best.judged) continue;
        const std::array<std::uint32_t, 3> triangle{corner.before, best.corner, corner.after};
        corner.gone = true;
        --remaining_;
        corners_[corner.before].after = corner.after;
        corners_[corner.after].before = corner.before;
        if (remaining_ > 2) {
            judge(corner.before);
            judge(corner.after);
        }
        return triangle;
    }
    return std::nullopt;
}

void EarClipper::judge(std::uint32_t corner) {
    const Kind kind = kind_of(corner);
    queue_.push({kind, third_side(corner), corner, ++corners_[corner].judged});
}

EarClipper::Kind EarClipper::kind_of(std::uint32_t corner) {
    Corner& c = corners_[corner];
    const int turn = side(c.before, corner, c.after);
    c.left = turn > 0;
    const GridPoint &before = outline_[c.before], &here = outline_[corner], &after = outline_[c.after];
    if (before == here || here == after || before == after) return Kind::kSpike;
    if (turn < 0) return Kind::kRight;
    if (turn == 0) return Kind::kFlat;
    return blocked(corner) ? Kind::kBlocked : Kind::kEar;
}

/// Whether another part of the outline enters the triangle at a corner, or stands on its third side.
bool EarClipper::blocked(std::uint32_t corner) const {
    const std::array<std::uint32_t, 3> triangle{corners_[corner].before, corner, corners_[corner].after};
    const auto [low_u, high_u] =
        std::minmax({corners_[triangle[0]].u, corners_[triangle[1]].u, corners_[triangle[2]].u});
    const auto [low_v, high_v] =
        std::minmax({corners_[triangle[0]].v, corners_[triangle[1]].v, corners_[triangle[2]].v});
    auto it = std::lower_bound(inward_.begin(), inward_.end(), low_u,
                               [&](std::uint32_t k, std::int64_t u) { return corners_[k].u < u; });
    for (; it != inward_.end() && corners_[*it].u <= high_u; ++it) {
        const Corner& other = corners_[*it];
        if (other.gone || other.left || other.v < low_v || other.v > high_v) continue;
        if (*it == triangle[0] || *it == triangle[1] || *it == triangle[2]) continue;
        if (enters(*it, triangle)) return true;
    }
    return false;
}

/// Whether a corner lies inside a triangle or within its third side, or lies on its rim and leads in from there.
bool EarClipper::enters(std::uint32_t other, const std::array<std::uint32_t, 3>& triangle) const {
    std::array<int, 3> sides;
    for (int k = 0; k < 3; ++k) {
        sides[k] = side(triangle[k], triangle[(k + 1) % 3], other);
        if (sides[k] < 0) return false;
    }
    if (sides[0] > 0 && sides[1] > 0) return true;
    const auto leads_in = [&](std::uint32_t to) {
        for (int k = 0; k < 3; ++k)
            if (sides[k] == 0 && side(triangle[k], triangle[(k + 1) % 3], to) <= 0) return false;
        return true;
    };
    return leads_in(corners_[other].before) || leads_in(corners_[other].after);
}

/// On which side of a directed line a corner lies: 1 on its left.
int EarClipper::side(std::uint32_t from, std::uint32_t to, std::uint32_t point) const {
    const Corner &a = corners_[from], &b = corners_[to], &p = corners_[point];
    const Wide area = Wide(b.u - a.u) * (p.v - a.v) - Wide(b.v - a.v) * (p.u - a.u);
    return (area > 0) - (area < 0);
}

EarClipper::Wide EarClipper::third_side(std::uint32_t corner) const {
    const GridPoint &a = outline_[corners_[corner].before], &b = outline_[corners_[corner].after];
    Wide sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t d = std::int64_t(b[axis]) - a[axis];
        sum += Wide(d) * d;
    }
    return sum;
}

}  // namespace firma
