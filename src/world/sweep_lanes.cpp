// SPDX-License-Identifier: MIT
// A sweep through an index, eight at a time: compiled once for each kind of processor, of which the best is taken.
//
// No products and sums are fused: each kind of processor computes the same bits, so that it looks at the same boxes and
// faces, in the same order.
#include "world/sweep_lanes.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/assert.h"
#include "solid/lay_out_faces.h"

#ifdef FIRMA_SIMD

// Those that are worth it, and whose vectors have a size that the compiler knows. A name that this version of Highway
// does not have counts as 0 where these are chosen, and is given that value for what follows.
#if defined(_WIN32)  // GCC does not align what it keeps of wider vectors on the stack there (its bug 54412)
#define FIRMA_TOO_WIDE (HWY_AVX2 | HWY_AVX3)
#else
#define FIRMA_TOO_WIDE 0
#endif
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS                                                                                \
    (HWY_SSE2 | HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX3_ZEN4 | HWY_AVX3_SPR | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
     HWY_SVE2_128 | HWY_RVV | FIRMA_TOO_WIDE)
#include <hwy/detect_targets.h>
#ifndef HWY_SSE2
#define HWY_SSE2 0LL
#endif
#ifndef HWY_AVX3_ZEN4
#define HWY_AVX3_ZEN4 0LL
#endif
#ifndef HWY_AVX3_SPR
#define HWY_AVX3_SPR 0LL
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/sweep_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::uint32_t kLanes = 8;
constexpr float kRoundoff = 0x1p-24f;
constexpr float kLess = 1 - 16 * kRoundoff, kMore = 1 + 16 * kRoundoff;

const hn::CappedTag<float, kLanes> kFloats;
using Floats = hn::Vec<decltype(kFloats)>;
const hn::Rebind<std::uint8_t, decltype(kFloats)> kBytes;
const hn::Rebind<std::int32_t, decltype(kFloats)> kInts;
constexpr std::uint32_t kAtOnce = std::uint32_t(hn::MaxLanes(kFloats));

HWY_INLINE Floats all(float x) {
    return hn::Set(kFloats, x);
}
HWY_INLINE Floats add(Floats a, Floats b) {
    return hn::Add(a, b);
}
HWY_INLINE Floats dot(const Floats* a, const Floats* b) {
    return add(add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}
HWY_INLINE void cross(const Floats* a, const Floats* b, Floats* c) {
    c[0] = hn::Sub(hn::Mul(a[1], b[2]), hn::Mul(a[2], b[1]));
    c[1] = hn::Sub(hn::Mul(a[2], b[0]), hn::Mul(a[0], b[2]));
    c[2] = hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
}
HWY_INLINE unsigned bits(hn::Mask<decltype(kFloats)> mask) {
#if HWY_TARGET == HWY_WASM  // Highway has several instructions here, and no doubles
    return wasm_i32x4_bitmask(mask.raw);
#else
    std::uint8_t bytes[8];
    hn::StoreMaskBits(kFloats, mask, bytes);
    return bytes[0];
#endif
}

/// What follows from a sweep, all coordinates together.
HWY_INLINE void make_ready(LaneSweep& sweep) {
    constexpr float kSteepest = 1e18f;  // stands for a slope that is infinite
#if HWY_TARGET == HWY_WASM
    for (int k = 0; k < 3; ++k) {
        const double from = sweep.start[k], grown = sweep.grown[k];
        const float way = float(sweep.direction[k]), low = float(from - grown), high = float(from + grown);
        const float slope = std::fabs(way) * kSteepest > 1 ? 1 / way : kSteepest;
        sweep.along[k] = way;
        sweep.inverse[k] = slope;
        sweep.early[k] = slope * kLess;
        sweep.late[k] = slope * kMore;
        sweep.turned[k] = slope < 0;
        sweep.ahead[k] = slope < 0 ? low : high;
        sweep.behind[k] = slope < 0 ? high : low;
    }
#else
    const hn::CappedTag<double, 4> doubles;
    const hn::Rebind<float, decltype(doubles)> floats;
    const hn::RebindToUnsigned<decltype(floats)> numbers;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
        const auto from = hn::LoadU(doubles, sweep.start + k), grown = hn::LoadU(doubles, sweep.grown + k);
        const auto way = hn::DemoteTo(floats, hn::LoadU(doubles, sweep.direction + k));
        const auto steepest = hn::Set(floats, kSteepest), one = hn::Set(floats, 1);
        const auto slope = hn::IfThenElse(hn::Gt(hn::Mul(hn::Abs(way), steepest), one), hn::Div(one, way), steepest);
        const auto down = hn::Lt(slope, hn::Zero(floats));
        const auto low = hn::DemoteTo(floats, hn::Sub(from, grown)), high = hn::DemoteTo(floats, hn::Add(from, grown));
        hn::StoreU(way, floats, sweep.along + k);
        hn::StoreU(slope, floats, sweep.inverse + k);
        hn::StoreU(hn::Mul(slope, hn::Set(floats, kLess)), floats, sweep.early + k);
        hn::StoreU(hn::Mul(slope, hn::Set(floats, kMore)), floats, sweep.late + k);
        hn::StoreU(hn::IfThenElse(down, low, high), floats, sweep.ahead + k);
        hn::StoreU(hn::IfThenElse(down, high, low), floats, sweep.behind + k);
        hn::StoreU(hn::BitCast(numbers, hn::VecFromMask(floats, down)), numbers, sweep.turned + k);
    }
#endif
    sweep.ready = true;
}

