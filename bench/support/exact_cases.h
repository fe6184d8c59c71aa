// SPDX-License-Identifier: MIT
// Casts with known answers, and a judge of other answers to them.
//
// The cases are ../shared/casts/cases: levels, queries, and results computed with rational arithmetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/hit.h"
#include "firma/level.h"
#include "scenes/cast_families.h"

namespace firma::bench {

/// One row of NAME.expected.csv.
struct Expected {
    Status status = Status::kMiss;
    double fraction = 0;
    std::vector<std::uint32_t> faces;  ///< met first, by index in the file; on a miss the nearest one
    double margin = 0;                 ///< metres: how deep the sphere would have gone; on a miss the clearance
    double first_margin = 0;           ///< the same for `faces` alone
    bool must_hit = false;             ///< from inside a closed room to far outside
};

struct ExactCase {
    std::string name;
    Level level;
    std::vector<std::vector<Vec3>> faces;  ///< corners by index in the file
    std::vector<scenes::CastQuery> casts;
    std::vector<Expected> expected;  ///< one-sided
};

/// All cases below `folder`, in order of name; empty when there are none.
std::vector<ExactCase> read_exact_cases(const std::string& folder);

/// What somebody answers to a cast.
struct Answer {
    bool touched = false;
    double fraction = 0;
    std::uint32_t face = 0;  ///< index in the file
};

/// Counts as ../shared/casts/score.py does, but in double: what lies within its tolerance (1e-9 m, growing with the
/// coordinates) is excused.
struct Verdict {
    std::size_t casts = 0;
    std::size_t hits = 0;         ///< expected
    std::size_t missed = 0;       ///< a clear hit was not reported
    std::size_t missed_hits = 0;  ///< of those, not from a start in touch or overlap
    std::size_t false_hits = 0;   ///< reported where nothing comes near, from behind, or far too early
    std::size_t late = 0;         ///< deeper than the tolerance in what should have stopped it
    std::size_t gross = 0;        ///< missed, false or late by more than 1 mm
    double deepest = 0;           ///< metres: by how much a sphere got into a face, missed ones included

    void judge(const ExactCase& exact, std::size_t cast, const Answer& answer);
    void add(const Verdict& more);
};

}  // namespace firma::bench
