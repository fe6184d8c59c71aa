// SPDX-License-Identifier: MIT
// Queries of `firma cast`: px,py,pz,dx,dy,dz,radius.
#pragma once

#include <string>
#include <vector>

#include "firma/polygon.h"
#include "firma/vec.h"

namespace firma::cli {

struct Query {
    Sphere sphere;
    Vec3 path;
};

/// Every row: query k stands on line k + 2.
/// @throws Failure naming file and line for whatever is not seven finite numbers with a radius of 0 or more that a cast
/// can take
std::vector<Query> read_queries(const std::string& path);

}  // namespace firma::cli
