// SPDX-License-Identifier: MIT
// One blast of a list, carved and timed.
#pragma once

#include <cmath>

#include "cli/read_blasts.h"
#include "firma/carve.h"
#include "firma/world.h"

namespace firma::cli {

struct FireOptions {
    CarveOptions carve;
    double slice = INFINITY;  ///< microseconds a call; INFINITY: in one go
};

struct Fired {
    CarveResult result;
    double seconds = 0;        ///< the edit with everything in it: from the call to the world replaced
    double longest_slice = 0;  ///< seconds
};

/// Carves a crater out of `world`, which is replaced by the world after it; what was held of it before is dropped
/// within the time measured.
Fired fire_blast(World& world, const Blast& blast, const FireOptions& options = {});

/// The same of any cutter.
Fired fire_cut(World& world, const Cutter& cutter, const Pose& pose, const FireOptions& options);

/// Whether nothing came of an edit though the cutter reached into faces, all of them castable only and kept.
bool met_only_castable(const CarveResult& result);

/// The value that a share of values, 0 .. 1, does not exceed; 0 for none. Changes their order.
double percentile(std::vector<double>& values, double share);

}  // namespace firma::cli
