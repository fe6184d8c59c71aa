// SPDX-License-Identifier: MIT
// Craters by CGAL's corefinement in the scenes of bench_scale.
//
// It is under the GPL: nothing but this program is built with it, and nothing that is handed out.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <array>

#include "carve/place_cutter.h"
#include "scale/cuts.h"
#include "support/craters.h"
#include "support/race.h"

namespace firma::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using CutKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CutMesh = CGAL::Surface_mesh<CutKernel::Point_3>;
using CutPoints = std::vector<CutKernel::Point_3>;
using CutTriangles = std::vector<std::array<std::size_t, 3>>;

CutMesh scene_mesh(const TriangleMesh& mesh) {
    CutPoints points;
    CutTriangles triangles;
    for (std::size_t k = 0; k < mesh.positions.size(); k += 3)
        points.emplace_back(mesh.positions[k], mesh.positions[k + 1], mesh.positions[k + 2]);
    for (std::size_t k = 0; k < mesh.corners.size(); k += 3)
        triangles.push_back({mesh.corners[k], mesh.corners[k + 1], mesh.corners[k + 2]});
    pmp::orient_polygon_soup(points, triangles);  // twins of vertices where several fans meet
    CutMesh made;
    pmp::polygon_soup_to_polygon_mesh(points, triangles, made);
    return made;
}

/// As Firma snaps it: both subtract the same numbers.
CutMesh cutter_mesh(const PlacedCutter& cutter) {
    CutMesh mesh;
    std::vector<CutMesh::Vertex_index> index;
    for (const InputPoint& v : cutter.vertices)
        index.push_back(mesh.add_vertex({v.x / kInputSteps, v.y / kInputSteps, v.z / kInputSteps}));
    for (const CutterTriangle& t : cutter.triangles) mesh.add_face(index[t[0]], index[t[1]], index[t[2]]);
    return mesh;
}

}  // namespace

bool has_cgal_cuts() {
    return true;
}

CutTimes cut_by_cgal(const TriangleMesh& level, const std::vector<Pose>& poses, double budget) {
    CutTimes times;
    const Cutter cutter = crater();
    CutMesh mesh = scene_mesh(level);
    const double whole = pmp::volume(mesh);
    const double begin = thread_seconds();
    for (const Pose& pose : poses) {
        if (thread_seconds() - begin > budget) break;
        CutMesh tool = cutter_mesh(place_cutter(cutter, pose).value());
        const double before = thread_seconds();
        times.refused += !pmp::corefine_and_compute_difference(mesh, tool, mesh);
        times.ms.push_back((thread_seconds() - before) * 1e3);
        times.taken.push_back(whole - pmp::volume(mesh));
    }
    return times;
}

}  // namespace firma::bench
