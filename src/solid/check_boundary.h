// SPDX-License-Identifier: MIT
// Whether a solid's boundary is what everything relies on: closed, exact, and covered by its facets.
#pragma once

#include <optional>

#include "firma/solid.h"
#include "solid/boundary.h"

namespace firma {

/// See check_solid(). Takes a few microseconds a face.
std::optional<SolidFault> check_boundary(const Boundary& boundary);

}  // namespace firma
