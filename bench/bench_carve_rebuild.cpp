// SPDX-License-Identifier: MIT
// The article's motive: after a cut a BSP of the room has to be built again, bins need not be; and Firma's blocks only
// where something changed. Rooms of 600 to 100 thousand faces, a crater in the floor.
#include <algorithm>
#include <cstdio>

#include "naive/plain_bsp.h"
#include "scenes/cut_levels.h"
#include "solid/append_faces.h"
#include "solid/build_blocks.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "world/world_data.h"

namespace firma::bench {
namespace {

constexpr double kPanel = 2.0 / 3;                 // metres: of crater_level's walls
constexpr std::size_t kMostFragments = 3'000'000;  // then the BSP is given up

/// A single room in endless rock, so many panels long and wide, half as high.
World hall(int panels) {
    const double size = panels * kPanel;
    const auto steps = [](double metres) { return std::int64_t(metres * kSurfaceSteps); };
    scenes::PanelBox box;
    box.high = {steps(size), steps(size), steps(size / 2)};
    box.count[0] = box.count[1] = panels;
    box.count[2] = panels / 2;
    box.bump = 0.12;
    box.room = true;
    scenes::Rng rng(5);
    std::vector<scenes::GridPolygon> faces;
    scenes::add_panel_box(faces, box, rng);
    return carvable_world(scenes::level_of(faces));
}

std::vector<BspPolygon> polygons_of(const World& world) {
    std::vector<BspPolygon> polygons;
    for (const Face& face : world.faces()) polygons.push_back(make_bsp_polygon(face.corners));
    return polygons;
}

/// In how many of some random points BSP and world say the same.
std::size_t disagreements(const PlainBsp& bsp, const World& world, double size) {
    scenes::Rng rng(9);
    std::size_t wrong = 0;
    for (int k = 0; k < 1000; ++k) {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(-1, size);
        const Where where = locate(world.solid(), point);
        wrong += where == (bsp.in_air(point) ? Where::kSolid : Where::kAir);
    }
    return wrong;
}

void measure_room(int panels, const Settings& settings, Table& table) {
    const World before = hall(panels);
    const Cutter cutter = crater();
    const double size = panels * kPanel;
    // Craters one at a time in the same room, in places all over its floor.
    const auto pose = [&](int k) {
        scenes::Rng rng(std::uint64_t(k) + 1);
        Pose it;
        it.position.x = rng.uniform(1, size - 1);
        it.position.y = rng.uniform(1, size - 1);
        it.position.z = -0.2;
        it.rotation = random_turn(rng.next());
        it.scale = 1.6;
        return it;
    };
    const World after = carve(before, cutter, pose(0)).world;
    const std::vector<BspPolygon> polygons = polygons_of(after);
    FaceSet faces;
    append_all_faces(*after.data().faces_of(0).tree, faces);
    BlockBuilder builder;
    PlainBsp bsp;
    std::vector<double> bsp_ms, bins_ms, blocks_us, cut_us;
    for (int round = 0; round < std::min(settings.rounds, panels > 50 ? 3 : 9); ++round) {
        double start = thread_seconds();
        bsp.build(polygons, 5, kMostFragments);
        bsp_ms.push_back((thread_seconds() - start) * 1e3);
        start = thread_seconds();
        keep(builder.build(faces, after.data().tree_options).get());
        bins_ms.push_back((thread_seconds() - start) * 1e3);
        for (int k = 0; k < 20; ++k) {
            World world = before;
            const CutCost cost = cut_crater(world, cutter, pose(k));
            blocks_us.push_back(cost.report.times.tree);
            cut_us.push_back(cost.cpu * 1e3);
        }
    }
    const double bsp_time = median(bsp_ms), bins_time = median(bins_ms), blocks_time = median(blocks_us);
    const bool done = !bsp.given_up();
    table.add({count(after.face_count()), done ? number(bsp_time) : "over " + number(bsp_time), number(bins_time),
               number(blocks_time / 1e3), number(median(cut_us) / 1e3),
               (done ? "" : "over ") + times(bsp_time * 1e3 / blocks_time), times(bins_time * 1e3 / blocks_time),
               count(bsp.nodes()), count(bsp.fragments()), std::to_string(bsp.depth()),
               done ? count(disagreements(bsp, after, size + 1)) : "-"});
}

int measure(const Settings& settings) {
    Table table("carve_rebuild", {"faces", "BSP of the room, ms", "bins of the whole room, ms", "Firma's blocks, ms",
                                  "Firma's whole cut, ms", "BSP to blocks", "whole bins to blocks", "BSP nodes",
                                  "BSP polygons", "BSP depth", "BSP and Firma disagree, of 1000 points"});
    std::vector<int> rooms{9, 27, 36, 112};
    if (settings.quick) rooms = {9};
    for (const int panels : rooms) measure_room(panels, settings, table);
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "After a cut: a BSP, bins of the whole room, blocks where it changed."));
}
