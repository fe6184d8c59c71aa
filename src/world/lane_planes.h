// SPDX-License-Identifier: MIT
// When a particle's path crosses the planes of triangles, in double, side by side; compiled once for each kind of
// processor.
#include <hwy/highway.h>

#include "cast/entry.h"
#include "geometry/rounding.h"
#include "solid/face_lanes.h"
#include "world/lane_vectors.h"
#include "world/sweep_lanes.h"

#if defined(FIRMA_LANE_PLANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRMA_LANE_PLANES_H
#undef FIRMA_LANE_PLANES_H
#else
#define FIRMA_LANE_PLANES_H
#endif

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

#if HWY_TARGET == HWY_WASM  // Highway has no doubles here
constexpr std::uint32_t kDoublesAtOnce = 1;
using Doubles = double;
using Steps = std::int32_t;
HWY_INLINE Doubles each(double x) {
    return x;
}
HWY_INLINE Steps load_steps(const FaceLanes& lanes, int c, int axis, std::uint32_t lane) {
    return lanes.steps(std::uint32_t(c), axis, lane);
}
HWY_INLINE Steps less(Steps a, Steps b) {
    return a - b;
}
HWY_INLINE Doubles as_doubles(Steps a) {
    return a;
}
HWY_INLINE Doubles size_of(Doubles a) {
    return std::fabs(a);
}
using Truths = bool;
HWY_INLINE Truths greater(Doubles a, Doubles b) {
    return a > b;
}
HWY_INLINE Truths both(Truths a, Truths b) {
    return a && b;
}
HWY_INLINE Truths either(Truths a, Truths b) {
    return a || b;
}
HWY_INLINE Truths differ(Truths a, Truths b) {
    return a != b;
}
HWY_INLINE Truths but_not(Truths a, Truths b) {
    return a && !b;
}
HWY_INLINE unsigned bits_of(Truths a) {
    return a;
}
HWY_INLINE void put(Doubles a, double* to) {
    *to = a;
}
HWY_INLINE Doubles times(Doubles a, Doubles b) {
    return a * b;
}
HWY_INLINE Doubles plus(Doubles a, Doubles b) {
    return a + b;
}
HWY_INLINE Doubles minus(Doubles a, Doubles b) {
    return a - b;
}
HWY_INLINE Doubles over(Doubles a, Doubles b) {
    return a / b;
}
HWY_INLINE Doubles larger(Doubles a, Doubles b) {
    return a > b ? a : b;
}
#else
const hn::CappedTag<double, 8> kDoubles;
constexpr std::uint32_t kDoublesAtOnce = std::uint32_t(hn::MaxLanes(kDoubles));
using Doubles = hn::Vec<decltype(kDoubles)>;
const hn::Rebind<std::int32_t, decltype(kDoubles)> kSteps;
using Steps = hn::Vec<decltype(kSteps)>;
HWY_INLINE Doubles each(double x) {
    return hn::Set(kDoubles, x);
}
HWY_INLINE Steps load_steps(const FaceLanes& lanes, int c, int axis, std::uint32_t lane) {
    const hn::Rebind<std::int16_t, decltype(kDoubles)> halves;
    const Steps upper = hn::PromoteTo(kSteps, hn::LoadU(halves, lanes.corner[c][axis] + lane));
    if (!lanes.is_wide()) return upper;
    const Steps lower = hn::PromoteTo(kSteps, hn::LoadU(halves, (&lanes)[1].corner[c][axis] + lane));
    return hn::Or(hn::ShiftLeft<16>(upper), hn::And(lower, hn::Set(kSteps, 0xFFFF)));
}
HWY_INLINE Steps less(Steps a, Steps b) {
    return hn::Sub(a, b);
}
HWY_INLINE Doubles as_doubles(Steps a) {
    return hn::PromoteTo(kDoubles, a);
}
HWY_INLINE Doubles size_of(Doubles a) {
    return hn::Abs(a);
}
using Truths = hn::Mask<decltype(kDoubles)>;
HWY_INLINE Truths greater(Doubles a, Doubles b) {
    return hn::Gt(a, b);
}
HWY_INLINE Truths both(Truths a, Truths b) {
    return hn::And(a, b);
}
HWY_INLINE Truths either(Truths a, Truths b) {
    return hn::Or(a, b);
}
HWY_INLINE Truths differ(Truths a, Truths b) {
    return hn::Xor(a, b);
}
HWY_INLINE Truths but_not(Truths a, Truths b) {
    return hn::AndNot(b, a);
}
HWY_INLINE unsigned bits_of(Truths a) {
    std::uint8_t bytes[8];
    hn::StoreMaskBits(kDoubles, a, bytes);
    return bytes[0];
}
HWY_INLINE void put(Doubles a, double* to) {
    hn::StoreU(a, kDoubles, to);
}
HWY_INLINE Doubles times(Doubles a, Doubles b) {
    return hn::Mul(a, b);
}
HWY_INLINE Doubles plus(Doubles a, Doubles b) {
    return hn::Add(a, b);
}
HWY_INLINE Doubles minus(Doubles a, Doubles b) {
    return hn::Sub(a, b);
}
HWY_INLINE Doubles over(Doubles a, Doubles b) {
    return hn::Div(a, b);
}
HWY_INLINE Doubles larger(Doubles a, Doubles b) {
    return hn::Max(a, b);
}
HWY_INLINE Doubles smaller(Doubles a, Doubles b) {
    return hn::Min(a, b);
}
HWY_INLINE Doubles negated_where_negative(Doubles a, Doubles which) {
    return hn::Xor(a, hn::And(which, hn::SignBit(kDoubles)));
}
#endif

