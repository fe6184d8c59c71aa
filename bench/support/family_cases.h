// SPDX-License-Identifier: MIT
// Cases of our own: the families of scenes/cast_families.h for when the shared ones are missing, judged by Firma's own
// answers, which the exact oracle of the tests judges in turn; and ordinary ones.
#pragma once

#include "support/exact_cases.h"

namespace firma::bench {

/// @param scenes_each  of every family
std::vector<ExactCase> family_cases(std::size_t scenes_each);

/// Short spheres and rays in a room and over open ground, for the clock: nothing is expected of them.
std::vector<ExactCase> ordinary_cases(std::size_t casts_each);

}  // namespace firma::bench