/// A point's coordinates: four in a row, as often as they fit.
#if HWY_TARGET == HWY_SCALAR
struct Point {
    float at[4];
};
HWY_INLINE Point load_point(const float* from) {
    return {{from[0], from[1], from[2], 0}};
}
template <class Compute>
HWY_INLINE Point by_coordinate(const Compute& compute, const Point& a, const Point& b, const Point& c, const Point& d) {
    Point result{};
    for (int k = 0; k < 3; ++k)
        result.at[k] = hn::GetLane(compute(all(a.at[k]), all(b.at[k]), all(c.at[k]), all(d.at[k])));
    return result;
}
template <int axis>
HWY_INLINE Floats spread(const Point& point) {
    return all(point.at[axis]);
}
#else
using Point = Floats;
HWY_INLINE Point load_point(const float* from) {
    return hn::LoadDup128(kFloats, from);
}
template <class Compute>
HWY_INLINE Point by_coordinate(const Compute& compute, Point a, Point b, Point c, Point d) {
    return compute(a, b, c, d);
}
template <int axis>
HWY_INLINE Floats spread(Point point) {
    return hn::Broadcast<axis>(point);
}
#endif

/// What every node asks of a sweep, in registers.
struct Way {
    Point early, late;  ///< the inverse of the direction, less and more by what times are lowered and raised
    Point ahead, behind;
    std::uint32_t near[3], far[3];  ///< by axis: which of a node's sides is passed first, and last

    HWY_INLINE explicit Way(const LaneSweep& sweep)
        : early(load_point(sweep.early)),
          late(load_point(sweep.late)),
          ahead(load_point(sweep.ahead)),
          behind(load_point(sweep.behind)) {
        for (int axis = 0; axis < 3; ++axis) {
            near[axis] = sweep.turned[axis] != 0;
            far[axis] = 1 - near[axis];
        }
    }
};

/// Times at which the sphere is in a node's boxes, by `latest`; a bit for each that it is in.
HWY_INLINE unsigned enter(const WideNode& node, const Way& way, float latest, float* times) {
    const Point base = load_point(node.base), scale = load_point(node.scale);
    const auto first = [](Floats corner, Floats size, Floats ahead, Floats slope) HWY_ATTR {
        const Floats unsure = hn::Mul(hn::Abs(hn::Mul(size, slope)), all(0x1p-13f));
        return hn::Sub(hn::Mul(hn::Sub(corner, ahead), slope), unsure);
    };
    const auto last = [](Floats corner, Floats size, Floats behind, Floats slope) HWY_ATTR {
        const Floats unsure = hn::Mul(hn::Abs(hn::Mul(size, slope)), all(0x1p-13f));
        return add(hn::Mul(hn::Sub(corner, behind), slope), unsure);
    };
    const auto one_step = [](Floats, Floats size, Floats, Floats slope) HWY_ATTR { return hn::Mul(size, slope); };
    const Point from = by_coordinate(first, base, scale, way.ahead, way.early);
    const Point to = by_coordinate(last, base, scale, way.behind, way.late);
    const Point early = by_coordinate(one_step, base, scale, way.behind, way.early);
    const Point late = by_coordinate(one_step, base, scale, way.behind, way.late);
    const Floats strides_in[3] = {spread<0>(early), spread<1>(early), spread<2>(early)};
    const Floats strides_out[3] = {spread<0>(late), spread<1>(late), spread<2>(late)};
    const Floats ins[3] = {spread<0>(from), spread<1>(from), spread<2>(from)};
    const Floats outs[3] = {spread<0>(to), spread<1>(to), spread<2>(to)};
    unsigned met = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        const auto passed = [&](int axis, std::uint32_t which, Floats stride, Floats start) HWY_ATTR {
            const auto at = hn::PromoteTo(kInts, hn::LoadU(kBytes, node.side[which][axis] + part));
            return add(hn::Mul(hn::ConvertTo(kFloats, at), stride), start);
        };
        const auto enters = [&](int axis)
                                HWY_ATTR { return passed(axis, way.near[axis], strides_in[axis], ins[axis]); };
        const auto leaves = [&](int axis)
                                HWY_ATTR { return passed(axis, way.far[axis], strides_out[axis], outs[axis]); };
        const Floats in = hn::Max(hn::Max(enters(0), enters(1)), hn::Max(enters(2), hn::Zero(kFloats)));
        const Floats out = hn::Min(hn::Min(leaves(0), leaves(1)), hn::Min(leaves(2), all(latest)));
        hn::Store(in, kFloats, times + part);
        met |= bits(hn::Le(in, out)) << part;
    }
    return met & ((1u << node.count) - 1);
}

