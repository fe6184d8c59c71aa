// SPDX-License-Identifier: MIT
// Shells are counted along a ray from each: the numbers of them around it say how it must be turned.
#include "carve/check_shells.h"

#include <string>
#include <vector>

#include "base/assert.h"
#include "carve/check_crossing.h"
#include "carve/triangles_cross.h"
#include "index/box_tree.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;

/// The shells, numbered by their first triangles.
struct Shells {
    std::vector<std::uint32_t> of_triangle;
    std::vector<std::uint32_t> first;  ///< triangle of each
};

Shells shells_of(const PlacedCutter& placed) {
    Shells shells;
    shells.of_triangle.assign(placed.triangles.size(), kNone);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t start = 0; start < placed.triangles.size(); ++start) {
        if (shells.of_triangle[start] != kNone) continue;
        const auto shell = std::uint32_t(shells.first.size());
        shells.first.push_back(start);
        shells.of_triangle[start] = shell;
        waiting.push_back(start);
        while (!waiting.empty()) {
            const std::uint32_t t = waiting.back();
            waiting.pop_back();
            for (const std::uint32_t e : placed.topology->triangle_edges[t]) {
                const CutterEdge& edge = placed.topology->edges[e];
                const std::uint32_t other = edge.left == t ? edge.right : edge.left;
                if (shells.of_triangle[other] != kNone) continue;
                shells.of_triangle[other] = shell;
                waiting.push_back(other);
            }
        }
    }
    return shells;
}

/// Which shells enclose a positive volume.
std::vector<bool> turned_outward(const PlacedCutter& placed, const Shells& shells) {
    std::vector<Int128> volume(shells.first.size(), 0);  // six times
    const InputPoint origin = placed.vertices[0];
    for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
        const auto& [a, b, c] = placed.triangles[t];
        const InputPoint& p = placed.vertices[a];
        const AreaVector n = area_vector(p, placed.vertices[b], placed.vertices[c]);
        volume[shells.of_triangle[t]] +=
            Int128(n.x) * (p.x - origin.x) + Int128(n.y) * (p.y - origin.y) + Int128(n.z) * (p.z - origin.z);
    }
    std::vector<bool> outward;
    for (const Int128 six_times : volume) outward.push_back(six_times > 0);
    return outward;
}

/// The middle of an edge, in half steps: no other shell passes through it, even where shells share a vertex.
struct Middle {
    std::int64_t x = 0, y = 0, z = 0;
};

/// Sign of the turn from a to b to the middle, seen against the x axis; the middle stands a shade beside itself, by an
/// infinitesimal in y and the square of it in z, so that it is on no edge that has any length in this view.
int turn(const InputPoint& a, const InputPoint& b, const Middle& m) {
    const std::int64_t uy = b.y - a.y, uz = b.z - a.z, vy = m.y - 2 * std::int64_t(a.y),
                       vz = m.z - 2 * std::int64_t(a.z);
    const std::int64_t area = uy * vz - uz * vy;
    const std::int64_t decisive = area != 0 ? area : uz != 0 ? -uz : uy;
    return decisive > 0 ? 1 : decisive < 0 ? -1 : 0;
}

/// How a ray from the middle along x passes through a triangle: 1 outward, -1 inward, 0 not at all.
int passage(const PlacedCutter& placed, const CutterTriangle& triangle, const Middle& m) {
    const auto& [ia, ib, ic] = triangle;
    const InputPoint &a = placed.vertices[ia], &b = placed.vertices[ib], &c = placed.vertices[ic];
    const AreaVector n = area_vector(a, b, c);
    if (n.x == 0) return 0;
    const int facing = n.x > 0 ? 1 : -1;
    if (turn(a, b, m) != facing || turn(b, c, m) != facing || turn(c, a, m) != facing) return 0;
    const Int128 height = Int128(n.x) * (m.x - 2 * std::int64_t(a.x)) + Int128(n.y) * (m.y - 2 * std::int64_t(a.y)) +
                          Int128(n.z) * (m.z - 2 * std::int64_t(a.z));
    return (height < 0) == (facing > 0) ? facing : 0;
}

/// How often the other shells wind around this one.
int winding_around(std::uint32_t shell, const PlacedCutter& placed, const Shells& shells, const BoxTree& tree,
                   PairBudget* budget) {
    const CutterTriangle& corners = placed.triangles[shells.first[shell]];
    const InputPoint &a = placed.vertices[corners[0]], &b = placed.vertices[corners[1]];
    const Middle m{std::int64_t(a.x) + b.x, std::int64_t(a.y) + b.y, std::int64_t(a.z) + b.z};
    const auto steps = [](std::int64_t half_steps) { return std::int32_t(half_steps * (kSurfacePerInput / 2)); };
    const GridBox ray{{steps(m.x), steps(m.y), steps(m.z)}, {INT32_MAX, steps(m.y), steps(m.z)}};
    int winding = 0;
    tree.for_each_meeting(ray, [&](std::uint32_t t) {
        if (budget && !budget->take()) return true;
        if (shells.of_triangle[t] != shell) winding += passage(placed, placed.triangles[t], m);
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

// Whether the shells are turned rightly is asked anew of all: a small one may have turned over, or left a large one
// without crossing it where it now is.
std::optional<Error> check_moved_cutter(const PlacedCutter& placed, std::span<const std::uint32_t> triangles,
                                        const BoxTree& tree, PairBudget* budget) {
    if (is_star_shaped(placed)) return std::nullopt;
    return verdict_on(placed, find_crossing_with(placed, triangles, tree, budget), budget);
}

}  // namespace firma
