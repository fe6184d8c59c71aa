// SPDX-License-Identifier: MIT
// What a version of a world holds that another does not.
#pragma once

#include <cstddef>

#include "firma/world.h"

namespace firma {

/// Bytes, counted as memory_used() counts them: for versions of one world, memory_used of both less that of `other`.
/// Opens only blocks that differ, so the cost follows the edits between them; worlds without anything in common are
/// walked whole.
std::size_t bytes_alone(const World& world, const World& other);

}  // namespace firma
