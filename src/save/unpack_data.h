// SPDX-License-Identifier: MIT
// What a saved world has besides faces: counters, tolerance, options, materials, rules.
#pragma once

#include "save/entries.h"
#include "world/world_data.h"

namespace firma {

struct UnpackedData {
    WorldData data;  ///< without rooms
    std::size_t rooms = 0;
    bool exact = false;                             ///< whether the exact part is there
    bool has_records = false, has_portals = false;  ///< whether those are
};

/// Check the Damage before using it.
UnpackedData unpack_data(Sections& sections, Damage& damage);

}  // namespace firma
