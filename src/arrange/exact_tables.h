// SPDX-License-Identifier: MIT
// Planes and points of what is arranged at a time.
#pragma once

#include "arrange/plane_table.h"
#include "arrange/point_table.h"

namespace firma {

struct ExactTables {
    PlaneTable planes;
    PointTable points{planes};

    ExactTables() = default;
    ExactTables(const ExactTables&) = delete;
};

}  // namespace firma
