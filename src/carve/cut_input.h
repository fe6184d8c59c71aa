// SPDX-License-Identifier: MIT
// What all phases of a cut read, and how a phase ends.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/cutter_solid.h"
#include "solid/solid_patch.h"

namespace firma {

/// How a phase ended.
enum class Verdict : std::uint8_t {
    kFine,
    kDegenerate,  ///< a predicate answered zero, or a facet failed its check: move the cutter and start again
    kBroken,      ///< what cannot be, unless the cutter crosses itself or there is a bug: refuse
};

/// Vertices of the cutter's elements that were found in degenerate position, some more than once.
using Touching = std::vector<std::uint32_t>;

/// The verdict of a whole phase, and what it found to touch.
struct PhaseEnd {
    Verdict verdict = Verdict::kFine;
    Touching touching;
};

struct CutInput {
    const SolidPatch& patch;  ///< tiled; all edges not split have their planes
    const CutterSolid& cutter;
    bool fill = false;      ///< add the cutter to the solid rather than take it away
    bool collects = false;  ///< whether phases go on after a degenerate position, to find all there are

    bool stops_at(Verdict verdict) const {
        return verdict == Verdict::kBroken || (verdict == Verdict::kDegenerate && !collects);
    }
};

}  // namespace firma
