// SPDX-License-Identifier: MIT
// Runs the casts of a seeded scene through Firma, every way there is, and has the oracle judge each answer.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/cast_families.h"
#include "tests/reference/judge.h"

namespace firma::reference {

/// What judging came to. Adds up.
struct Tally {
    std::uint64_t casts = 0;  ///< answers judged
    std::uint64_t touched = 0;
    std::uint64_t excused = 0;
    std::array<std::uint64_t, kFaultCount> faults{};
    std::vector<std::string> failures;  ///< the first few, each with all that is needed to see it again

    std::uint64_t errors() const;
    void add(const Tally& other);
    void add(const Verdict& verdict, bool touch, const std::string& repeat);
    /// Whether another failure is still worth describing.
    bool wants_more() const { return failures.size() < 5; }
};

/// Casts through a World one-sided and two-sided, what follows from each hit (on along the path, sliding, bouncing),
/// the pair function, cast_any and cast_all.
/// @param seed  of what is chosen here
Tally judge_scene(const scenes::CastScene& scene, std::uint64_t seed);

/// As make_cast_scene(family, seed, index), judged.
Tally judge_family(const scenes::CastFamily& family, std::uint64_t seed, std::uint64_t index);

/// Polygons and cast with 17 digits, as C++.
std::string describe(const ExactOracle& oracle, const Cast& cast, const std::vector<std::uint32_t>& faces);

}  // namespace firma::reference