/// What is known of planes: a bit for each triangle, and of those crossed when, and the normal.
struct Crossings {
    alignas(64) double at[kLanes];
#if HWY_TARGET != HWY_WASM  // the module has to be small
    alignas(64) double normal[3][kLanes];
#endif

    unsigned crossed = 0;  ///< on the path and by the latest time, if the line passes between the edges
    unsigned never = 0;    ///< not so; of those that are in neither, double cannot tell
    unsigned away = 0;     ///< the path runs along the normal
};

/// More than kShallow by far more than rounding, so that no angle is clear here and not in polygons.
constexpr double kSurelyShallow = kShallow * (1 + 0x1p-40);

/// The same steps, to the bit, as cast_particle_polygon() takes. Of lanes that are whole the normal is exact.
/// @param wanted  which lanes; of others anything may be said
HWY_INLINE void cross_planes(const FaceLanes& lanes, const LaneQuery& query, unsigned wanted, Crossings& all_found) {
    const Sweep& sweep = *query.sweep.path;
    const Doubles step = each(double(lanes.step));
    const unsigned one_sided = query.front_only ? ~unsigned(lanes.two_sided) : 0u;
    for (std::uint32_t part = 0; part < kLanes; part += kDoublesAtOnce) {
        if ((wanted >> part & ((1u << kDoublesAtOnce) - 1)) == 0) continue;
        Doubles from[3], b[3], c[3];  // the start seen from the first corner; edges from there, in steps
        for (int axis = 0; axis < 3; ++axis) {
            const Steps corner = load_steps(lanes, 0, axis, part);
            b[axis] = as_doubles(less(load_steps(lanes, 1, axis, part), corner));
            c[axis] = as_doubles(less(load_steps(lanes, 2, axis, part), corner));
            const double origin = lanes.origin[axis] * (1 / kSurfaceSteps);
            from[axis] = minus(each(sweep.start[axis]), plus(times(as_doubles(corner), step), each(origin)));
        }
        Doubles n[3];
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            n[axis] = minus(times(b[u], c[v]), times(b[v], c[u]));  // by the square of a step, a power of two
        }
        const auto dot = [](Doubles x, Doubles y, Doubles z, const Doubles* with)
                             HWY_ATTR { return plus(plus(times(x, with[0]), times(y, with[1])), times(z, with[2])); };
        const Doubles height = dot(from[0], from[1], from[2], n);
        const Doubles rise = dot(each(sweep.direction[0]), each(sweep.direction[1]), each(sweep.direction[2]), n);
        const Doubles normal_size = plus(plus(size_of(n[0]), size_of(n[1])), size_of(n[2]));
        const Doubles rise_size = times(each(2), normal_size);
        const Doubles end = plus(height, times(rise, each(sweep.end)));
        const Doubles far = larger(larger(size_of(from[0]), size_of(from[1])), size_of(from[2]));
        const Doubles doubt =
            times(each(firma::rounding(16)), plus(times(far, normal_size), times(rise_size, each(sweep.end))));
        const Doubles t = over(size_of(height), size_of(rise));
        const Doubles shallow = times(dot(n[0], n[1], n[2], n), each(sweep.direction_square * kSurelyShallow));
        const Doubles zero = each(0);
        const Truths turned = greater(size_of(rise), times(each(firma::rounding(8)), rise_size));
        const Truths away = greater(rise, zero);
        const Truths certain = both(turned, both(greater(size_of(height), doubt), greater(size_of(end), doubt)));
        const Truths approaches = differ(greater(height, zero), away),
                     arrives = but_not(approaches, differ(greater(end, zero), away));
        // Near the end, or at too flat an angle, double loses too much.
        const Truths clear = both(greater(t, zero), greater(each(sweep.end * (1 - kNearEnd)), t));
        const Truths sure = both(certain, but_not(clear, greater(shallow, times(rise, rise))));
        const Truths late = greater(t, each(query.latest));
        all_found.never |= bits_of(either(but_not(certain, arrives), both(sure, late))) << part;
        if (one_sided) all_found.never |= bits_of(both(turned, away)) << part & one_sided;
        all_found.crossed |= bits_of(but_not(sure, late)) << part;
        all_found.away |= bits_of(away) << part;
        put(t, all_found.at + part);
#if HWY_TARGET != HWY_WASM
        for (int axis = 0; axis < 3; ++axis) put(n[axis], all_found.normal[axis] + part);
#endif
    }
    all_found.crossed &= ~all_found.never;
}

