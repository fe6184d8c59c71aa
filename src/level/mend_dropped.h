// SPDX-License-Identifier: MIT
// Faces that lie on one line are dropped; what they held together is mended.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/level.h"

namespace firma {

/// Where the snap flattens a face to a line, dropping it leaves a T-joint: a corner of it inside the side of a
/// neighbour. The neighbour gets that corner, on its side, which changes nothing of its shape; so a mesh that was
/// closed by such faces stays closed without them.
///
/// @param dropped  outlines of dropped faces, as indices of vertices; those that do not lie on one line change nothing
void mend_dropped(std::vector<std::vector<std::uint32_t>> dropped, Level& level);

}  // namespace firma
