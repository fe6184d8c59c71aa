// SPDX-License-Identifier: MIT
// A placed cutter as a solid.
#include "carve/cutter_solid.h"

#include <optional>

#include "carve/gather.h"
#include "carve/side_of_solid.h"

namespace firma {
namespace {

GridBox box_of(const CutterSolid& cutter, std::uint32_t t) {
    GridBox box;
    for (const std::uint32_t v : cutter.triangle(t)) box.add(cutter.points[v].rounded());
    return box;
}

Ref<const SolidPlane> new_plane(const Plane& plane) {
    return Ref<const SolidPlane>(new SolidPlane(plane));
}

/// Of a point in the triangle's plane, exactly.
bool in_triangle(const CutterSolid& cutter, std::uint32_t t, const ExactPoint& point) {
    const auto& corners = cutter.triangle(t);
    int side[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const InputPoint& a = cutter.placed.vertices[corners[k]];
        const InputPoint& b = cutter.placed.vertices[corners[k < 2 ? k + 1 : 0]];
        const Plane upright = edge_plane(a, b, cutter.planes[t]->plane);
        // All corners lie on one side.
        side[k] = exact_side(upright, point) *
                  exact_side(upright, ExactPoint(cutter.placed.vertices[corners[k < 1 ? 2 : k - 1]]));
    }
    return side[0] >= 0 && side[1] >= 0 && side[2] >= 0;
}

/// 1: the segment from the point to `outside`, which is not on the triangle, crosses it; 0: it does not; -1: it meets
/// an edge, or begins on the triangle.
int crosses(const CutterSolid& cutter, std::uint32_t t, const ExactPoint& point, const InputPoint& outside) {
    const Plane& plane = cutter.planes[t]->plane;
    const int here = exact_side(plane, point), there = exact_side(plane, ExactPoint(outside));
    if (here == 0 && there == 0) return -1;
    if (here == 0) return in_triangle(cutter, t, point) ? -1 : 0;
    if (there == 0) return 0;
    if (here == there) return 0;
    const auto& corners = cutter.triangle(t);
    int side[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const InputPoint& a = cutter.placed.vertices[corners[k]];
        const InputPoint& b = cutter.placed.vertices[corners[k < 2 ? k + 1 : 0]];
        const Plane fan = plane_through(outside, a, b);
        if (!fan.valid()) return -1;
        side[k] = exact_side(fan, point);
    }
    if (side[0] == side[1] && side[1] == side[2]) return side[0] == 0 ? -1 : 1;
    // A zero beside two of the same sign is a crossing of an edge; beside two that differ, a miss.
    const int sum = side[0] + side[1] + side[2];
    const bool has_zero = side[0] == 0 || side[1] == 0 || side[2] == 0;
    return has_zero && sum != 0 ? -1 : 0;
}

Ref<const SolidPlane> plane_of(const PlacedCutter& placed, std::uint32_t t) {
    const auto& [a, b, c] = placed.triangles[t];
    return new_plane(plane_through(placed.vertices[a], placed.vertices[b], placed.vertices[c]));
}

/// Neighbours in one plane are one polygon, and share the plane of its lowest.
/// @param flat  of each edge: whether the planes of its triangles are parallel
void find_polygons(const CutterTopology& topology, const std::vector<std::uint8_t>& flat, CutterSolid& cutter) {
    DisjointSets sets(cutter.planes.size());
    for (std::size_t k = 0; k < flat.size(); ++k) {
        if (!flat[k]) continue;
        const CutterEdge& edge = topology.edges[k];
        const Plane &left = cutter.planes[edge.left]->plane, &right = cutter.planes[edge.right]->plane;
        const int axis = left.dominant_axis();
        if ((left.normal[axis] > 0) == (right.normal[axis] > 0)) sets.join(edge.left, edge.right);
    }
    cutter.polygons.set(sets, cutter.planes.size());
    for (std::uint32_t t = 0; t < cutter.planes.size(); ++t) cutter.planes[t] = cutter.planes[cutter.polygons.of(t)];
}

CutterSolid::Edge edge_of_planes(const CutterSolid& cutter, const CutterEdge& edge, bool flat) {
    const Ref<const SolidPlane>&left = cutter.planes[edge.left], &right = cutter.planes[edge.right];
    const auto& vertices = cutter.placed.vertices;
    return {edge.a,
            edge.b,
            edge.left,
            edge.right,
            {left, flat ? new_plane(edge_plane(vertices[edge.a], vertices[edge.b], left->plane)) : right}};
}

}  // namespace

void index_triangles(CutterSolid& cutter) {
    cutter.boxes.clear();
    cutter.boxes.reserve(cutter.placed.triangles.size());
    cutter.box = {};
    for (std::uint32_t t = 0; t < cutter.placed.triangles.size(); ++t) {
        cutter.boxes.push_back(box_of(cutter, t));
        cutter.box.add(cutter.boxes.back());
    }
    cutter.tree = BoxTree(cutter.boxes);
    cutter.bevelled = {cutter.box, cutter.points.size(), [&](std::size_t v) { return cutter.points[v].rounded(); }};
}

void make_cutter_solid(PlacedCutter placed, CutterSolid& cutter) {
    cutter.placed = std::move(placed);
    const PlacedCutter& it = cutter.placed;
    cutter.points.clear();
    cutter.points.reserve(it.vertices.size());
    for (const InputPoint& p : it.vertices) cutter.points.emplace_back(p);

    cutter.planes.clear();
    cutter.planes.reserve(it.triangles.size());
    for (std::uint32_t t = 0; t < it.triangles.size(); ++t) cutter.planes.push_back(plane_of(it, t));
    const std::vector<CutterEdge>& edges = it.topology->edges;
    std::vector<std::uint8_t> flat(edges.size());
    bool any_flat = false;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        flat[k] = exact_parallel(cutter.planes[edges[k].left]->plane, cutter.planes[edges[k].right]->plane);
        any_flat |= flat[k] != 0;
    }
    cutter.polygons.clear();
    if (any_flat) find_polygons(*it.topology, flat, cutter);
    cutter.edges.clear();
    cutter.edges.reserve(edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k)
        cutter.edges.push_back(edge_of_planes(cutter, edges[k], flat[k] != 0));
    cutter.turned.reset();
    index_triangles(cutter);
}

