// SPDX-License-Identifier: MIT
// What a cut opens, piece by connected piece: each pocket is bounded by the faces that the cutter leaves and by what it
// takes of faces that were there.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/cut_view.h"

namespace firma {

struct Pockets {
    static constexpr std::uint32_t kNone = ~0u;
    std::uint32_t count = 0;
    std::vector<std::uint32_t> of_face;   ///< of NewLoops::faces; kNone: a piece of a face that was there
    std::vector<std::uint32_t> of_taken;  ///< of NewLoops::taken
};

/// In order of their first faces, those that the cutter leaves before those that it takes. What hangs together at an
/// edge alone may count as one pocket. The shell of a cavity that lies wholly in the cutter belongs to the pocket
/// around it.
/// @param loops  of a carving, with what it takes
/// Costs the edges of these faces; where there are several shells, some of them turned inward, also exact rays from
/// one vertex of each.
Pockets find_pockets(const CutView& view, const NewLoops& loops);

}  // namespace firma
