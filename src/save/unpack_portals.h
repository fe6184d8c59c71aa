// SPDX-License-Identifier: MIT
// What a saved world says of its rooms besides their faces, and its portals.
#pragma once

#include "save/entries.h"
#include "save/unpack_data.h"

namespace firma {

/// Check the Damage before using what it added. check_world() does the rest: which rooms and polygons are sound.
void unpack_portals(Sections& sections, UnpackedData& unpacked, Damage& damage);

}  // namespace firma
