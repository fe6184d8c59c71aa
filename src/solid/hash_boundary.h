// SPDX-License-Identifier: MIT
// What a solid is, whatever it was made by: a hash of planes, materials and loops.
#pragma once

#include <span>
#include <string>

#include "solid/boundary.h"

namespace firma {

/// See hash_solid().
/// @param materials  names by index; one that is missing counts as ""
std::uint64_t hash_boundary(const Boundary& boundary, std::span<const std::string> materials);

}  // namespace firma
