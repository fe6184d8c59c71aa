// SPDX-License-Identifier: MIT
// Seeded casts of capsules and hulls against one polygon each, judged by the exact oracles: on lattices, where all ties
// there are come up, in awkward places, and anywhere.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scenes/rng.h"

namespace firma::reference {

struct ShapeTally {
    std::uint64_t casts = 0, hits = 0, overlaps = 0, misses = 0;
    std::uint64_t precise = 0;  ///< questions that double left open
    std::uint64_t excused = 0;  ///< what differs lies within rounding of what was asked
    std::uint64_t wrong = 0;
    std::string first_failure;

    void add(const ShapeTally& other);
    /// One more answer that is wrong.
    void fail(const std::string& what);
};

struct ShapeFamily {
    const char* name;
    void (*judge_one)(scenes::Rng& rng, ShapeTally& tally);
};

std::span<const ShapeFamily> capsule_families();
std::span<const ShapeFamily> hull_families();

/// @param count  casts
ShapeTally judge_shapes(const ShapeFamily& family, std::uint64_t seed, std::uint64_t count);

}  // namespace firma::reference
