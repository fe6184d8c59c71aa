// SPDX-License-Identifier: MIT
#pragma once

#include "firma/brush_world.h"
#include "firma/carve.h"

namespace firma::test {

/// The world of a level in which all that is solid may be carved, its sky too: rules that say so of each material.
/// @param open_faces  whether carvings take along faces that bound no solid
inline World unprotected_world(const BrushLevel& level, bool open_faces) {
    CarveRules rules;
    rules.open_faces = open_faces;
    rules.hardness.assign(level.materials.size(), 0.0);
    return with_rules(make_world(level).value(), rules).value();
}

}  // namespace firma::test
