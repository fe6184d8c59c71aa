// SPDX-License-Identifier: MIT
// A placed cutter as a solid.
#include "carve/cutter_solid.h"

#include <algorithm>
#include <cmath>

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

Ref<const SolidPlane> plane_of(const PlacedCutter& placed, std::uint32_t t) {
    const auto& [a, b, c] = placed.triangles[t];
    return new_plane(plane_through(placed.vertices[a], placed.vertices[b], placed.vertices[c]));
}

/// Triangles: a face's facets take the square of its corners.
constexpr std::uint32_t kMostInPolygon = 4096;

/// Neighbours in one plane are one polygon, and share the plane of its lowest.
/// @param flat  of each edge: whether the planes of its triangles are parallel
void find_polygons(const CutterTopology& topology, const std::vector<std::uint8_t>& flat, CutterSolid& cutter) {
    DisjointSets sets(cutter.planes.size());
    std::vector<std::uint32_t> count(cutter.planes.size(), 1);
    for (std::size_t k = 0; k < flat.size(); ++k) {
        if (!flat[k]) continue;
        const CutterEdge& edge = topology.edges[k];
        const Plane &left = cutter.planes[edge.left]->plane, &right = cutter.planes[edge.right]->plane;
        const int axis = left.dominant_axis();
        if ((left.normal[axis] > 0) != (right.normal[axis] > 0)) continue;
        const std::uint32_t a = sets.find(edge.left), b = sets.find(edge.right);
        if (a == b || count[a] + count[b] > kMostInPolygon) continue;
        sets.join(a, b);
        count[sets.find(a)] = count[a] + count[b];
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
            {left, flat ? new_plane(edge_plane(vertices[edge.a], vertices[edge.b], left->plane)) : right},
            flat};
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

}  // namespace firma
