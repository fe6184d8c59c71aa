// SPDX-License-Identifier: MIT
// What may be carved: zones and materials that refuse a cut or shrink it, and limits on what one edit may do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/vec.h"

namespace firma {

/// A region that resists cutters whose surface or inside reaches into it.
struct CarveZone {
    std::string name;  ///< for messages
    Box box;           ///< metres, closed
    double hardness =
        1;  ///< 1 refuses the cut; below, the cutter is shrunk to (1 - hardness) of its scale; 0 does nothing
};

/// Carried by the World. An edit that breaks a rule is refused and says which; the world stays as it was.
struct CarveRules {
    std::vector<CarveZone> zones;
    /// By material (index as in World::material_name); missing ones are 0. A cut that takes something of a face of
    /// hardness 1 is refused; below, the cutter is shrunk to (1 - hardness) of its scale, by the hardest face met.
    std::vector<double> hardness;

    std::size_t most_faces = std::size_t(1) << 30;  ///< in the world after an edit
    std::size_t most_faces_looked_at = 4'000'000;   ///< by one edit
    std::size_t most_new_faces = 4'000'000;         ///< by one edit
    std::size_t most_cutter_triangles = 1'000'000;  ///< of one cutter
    /// Of two triangles of the cutter, or of one and a face of the world, tested by one edit: to judge the cutter and
    /// to cut, in all its tries together. Looking at all corners of a face counts once for every 64 of them, and moving
    /// a cutter of more than 2,000 vertices once for each of its triangles.
    std::size_t most_pairs = 20'000'000;
    std::size_t most_corners = 20'000;  ///< of one new face; dividing it into facets takes their square
    double largest_cutter = 16384;      ///< metres along any axis, once placed
};

}  // namespace firma
