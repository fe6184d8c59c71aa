// SPDX-License-Identifier: MIT
// Judges the answer of a cast against the exact oracle: what is an error, what lies within the tolerances.
//
// The tolerances are those of ../shared/casts/score.py, measured at start + fraction * path exactly. Stricter than
// there: a late answer is looked for at every face, not only at those met first; the face normal must point as wound;
// indices of features must fit; a hit must not lie inside an overlap that was to be ignored.
#pragma once

#include <cmath>
#include <string>

#include "firma/hit.h"
#include "tests/reference/exact_oracle.h"

namespace firma::reference {

enum class Fault : std::uint8_t {
    kNone,
    kMissed,    ///< a clear hit was not reported
    kFalse,     ///< nothing there to stop at
    kLate,      ///< the sphere is deeper than the tolerance in a face it should have stopped at
    kEarly,     ///< stops short of the face it reports, though something is met later
    kFraction,  ///< a clear and steep contact at the wrong place along the path
    kFields,    ///< centre, point, normals, feature, status or safe_fraction do not fit
};
inline constexpr int kFaultCount = 7;
const char* name_of(Fault fault);

struct Verdict {
    Fault fault = Fault::kNone;
    bool excused = false;  ///< not the exact answer, but within the tolerances
    std::string text;      ///< for people; empty when right
    bool ok() const { return fault == Fault::kNone; }
};

/// What was answered.
struct Answer {
    PolygonHit hit;
    std::uint32_t face = 0;      ///< index into the oracle's polygons
    double safe_fraction = NAN;  ///< NaN is not judged
    double contact_offset = 0.001;
    bool must_hit = false;  ///< from inside a closed room to outside: no margin excuses a miss
};

/// Over all faces.
Verdict judge(const ExactOracle& oracle, const Cast& cast, const Answer& answer);
/// Among this face alone.
Verdict judge_face(const ExactOracle& oracle, const Cast& cast, const Answer& answer);

/// Whether reporting a miss of `face` is beyond excuse.
bool is_clear(const ExactOracle& oracle, const Cast& cast, std::uint32_t face);

}  // namespace firma::reference
