// SPDX-License-Identifier: MIT
// Whether a solid's boundary is what everything relies on: closed, exact, and covered by its facets.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "firma/solid.h"
#include "solid/boundary.h"

namespace firma {

/// See check_solid(). Takes a few microseconds a face.
std::optional<SolidFault> check_boundary(const Boundary& boundary);

/// Whether a sound boundary stays sound where faces are exchanged: those that come are judged as by check_boundary(),
/// and each edge that they or those that go have must be used once each way afterwards, with the faces that stay. Other
/// edges are used as before. Costs the faces exchanged and those near.
/// @param added    facets of the faces that come; facets of one exact face, all of them or none
/// @param removed  likewise of those that go: of `before`
/// @param near     at least those facets of before that meet the boxes of faces that come; each once
std::optional<SolidFault> check_exchange(std::vector<FacetPlace> added, std::span<const FacetPlace> removed,
                                         std::span<const FacetPlace> near);

}  // namespace firma
