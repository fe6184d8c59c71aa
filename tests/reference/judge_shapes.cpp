// SPDX-License-Identifier: MIT
// What judging shapes came to.
#include "tests/reference/judge_shapes.h"

namespace firma::reference {

void ShapeTally::add(const ShapeTally& other) {
    casts += other.casts;
    hits += other.hits;
    overlaps += other.overlaps;
    misses += other.misses;
    precise += other.precise;
    excused += other.excused;
    wrong += other.wrong;
    if (first_failure.empty()) first_failure = other.first_failure;
}

void ShapeTally::fail(const std::string& what) {
    ++wrong;
    if (first_failure.empty()) first_failure = what;
}

ShapeTally judge_shapes(const ShapeFamily& family, std::uint64_t seed, std::uint64_t count) {
    ShapeTally tally;
    for (const char* c = family.name; *c != 0; ++c) seed = seed * 131 + std::uint64_t(*c);  // other casts for each
    scenes::Rng rng(seed);
    while (tally.casts < count) family.judge_one(rng, tally);
    return tally;
}

}  // namespace firma::reference
