// SPDX-License-Identifier: MIT
// What a cut takes by Firma, and by CGAL's corefinement with exact constructions: single cuts, each of a level as it
// was, or of what the cuts before it left. Nothing is timed; ends with 1 where volumes differ in the first twelve
// digits.
//
// CGAL's corefinement is under the GPL: nothing but this program and bench_carve_cgal is built with it, and nothing
// that is handed out.
#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "carve/place_cutter.h"
#include "cgal/cgal_solid.h"
#include "scenes/sweeps.h"
#include "support/craters.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Mesh = ExactMesh;
using Exact = ExactKernel::FT::Exact_type;  ///< rational

constexpr double kMostOff = 1e-12;

/// In input steps, as all corners lie on that grid; divided into triangles.
Mesh mesh_of(const Level& level) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> index;
    for (const GridPoint& v : level.vertices) {
        const Vec3 p = to_metres(v) * kInputSteps;
        index.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    }
    for (const LevelFace& face : level.faces) {
        const std::uint32_t* corner = level.corners.data() + face.first_corner;
        for (std::uint32_t k = 2; k < face.corner_count; ++k)
            mesh.add_face(index[corner[0]], index[corner[k - 1]], index[corner[k]]);
    }
    return mesh;
}

Mesh mesh_of(const PlacedCutter& cutter) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> index;
    for (const InputPoint& v : cutter.vertices) index.push_back(mesh.add_vertex({v.x, v.y, v.z}));
    for (const CutterTriangle& t : cutter.triangles) mesh.add_face(index[t[0]], index[t[1]], index[t[2]]);
    return mesh;
}

/// Exactly, cubic input steps.
Exact volume_of(const Mesh& mesh) {
    Exact six(0);
    for (const Mesh::Face_index face : mesh.faces()) {
        Exact p[3][3];
        int k = 0;
        for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face))) {
            for (int axis = 0; axis < 3; ++axis) p[k][axis] = mesh.point(v)[axis].exact();
            ++k;
        }
        six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    return Exact(six / 6);
}

struct Answers {
    std::size_t cuts = 0, refused = 0, failed = 0, nothing = 0;
    std::size_t unmeshed = 0;    ///< worlds that are no mesh: several edges run between the same points
    double firma = 0, cgal = 0;  ///< cubic metres
    double worst = 0;
    double worst_before = 0;  ///< of worlds, by measure_solid() and by CGAL
};

void compare(const World& world, const Mesh& level, const Exact& before, const Cutter& cutter, const Pose& pose,
             Answers& answers) {
    const CarveResult result = carve(world, cutter, pose);
    ++answers.cuts;
    answers.refused += result.status == CarveStatus::kRefused;
    if (result.status == CarveStatus::kRefused) return;
    Mesh mine = level, other = mesh_of(place_cutter(cutter, pose).value());
    if (!pmp::corefine_and_compute_difference(mine, other, mine)) {
        ++answers.failed;
        return;
    }
    const double taken = CGAL::to_double(Exact(before - volume_of(mine))) / std::pow(kInputSteps, 3);
    answers.firma += result.report.volume;
    answers.cgal += taken;
    if (taken == 0 && result.status == CarveStatus::kNothing)
        ++answers.nothing;
    else
        answers.worst = std::max(answers.worst, std::fabs(result.report.volume / taken - 1));
}

/// Cut after cut; every so many are compared, from the world before each.
void compare_row(World world, const Cutter& cutter, const std::vector<Pose>& poses, std::size_t step,
                 Answers& answers) {
    for (std::size_t k = 0; k < poses.size(); ++k) {
        if (k % step == step - 1) {
            if (const auto mesh = CgalSolid(world.solid()).mesh()) {
                const Exact before = volume_of(*mesh);
                const double by_cgal = CGAL::to_double(before) / std::pow(kInputSteps, 3);
                answers.worst_before =
                    std::max(answers.worst_before, std::fabs(measure_solid(world).volume / by_cgal - 1));
                compare(world, *mesh, before, cutter, poses[k], answers);
            } else {
                ++answers.unmeshed;
            }
        }
        world = carve(world, cutter, poses[k]).world;
    }
}

int measure(const Settings& settings) {
    Table table("cgal_exact",
                {"cuts of", "cuts", "nothing to take", "refused", "not cut by CGAL", "Firma took m3", "CGAL took m3",
                 "volumes differ by at most", "worlds that are no mesh", "volumes of worlds differ by at most"});
    bool same = true;
    const auto add = [&](std::string name, const Answers& answers) {
        table.add({std::move(name), count(answers.cuts), count(answers.nothing), count(answers.refused),
                   count(answers.failed), std::to_string(answers.firma), std::to_string(answers.cgal),
                   number(answers.worst), count(answers.unmeshed), number(answers.worst_before)});
        same = same && answers.worst <= kMostOff && answers.worst_before <= kMostOff;
    };
    const std::size_t craters = settings.quick ? 5 : 100, step = settings.quick ? 20 : 3;
    {
        const Level level = crater_level(1);
        const World world = carvable_world(level);
        const Mesh mesh = mesh_of(level);
        const Exact before = volume_of(mesh);
        Answers answers;
        for (std::size_t k = 0; k < craters; ++k)
            compare(world, mesh, before, crater(), crater_pose(1, CraterPlaces::kSpread, k), answers);
        add("a room, by craters", answers);
    }
    for (const scenes::SweepTool tool : scenes::kSweepTools) {
        const scenes::Sweep sweep = scenes::make_sweep(tool, 3);
        const World world = carvable_world(sweep.block);
        const Mesh mesh = mesh_of(sweep.block);
        const Exact before = volume_of(mesh);
        Answers answers;
        for (std::size_t k = 0; k < sweep.poses.size(); k += step)
            compare(world, mesh, before, sweep.tool, sweep.poses[k], answers);
        add("a block, by " + std::string(scenes::name_of(tool)), answers);
    }
    const std::size_t apart = settings.quick ? 20 : 3;
    {
        std::vector<Pose> poses;
        for (std::size_t k = 0; k < (settings.quick ? 40u : 300u); ++k)
            poses.push_back(crater_pose(1, CraterPlaces::kSpread, k));
        Answers answers;
        compare_row(carvable_world(crater_level(1)), crater(), poses, apart, answers);
        add("a room after craters, by one more", answers);
    }
    for (const scenes::SweepTool tool : scenes::kSweepTools) {
        scenes::Sweep sweep = scenes::make_sweep(tool, 3);
        if (settings.quick) sweep.poses.resize(40);
        Answers answers;
        compare_row(carvable_world(sweep.block), sweep.tool, sweep.poses, apart, answers);
        add("a block after " + std::string(scenes::name_of(tool)) + ", by one more", answers);
    }
    return table.finish(settings.csv) && same ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Volumes of single cuts by Firma and by CGAL with exact constructions."));
}
