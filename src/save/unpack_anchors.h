// SPDX-License-Identifier: MIT
// What holds pieces, of a saved world.
#pragma once

#include <memory>

#include "save/entries.h"
#include "solid/anchors.h"

namespace firma {

/// Null where the file says nothing of it.
std::shared_ptr<const Anchors> unpack_anchors(Sections& sections, Damage& damage);

}  // namespace firma
