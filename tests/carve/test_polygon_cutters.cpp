// SPDX-License-Identifier: MIT
// Cutters with several triangles in one plane, that touch nothing: what they leave has no seam between these.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "carve/cut_job.h"
#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/lattice_solids.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using namespace test;

Solid block() {
    return make_solid(box_level({-4, -4, -4}, {4, 4, 4})).value();
}

/// Runs a cut; `arranged`: whether it touched, and so went through the arrangement.
Solid cut(const Solid& solid, const Cutter& cutter, const Pose& pose, CarveKind kind, std::size_t& faces,
          bool& arranged) {
    CutJob job(solid, cutter, pose, {}, kind);
    while (job.step()) continue;
    arranged = job.arranged();
    EXPECT_EQ(job.status(), CarveStatus::kDone);
    faces = job.take_change().added.owners.size();
    return (kind == CarveKind::kFill ? unite(solid, cutter, pose) : subtract(solid, cutter, pose)).solid;
}

/// Its lowest corner goes to (x, y, z).
Pose low_at(const Cutter& cutter, double x, double y, double z) {
    Vec3 low = cutter.vertices()[0];
    for (const Vec3& v : cutter.vertices())
        for (int axis = 0; axis < 3; ++axis) low[axis] = std::min(low[axis], v[axis]);
    return pose_at(x - low.x, y - low.y, z - low.z);
}

/// The same, but each triangle begins at another of its corners.
Cutter begun_elsewhere(const Cutter& cutter, std::size_t by) {
    TriangleMesh mesh = mesh_of(cutter);
    for (CutterTriangle& corners : mesh.triangles)
        std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(by), corners.end());
    return mesh.cutter().value();
}

/// Cut by the mesh, and by the same as a Solid, which always goes through the arrangement.
void expect_no_seams(const Cutter& cutter, const Pose& pose, CarveKind kind) {
    const Cutter as_solid = cutter_from_solid(unite(Solid(), cutter, pose).solid).value();
    std::size_t faces = 0, wanted = 0;
    bool arranged = false, arranged_solid = false;
    const Solid made = cut(block(), cutter, pose, kind, faces, arranged);
    const Solid by_solid = cut(block(), as_solid, Pose(), kind, wanted, arranged_solid);
    EXPECT_FALSE(arranged);
    EXPECT_TRUE(arranged_solid);
    EXPECT_EQ(faces, wanted);
    const auto fault = check_solid(made);
    EXPECT_FALSE(fault) << fault->what;
    EXPECT_TRUE(same_solid(made, by_solid));
    EXPECT_EQ(hash_solid(made), hash_solid(by_solid));
    EXPECT_EQ(measure_solid(made).volume, measure_solid(by_solid).volume);
}

struct Tool {
    Cutter cutter;
    std::string name;
};

std::vector<Tool> tools() {
    scenes::Rng rng(5);
    std::vector<Tool> made;
    const auto add = [&](const char* name, const scenes::LatticeSolid& solid) {
        Vec3 at;
        made.push_back({scenes::cutter_of(scenes::scaled(solid, kSurfacePerInput * 512), name, at), name});
    };
    add("sponge", scenes::sponge_solid(1));
    add("sponge of level 2", scenes::sponge_solid(2));
    add("letter E", scenes::letter_solid('E', 7));
    add("letter O", scenes::letter_solid('O', 9));
    add("gear", scenes::gear_solid(rng, 12));
    add("terrain", scenes::column_terrain(rng, 6, 5));
    made.push_back({box_mesh({0, 0, 0}, {1, 1.25, 1.5}).cutter().value(), "box"});
    return made;
}

TEST(PolygonCutters, LeaveNoSeams) {
    for (const Tool& tool : tools())
        for (const CarveKind kind : {CarveKind::kCarve, CarveKind::kFill}) {
            SCOPED_TRACE(tool.name);
            SCOPED_TRACE(kind == CarveKind::kFill ? "fill" : "carve");
            // Through faces, an edge and a corner of the block; nothing of both lies in one plane.
            for (const std::size_t by : {0, 1, 2})
                expect_no_seams(begun_elsewhere(tool.cutter, by), low_at(tool.cutter, 3.7001, 0.3003, 0.2007), kind);
            expect_no_seams(tool.cutter, low_at(tool.cutter, 3.7001, 3.6003, 0.2007), kind);
            expect_no_seams(tool.cutter, low_at(tool.cutter, 3.7001, 3.6003, 3.5007), kind);
        }
}

TEST(PolygonCutters, LeaveRoomsWithoutSeams) {
    for (const Tool& tool : tools()) {
        SCOPED_TRACE(tool.name);
        expect_no_seams(tool.cutter, low_at(tool.cutter, 0.1001, 0.3003, 0.2007), CarveKind::kCarve);
        expect_no_seams(tool.cutter, low_at(tool.cutter, 6.1001, 0.3003, 0.2007), CarveKind::kFill);
    }
}

}  // namespace
}  // namespace firma
