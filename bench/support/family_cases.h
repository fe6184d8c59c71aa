// SPDX-License-Identifier: MIT
// Cases for when the shared ones are missing: the families of scenes/cast_families.h, judged by Firma's own answers,
// which the exact twin of the tests judges in turn.
#pragma once

#include "support/exact_cases.h"

namespace firma::bench {

/// @param scenes_each  of every family
std::vector<ExactCase> family_cases(std::size_t scenes_each);

}  // namespace firma::bench
