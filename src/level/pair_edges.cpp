// SPDX-License-Identifier: MIT
// Angles around an edge from low to high, counter-clockwise seen against it. A face that uses it upward has its air on
// the side of greater angles, one that uses it downward on that of lesser ones: so the air between two faces begins at
// an upward one and ends at the next, a downward one.
#include "level/pair_edges.h"

#include "geometry/around_edge.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

/// Of half planes that are known by points in them.
class EdgeAngles final : public SpokeAngles {
public:
    EdgeAngles(std::span<const InputPoint> points, const EdgeSide& edge)
        : points_(points), low_(points[edge.low]), high_(points[edge.high]) {}

    int turn(std::uint32_t a, std::uint32_t b) const override { return orient(low_, high_, points_[a], points_[b]); }
    bool same_half(std::uint32_t a, std::uint32_t b) const override {
        const AreaVector n = area_vector(low_, high_, points_[a]), m = area_vector(low_, high_, points_[b]);
        return Int128(n.x) * m.x + Int128(n.y) * m.y + Int128(n.z) * m.z > 0;
    }

private:
    std::span<const InputPoint> points_;
    const InputPoint &low_, &high_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_sides(std::span<const InputPoint> points,
                                                                std::span<const EdgeSide> sides,
                                                                std::span<const std::uint32_t> apexes) {
    std::vector<Spoke> spokes;
    for (std::uint32_t k = 0; k < sides.size(); ++k)
        spokes.push_back({apexes[k], k, !sides[k].upward, sides[k].upward});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    if (!sort_spokes(spokes, EdgeAngles(points, sides[0]))) return pairs;
    for (std::size_t k = 0; k < spokes.size(); ++k)
        if (spokes[k].air_after) pairs.emplace_back(spokes[k].owner, spokes[k + 1 < spokes.size() ? k + 1 : 0].owner);
    return pairs;
}

}  // namespace firma