#if HWY_TARGET != HWY_WASM  // the module has to be small
/// How a path's line passes triangles' edges: a bit for each triangle. Of those that are in neither, double cannot
/// tell.
struct Passes {
    unsigned inside = 0;   ///< on the inner side of all edges
    unsigned outside = 0;  ///< on the outer side of one
};

/// With d the path's direction, w the first corner as seen from its start, b and c the edges from there, the line
/// passes b by b . (d x w), the edge that comes back from c by -c . (d x w), and the third edge by what is left of d .
/// (b x c), which is the sum of all three. Let u be half an ulp of 1, L above the sums of the sizes of the coordinates
/// of b and of c, F above the size of each coordinate of w, all in one unit; those of d are below 2. Each part of d x w
/// is a difference of two products, off by 3 u of their sum for rounding, w's among them, so b . (d x w) is by 36 u L
/// F; and so is c's. Both are below 6 L F. The normal is exact, and d . n, below 2 L L, off by 6 u L L. The third is
/// off by all that and by what the two differences round: by 96 u L F and 10 u L L in all. L is at most twice `size` of
/// the lanes.
/// @param open  lanes that are crossed
HWY_NOINLINE Passes pass_edges(const FaceLanes& lanes, const LaneQuery& query, unsigned open,
                               const Crossings& crossings) {
    const Sweep& sweep = *query.sweep.path;
    const Doubles step = each(double(lanes.step)), zero = each(0);
    const Doubles d[3] = {each(sweep.direction[0]), each(sweep.direction[1]), each(sweep.direction[2])};
    const double longest = 2 * double(lanes.size) / double(lanes.step);  // L, in steps
    Passes found;
    for (std::uint32_t part = 0; part < kLanes; part += kDoublesAtOnce) {
        if ((open >> part & ((1u << kDoublesAtOnce) - 1)) == 0) continue;
        Doubles w[3], b[3], c[3], far = zero;  // w in metres, edges in steps
        for (int axis = 0; axis < 3; ++axis) {
            const Steps corner = load_steps(lanes, 0, axis, part);
            b[axis] = as_doubles(less(load_steps(lanes, 1, axis, part), corner));
            c[axis] = as_doubles(less(load_steps(lanes, 2, axis, part), corner));
            const double origin = lanes.origin[axis] * (1 / kSurfaceSteps);
            w[axis] = minus(plus(times(as_doubles(corner), step), each(origin)), each(sweep.start[axis]));
            far = larger(far, size_of(w[axis]));
        }
        Doubles moment[3], n[3];
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            moment[axis] = minus(times(d[u], w[v]), times(d[v], w[u]));
            n[axis] = hn::Load(kDoubles, crossings.normal[axis] + part);
        }
        const auto dot = [](const Doubles* x, const Doubles* y)
                             HWY_ATTR { return plus(plus(times(x[0], y[0]), times(x[1], y[1])), times(x[2], y[2])); };
        const Doubles rise = dot(d, n);
        // Inward is above 0; of c, the other way round, below.
        const Doubles by_b = negated_where_negative(dot(b, moment), rise);
        const Doubles by_c = negated_where_negative(dot(c, moment), rise);
        const Doubles by_third = plus(minus(times(size_of(rise), step), by_b), by_c);
        const Doubles least = smaller(smaller(by_b, minus(zero, by_c)), by_third);
        const Doubles unsure = times(plus(far, each(double(lanes.size))), each(firma::rounding(128) * longest));
        found.inside |= bits_of(greater(least, unsure)) << part;
        found.outside |= bits_of(greater(zero, plus(least, unsure))) << part;
    }
    return found;
}
#endif

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