/// Narrows [in, out] to the times t with b t <= w.
HWY_INLINE void clip(Floats b, Floats w, Floats& in, Floats& out) {
    constexpr float kLevel = 0x1p-120f;
    b = hn::IfThenElse(hn::Lt(hn::Abs(b), all(kLevel)), all(kLevel), b);
    const Floats t = hn::Div(w, b);
    const auto falls = hn::Lt(b, hn::Zero(kFloats));
    in = hn::IfThenElse(falls, hn::Max(in, t), in);
    out = hn::IfThenElse(falls, out, hn::Min(out, t));
}

/// How many axes an extent has, where that is not known when this is compiled.
constexpr int kAnyAxes = -1;
template <int known>
HWY_INLINE int axes_of(const LaneSweep& sweep) {
    return known == kAnyAxes ? sweep.axes : known;
}

/// What the extent's axes add to a reach along n.
template <int known>
HWY_INLINE Floats beside(const LaneSweep& sweep, const Floats* n, Floats reach) {
    const int axes = axes_of<known>(sweep);
    for (int k = 0; k < axes; ++k) {
        const Floats a[3] = {all(sweep.axis[k][0]), all(sweep.axis[k][1]), all(sweep.axis[k][2])};
        reach = add(reach, hn::Mul(hn::Abs(dot(n, a)), all(kMore)));
    }
    return reach;
}

