// SPDX-License-Identifier: MIT
// Where two answers to the same casts differ, and which of them is wrong: by the tests' reference oracle, in rational
// arithmetic, over all triangles near the path.
#pragma once

#include <cstddef>
#include <map>
#include <span>

#include "scale/scale_peer.h"
#include "scale/work.h"

namespace firma::bench {

/// Metres along the path that two stops may lie apart: twice what Bullet stops early by design.
inline constexpr double kStopTolerance = 0.002;

/// Of one peer's answers, in comparison with Firma's.
struct Differences {
    std::size_t asked = 0, hits = 0;  ///< hits of the peer
    std::size_t differ = 0;           ///< from Firma's: hit against miss, or stops too far apart
    std::size_t judged = 0;           ///< of these
    std::size_t wrong = 0, ours_wrong = 0;
    std::size_t missed = 0, false_hits = 0, early = 0, late = 0;  ///< of those where the peer is wrong
    std::size_t leaks = 0, our_leaks = 0;                         ///< misses of rays that must hit, all of them counted
};

class Judge {
public:
    /// @param max_triangles  that are looked at in all, for one set of casts and one peer; then differences count as
    ///                        not judged
    Judge(const TriangleMesh& mesh, std::span<const FloatCast> casts, bool must_hit, double max_triangles)
        : mesh_(mesh), casts_(casts), must_hit_(must_hit), max_(max_triangles) {}

    /// @param theirs  of the first so many casts
    Differences compare(std::span<const double> ours, std::span<const double> theirs);

private:
    /// The fraction by the oracle, kScaleMiss for a miss.
    double truth(std::size_t cast);

    const TriangleMesh& mesh_;
    std::span<const FloatCast> casts_;
    bool must_hit_;
    double max_;
    std::map<std::size_t, double> known_;
};

}  // namespace firma::bench
