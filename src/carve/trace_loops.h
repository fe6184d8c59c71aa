// SPDX-License-Identifier: MIT
// From labels and segments to the loops of new faces.
#pragma once

#include "carve/cut_state.h"

namespace firma {

/// Splits every cut edge once and traces the loops of the faces that change: pieces of the world's faces outside the
/// cutter, and pieces of the cutter's triangles inside the solid (when filling: outside of it). Fills new_edges,
/// new_faces and gone.
Verdict trace_loops(Cut& cut);

}  // namespace firma
