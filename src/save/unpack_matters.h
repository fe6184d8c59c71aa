// SPDX-License-Identifier: MIT
// What a saved world is made of.
#pragma once

#include <memory>

#include "save/entries.h"
#include "solid/matter_pieces.h"

namespace firma {

/// Null where the file says nothing of it.
/// @param materials  how many the world has
std::shared_ptr<const MatterPieces> unpack_matters(Sections& sections, std::size_t materials, Damage& damage);

}  // namespace firma
