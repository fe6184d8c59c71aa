// SPDX-License-Identifier: MIT
// A touch between a sweep and one polygon, before it is dressed up as a hit.
#pragma once

#include <cstdint>

#include "firma/hit.h"

namespace firma {

struct Contact {
    Status status = Status::kMiss;
    Feature feature = Feature::kFace;
    std::uint32_t index = 0;  ///< of the vertex, or of the edge's first corner
    double t = 0;             ///< in the sweep's parameter, 0..end

    bool touched() const { return status != Status::kMiss; }
};

}  // namespace firma
