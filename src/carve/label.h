// SPDX-License-Identifier: MIT
// From crossings to labels: their order along each edge, and which vertices lie inside what.
#pragma once

#include <functional>

#include "carve/cut_state.h"

namespace firma {

/// Orders the crossings along every edge; they must alternate between entering and leaving.
Verdict order_cuts(Cut& cut);

/// Whether a cutter vertex that no face's cut tells about lies in the solid: kUnknown when that cannot be told.
using LocateInSolid = std::function<Where(std::uint32_t cutter_vertex)>;

/// Labels all vertices: from the edges that are cut, along those that are not, and by a test of one vertex where no
/// edge of a component is cut.
Verdict label_vertices(Cut& cut, const LocateInSolid& locate);

}  // namespace firma