namespace {

/// A point outside the cutter's box, beside it along one axis; nothing where that would be outside the world. No two
/// ways give points in line with the middle.
std::optional<InputPoint> point_outside(const GridBox& box, int way) {
    InputPoint outside;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t low = box.low[axis] / kSurfacePerInput, high = box.high[axis] / kSurfacePerInput;
        const std::int64_t size = high - low + 1;
        const std::int64_t beside = way % 2 ? low - 5 - way : high + 5 + way;
        const std::int64_t at = axis == way % 3 ? beside : low + size * ((3 + 7 * way + 11 * axis) % 31) / 31;
        if (at < INT32_MIN / kSurfacePerInput || at > INT32_MAX / kSurfacePerInput) return {};
        outside[axis] = std::int32_t(at);
    }
    return outside;
}

}  // namespace

int side_of_cutter(const CutterSolid& cutter, const ExactPoint& point) {
    if (cutter.turned) return side_of_solid(cutter.turned->solid, cutter.turned->turn.back(point.rounded()));
    for (int way = 0; way < 12; ++way) {
        const std::optional<InputPoint> outside = point_outside(cutter.box, way);
        if (!outside) continue;
        GridBox reach;
        reach.add(to_surface(*outside));
        reach.add(point.rounded());
        reach = grown(reach, 1);  // the point itself lies within a step of its rounded one
        int crossings = 0;
        bool unsure = false;
        cutter.tree.for_each_meeting(reach, [&](std::uint32_t t) {
            const int verdict = crosses(cutter, t, point, *outside);
            if (verdict < 0) unsure = true;
            crossings += verdict == 1;
            return unsure;
        });
        if (!unsure) return crossings % 2 ? 1 : -1;
    }
    return 0;
}

}  // namespace firma
