// SPDX-License-Identifier: MIT
// A placed cutter as a solid: exact planes, edges with two planes, boxes to find its triangles by.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "carve/mesh_polygons.h"
#include "carve/place_cutter.h"
#include "firma/solid.h"
#include "geometry/bevelled_box.h"
#include "index/box_tree.h"
#include "solid/solid_patch.h"

namespace firma {

/// A Solid that cuts, by quarter turns and whole steps.
struct TurnedSolid {
    Solid solid;  ///< as it was before
    GridTurn turn;
    SolidPatch boundary;                 ///< all of it, turned; its stored edges and vertices are null
    std::vector<std::uint32_t> face_of;  ///< the boundary's, of a triangle
};

struct CutterSolid {
    /// An edge runs a -> b counter-clockwise in triangle `left`, b -> a in `right`.
    struct Edge {
        std::uint32_t a, b, left, right;
        /// Those of its triangles; the second an auxiliary one where both lie in one plane.
        Ref<const SolidPlane> plane[2];
        bool flat = false;  ///< whether the planes of its triangles are parallel
    };

    PlacedCutter placed;
    std::vector<ExactPoint> points;             ///< a vertex each
    std::vector<Ref<const SolidPlane>> planes;  ///< a triangle each, looking out of the cutter; a polygon shares one
    std::vector<Edge> edges;
    MeshPolygons polygons;
    std::vector<GridBox> boxes;  ///< a triangle each
    GridBox box;
    BevelledBox bevelled;  ///< around all points
    BoxTree tree;
    /// For a cutter that is a Solid: then the triangles are those of its facets, the points the vertices of its
    /// boundary, and there are no planes, no edges, no polygons, no PlacedCutter::vertices and no topology. Null for a
    /// mesh.
    std::unique_ptr<TurnedSolid> turned;

    const CutterTriangle& triangle(std::uint32_t t) const { return placed.triangles[t]; }
    /// Edge k of triangle t runs from corner k to corner k + 1.
    std::uint32_t edge_of(std::uint32_t t, int k) const { return placed.topology->triangle_edges[t][std::size_t(k)]; }
    /// A plane that holds an edge of a triangle, and is not parallel to that.
    const SolidPlane& across(const Edge& edge, std::uint32_t t) const {
        return *edge.plane[edge.left == t || edge.flat];
    }
    /// Whether an edge lies between two triangles of one polygon.
    bool is_seam(const Edge& edge) const { return polygons.is_one(edge.left, edge.right); }
};

/// @param cutter  replaced; keeps its memory
void make_cutter_solid(PlacedCutter placed, CutterSolid& cutter);

/// Boxes, tree and hull of points and triangles.
void index_triangles(CutterSolid& cutter);

/// Whether a point lies inside: 1 or -1; 0 when that cannot be told, as the point lies on the surface or every line
/// tried meets an edge. Exact for points of three planes too, which mesh_shells.h and see_first() are not.
int side_of_cutter(const CutterSolid& cutter, const ExactPoint& point);

}  // namespace firma