/// Lower bounds for when triangles are met, from the time `enter` on, a bit for each that may be by `latest`.
/// @tparam known  how many axes the extent that moves has, or kAnyAxes
template <int known>
HWY_INLINE unsigned look(const FaceLanes& lanes, const LaneQuery& query, float enter, float latest, float* times) {
    const LaneSweep& sweep = query.sweep;
    const int axes = axes_of<known>(sweep);
    float o[3], size = lanes.size + sweep.size;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = sweep.start[axis] - double(lanes.origin[axis]) / kSurfaceSteps;
        o[axis] = float(from + double(enter) * sweep.direction[axis]);
        size += std::fabs(o[axis]);
    }
    const float unsure = lanes.uneven + sweep.margin + 8 * kRoundoff * size;
    const float reach = (sweep.radius + unsure) * kMore;
    const float error = (axes ? 64 : 32) * kRoundoff * size;
    unsigned met = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        Floats p[3][3];  // corners seen from there
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                p[c][axis] = hn::Sub(hn::LoadU(kFloats, lanes.corner[c][axis] + part), all(o[axis]));
        Floats in = hn::Zero(kFloats), out = all((latest - enter) * kMore);
        for (int axis = 0; axis < 3; ++axis) {
            const Floats aside = all(axes ? (sweep.extent[axis] + unsure) * kMore : reach);
            const Floats low = hn::Sub(hn::Min(hn::Min(p[0][axis], p[1][axis]), p[2][axis]), aside);
            const Floats high = hn::Add(hn::Max(hn::Max(p[0][axis], p[1][axis]), p[2][axis]), aside);
            const Floats slope = all(sweep.inverse[axis]);
            const Floats one = hn::Mul(low, slope), other = hn::Mul(high, slope);
            in = hn::Max(in, hn::Min(one, other));  // which is which cannot be foreseen by a branch
            out = hn::Min(out, hn::Max(one, other));
        }
        unsigned left = bits(hn::Le(hn::Mul(in, all(kLess)), hn::Mul(out, all(kMore))));
        if ((left << part & lanes.used) == 0) continue;
        Floats e[3][3], n[3];
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                e[c][axis] = hn::Sub(hn::LoadU(kFloats, lanes.corner[(c + 1) % 3][axis] + part),
                                     hn::LoadU(kFloats, lanes.corner[c][axis] + part));
        cross(e[0], e[1], n);
        const Floats squares[3] = {dot(e[0], e[0]), dot(e[1], e[1]), dot(e[2], e[2])};
        const Floats longest = hn::Max(hn::Max(squares[0], squares[1]), squares[2]);
        const Floats g =
            add(hn::Mul(hn::Mul(hn::Sqrt(dot(n, n)), all(kMore)), all(reach)), hn::Mul(longest, all(error)));
        const Floats d[3] = {all(sweep.along[0]), all(sweep.along[1]), all(sweep.along[2])};
        const Floats height = dot(n, p[0]), rise = dot(n, d), far = beside<known>(sweep, n, g);
        // -height + rise t lies between -far and far.
        clip(rise, hn::Add(far, height), in, out);
        clip(hn::Neg(rise), hn::Sub(far, height), in, out);
        for (int c = 0; c < 3; ++c) {
            Floats m[3];
            cross(e[c], n, m);
            const Floats grown = hn::Mul(hn::Mul(hn::Sqrt(squares[c]), all(kMore)), g);
            clip(dot(m, d), add(beside<known>(sweep, m, grown), dot(m, p[c])), in, out);
        }
        in = hn::Mul(in, all(kLess));
        left &= bits(hn::Le(in, hn::Mul(out, all(kMore))));
        if (query.front_only) {
            Floats doubt = hn::Mul(longest, all(128 * kRoundoff));
            if (const float tilted = lanes.uneven + lanes.shifted; tilted > 0)
                doubt = add(doubt, hn::Mul(hn::Sqrt(longest), all(32 * tilted)));
            const unsigned away = bits(hn::Gt(rise, doubt));
            left &= ~(away & ~(unsigned(lanes.two_sided) >> part));
        }
        hn::StoreU(in, kFloats, times + part);
        met |= left << part;
    }
    return met & lanes.used;
}

/// The start as seen from the origin of lanes, rounded; the fourth number is 0.
HWY_INLINE void start_from(const FaceLanes& lanes, const LaneSweep& sweep, float* point) {
#if HWY_TARGET == HWY_WASM
    for (int k = 0; k < 3; ++k) point[k] = float(sweep.start[k] - lanes.origin[k] * (1 / kSurfaceSteps));
#else
    const hn::CappedTag<double, 4> doubles;
    const hn::Rebind<float, decltype(doubles)> floats;
    const hn::Rebind<std::int32_t, decltype(doubles)> ints;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
        const auto origin = hn::PromoteTo(doubles, hn::LoadU(ints, &lanes.origin.x + k));
        const auto from =
            hn::Sub(hn::LoadU(doubles, sweep.start + k), hn::Mul(origin, hn::Set(doubles, 1 / kSurfaceSteps)));
        hn::StoreU(hn::DemoteTo(floats, from), floats, point + k);
    }
#endif
}

