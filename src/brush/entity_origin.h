// SPDX-License-Identifier: MIT
// Where a point entity stands.
#pragma once

#include <optional>

#include "firma/brush_level.h"

namespace firma {

/// The entity's `origin` in metres; nothing where it has none, or it is no three numbers with blanks between them.
std::optional<Vec3> entity_origin(const BrushLevel& level, const Entity& entity);

}  // namespace firma
