// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of the brushes of firma_anchor.
#pragma once

#include <cstddef>
#include <vector>

#include "firma/brush_world.h"
#include "firma/world.h"

namespace firma::cli {

struct AnchorBrushes {
    std::size_t volumes = 0;        ///< as anchor_volumes() gives them
    std::vector<EntityNote> notes;  ///< entities and brushes that hold nothing, and why
};

/// @param world  of the level
/// Costs a cut of the solid for each volume.
AnchorBrushes judge_anchors(const BrushLevel& level, const World& world);

}  // namespace firma::cli