/// The same for a particle, seen from its start: triangles along its path, as in Sweep's projection. Times are those of
/// boxes, and count from the start.
HWY_INLINE unsigned look_along(const FaceLanes& lanes, const LaneQuery& query, float latest, float* times) {
    const LaneSweep& sweep = query.sweep;
    alignas(16) float o[4];
    start_from(lanes, sweep, o);
    const float size = lanes.size + (std::fabs(o[0]) + std::fabs(o[1]) + std::fabs(o[2]));
    const float reach = (lanes.uneven + sweep.margin + 8 * kRoundoff * size) * kMore;
    const float extent = 3 * lanes.size;  // no triangle's is larger
    const float rounding = 64 * kRoundoff * extent;
    const Floats g = all(extent * (8 * reach + rounding));
    const Floats shear[2] = {all(sweep.shear[0]), all(sweep.shear[1])};
    const float deep = o[sweep.longest];
    const Floats from[2] = {all(o[sweep.aside[0]] - sweep.shear[0] * deep),
                            all(o[sweep.aside[1]] - sweep.shear[1] * deep)};
    unsigned met = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        Floats flat[3][2];  // corners along the path, seen from there
        for (int c = 0; c < 3; ++c) {
            const Floats ahead = hn::LoadU(kFloats, lanes.corner[c][sweep.longest] + part);
            for (int axis = 0; axis < 2; ++axis)
                flat[c][axis] = hn::Sub(
                    hn::Sub(hn::LoadU(kFloats, lanes.corner[c][sweep.aside[axis]] + part), hn::Mul(shear[axis], ahead)),
                    from[axis]);
        }
        Floats turns[3];  // twice the area with the path, by side
        for (int c = 0; c < 3; ++c) {
            const Floats *a = flat[c], *b = flat[(c + 1) % 3];
            turns[c] = hn::Sub(hn::Mul(a[0], hn::Sub(b[1], a[1])), hn::Mul(a[1], hn::Sub(b[0], a[0])));
        }
        const Floats least = hn::Min(hn::Min(turns[0], turns[1]), turns[2]);
        const Floats most = hn::Max(hn::Max(turns[0], turns[1]), turns[2]);
        unsigned left = bits(hn::Or(hn::Ge(least, hn::Neg(g)), hn::Le(most, g)));
        if (query.front_only) {
            const Floats area = add(add(turns[0], turns[1]), turns[2]);
            const float tilted = reach + lanes.uneven + lanes.shifted;
            const unsigned away = bits(hn::Gt(area, all(extent * (32 * tilted + rounding))));
            left &= ~(away & ~(unsigned(lanes.two_sided) >> part));
        }
        if ((left << part & lanes.used) == 0) continue;
        const float bent = 1024 * lanes.uneven;
        Floats in = hn::Zero(kFloats), out = all(latest);
        for (int axis = 0; axis < 3; ++axis) {
            const Floats a = hn::LoadU(kFloats, lanes.corner[0][axis] + part),
                         b = hn::LoadU(kFloats, lanes.corner[1][axis] + part),
                         c = hn::LoadU(kFloats, lanes.corner[2][axis] + part);
            const Floats low = hn::Sub(hn::Min(hn::Min(a, b), c), all(o[axis] + reach));
            const Floats high = hn::Sub(hn::Max(hn::Max(a, b), c), all(o[axis] - reach));
            const Floats slope = all(sweep.inverse[axis]);
            const Floats one = hn::Mul(low, slope), other = hn::Mul(high, slope);
            in = hn::Max(in, hn::Min(one, other));  // which is which cannot be foreseen by a branch
            out = hn::Min(out, hn::Max(one, other));
        }
        in = hn::Sub(hn::Mul(in, all(kLess)), all(bent));
        left &= bits(hn::Le(in, add(hn::Mul(out, all(kMore)), all(bent))));
        hn::StoreU(in, kFloats, times + part);
        met |= left << part;
    }
    return met & lanes.used;
}

/// Times count from the start.
HWY_INLINE unsigned look_by_kind(const FaceLanes& lanes, const LaneQuery& query, float enter, float latest,
                                 float* times) {
    if (query.sweep.particle) return look_along(lanes, query, latest, times);
#if HWY_TARGET == HWY_WASM  // the module has to be small
    const unsigned met = look<kAnyAxes>(lanes, query, enter, latest, times);
#else
    const unsigned met = query.sweep.axes == 0   ? look<0>(lanes, query, enter, latest, times)
                         : query.sweep.axes == 1 ? look<1>(lanes, query, enter, latest, times)
                                                 : look<3>(lanes, query, enter, latest, times);
#endif
    if (met == 0) return 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce)
        hn::Store(add(hn::Load(kFloats, times + part), all(enter)), kFloats, times + part);
    return met;
}

/// Rounded up.
HWY_INLINE float to_float(double latest) {
    return float(latest) * (1 + 4 * kRoundoff);
}

HWY_INLINE std::uint32_t first_bit(unsigned bits) {
    return std::uint32_t(__builtin_ctz(bits));
}

