// SPDX-License-Identifier: MIT
// A capsule's segment against a side of a polygon, where both meet with their insides.
//
// With w = A - v, the height of the segment over the side is u.w / |u| along u = e x s. The capsule touches when that
// falls to r: t = (u.w - r |u|) / -(u.d), u turned so that u.w >= 0. The touch counts when the foot of A on the plane
// across u lies in the parallelogram of all v + x e - y s with x and y in 0..1, as then v + x e is right below A + y s:
//     x u.u = (w + t d).(s x u),   y u.u = -(w + t d).(u x e)
// Beyond its rim the ends and the corners answer. Side and segment that are parallel have no such touch by themselves.
#pragma once

#include <cmath>

#include "cast/capsule_shape.h"
#include "cast/entry.h"
#include "geometry/exact_triple.h"
#include "geometry/rounding.h"

namespace firma {

/// Sine of the angle between side and segment below which they are parallel: the height then changes along them by less
/// than rounding.
inline constexpr double kParallelSine = 0x1p-80;

inline Entry enter_axis_side(const CapsuleSweep& capsule, const Vec3& v, const Vec3& next) {
    const Vec3 w = capsule.a.start - v, e = next - v, &s = capsule.s, &d = capsule.direction();
    const Vec3 u = cross(e, s);
    const double uu = dot(u, u), all = dot(e, e) * dot(s, s), size = std::sqrt(all), r = capsule.radius();
    const double u_length = std::sqrt(uu), speed = capsule.a.direction_length;
    const double height_error = rounding(32) * size * length(w), fall_error = rounding(32) * size * speed;
    const double turned = dot(u, w) < 0 ? -1 : 1;
    const double height = turned * dot(u, w), fall = -turned * dot(u, d), reach = r * u_length;
    const double reach_error = rounding(32) * size * r;
    if (height - height_error > reach + reach_error + (fall + fall_error) * capsule.end() * (1 + rounding(8)))
        return {};
    if (height > height_error && fall < -fall_error) return {};
    if (uu < kShallow * all || fall < kShallowSine * u_length * speed ||
        height_error + reach_error > kTinyRadius * reach)
        return {Entry::kDoubtful};
    if (height + height_error < reach - reach_error) return {};
    double t = (height - reach) / fall;
    if (near_end(t, capsule.end())) return {Entry::kDoubtful};
    if (t > capsule.end()) return {};
    if (t < 0) t = 0;  // by rounding only: it was found apart at the start
    const Vec3 at = w + d * t;
    const double x = dot(at, cross(s, u)), y = -dot(at, cross(u, e));
    if (!(x >= 0 && x <= uu && y >= 0 && y <= uu)) return {};
    return {Entry::kFound, t};
}

/// The same in double-double: never kDoubtful.
inline Entry enter_axis_side_precisely(const CapsuleSweep& capsule, const Vec3& v, const Vec3& next) {
    using Real = DoubleDouble;
    const VectorOf<Real> w = difference<Real>(capsule.a.start, v), e = difference<Real>(next, v),
                         s = capsule.precise_s(), d = exactly<Real>(capsule.direction());
    VectorOf<Real> u = cross(e, s);
    const Real uu = dot(u, u);
    if (!(uu.high > kParallelSine * kParallelSine * rounded(dot(e, e)) * rounded(dot(s, s)))) return {};
    const Real over = dot(u, w), down = dot(u, d);
    const bool turn = over < 0.0;
    const Real height = turn ? -over : over, fall = turn ? down : -down;
    if (!(0.0 < fall)) return {};
    Real t = (height - Real(capsule.radius()) * square_root(uu)) / fall;
    if (t.high < 0) {
        // Below the parallelogram's side already: the ends and corners answer. By rounding alone it stands there still.
        const double slack = 64 * kDoubleDoubleRoundoff * (height.high + capsule.radius() * std::sqrt(uu.high));
        if (t.high * fall.high < -slack) return {};
        t = 0.0;
    }
    const VectorOf<Real> at = w + d * t;
    const Real x = dot(at, cross(s, u)), y = -dot(at, cross(u, e));
    if (x < 0.0 || uu < x || y < 0.0 || uu < y) return {};
    return counted(capsule.a, t);
}

/// The segment alone, however small the radius: whether it meets the side is decided exactly. Both apart at the start.
/// @return when the capsule touches, or, for radius 0, the segment
inline Entry cross_axis_side(const CapsuleSweep& capsule, const Vec3& v, const Vec3& next) {
    const Vec3 e = next - v, &d = capsule.direction();
    const SumVec<2> s = capsule.exact_s(), w = difference_as_sum(capsule.a.start, v);
    const int over = exact_triple_sign(w, as_sum(e), s), down = exact_triple_sign(as_sum(d), as_sum(e), s);
    if (down == 0 || over == 0 || over == down) return {};
    SumVec<3> last;
    for (int axis = 0; axis < 3; ++axis) {
        last.at[axis][0] = w.at[axis][0];
        last.at[axis][1] = w.at[axis][1];
        last.at[axis][2] = d[axis] * capsule.end();  // a power of two: exact
    }
    if (exact_triple_sign(last, as_sum(e), s) == over) return {};
    // The line of A between the two sides of the parallelogram along e, and between those along s.
    const SumVec<2> from_b = difference_as_sum(capsule.b.start, v),
                    from_next = difference_as_sum(capsule.a.start, next);
    if (exact_triple_sign(as_sum(d), as_sum(e), w) * exact_triple_sign(as_sum(d), as_sum(e), from_b) > 0) return {};
    if (exact_triple_sign(as_sum(d), s, w) * exact_triple_sign(as_sum(d), s, from_next) > 0) return {};
    using Real = DoubleDouble;
    const VectorOf<Real> u = cross(exactly<Real>(e), capsule.precise_s());
    const Real height = dot(u, difference<Real>(capsule.a.start, v)), fall = dot(u, exactly<Real>(d));
    const Real reach = Real(capsule.radius()) * square_root(dot(u, u)) * Real(double(over));
    const double t = rounded((height - reach) / -fall);
    return {Entry::kFound, t < 0 ? 0 : t > capsule.end() ? capsule.end() : t};
}

}  // namespace firma
