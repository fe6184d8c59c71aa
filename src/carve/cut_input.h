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
    kDegenerate,  ///< something touches: the cut goes through an arrangement, see arrange_cut.h
    kBroken,      ///< what cannot be, unless the cutter crosses itself or there is a bug: refuse
};

struct CutInput {
    const SolidPatch& patch;  ///< tiled; all edges not split have their planes
    const CutterSolid& cutter;
    bool fill = false;     ///< add the cutter to the solid rather than take it away
    bool opens = false;    ///< also asked for: what the cutter takes of faces (NewLoops::taken)
    bool divides = false;  ///< also asked for, and with `opens`: how edges are divided (NewLoops::divisions)
};

}  // namespace firma