/// What will be looked at. Without a branch: which of both it is cannot be foreseen.
HWY_INLINE void fetch(const void* child, bool faces) {
    const auto* const from = static_cast<const char*>(child);
    const std::size_t last = faces ? sizeof(FaceLanes) - 1 : sizeof(WideNode) - 1;
    for (std::size_t at = 0; at < sizeof(FaceLanes); at += 64) __builtin_prefetch(from + (at < last ? at : last));
}

/// Looks at facets side by side; true when that ends the sweep.
HWY_INLINE bool look_at(const FaceLanes* first, std::uint32_t count, float enter, LaneQuery& query, float& latest) {
    std::uint64_t looked_at = 0;  // facets of the block: one may be in several lanes
    alignas(64) float times[kLanes];
    for (const FaceLanes* lanes = first; lanes != first + count; ++lanes) {
        query.counts.boxes += std::uint32_t(__builtin_popcount(lanes->used));
        unsigned met = look_by_kind(*lanes, query, enter, latest, times);
        while (met) {  // by rising bound
            std::uint32_t lane = first_bit(met);
            for (unsigned rest = met & (met - 1); rest; rest &= rest - 1)
                if (const std::uint32_t other = first_bit(rest); times[other] < times[lane]) lane = other;
            met &= ~(1u << lane);
            if (times[lane] > latest) break;
            const std::uint64_t bit = std::uint64_t(1) << lanes->slot[lane];
            if (looked_at & bit) continue;
            looked_at |= bit;
            if (query.look(query, *lanes, lane)) return true;
            latest = to_float(query.latest);
        }
    }
    return false;
}

bool sweep_lanes(const Node& root, LaneQuery& query) {
    if (!query.sweep.ready) make_ready(query.sweep);
    struct Waiting {
        const void* child;
        std::uint32_t facets;
        float time;
    };
    constexpr std::size_t kMost = (kDeepestTree + 1) * (kLanes - 1) + 1;
    Waiting waiting[kMost];
    std::size_t count = 0;
    Waiting now{root.wide.data(), 0, 0};
    float latest = to_float(query.latest);
    alignas(64) float times[kLanes];
    const Way way(query.sweep);
    for (;;) {
        if (now.facets) {
            const auto* const lanes = static_cast<const FaceLanes*>(now.child);
            if (look_at(lanes, now.facets, now.time, query, latest)) return true;
        } else {
            const WideNode& node = *static_cast<const WideNode*>(now.child);
            query.counts.nodes += node.count;
            unsigned met = enter(node, way, latest, times);
            if (met) {
                std::uint32_t lane = first_bit(met);
                Waiting next{node.child[lane], node.facets[lane], times[lane]};
                const std::size_t base = count;
                // The nearest goes on, the others wait, the farthest deepest.
                for (met &= met - 1; met; met &= met - 1) {
                    lane = first_bit(met);
                    Waiting other{node.child[lane], node.facets[lane], times[lane]};
                    fetch(other.child, other.facets > 0);
                    if (other.time < next.time) std::swap(other, next);
                    FIRMA_ASSERT(count < kMost, "an index is deeper than any that is built");
                    std::size_t k = count++;
                    for (; k > base && waiting[k - 1].time < other.time; --k) waiting[k] = waiting[k - 1];
                    waiting[k] = other;
                }
                now = next;
                continue;
            }
        }
        do {
            if (count == 0) return false;
            now = waiting[--count];
        } while (now.time > latest);
    }
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firma {
namespace {

/// The best first.
struct Kernels {
    std::array<LaneKernel, 4> all;
    std::size_t count = 0;

    Kernels() {
#if HWY_TARGETS & HWY_AVX3
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
            __builtin_cpu_supports("avx512cd") && has_avx2())
            all[count++] = {"AVX-512", N_AVX3::sweep_lanes};
#endif
#if HWY_TARGETS & HWY_AVX2
        if (has_avx2()) all[count++] = {"AVX2", N_AVX2::sweep_lanes};
#endif
#if HWY_TARGETS & HWY_SSE4
        if (has_sse4()) all[count++] = {"SSE4", N_SSE4::sweep_lanes};
#endif
        all[count++] = {"compiled", HWY_STATIC_DISPATCH(sweep_lanes)};
    }

private:
#if HWY_ARCH_X86
    [[maybe_unused]] static bool has_sse4() {
        return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
    }
    [[maybe_unused]] static bool has_avx2() {
        return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    }
#endif
};

const Kernels& kernels() {
    static const Kernels known;
    return known;
}

bool sweep_by_best(const Node& root, LaneQuery& query);
std::atomic<LaneFunction> taken{sweep_by_best};

bool sweep_by_best(const Node& root, LaneQuery& query) {
    const LaneFunction best = kernels().all[0].sweep;
    taken.store(best, std::memory_order_relaxed);
    return best(root, query);
}

}  // namespace

namespace {

constexpr double kFarthest = 0x1p+20;

bool near_enough(const Sweep& sweep) {
    return max_abs(sweep.start) < kFarthest && sweep.end < kFarthest && sweep.radius < kFarthest;
}

/// Of doubles on the way, metres.
double rounding_error_of(const Sweep& sweep) {
    return 0x1p-44 * (max_abs(sweep.start) + 2 * sweep.end + sweep.radius + kWorldRim);
}

/// Floats of boxes' sides are exact; their distance from the start is off by a roundoff of its own, and by those of the
/// start.
double grown_by(double reach, double whole, double middle, double rounding_error) {
    return reach + (rounding_error + 0x1p-20 + 0x1p-21 * (std::fabs(middle) + whole));
}

}  // namespace

LaneSweep::LaneSweep(const Sweep& sweep) {
    if (!taken.load(std::memory_order_relaxed) || !near_enough(sweep)) return;
    usable = true;
    particle = sweep.radius == 0;
    const double rounding_error = rounding_error_of(sweep);
    radius = size = float(sweep.radius);
    margin = float(rounding_error) + size * 0x1p-22f;
    set_path(sweep, sweep.start);
    const auto grow = [&](double middle) { return grown_by(sweep.radius, sweep.radius, middle, rounding_error); };
    put({grow(sweep.start.x), grow(sweep.start.y), grow(sweep.start.z)}, grown);
}

LaneSweep::LaneSweep(const Sweep& sweep, const ShapeExtent& shape) {
    if (!taken.load(std::memory_order_relaxed) || !near_enough(sweep)) return;
    usable = true;
    particle = false;
    const double rounding_error = rounding_error_of(sweep);
    axes = shape.axes;
    double whole = shape.radius;
    Vec3 reach{shape.radius, shape.radius, shape.radius};
    for (int k = 0; k < axes; ++k) {
        const Vec3& a = shape.axis[std::size_t(k)];
        whole += length(a);
        for (int coordinate = 0; coordinate < 3; ++coordinate) axis[k][coordinate] = float(a[coordinate]);
        reach += Vec3{std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)};
    }
    radius = float(shape.radius);
    size = float(whole);
    margin = float(rounding_error) + size * 0x1p-22f;
    const Vec3 middle = sweep.start + shape.middle;
    set_path(sweep, middle);
    const auto grow = [&](double by, double at) { return grown_by(by, whole, at, rounding_error); };
    put({grow(reach.x, middle.x), grow(reach.y, middle.y), grow(reach.z, middle.z)}, grown);
    for (int coordinate = 0; coordinate < 3; ++coordinate) extent[coordinate] = float(reach[coordinate]);
}

