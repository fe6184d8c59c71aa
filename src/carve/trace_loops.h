// SPDX-License-Identifier: MIT
// From labels and segments to the loops of new faces.
#pragma once

#include "carve/label.h"
#include "carve/new_loops.h"

namespace firma {

/// Splits every cut edge once and traces the loops of the faces that change: pieces of the world's faces outside the
/// cutter, and pieces of the cutter's triangles inside the solid (when filling: outside of it).
/// @param loops  replaced; keeps its memory
Verdict trace_loops(const CutInput& in, const Crossings& crossings, const CutOrder& order, const Labels& labels,
                    NewLoops& loops);

}  // namespace firma
