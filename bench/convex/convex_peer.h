// SPDX-License-Identifier: MIT
// What divides a mesh into convex hulls, beside Firma.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firma/vec.h"

namespace firma::bench {

struct PeerMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The points of each hull.
using PeerHulls = std::vector<std::vector<Vec3>>;

/// V-HACD 4, on this thread.
/// @param voxels, hulls  its resolution and the most hulls; 400,000 and 64 are its defaults
PeerHulls vhacd_pieces(const PeerMesh& mesh, std::uint32_t voxels, std::uint32_t hulls);

/// HACD, as Bullet's extras have it.
/// @param concavity  metres
PeerHulls hacd_pieces(const PeerMesh& mesh, double concavity);

}  // namespace firma::bench