void LaneSweep::put(const Vec3& values, double (&into)[4]) {
    into[0] = values.x;
    into[1] = values.y;
    into[2] = values.z;
    into[3] = 0;
}

void LaneSweep::set_path(const Sweep& sweep, const Vec3& middle) {
    put(middle, start);
    put(sweep.direction, direction);
    longest = sweep.axis_k;
    aside[0] = sweep.axis_u;
    aside[1] = sweep.axis_v;
    shear[0] = float(sweep.shear_u);
    shear[1] = float(sweep.shear_v);
}

std::span<const LaneKernel> lane_kernels() {
    return {kernels().all.data(), kernels().count};
}

void take_lane_kernel(const LaneKernel* kernel) {
    taken.store(kernel ? kernel->sweep : nullptr, std::memory_order_relaxed);
}

bool sweep_lanes(const Node& root, LaneQuery& query) {
    return taken.load(std::memory_order_relaxed)(root, query);
}

}  // namespace firma
#endif

#else  // FIRMA_SIMD

namespace firma {

LaneSweep::LaneSweep(const Sweep&) {}

LaneSweep::LaneSweep(const Sweep&, const ShapeExtent&) {}

std::span<const LaneKernel> lane_kernels() {
    return {};
}

void take_lane_kernel(const LaneKernel*) {}

bool sweep_lanes(const Node&, LaneQuery&) {
    FIRMA_ASSERT(false, "no sweep is usable by lanes");
    return false;
}

}  // namespace firma

#endif
