// SPDX-License-Identifier: MIT
// Seeded families of levels and cuts in forced contact: faces in one plane, edges on edges, vertices on faces, edges
// and vertices, the same cutter twice, a cutter equal to a part of the level, inside it, around it.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes/cut_families.h"

namespace firma::scenes {

/// As cut_families(): each is a level with 16 cuts, for make_cut_case(). All that is not cut out of a level's own faces
/// lies on a lattice of 1, 1/2, 1/4 or 1/16 m.
const std::vector<CutFamily>& contact_families();

/// Cuts of every kind that touch a level's faces, for levels that are made otherwise.
/// @param walls  its faces; those with a corner off the input grid are not used, and at least one must be left
std::vector<CutOrder> contact_cuts(const Level& walls, std::uint64_t seed, std::uint64_t index);

}  // namespace firma::scenes
