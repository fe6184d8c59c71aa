// SPDX-License-Identifier: MIT
// Casts by every kernel of the lanes that this processor runs, and without lanes.
#pragma once

#include "world/sweep_lanes.h"

namespace firma::test {

/// Calls function(name) with each kernel in use in turn, then with none, and goes back to the best one.
template <class Function>
void with_every_kernel(const Function& function) {
    for (const LaneKernel& kernel : lane_kernels()) {
        take_lane_kernel(&kernel);
        function(kernel.name);
    }
    take_lane_kernel(nullptr);
    function("one by one");
    if (!lane_kernels().empty()) take_lane_kernel(&lane_kernels()[0]);
}

}  // namespace firma::test
