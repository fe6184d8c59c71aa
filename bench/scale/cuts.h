// SPDX-License-Identifier: MIT
// Craters in the scenes of bench_scale, by Firma and by CGAL's corefinement.
#pragma once

#include <cstddef>
#include <vector>

#include "firma/cutter.h"
#include "scale/work.h"

namespace firma::bench {

struct CutTimes {
    std::vector<double> ms;     ///< processor time of each, all included
    std::vector<double> taken;  ///< cubic metres, after each in all
    std::size_t refused = 0;    ///< not cut
};

/// Where casts of short spheres start from, a crater within 0.3 m of the nearest surface.
std::vector<Pose> crater_poses(const ScaleScene& scene, const World& world, std::size_t count);

/// @param budget  seconds after which no further cut begins
CutTimes cut_by_firma(const World& carvable, const std::vector<Pose>& poses, double budget);

/// Whether bench_scale was built with CGAL.
bool has_cgal_cuts();
CutTimes cut_by_cgal(const TriangleMesh& level, const std::vector<Pose>& poses, double budget);

}  // namespace firma::bench
