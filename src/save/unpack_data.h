// SPDX-License-Identifier: MIT
// What a saved world has besides faces: counters, tolerance, options, materials, rules, records of rooms, portals.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "save/entries.h"
#include "solid/solid_face.h"
#include "world/assemble_world.h"

namespace firma {

struct UnpackedData {
    StoredWorld world;  ///< without faces, rooms and portals
    std::size_t faces = 0, rooms = 0;
    bool exact = false;                             ///< whether the exact part is there
    bool has_records = false, has_portals = false;  ///< whether those are

    /// The first is there without a name too.
    std::size_t material_count() const { return std::max<std::size_t>(world.materials->size(), 1); }
};

/// Check the Damage before using it.
UnpackedData unpack_data(Sections& sections, Damage& damage);

/// Adds records of rooms, and portals. Check the Damage before using them. check_world() does the rest: which rooms and
/// polygons are sound.
/// @param exact  of which a portal's polygons may be facets, which are counted; null where the file says nothing of it
void unpack_portals(Sections& sections, UnpackedData& unpacked, const std::vector<Ref<SolidFace>>* exact,
                    Damage& damage);

}  // namespace firma
