// SPDX-License-Identifier: MIT
// Which plane divides a solid next: by the reflex edges that it resolves and those that it makes two of.
#include "convex/choose_plane.h"

#include <algorithm>

#include "base/sort.h"
#include "convex/split_sides.h"

namespace firma {
namespace {

/// Planes that are tried.
constexpr std::size_t kTries = 4;
/// What an edge that is crossed counts, in edges that are resolved.
constexpr double kCrossed = 1;

struct ScoredPlane {
    PlaneId plane = kNoPlane;
    double score = 0;
};

std::vector<ScoredPlane> score_planes(ConvexSpace& space, const SolidSides& solid, const ReflexWeights& weights) {
    std::vector<PlaneId> planes;
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t k = 0; k < solid.size(); ++k) {
        if (solid.bend[k] >= 0) continue;
        planes.push_back(solid.sides[k].plane & ~1u);
        if (k < solid.twin[k]) reflex.push_back(k);
    }
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
    std::stable_sort(scored.begin(), scored.end(),
                     [](const ScoredPlane& a, const ScoredPlane& b) { return a.score > b.score; });
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
