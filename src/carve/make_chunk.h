// SPDX-License-Identifier: MIT
// A loose piece as a solid in a frame of its own.
#pragma once

#include "carve/cut_job.h"
#include "firma/chunk.h"

namespace firma {

/// @param solid  that it came off, before the cut
Chunk make_chunk(const CutPiece& piece, const Solid& solid, double density);

}  // namespace firma
