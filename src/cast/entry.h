// SPDX-License-Identifier: MIT
// When a moving sphere enters a vertex's ball or an edge's cylinder: the answer of one quadratic.
#pragma once

namespace firma {

struct Entry {
    enum Kind : unsigned char {
        kNone,      ///< never, or not on this path
        kFound,     ///< at t
        kDoubtful,  ///< double cannot tell, or would lose digits: ask again in double-double
    };
    Kind kind = kNone;
    double t = 0;
};

/// The sine of the angle at which the path meets the surface, below which digits are lost: an error of e across the
/// path moves the contact by e / sine along it. And its square.
inline constexpr double kShallowSine = 1.0 / 8;
inline constexpr double kShallow = kShallowSine * kShallowSine;

/// Within this share of the path's end, double cannot tell whether a touch still counts.
inline constexpr double kNearEnd = 0x1p-40;

inline bool near_end(double t, double end) {
    return t > end * (1 - kNearEnd) && t < end * (1 + kNearEnd);
}

/// A radius within this factor of the rounding of positions says nothing in double.
inline constexpr double kTinyRadius = 0x1p-16;

}  // namespace firma
