// SPDX-License-Identifier: MIT
// A solid as chains of sides, plane by plane.
#include "convex/sides.h"

#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "solid/boundary.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

/// Sides of one plane between the same two points, whichever way.
bool same_place(const FaceSide& a, const FaceSide& b) {
    return a.plane == b.plane && std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
}

bool by_place(const FaceSide& a, const FaceSide& b) {
    if (a.plane != b.plane) return a.plane < b.plane;
    const auto p = std::minmax(a.from, a.to), q = std::minmax(b.from, b.to);
    return p != q ? p < q : a.from < b.from;
}

}  // namespace

void settle_sides(FaceSides& sides) {
    sort_range(sides, by_place);
    std::size_t kept = 0;
    for (std::size_t first = 0, end; first < sides.size(); first = end) {
        end = first + 1;
        while (end < sides.size() && same_place(sides[first], sides[end])) ++end;
        // Those that run up come first, then those that run down.
        std::size_t up = first;
        while (up < end && sides[up].from < sides[up].to) ++up;
        const std::size_t gone = std::min(up - first, end - up);
        for (std::size_t k = first + gone; k < up; ++k) sides[kept++] = sides[k];
        for (std::size_t k = up + gone; k < end; ++k) sides[kept++] = sides[k];
    }
    sides.resize(kept);
    sort_range(sides);
}

bool sides_of_solid(ConvexSpace& space, const Solid& solid, FaceSides& sides) {
    const Boundary boundary = take_boundary(solid.data().faces.root.get());
    const SolidPatch& patch = boundary.patch;
    std::vector<std::uint32_t> number;
    for (const PatchVertex& vertex : patch.vertices) {
        const ExactPoint& point = vertex.point;
        if (point.on_grid()) {
            number.push_back(space.tables.points.add(point.grid()));
            continue;
        }
        PlaneId planes[3];
        for (int k = 0; k < 3; ++k) planes[k] = space.tables.planes.add(*point.plane(k));
        number.push_back(space.tables.points.add(planes[0], planes[1], planes[2]));
        if (number.back() == PointTable::kNone) return false;
    }
    sides.clear();
    for (const PatchFace& face : patch.faces) {
        if (!face.plane->plane.valid()) return false;
        const PlaneId plane = space.tables.planes.add(face.plane->plane);
        for (const PatchUse& use : patch.uses(face))
            sides.push_back({plane, number[patch.from(use)], number[patch.to(use)]});
    }
    settle_sides(sides);
    return true;
}

std::size_t count_reflex(const SolidSides& solid) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < solid.size(); ++k) count += solid.bend[k] < 0 && k < solid.twin[k];
    return count;
}

void straighten_sides(ConvexSpace& space, FaceSides& sides) {
    SolidSides solid;
    if (!pair_sides(space, sides, solid)) return;
    // By the point that they begin at: two sides and no more, each in the plane beyond the other.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> from;
    for (std::uint32_t k = 0; k < solid.size(); ++k) from.emplace_back(solid.sides[k].from, k);
    sort_range(from);
    std::vector<std::uint32_t> straight(solid.size(), 0);
    bool any = false;
    for (std::size_t first = 0, end; first < from.size(); first = end) {
        end = first + 1;
        while (end < from.size() && from[end].first == from[first].first) ++end;
        if (end - first != 2) continue;
        const std::uint32_t a = from[first].second, b = from[first + 1].second;
        if (solid.across(a) != solid.sides[b].plane || solid.across(b) != solid.sides[a].plane) continue;
        straight[a] = straight[b] = 1;
        any = true;
    }
    if (!any) return;
    sides.clear();
    for (std::uint32_t k = 0; k < solid.size(); ++k) {
        if (straight[k]) continue;
        std::uint32_t last = k;
        while (straight[solid.next[last]]) last = solid.next[last];
        sides.push_back({solid.sides[k].plane, solid.sides[k].from, solid.sides[last].to});
    }
    settle_sides(sides);
}

}  // namespace firma
