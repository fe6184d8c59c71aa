// SPDX-License-Identifier: MIT
// Whether the shells of a cutter lie in each other as boundaries do, and all that a placed cutter must pass.
#pragma once

#include <cstdint>
#include <optional>

#include "carve/check_crossing.h"
#include "carve/place_cutter.h"

namespace firma {

/// A triangle of a shell that is turned the wrong way: outward within a solid part, or inward anywhere else. Around
/// such a shell a point would be in the cutter twice, or less than not at all.
///
/// @param placed  with its topology; find_crossing() found nothing
/// @param budget  may be null; once spent(), nothing is known
std::optional<std::uint32_t> find_wrong_shell(const PlacedCutter& placed, PairBudget* budget = nullptr);

/// Whether a placed cutter bounds a solid: it does not cross itself, and its shells are turned as they should be.
///
/// @param budget  may be null
/// @return nothing; kInvalid with the triangles; kTooLarge once the budget is spent
std::optional<Error> check_cutter(const PlacedCutter& placed, PairBudget* budget = nullptr);

}  // namespace firma
