// SPDX-License-Identifier: MIT
// Which plane divides a solid next: by the reflex edges that it resolves and those that it makes two of.
#include "convex/choose_plane.h"

#include <algorithm>
#include <optional>

#include "base/sort.h"
#include "convex/split_sides.h"

namespace firma {
namespace {

/// Planes that are tried.
constexpr std::size_t kTries = 4;
/// What an edge that is crossed counts, in edges that are resolved.
constexpr double kCrossed = 1;

/// Of more reflex edges no planes through two of them are looked for.
constexpr std::size_t kMaxPaired = 64;

struct ScoredPlane {
    PlaneId plane = kNoPlane;
    double score = 0;
};

/// Of points of the input grid, where all are.
std::optional<Plane> plane_through_edges(const ConvexSpace& space, const FaceSide& a, const FaceSide& b) {
    InputPoint at[4];
    std::size_t count = 0;
    for (const std::uint32_t point : {a.from, a.to, b.from, b.to}) {
        if (!space.point(point).on_grid()) return std::nullopt;
        at[count++] = space.point(point).grid();
    }
    Plane plane = plane_through(at[0], at[1], at[2]);
    if (!plane.valid()) plane = plane_through(at[0], at[1], at[3]);
    if (!plane.valid()) return std::nullopt;
    for (const InputPoint& point : at)
        if (exact_side(plane, ExactPoint(point)) != 0) return std::nullopt;
    return plane;
}

/// Edges side by side, as of the teeth of a wheel: a plane through two of them resolves both.
void add_planes_through_two(ConvexSpace& space, const SolidSides& solid, const std::vector<std::uint32_t>& reflex,
                            std::vector<PlaneId>& planes) {
    if (reflex.size() > kMaxPaired) return;
    for (std::size_t a = 0; a < reflex.size(); ++a)
        for (std::size_t b = a + 1; b < reflex.size(); ++b)
            if (const std::optional<Plane> plane =
                    plane_through_edges(space, solid.sides[reflex[a]], solid.sides[reflex[b]]))
                planes.push_back(space.tables.planes.add(*plane) & ~1u);
}

std::vector<ScoredPlane> score_planes(ConvexSpace& space, const SolidSides& solid, const ReflexWeights& weights) {
    std::vector<PlaneId> planes;
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t k = 0; k < solid.size(); ++k) {
        if (solid.bend[k] >= 0) continue;
        planes.push_back(solid.sides[k].plane & ~1u);
        if (k < solid.twin[k]) reflex.push_back(k);
    }
    add_planes_through_two(space, solid, reflex, planes);
    sort_once(planes);
    std::vector<ScoredPlane> scored;
    std::vector<std::int8_t> sides(space.tables.points.size());
    for (const PlaneId plane : planes) {
        for (const std::uint32_t k : reflex)
            for (const std::uint32_t point : {solid.sides[k].from, solid.sides[k].to})
                sides[point] = std::int8_t(space.tables.points.side(plane, point));
        ScoredPlane one{plane, 0};
        for (const std::uint32_t k : reflex) {
            const int here = sides[solid.sides[k].from], there = sides[solid.sides[k].to];
            if (here == 0 && there == 0) one.score += weights[k];
            if (here * there < 0) one.score -= kCrossed * weights[k];
        }
        scored.push_back(one);
    }
    sort_stably(scored, [](const ScoredPlane& a, const ScoredPlane& b) { return a.score > b.score; });
    return scored;
}

/// Reflex edges that are left and parts that there are: about how many pieces it will be.
std::size_t left_to_do(ConvexSpace& space, const std::vector<FaceSides>& parts) {
    std::size_t sum = parts.size();
    SolidSides solid;
    for (const FaceSides& part : parts)
        if (pair_sides(space, part, solid)) sum += count_reflex(solid);
    return sum;
}

}  // namespace

bool divide_best(ConvexSpace& space, const SolidSides& solid, const ReflexWeights& weights,
                 std::vector<FaceSides>& parts) {
    const std::vector<ScoredPlane> scored = score_planes(space, solid, weights);
    std::size_t least = SIZE_MAX;
    std::vector<FaceSides> tried;
    for (std::size_t k = 0; k < scored.size() && (k < kTries || least == SIZE_MAX); ++k) {
        if (!divide_solid(space, solid, scored[k].plane, tried) || tried.size() < 2) continue;
        const std::size_t left = left_to_do(space, tried);
        if (left >= least) continue;
        least = left;
        parts = std::move(tried);
    }
    return least != SIZE_MAX;
}

}  // namespace firma
