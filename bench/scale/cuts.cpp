// SPDX-License-Identifier: MIT
// Craters by Firma in the scenes of bench_scale.
#include "scale/cuts.h"

#include "firma/queries.h"
#include "scenes/rng.h"
#include "support/craters.h"
#include "support/race.h"

namespace firma::bench {

std::vector<Pose> crater_poses(const ScaleScene& scene, const World& world, std::size_t count) {
    std::vector<Pose> poses;
    scenes::Rng rng(17);
    for (const FloatCast& c : casts_of(scene, kKinds[3], world, count)) {
        Pose pose;
        pose.position = closest(world, {c.start[0], c.start[1], c.start[2]}).point;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] += rng.uniform(-0.3, 0.3);
        pose.rotation = random_turn(rng.next());
        poses.push_back(pose);
    }
    return poses;
}

CutTimes cut_by_firma(const World& carvable, const std::vector<Pose>& poses, double budget) {
    CutTimes times;
    const Cutter cutter = crater();
    World world = carvable;
    const double begin = thread_seconds();
    double taken = 0;
    for (const Pose& pose : poses) {
        if (thread_seconds() - begin > budget) break;
        const CutCost cost = cut_crater(world, cutter, pose);
        times.ms.push_back(cost.cpu);
        taken += cost.report.volume;
        times.taken.push_back(taken);
        times.refused += cost.status == CarveStatus::kRefused;
    }
    return times;
}

#ifndef FIRMA_WITH_CGAL
bool has_cgal_cuts() {
    return false;
}

CutTimes cut_by_cgal(const TriangleMesh&, const std::vector<Pose>&, double) {
    return {};
}
#endif

}  // namespace firma::bench
