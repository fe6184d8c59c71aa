// SPDX-License-Identifier: MIT
// From crossings to labels: which vertices lie inside what.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "carve/order_cuts.h"

namespace firma {

enum class CutSide : std::int8_t { kInside = -1, kUnknown = 0, kOutside = 1 };

struct Labels {
    std::vector<CutSide> world;   ///< of patch vertices: against the cutter
    std::vector<CutSide> cutter;  ///< of cutter vertices: inside the solid, or outside of it
};

/// Whether a cutter vertex that no face's cut tells about lies in the solid: kUnknown when that cannot be told.
using LocateInSolid = std::function<CutSide(std::uint32_t cutter_vertex)>;

/// Labels all vertices: from the edges that are cut, along those that are not, and by a test of one vertex where no
/// edge of a component is cut.
/// @param labels  replaced; keeps its memory
Verdict label_vertices(const CutInput& in, const Crossings& crossings, const CutOrder& order,
                       const LocateInSolid& locate, Labels& labels);

}  // namespace firma
