// SPDX-License-Identifier: MIT
// Angles around an edge from low to high, counter-clockwise seen against it. A face that uses it upward has its air on
// the side of greater angles, one that uses it downward on that of lesser ones: so the air between two faces begins at
// an upward one and ends at the next, a downward one.
#include "level/pair_edges.h"

#include <numeric>

#include "base/sort.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

class AroundEdge {
public:
    AroundEdge(std::span<const InputPoint> points, const EdgeUse& reference)
        : points_(points), low_(points[reference.low]), high_(points[reference.high]), zero_(reference.apex) {}

    /// Whether a lies before b, by angle from the reference.
    bool before(std::uint32_t a, std::uint32_t b) const {
        const int half_a = half(a), half_b = half(b);
        return half_a != half_b ? half_a < half_b : turn(a, b) > 0;
    }
    bool same(std::uint32_t a, std::uint32_t b) const { return half(a) == half(b) && turn(a, b) == 0; }

private:
    int turn(std::uint32_t a, std::uint32_t b) const { return orient(low_, high_, points_[a], points_[b]); }
    /// 0 at the reference's angle, 1 within half a turn from there, 2 opposite, 3 beyond.
    int half(std::uint32_t a) const {
        const int side = turn(zero_, a);
        if (side != 0) return side > 0 ? 1 : 3;
        const AreaVector n = area_vector(low_, high_, points_[zero_]), m = area_vector(low_, high_, points_[a]);
        return Int128(n.x) * m.x + Int128(n.y) * m.y + Int128(n.z) * m.z > 0 ? 0 : 2;
    }

    std::span<const InputPoint> points_;
    const InputPoint &low_, &high_;
    const std::uint32_t zero_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_uses(std::span<const InputPoint> points,
                                                               std::span<const EdgeUse> uses) {
    const AroundEdge around(points, uses[0]);
    std::vector<std::uint32_t> order(uses.size());
    std::iota(order.begin(), order.end(), 0u);
    sort_range(order, [&](std::uint32_t a, std::uint32_t b) {
        if (around.same(uses[a].apex, uses[b].apex)) return a < b;
        return around.before(uses[a].apex, uses[b].apex);
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::uint32_t here = order[k], next = order[k + 1 < order.size() ? k + 1 : 0];
        if (uses[here].upward == uses[next].upward || around.same(uses[here].apex, uses[next].apex)) return {};
        if (uses[here].upward) pairs.emplace_back(here, next);
    }
    return pairs;
}

}  // namespace firma
