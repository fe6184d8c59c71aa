// SPDX-License-Identifier: MIT
// A sphere against an edge.
//
// With w = start - a and e = b - a, the distance from the line through a and b, times |e|, is |m + t n| where m = w x e
// and n = d x e. The first touch solves |m + t n| = r |e| about the closest approach t0 = -(m.n) / (n.n), c = m + t0 n:
//     n.n s^2 + 2 (c.n) s + |c|^2 - r^2 e.e = 0,   t = t0 + s.
// These are the article's a, b and c (with its two slips mended) over e.e, but written so that nothing cancels: no term
// is larger than the distance it stands for. n = 0 is a path along the edge: its ends, the vertices, decide. The touch
// counts when it lies between the ends: 0 <= (w + t d).e <= e.e.
#pragma once

#include "base/seldom.h"
#include "cast/entry.h"
#include "cast/sweep.h"
#include "cast/vector_of.h"
#include "geometry/rounding.h"

namespace firma {

/// @param w, e  each coordinate rounded once at most
inline Entry enter_cylinder(const Sweep& sweep, const Vec3& w, const Vec3& e) {
    const Vec3 m = cross(w, e), n = cross(sweep.direction, e);
    const double ee = dot(e, e), nn = dot(n, n), e_length = std::sqrt(ee);
    const double error_now = rounding(32) * length(w) * e_length;
    const double reach = sweep.radius * e_length;
    const double all = sweep.direction_square * ee;
    if (nn < kShallow * kShallow * all) {  // nearly along the edge
        const double drift = (std::sqrt(nn) + rounding(32) * std::sqrt(all)) * sweep.end;
        if (length(m) - error_now - drift > reach) return {};
        return {Entry::kDoubtful};
    }
    const double n_length = std::sqrt(nn);
    const double t0 = -dot(m, n) / nn;
    const Vec3 c = m + n * t0;
    const double distance = length(c);
    const double error = error_now + rounding(32) * std::fabs(t0) * std::sqrt(all);
    if (distance - error > reach) return {};
    const double slack = error / n_length;
    const double earliest = t0 - reach / n_length - 2 * slack, latest = t0 + slack;
    if (latest < 0 || earliest > sweep.end) return {};
    const double we = dot(w, e), de = dot(sweep.direction, e);
    const double one_end = we + earliest * de, other_end = we + latest * de;
    const double blur = error_now + error;
    if ((one_end < -blur && other_end < -blur) || (one_end > ee + blur && other_end > ee + blur)) return {};

    const double rest = dot(c, n);
    const double discriminant = rest * rest + nn * ((reach - distance) * (reach + distance));
    if (std::fabs(discriminant) < kShallow * all * reach * reach || error > kTinyRadius * reach)
        return {Entry::kDoubtful};
    if (discriminant < 0) return {};
    double t = t0 - (rest + std::sqrt(discriminant)) / nn;
    if (near_end(t, sweep.end)) return {Entry::kDoubtful};
    if (t > sweep.end) return {};
    if (t < 0) {
        if (!(dot(m, n) < 0)) return {};
        t = 0;  // it was found apart from the edge at the start: in touch now by rounding, or beside it
    }
    const double along = we + t * de;
    if (!(along >= 0 && along <= ee)) return {};
    return {Entry::kFound, t};
}

inline Entry enter_edge(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    return enter_cylinder(sweep, sweep.start - a, b - a);
}

/// The same in double-double: never kDoubtful. A discriminant of zero, to the last digit, is a graze and counts.
FIRMA_SELDOM inline Entry enter_cylinder_precisely(const Sweep& sweep, const VectorOf<DoubleDouble>& w,
                                                   const VectorOf<DoubleDouble>& e) {
    using Real = DoubleDouble;
    const VectorOf<Real> d = exactly<Real>(sweep.direction);
    const VectorOf<Real> m = cross(w, e), n = cross(d, e);
    const Real ee = dot(e, e), nn = dot(n, n), mn = dot(m, n);
    const double all = sweep.direction_square * rounded(ee);
    if (!(nn.high > kDoubleDoubleRoundoff * kDoubleDoubleRoundoff * all)) return {};  // along the edge
    if (!(mn < 0.0)) return {};
    const Real t0 = -mn / nn;
    const VectorOf<Real> c = m + n * t0;
    const Real rest = dot(c, n), reach_square = Real(sweep.radius) * Real(sweep.radius) * ee;
    const Real discriminant = rest * rest + nn * (reach_square - dot(c, c));
    const double far = std::sqrt(rounded(dot(w, w))) + rounded(t0) * sweep.direction_length + sweep.radius;
    const double bound = 8 * kDoubleDoubleRoundoff * nn.high * rounded(ee) * far * sweep.radius;
    if (discriminant.high < -bound) return {};
    Real t = t0 - (rest + square_root(discriminant)) / nn;
    if (t.high < 0) t = 0.0;
    const Real along = dot(w, e) + t * dot(d, e);
    if (along < 0.0 || ee < along) return {};
    return counted(sweep, t);
}

inline Entry enter_edge_precisely(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    using Real = DoubleDouble;
    return enter_cylinder_precisely(sweep, difference<Real>(sweep.start, a), difference<Real>(b, a));
}

}  // namespace firma
