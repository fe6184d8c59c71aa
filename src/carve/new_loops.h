// SPDX-License-Identifier: MIT
// What tracing a cut makes: new edges, the loops of new faces, and which faces go.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "carve/cut_input.h"

namespace firma {

/// An edge that the cut makes: part of one that it split, or a segment.
struct NewEdge {
    std::uint32_t from, to;
    const SolidPlane* plane[2];  ///< the patch's and the cutter's
    bool doubled = false;        ///< there are, or may be, others between the same vertices
};

/// A face that the cut makes.
struct NewFace {
    Ref<const SolidPlane> plane;
    std::uint32_t first_use = 0, use_count = 0;    ///< in NewLoops::all_uses
    std::uint32_t first_loop = 0, loop_count = 0;  ///< in NewLoops::loop_ends, counted from first_use
    std::uint32_t face = ~0u;                      ///< the patch's face that it is a piece of; ~0: of the cutter
    std::uint32_t triangle = ~0u;                  ///< the cutter's triangle that it is a piece of; ~0: of the world
    std::uint32_t material = ~0u;                  ///< of one of the cutter; ~0: that of all of them
};

/// An edge of the patch that is several edges now.
struct EdgeDivision {
    std::uint32_t edge = 0;                   ///< the patch's
    std::uint32_t first_part = 0, count = 0;  ///< in NewLoops::parts, along the edge
};

struct NewLoops {
    std::vector<NewEdge> edges;
    std::vector<PatchUse> all_uses;  ///< edges numbered through; see cut_view.h
    std::vector<std::uint32_t> loop_ends;
    std::vector<NewFace> faces;
    std::vector<std::uint32_t> gone;  ///< patch faces that were cut, or taken whole; none that is `replaced`

    // Where CutInput asks for them:
    std::vector<NewFace> taken;           ///< what of the patch's faces is gone: turned as they were
    std::vector<EdgeDivision> divisions;  ///< in order of edges
    std::vector<PatchUse> parts;          ///< of divided edges: edges numbered through, as they run

    std::span<const PatchUse> uses(const NewFace& face) const {
        return {all_uses.data() + face.first_use, face.use_count};
    }
    std::span<const std::uint32_t> ends(const NewFace& face) const {
        return {loop_ends.data() + face.first_loop, face.loop_count};
    }
};

}  // namespace firma
