// SPDX-License-Identifier: MIT
// Shells are counted along a ray from each: the numbers of them around it say how it must be turned.
#include "carve/check_shells.h"

#include <string>
#include <vector>

#include "base/assert.h"
#include "base/disjoint_sets.h"
#include "carve/check_crossing.h"
#include "geometry/mesh_shells.h"
#include "index/box_tree.h"

namespace firma {
namespace {

/// The shells, numbered by their first triangles.
struct Shells {
    std::vector<std::uint32_t> of_triangle;
    std::vector<std::uint32_t> first;  ///< triangle of each
};

Shells shells_of(const PlacedCutter& placed) {
    DisjointSets sets(placed.triangles.size());
    for (const CutterEdge& edge : placed.topology->edges) sets.join(edge.left, edge.right);
    Shells shells;
    shells.of_triangle.reserve(placed.triangles.size());
    for (std::uint32_t t = 0; t < placed.triangles.size(); ++t) {
        const std::uint32_t first = sets.find(t);
        shells.of_triangle.push_back(first == t ? std::uint32_t(shells.first.size()) : shells.of_triangle[first]);
        if (first == t) shells.first.push_back(t);
    }
    return shells;
}

/// Which shells enclose a positive volume.
std::vector<bool> turned_outward(const PlacedCutter& placed, const Shells& shells) {
    std::vector<Int128> volume(shells.first.size(), 0);  // six times
    for (std::size_t t = 0; t < placed.triangles.size(); ++t)
        volume[shells.of_triangle[t]] += six_times_cone(placed.vertices, placed.triangles[t], placed.vertices[0]);
    std::vector<bool> outward;
    for (const Int128 six_times : volume) outward.push_back(six_times > 0);
    return outward;
}

/// How often the other shells wind around this one.
int winding_around(std::uint32_t shell, const PlacedCutter& placed, const Shells& shells, const BoxTree& tree,
                   PairBudget* budget) {
    const CutterTriangle& edge = placed.triangles[shells.first[shell]];
    const EdgeRay ray(placed.vertices[edge[0]], placed.vertices[edge[1]]);
    int winding = 0;
    tree.for_each_meeting(ray.box(), [&](std::uint32_t t) {
        if (budget && !budget->take()) return true;
        if (shells.of_triangle[t] != shell) winding += ray.passage(placed.vertices, polygon_of(placed, t));
        return false;
    });
    return winding;
}

Error self_crossing(const PlacedCutter& placed, const Crossing& crossing) {
    return {ErrorCode::kInvalid, placed.name,
            "crosses or touches itself on the grid: triangles " + std::to_string(crossing.first) + " and " +
                std::to_string(crossing.second)};
}

Error wrong_shell(const PlacedCutter& placed, std::uint32_t triangle) {
    return {ErrorCode::kInvalid, placed.name,
            "the shell of triangle " + std::to_string(triangle) + " is turned the wrong way for where it lies"};
}

Error too_many_pairs(const PlacedCutter& placed, std::uint64_t most) {
    return {ErrorCode::kTooLarge, placed.name,
            "the boxes of its triangles overlap so much that it takes more than " + std::to_string(most) +
                " pairs to tell whether it crosses itself"};
}

/// Once it is known whether triangles cross.
std::optional<Error> verdict_on(const PlacedCutter& placed, const std::optional<Crossing>& crossing,
                                PairBudget* budget) {
    if (crossing) return self_crossing(placed, *crossing);
    const auto spent = [&] { return budget && budget->spent(); };
    if (!spent())
        if (const auto triangle = find_wrong_shell(placed, budget)) return wrong_shell(placed, *triangle);
    if (!spent()) return std::nullopt;
    return too_many_pairs(placed, budget->most());
}

}  // namespace

std::optional<std::uint32_t> find_wrong_shell(const PlacedCutter& placed, PairBudget* budget) {
    FIRMA_ASSERT(placed.topology || placed.triangles.empty(), "a cutter by place_cutter() has its edges");
    const Shells shells = shells_of(placed);
    if (shells.first.empty()) return std::nullopt;
    const std::vector<bool> outward = turned_outward(placed, shells);
    if (shells.first.size() == 1) return outward[0] ? std::nullopt : std::optional(shells.first[0]);
    const BoxTree tree(triangle_boxes(placed));
    for (std::uint32_t shell = 0; shell < shells.first.size(); ++shell) {
        const int winding = winding_around(shell, placed, shells, tree, budget);
        if (budget && budget->spent()) return std::nullopt;
        if (winding != (outward[shell] ? 0 : 1)) return shells.first[shell];
    }
    return std::nullopt;
}

std::optional<Error> check_cutter(const PlacedCutter& placed, PairBudget* budget) {
    // A star is one shell, and faces outward.
    if (is_star_shaped(placed)) return std::nullopt;
    return verdict_on(placed, find_crossing_pair(placed, budget), budget);
}

}  // namespace firma
