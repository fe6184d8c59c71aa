// SPDX-License-Identifier: MIT
// Random vectors that are the same by every compiler: which of two draws in one expression comes first, each decides.
#pragma once

#include "scenes/rng.h"

namespace firma::test {

/// In any direction, of a length in between.
inline Vec3 random_vector(scenes::Rng& rng, double shortest, double longest) {
    const double length = rng.uniform(shortest, longest);
    return rng.direction() * length;
}

}  // namespace firma::test
