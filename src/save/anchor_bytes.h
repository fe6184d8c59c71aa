// SPDX-License-Identifier: MIT
// What holds pieces, as a section of saved worlds and of patches.
#pragma once

#include <memory>

#include "save/entries.h"
#include "save/little_endian.h"
#include "solid/anchors.h"

namespace firma {

void put_anchors(ByteWriter& out, const Anchors& anchors);

/// Null where the file says nothing of it.
std::shared_ptr<const Anchors> unpack_anchors(Sections& sections, Damage& damage);

}  // namespace firma
