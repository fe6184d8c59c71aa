// SPDX-License-Identifier: MIT
// A sphere against a vertex.
//
// With w = start - vertex, find the first t >= 0 at which |w + t d| = r. As printed in the article, t comes from
// a t^2 + 2 b t + c with c = w.w - r^2: far from the start both b^2 - a c and c lose all digits of a small radius. Here
// the closest approach comes first, t0 = -(w.d) / (d.d) with c = w + t0 d, and the quadratic is solved about it:
//     d.d s^2 + 2 (c.d) s + |c|^2 - r^2 = 0,   t = t0 + s,   where c.d is what rounding left of 0, and
//     r^2 - |c|^2 = (r - |c|) (r + |c|).
#pragma once

#include "base/seldom.h"
#include "cast/entry.h"
#include "cast/sweep.h"
#include "cast/vector_of.h"
#include "geometry/rounding.h"

namespace firma {

inline Entry enter_vertex(const Sweep& sweep, const Vec3& vertex) {
    const Vec3 w = sweep.start - vertex;
    const double closing = dot(w, sweep.direction);
    if (closing >= 0) return {};  // apart at the start and not coming closer
    const double t0 = -closing / sweep.direction_square;
    const Vec3 c = w + sweep.direction * t0;
    const double distance = length(c);
    const double error = rounding(16) * (length(w) + t0 * sweep.direction_length);
    if (distance - error > sweep.radius) return {};
    const double back = (sweep.radius + error) / sweep.direction_length;
    if (t0 - back > sweep.end * (1 + rounding(8))) return {};

    const double rest = dot(c, sweep.direction);
    const double gap = (sweep.radius - distance) * (sweep.radius + distance);
    const double discriminant = rest * rest + sweep.direction_square * gap;
    const double full = sweep.direction_square * sweep.radius * sweep.radius;
    if (std::fabs(discriminant) < kShallow * full || error > kTinyRadius * sweep.radius) return {Entry::kDoubtful};
    if (discriminant < 0) return {};
    const double t = t0 - (rest + std::sqrt(discriminant)) / sweep.direction_square;
    if (near_end(t, sweep.end)) return {Entry::kDoubtful};
    if (t > sweep.end) return {};
    return {Entry::kFound, t < 0 ? 0 : t};  // before the start by rounding only: it was found apart there
}

/// The same in double-double: never kDoubtful. A discriminant of zero, to the last digit, is a graze and counts.
FIRMA_SELDOM inline Entry enter_vertex_precisely(const Sweep& sweep, const Vec3& vertex) {
    using Real = DoubleDouble;
    const VectorOf<Real> w = difference<Real>(sweep.start, vertex), d = exactly<Real>(sweep.direction);
    const Real closing = dot(w, d);
    if (!(closing < 0.0)) return {};
    const Real square = dot(d, d);
    const Real t0 = -closing / square;
    const VectorOf<Real> c = w + d * t0;
    const Real r = sweep.radius, rest = dot(c, d);
    const Real discriminant = rest * rest + square * (r * r - dot(c, c));
    const double far = std::sqrt(rounded(dot(w, w))) + sweep.radius;
    if (discriminant.high < -8 * kDoubleDoubleRoundoff * rounded(square) * far * sweep.radius) return {};
    const Real t = t0 - (rest + square_root(discriminant)) / square;
    return counted(sweep, t);
}

}  // namespace firma
