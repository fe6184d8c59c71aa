// SPDX-License-Identifier: MIT
// What the brushes of a level are made of.
#pragma once

#include "firma/brush_level.h"
#include "firma/matter.h"
#include "join/join_brushes.h"
#include "solid/matter_pieces.h"

namespace firma {

/// A brush's matter: what its entity says by a key `matter`; else what most of its sides say by their textures (of
/// equally many, the first); else what the world's entity says; else the first of the table. Names are looked for in
/// the table, then tried as names of textures.
MatterPieces matters_of_brushes(const BrushLevel& level, const JoinedLevel& joined, const MatterTable& table);

}  // namespace firma
