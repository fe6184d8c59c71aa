// SPDX-License-Identifier: MIT
// The same craters in the same levels by Firma and by CGAL's corefinement, a few of one and a few of the other in turn,
// and whether both took the same volume away.
//
// CGAL's corefinement is under the GPL: nothing but this program is built with it, and nothing that is handed out.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdio>

#include "carve/place_cutter.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr std::size_t kTurn = 5;

Mesh mesh_of(const Level& level) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> index;
    for (const GridPoint& v : level.vertices) {
        const Vec3 p = to_metres(v);
        index.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    }
    for (const LevelFace& face : level.faces) {
        const std::uint32_t* corner = level.corners.data() + face.first_corner;
        mesh.add_face(index[corner[0]], index[corner[1]], index[corner[2]]);
    }
    return mesh;
}

/// As Firma snaps it: both subtract the same numbers.
Mesh mesh_of(const PlacedCutter& cutter) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> index;
    for (const InputPoint& v : cutter.vertices)
        index.push_back(mesh.add_vertex({v.x / kInputSteps, v.y / kInputSteps, v.z / kInputSteps}));
    for (const CutterTriangle& t : cutter.triangles) mesh.add_face(index[t[0]], index[t[1]], index[t[2]]);
    return mesh;
}

/// Of what a world's facets enclose: those of the surface grid, which lie within 4 um of the exact faces.
double volume_of(const World& world) {
    double six = 0;
    for (const Face& face : world.faces())
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            six += dot(face.corners[0], cross(face.corners[k - 1], face.corners[k]));
    return six / 6;
}

struct Race {
    Level level;
    World world;
    Mesh mesh;
    std::vector<double> firma, cgal, copy;  ///< milliseconds; of copying CGAL's mesh, for its own undo
    double firma_taken = 0;                 ///< by the reports, m3
    int retries = 0, refused = 0, failed = 0;
};

void cut_both(Race& race, int rooms, CraterPlaces places, std::size_t from, const Cutter& cutter) {
    for (std::size_t k = from; k < from + kTurn; ++k) {
        const CutCost cost = cut_crater(race.world, cutter, crater_pose(rooms, places, k));
        race.firma.push_back(cost.cpu);
        race.firma_taken += cost.report.volume;
        race.retries += cost.report.retries;
        race.refused += cost.status == CarveStatus::kRefused;
    }
    for (std::size_t k = from; k < from + kTurn; ++k) {
        const PlacedCutter placed = place_cutter(cutter, crater_pose(rooms, places, k)).value();
        Mesh other = mesh_of(placed);
        double before = thread_seconds();
        {
            const Mesh kept = race.mesh;
            keep(kept.number_of_faces());
        }
        race.copy.push_back((thread_seconds() - before) * 1e3);
        before = thread_seconds();
        race.failed += !pmp::corefine_and_compute_difference(race.mesh, other, race.mesh);
        race.cgal.push_back((thread_seconds() - before) * 1e3);
    }
    race.mesh.collect_garbage();  // not counted: it could be done less often
}

int measure(const Settings& settings) {
    Table table("carve_cgal",
                {"triangles", "craters", "cuts", "Firma median ms", "Firma p99 ms", "CGAL in place, median ms",
                 "CGAL p99 ms", "CGAL with a copy kept, median ms", "CGAL in place to Firma",
                 "CGAL with a copy to Firma", "Firma's retries", "not cut by Firma", "not cut by CGAL", "Firma took m3",
                 "CGAL took m3", "differ by", "Firma's facets differ by"});
    const Cutter cutter = crater();
    const std::size_t cuts = settings.quick ? 5 : 200;
    for (const CraterPlaces places : {CraterPlaces::kSpread, CraterPlaces::kCorner})
        for (const int rooms : {2, 6}) {
            if (settings.quick && rooms > 2) break;
            Race race;
            race.level = crater_level(rooms);
            race.world = carvable_world(race.level);
            race.mesh = mesh_of(race.level);
            const double cgal_before = pmp::volume(race.mesh), firma_before = volume_of(race.world);
            for (std::size_t k = 0; k < cuts; k += kTurn) cut_both(race, rooms, places, k, cutter);
            const double cgal_taken = cgal_before - pmp::volume(race.mesh);
            const double facets_taken = firma_before - volume_of(race.world);
            const double ours = median(race.firma), theirs = median(race.cgal);
            std::vector<double> kept = race.cgal;
            for (std::size_t k = 0; k < kept.size(); ++k) kept[k] += race.copy[k];
            const double with_copy = median(kept);
            table.add({count(race.level.faces.size()), places == CraterPlaces::kCorner ? "in one corner" : "spread",
                       count(cuts), number(ours), number(quantile(race.firma, 0.99)), number(theirs),
                       number(quantile(race.cgal, 0.99)), number(with_copy), times(theirs / ours),
                       times(with_copy / ours), count(std::size_t(race.retries)), count(std::size_t(race.refused)),
                       count(std::size_t(race.failed)), std::to_string(race.firma_taken), std::to_string(cgal_taken),
                       number(std::fabs(race.firma_taken / cgal_taken - 1)),
                       number(std::fabs(facets_taken / cgal_taken - 1))});
        }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Craters by Firma and by CGAL's corefinement in turn."));
}
