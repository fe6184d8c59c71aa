// SPDX-License-Identifier: MIT
// Judges a BrushLevel that anybody may have made: indices, counts, planes, surfaces.
#pragma once

#include <optional>

#include "firma/brush_level.h"

namespace firma {

/// The first thing that keeps a level of brushes from being joined, with its brush and side: what BrushLevel,
/// Brush and BrushSide say of their members and does not hold. kInvalid; kTooLarge for 2^20 sides or more.
std::optional<Error> judge_brush_level(const BrushLevel& level);

}  // namespace firma
